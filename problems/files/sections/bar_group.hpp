// Keys of a group of bars: EA, or E and A; the axial force at which they yield, or the stress and
// A; buckling (docs/problem-files.md).
#pragma once

#include <optional>

#include "problems/files/toml/toml_reader.hpp"
#include "problems/structure/model/buckling.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// What is the same of all bars of a group, and where it stands: if it is not given, the group.
struct BarGroup {
  Member bar{};                         ///< without nodes
  support::SourcePosition stiffness{};  ///< of EA, or of E
  support::SourcePosition yield{};      ///< of yield, or of fy
  /// Of the bars with `buckling`, whose compression strength depends on their length. The length
  /// here is the factor of it: L_cr / L.
  std::optional<CompressedBar> compressed{};

  /// The yield forces of a bar of this length.
  std::optional<YieldForces> yield_at(double length) const;
};

/// The keys EA, E, A, yield, fy and buckling of a group. E A and A fy are rounded to a double each,
/// and so they are meant.
/// @throws InputError if something is given in both ways, or in one of them by half
BarGroup bars_in(const TomlReader& reader, const TomlTable& group);

}  // namespace kusabi::problems
