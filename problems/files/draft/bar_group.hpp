// Properties of a group of bars: EA, or E and A; yield forces, or yield stress and A; buckling
// (docs/problem-files.md).
#pragma once

#include <optional>

#include "problems/files/toml/toml_reader.hpp"
#include "problems/structure/model/buckling.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Common properties of all bars of a group, and their places in the file, or that of the group if
/// not given.
struct BarGroup {
  Member bar{};                         ///< without nodes
  support::SourcePosition stiffness{};  ///< of EA, or of E
  support::SourcePosition yield{};      ///< of yield, or of fy
  /// Bars with `buckling`: their compression strength depends on their length. The length in this
  /// entry is the factor L_cr / L.
  std::optional<CompressedBar> compressed{};

  /// Of struts: the share of their compression strength that remains after buckling.
  std::optional<double> residual{};

  /// The yield forces of a bar of this length.
  std::optional<YieldForces> yield_at(double length) const;
};

/// The keys EA, E, A, yield, fy and buckling of a group. The products E A and A fy are rounded to a
/// double, which is then taken as exact.
/// @throws InputError if a property is given in both ways, or incompletely in one
BarGroup bars_in(const TomlReader& reader, const TomlTable& group);

}  // namespace kusabi::problems
