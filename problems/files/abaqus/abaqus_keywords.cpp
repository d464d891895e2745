// Table of keywords.
#include "problems/files/abaqus/abaqus_keywords.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "problems/files/abaqus/abaqus_text.hpp"
#include "support/nearest.hpp"

namespace kusabi::problems {
namespace {

constexpr std::array<std::string_view, 27> read_ones{"*HEADING",
                                                     "*NODE",
                                                     "*ELEMENT",
                                                     "*NSET",
                                                     "*ELSET",
                                                     "*SURFACE",
                                                     "*MATERIAL",
                                                     "*ELASTIC",
                                                     "*SOLID SECTION",
                                                     "*BOUNDARY",
                                                     "*CLOAD",
                                                     "*DLOAD",
                                                     "*DENSITY",
                                                     "*INCLUDE",
                                                     "*PART",
                                                     "*END PART",
                                                     "*ASSEMBLY",
                                                     "*END ASSEMBLY",
                                                     "*INSTANCE",
                                                     "*END INSTANCE",
                                                     "*CONTACT PAIR",
                                                     "*TIE",
                                                     "*FRICTION",
                                                     "*SURFACE INTERACTION",
                                                     "*SURFACE BEHAVIOR",
                                                     "*TRANSFORM",
                                                     "*STEP"};

constexpr std::array<std::string_view, 48> harmless{"*END STEP",
                                                    "*STATIC",
                                                    "*DYNAMIC",
                                                    "*VISCO",
                                                    "*FREQUENCY",
                                                    "*BUCKLE",
                                                    "*DSLOAD",
                                                    "*NODE FILE",
                                                    "*NODE PRINT",
                                                    "*NODE OUTPUT",
                                                    "*EL FILE",
                                                    "*EL PRINT",
                                                    "*ELEMENT OUTPUT",
                                                    "*CONTACT OUTPUT",
                                                    "*CONTACT FILE",
                                                    "*CONTACT PRINT",
                                                    "*ENERGY OUTPUT",
                                                    "*ENERGY PRINT",
                                                    "*ENERGY FILE",
                                                    "*OUTPUT",
                                                    "*FILE FORMAT",
                                                    "*SECTION PRINT",
                                                    "*FACE PRINT",
                                                    "*PRINT",
                                                    "*PREPRINT",
                                                    "*RESTART",
                                                    "*MONITOR",
                                                    "*CONTROLS",
                                                    "*SECTION CONTROLS",
                                                    "*CONTACT CONTROLS",
                                                    "*SOLVER CONTROLS",
                                                    "*TIME POINTS",
                                                    "*AMPLITUDE",
                                                    "*EXPANSION",
                                                    "*CONDUCTIVITY",
                                                    "*SPECIFIC HEAT",
                                                    "*DAMPING",
                                                    "*ORIENTATION",
                                                    "*TEMPERATURE",
                                                    "*INITIAL CONDITIONS",
                                                    "*PHYSICAL CONSTANTS",
                                                    "*GAP CONDUCTANCE",
                                                    "*CONTACT DAMPING",
                                                    "*BOUNDARYF",
                                                    "*CFLUX",
                                                    "*DFLUX",
                                                    "*FILM",
                                                    "*RADIATE"};

constexpr std::array<std::string_view, 9> not_read{
    "*NGEN", "*NFILL", "*NCOPY", "*NMAP", "*ELGEN", "*ELCOPY", "*SYSTEM", "*PARAMETER", "*IMPORT"};

/// Keywords that resemble one that is read, but are not misspelt.
constexpr std::array<std::string_view, 4> resembling{"*PLASTIC", "*TRANSFORMF", "*HYPERELASTIC",
                                                     "*SHELL SECTION"};

bool is_among(std::string_view keyword, const auto& all) {
  return std::ranges::find(all, keyword) != all.end();
}

std::string without_blanks(std::string_view text) {
  std::string result(text);
  std::erase(result, ' ');
  return result;
}

/// The keyword of the table with the same letters; empty if there is none.
std::string_view spelt(const std::string& letters, const auto& all) {
  const auto found = std::ranges::find_if(
      all, [&](std::string_view one) { return without_blanks(one) == letters; });
  return found == all.end() ? std::string_view() : *found;
}

}  // namespace

std::string canonical_keyword(std::string_view text) {
  std::string keyword;
  for (const char character : capitals(text)) {
    if (character == ' ' && (keyword.ends_with(' ') || keyword == "*")) continue;
    keyword += character;
  }
  if (is_among(keyword, read_ones)) return keyword;
  const std::string letters = without_blanks(keyword);
  for (const auto known : {spelt(letters, read_ones), spelt(letters, harmless)}) {
    if (!known.empty()) return std::string(known);
  }
  return keyword;
}

KeywordUse keyword_use(std::string_view keyword) {
  if (is_among(keyword, read_ones)) return KeywordUse::read;
  if (is_among(keyword, harmless)) return KeywordUse::left_out;
  return is_among(keyword, not_read) ? KeywordUse::refused : KeywordUse::unknown;
}

std::string similar_keyword(std::string_view keyword) {
  if (is_among(keyword, resembling)) return {};
  return support::did_you_mean(keyword, {read_ones.begin(), read_ones.end()});
}

}  // namespace kusabi::problems
