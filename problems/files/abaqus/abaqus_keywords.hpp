// Keywords of Abaqus and CalculiX: spelling, and those that are left out or refused.
#pragma once

#include <string>
#include <string_view>

namespace kusabi::problems {

enum class KeywordUse {
  read,      ///< by the reader of meshes
  left_out,  ///< without influence on the stiffness of the body or its supports
  refused,   ///< changes what is read, such as the positions of nodes
  unknown,   ///< left out, too: the structure is without it
};

/// The keyword in capitals, with the blanks that keywords of its letters have: CalculiX admits
/// "*SOLIDSECTION".
std::string canonical_keyword(std::string_view text);

KeywordUse keyword_use(std::string_view keyword);

/// Suffix "; did you mean ...?" of a message on an unknown keyword; empty if none is near.
std::string similar_keyword(std::string_view keyword);

}  // namespace kusabi::problems
