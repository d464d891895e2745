// LP files line by line, before GLPK sees them: it would take some of these words for columns.
#include "solvers/linear/unsupported.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "solvers/linear/mps_lines.hpp"
#include "solvers/linear/mps_program.hpp"
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

// The objective and the rows of a file in CPLEX LP format, as far as forms that GLPK does not read are
// concerned. It reports them as missing names, and mostly one line too late.
class LpForms {
 public:
  explicit LpForms(const std::string& file) : file_(file) {}

  void check(std::string_view text) {
    for (std::size_t line = 1; !text.empty(); ++line) {
      const auto end = std::min(text.find('\n'), text.size());
      read(plain(text.substr(0, end)), line);
      text.remove_prefix(std::min(end + 1, text.size()));
      if (part_ == Part::others) break;
    }
    if (part_ == Part::none) return;
    check_objective();
    check_rows();
  }

 private:
  enum class Part { none, objective, rows, others };
  enum class Kind { number, name, sign, sense, colon };
  struct Token {
    Kind kind;
    std::size_t line;
  };

  [[noreturn]] void refuse(std::size_t line, std::string_view fault,
                           std::string_view expected) const {
    refuse_line(file_, line, fault, expected);
  }

  // A line in capitals. Keywords are at its beginning.
  void read(std::string_view words, std::size_t line) {
    static constexpr std::array<std::string_view, 6> objectives{"MAXIMIZE", "MAXIMUM", "MAX",
                                                                "MINIMIZE", "MINIMUM", "MIN"};
    static constexpr std::array<std::string_view, 5> rows{"SUBJECT TO", "SUCH THAT", "S.T.", "ST.",
                                                          "ST"};
    static constexpr std::array<std::string_view, 12> others{
        "BOUNDS",  "BOUND", "GENERALS", "GENERAL", "GEN", "INTEGERS",
        "INTEGER", "INT",   "BINARIES", "BINARY",  "BIN", "END"};
    const auto begins = [&](std::string_view keyword) {
      return words.starts_with(keyword) &&
             (words.size() == keyword.size() || words[keyword.size()] == ' ');
    };
    const auto enter = [&](const auto& keywords, Part part) {
      const auto found = std::find_if(keywords.begin(), keywords.end(), begins);
      if (found == keywords.end()) return;
      words.remove_prefix(found->size());
      part_ = part;
      if (part == Part::objective) objective_line_ = line;
    };
    if (part_ == Part::none) enter(objectives, Part::objective);
    if (part_ == Part::objective) enter(rows, Part::rows);
    if (part_ == Part::rows) enter(others, Part::others);
    if (part_ == Part::objective) add_tokens(words, line, objective_);
    if (part_ == Part::rows) add_tokens(words, line, rows_);
  }

  static void add_tokens(std::string_view words, std::size_t line, std::vector<Token>& tokens) {
    constexpr std::string_view signs = "+-";
    constexpr std::string_view senses = "<>=";
    constexpr std::string_view digits = "0123456789.";
    const auto is_in = [](std::string_view set, char letter) {
      return set.find(letter) != std::string_view::npos;
    };
    const auto ends_name = [&](char letter) {
      return letter == ' ' || letter == ':' || is_in(signs, letter) || is_in(senses, letter);
    };
    for (std::size_t at = 0; at < words.size();) {
      const char letter = words[at];
      if (letter == ' ') {
        ++at;
      } else if (letter == ':' || is_in(signs, letter)) {
        tokens.push_back({letter == ':' ? Kind::colon : Kind::sign, line});
        ++at;
      } else if (is_in(senses, letter)) {
        while (at < words.size() && is_in(senses, words[at])) ++at;
        tokens.push_back({Kind::sense, line});
      } else if (is_in(digits, letter)) {
        double value = 0;
        const char* const begin = words.data() + at;
        const auto [end, error] = std::from_chars(begin, words.data() + words.size(), value);
        at += std::max<std::size_t>(1, static_cast<std::size_t>(end - begin));
        tokens.push_back({Kind::number, line});
      } else {
        while (at < words.size() && !ends_name(words[at])) ++at;
        tokens.push_back({Kind::name, line});
      }
    }
  }

  static bool is(const std::vector<Token>& tokens, std::size_t at, Kind kind) {
    return at < tokens.size() && tokens[at].kind == kind;
  }

  // The first token after "name:".
  static std::size_t after_label(const std::vector<Token>& tokens, std::size_t at) {
    return is(tokens, at, Kind::name) && is(tokens, at + 1, Kind::colon) ? at + 2 : at;
  }

  // A number among these tokens that no name follows.
  static std::optional<Token> constant(const std::vector<Token>& tokens, std::size_t begin,
                                       std::size_t end) {
    for (std::size_t at = begin; at < end; ++at) {
      const bool has_name = at + 1 < end && tokens[at + 1].kind == Kind::name;
      if (tokens[at].kind == Kind::number && !has_name) return tokens[at];
    }
    return {};
  }

  void check_objective() const {
    const std::size_t begin = after_label(objective_, 0);
    if (begin == objective_.size()) {
      refuse(begin == 0 ? objective_line_ : objective_[begin - 1].line,
             "an objective without terms", "at least one term, such as 0 x");
    }
    if (const auto found = constant(objective_, begin, objective_.size())) {
      refuse(found->line, "a constant in the objective",
             "terms only, such as 4 x with a column x that is fixed at 1");
    }
  }

  void check_rows() const {
    constexpr std::string_view one_sense = "one sense in a row; two rows for a range";
    for (std::size_t at = 0; at < rows_.size();) {
      const std::size_t begin = after_label(rows_, at);
      std::size_t sense = begin;
      while (sense < rows_.size() && rows_[sense].kind != Kind::sense) ++sense;
      if (sense == rows_.size()) return;  // an error that GLPK reports
      const auto is_name = [](const Token& token) { return token.kind == Kind::name; };
      const auto from = rows_.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto to = rows_.begin() + static_cast<std::ptrdiff_t>(sense);
      if (begin < sense && std::none_of(from, to, is_name)) {
        refuse(rows_[sense].line, "a range, with a number on the left-hand side", one_sense);
      }
      if (const auto found = constant(rows_, begin, sense)) {
        refuse(found->line, "a constant on the left-hand side of a row",
               "terms only, and all constants in the number on the right-hand side");
      }
      at = sense + 1;
      while (is(rows_, at, Kind::sign)) ++at;
      const bool number = is(rows_, at, Kind::number);
      const std::size_t line = rows_[at - 1].line;
      if (number) ++at;
      if (is(rows_, at, Kind::sense)) refuse(rows_[at].line, "a range, with two senses", one_sense);
      const bool more = is(rows_, at, Kind::sign) ||
                        (is(rows_, at, Kind::name) && !is(rows_, at + 1, Kind::colon));
      if (more && rows_[at].line == line) {
        refuse(line, "terms on the right-hand side of a row",
               "a number there, and all terms before");
      }
      if (!number) return;  // an error that GLPK reports
    }
  }

  const std::string& file_;
  Part part_ = Part::none;
  std::size_t objective_line_ = 0;
  std::vector<Token> objective_;
  std::vector<Token> rows_;
};

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
  const auto whole = text;
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
  LpForms(file).check(whole);
}

}  // namespace kusabi::linear
