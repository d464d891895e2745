// Properties of a group of bars: EA, or E and A; yield forces, or yield stress and A
// (docs/problem-files.md).
#pragma once

#include "problems/files/toml/toml_reader.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Common properties of all bars of a group, and their places in the file, or that of the group if
/// not given.
struct BarGroup {
  Member bar{};                         ///< without nodes
  support::SourcePosition stiffness{};  ///< of EA, or of E
  support::SourcePosition yield{};      ///< of yield, or of fy
};

/// The keys EA, E, A, yield and fy of a group. The products E A and A fy are rounded to a double,
/// which is then taken as exact.
/// @throws InputError if a property is given in both ways, or incompletely in one
BarGroup bars_in(const TomlReader& reader, const TomlTable& group);

}  // namespace kusabi::problems
