// What a group of bars says of them: EA, or E and A; the axial force at which they yield, or the
// stress and A (docs/problem-files.md).
#pragma once

#include "problems/files/toml/toml_reader.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// What is the same of all bars of a group, and where it stands: if it is not given, the group.
struct BarGroup {
  Member bar{};                         ///< without nodes
  support::SourcePosition stiffness{};  ///< of EA, or of E
  support::SourcePosition yield{};      ///< of yield, or of fy
};

/// The keys EA, E, A, yield and fy of a group. E A and A fy are rounded to a double each, and so
/// they are meant.
/// @throws InputError if something is given in both ways, or in one of them by half
BarGroup bars_in(const TomlReader& reader, const TomlTable& group);

}  // namespace kusabi::problems
