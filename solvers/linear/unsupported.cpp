// LP files line by line, before GLPK sees them: it would take some of these words for columns.
#include "solvers/linear/unsupported.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "solvers/linear/mps_lines.hpp"
#include "support/input_error.hpp"

namespace kusabi::linear {
namespace {

using Feature = std::pair<std::string_view, std::string_view>;

constexpr std::string_view sets = "special ordered sets";
constexpr std::string_view semi_continuous = "semi-continuous columns";
constexpr std::string_view indicators = "indicator constraints";
constexpr std::string_view quadratic = "quadratic terms";
constexpr std::string_view general = "general constraints";
constexpr std::string_view lazy = "lazy constraints";
constexpr std::string_view piecewise = "piecewise-linear objectives";

template <std::size_t count>
std::string_view feature_of(const std::array<Feature, count>& features, std::string_view word) {
  const auto found = std::find_if(features.begin(), features.end(),
                                  [&](const Feature& each) { return each.first == word; });
  return found == features.end() ? std::string_view() : found->second;
}

bool is_blank(char letter) {
  return std::isspace(static_cast<unsigned char>(letter)) != 0;
}

// In capitals, without the comment, with one blank between words.
std::string plain(std::string_view line) {
  line = line.substr(0, line.find('\\'));
  std::string words;
  for (const char letter : line) {
    if (!is_blank(letter)) {
      words += letter;
    } else if (!words.empty() && words.back() != ' ') {
      words += ' ';
    }
  }
  if (!words.empty() && words.back() == ' ') words.pop_back();
  return capitals(words);
}

// A bracket at the beginning of a word; others are parts of a name.
bool begins_with_square_bracket(std::string_view words) {
  for (std::size_t at = words.find('['); at != std::string_view::npos;
       at = words.find('[', at + 1)) {
    constexpr std::string_view before = " +-:=";
    if (at == 0 || before.find(words[at - 1]) != std::string_view::npos) return true;
  }
  return words.find('^') != std::string_view::npos;
}

// Of a line and the next that is not empty.
std::optional<Feature> feature_in(std::string_view words, std::string_view next) {
  static constexpr std::array<Feature, 6> headings{{{"SEMIS", semi_continuous},
                                                    {"SEMI", semi_continuous},
                                                    {"LAZY CONSTRAINTS", lazy},
                                                    {"USER CUTS", lazy},
                                                    {"GENERAL CONSTRAINTS", general},
                                                    {"PWLOBJ", piecewise}}};
  static constexpr std::array<std::string_view, 3> of_sets{"SOS", "SOS1", "SOS2"};
  const auto has = [&](std::string_view part) {
    return words.find(part) != std::string_view::npos;
  };
  if (const auto feature = feature_of(headings, words); !feature.empty()) return {{words, feature}};
  // A column may be called so, alone in its line; the sets that follow have colons.
  const bool heads_sets = std::find(of_sets.begin(), of_sets.end(), words) != of_sets.end() &&
                          next.find(':') != std::string_view::npos;
  if (heads_sets) return {{words, sets}};
  for (const std::string_view type : {"S1::", "S2::", "S1 ::", "S2 ::"}) {
    if (has(type)) return {{type, sets}};
  }
  if (has("SEMI-CONTINUOUS")) return {{"SEMI-CONTINUOUS", semi_continuous}};
  if (has("->")) return {{"->", indicators}};
  if (begins_with_square_bracket(words)) return {{has("[") ? "[" : "^", quadratic}};
  return {};
}

}  // namespace

std::string_view unsupported_feature(std::string_view section) {
  static constexpr std::array<Feature, 14> sections{{{"SOS", sets},
                                                     {"SOS1", sets},
                                                     {"SOS2", sets},
                                                     {"SETS", sets},
                                                     {"QUADOBJ", quadratic},
                                                     {"QMATRIX", quadratic},
                                                     {"QSECTION", quadratic},
                                                     {"QCMATRIX", quadratic},
                                                     {"CSECTION", "second-order cones"},
                                                     {"INDICATORS", indicators},
                                                     {"GENCONS", general},
                                                     {"LAZYCONS", lazy},
                                                     {"USERCUTS", lazy},
                                                     {"PWLOBJ", piecewise}}};
  return feature_of(sections, section);
}

void refuse_unsupported(const std::string& file, std::size_t line, std::string_view what,
                        std::string_view feature) {
  throw support::InputError(
      fmt::format("{}:{}", file, line), {},
      fmt::format("{}: {} are not supported; expected linear rows, bounds and binary columns only",
                  support::in_quotes(what), feature));
}

void refuse_unsupported_lp(std::string_view text, const std::string& file) {
  std::string words;
  std::size_t number = 0;
  const auto look_at = [&](std::string_view next) {
    if (words.empty()) return;
    if (const auto found = feature_in(words, next)) {
      refuse_unsupported(file, number, found->first, found->second);
    }
  };
  for (std::size_t line = 1; !text.empty(); ++line) {
    const auto end = std::min(text.find('\n'), text.size());
    auto next = plain(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (next.empty()) continue;
    look_at(next);
    words = std::move(next);
    number = line;
  }
  look_at({});
}

}  // namespace kusabi::linear
