// OptionTable: the options of a subcommand with names, values, descriptions and defaults. Parsing,
// range checks, help, manual pages and the call that resumes a run are made from it
// (run/command/command_line).
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "engine/options.hpp"
#include "engine/statistics.hpp"

namespace kusabi::run {

/// File of default options, as named in the call.
struct ConfigChoice {
  std::string file;   ///< of --config; empty: the default place
  bool none = false;  ///< --no-config
};

/// Words of an option and their values, for its choice in a call and its name in results.
template <class T>
using OptionWords = std::vector<std::pair<std::string, T>>;

/// @pre the value has a word
template <class T>
const std::string& word_of(const OptionWords<T>& words, const T& value) {
  return std::ranges::find(words, value, &std::pair<std::string, T>::second)->first;
}

/// Range of a number.
struct Range {
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool min_is_excluded = false;
  bool even = false;
};

/// Numbers above, not below, or between bounds.
constexpr Range above(double bound) {
  return {.minimum = bound, .min_is_excluded = true};
}
constexpr Range at_least(double bound) {
  return {.minimum = bound};
}
constexpr Range between(double minimum, double maximum) {
  return {.minimum = minimum, .maximum = maximum};
}

/// Role of an option outside its subcommand.
enum class Role {
  plain,
  input,     ///< a file that is read
  output,    ///< a file that is opened before the search and written at its end
  folder,    ///< a folder that is created before the search and filled at its end
  evidence,  ///< files that are written while ranks search
  state,     ///< the file that keeps everything finished of an analysis
};

/// One option, or the file argument of a subcommand.
struct OptionRow {
  std::string name;                  ///< "--mu"; "file" for a positional argument
  std::string letter{};              ///< the short form, "-o"; empty: none
  std::string value{};               ///< "NUMBER", "FILE", "a|b|c"; empty: a switch
  bool shows_range = false;          ///< help shows `expected`
  std::string expected{};            ///< range, as errors show it: "a number above 0"
  std::vector<std::string> words{};  ///< the choices, if there are any
  std::string unit{};                ///< unit of a number
  std::string default_value{};       ///< empty: none
  std::string help{};
  bool required = false;
  std::string needs{};        ///< an option that this one requires
  std::string needs_value{};  ///< its required value; empty: any
  Role role = Role::plain;
  std::vector<std::string> endings{""};  ///< permitted endings of file names
  /// Status of a search that this option stops; a resumed call leaves the option out.
  std::optional<engine::Status> stops{};
  /// True if runs that resume each other must agree on it, because results depend on it. By default
  /// true for plain options and for evidence.
  std::optional<bool> matters{};
  bool of_answer = true;  ///< false: only the form of the result file depends on it
  /// Stores the value of the call. @return an error message; empty: none
  std::function<std::string(const std::string& text)> store{};
  std::optional<std::string> given{};  ///< value in the call
  /// The value of a text as in result files; empty: the text itself.
  std::function<nlohmann::ordered_json(const std::string& text)> typed{};

  [[nodiscard]] bool named() const { return name.starts_with('-'); }
  /// True if this option may be used beside a value of the one that it requires; nothing: absent.
  [[nodiscard]] bool is_met_by(const std::optional<std::string>& other) const {
    return other && (needs_value.empty() || *other == needs_value);
  }
  /// The required option with its value: "--method polyhedral".
  [[nodiscard]] std::string requirement() const {
    return needs_value.empty() ? needs : needs + ' ' + needs_value;
  }
  /// True if the answer may depend on its value, which result files then contain.
  [[nodiscard]] bool is_asked() const {
    return named() && (role == Role::plain || role == Role::input) && of_answer &&
           matters.value_or(true);
  }
  /// All spellings in a call: {"-o", "--output"}.
  [[nodiscard]] std::vector<std::string> names() const {
    return letter.empty() ? std::vector{name} : std::vector{letter, name};
  }
};

/// Builder of a row.
class RowBuilder {
 public:
  explicit RowBuilder(OptionRow& row) : row_(row) {}
  RowBuilder& letter(std::string letter) { return row_.letter = std::move(letter), *this; }
  RowBuilder& required() { return row_.required = true, *this; }
  RowBuilder& needs(std::string option, std::string value = "") {
    return row_.needs = std::move(option), row_.needs_value = std::move(value), *this;
  }
  RowBuilder& unit(std::string unit) { return row_.unit = std::move(unit), *this; }
  RowBuilder& stops(engine::Status how) { return row_.stops = how, *this; }
  /// Runs that resume each other may differ in it.
  RowBuilder& varies() { return row_.matters = false, *this; }
  /// Runs that resume each other must agree on it, though it is a file.
  RowBuilder& matters() { return row_.matters = true, *this; }
  /// Only the form of the result file depends on it.
  RowBuilder& of_file() { return row_.of_answer = false, *this; }
  /// A range given as its value is answered with a hint at `kusabi sweep`.
  RowBuilder& swept();
  /// File names are the value in the call followed by one of these.
  RowBuilder& ends_in(std::vector<std::string> endings) {
    return row_.endings = std::move(endings), *this;
  }

 private:
  OptionRow& row_;
};

/// Variable of a number. If it is empty, the greatest value of its type or out of range before the
/// call is read, the option has no default.
using NumberOption = std::variant<double*, std::optional<double>*, int*, unsigned*, std::uint64_t*>;

/// File that keeps the state of an analysis.
struct CheckpointChoice {
  std::string state;            ///< file of --resume; empty: none
  double interval = 600;        ///< seconds between two states of a search
  bool on_improvement = false;  ///< also when a better solution is found
  double patience = 30;         ///< seconds to wait for a file that another run uses
};

/// A word of a call, quoted for a shell.
std::string quoted(const std::string& word);

class OptionTable {
 public:
  /// A number. @param name with its dashes
  RowBuilder number(std::string name, NumberOption variable, Range range, std::string help);

  /// A duration: seconds, 90s or 1h30m. @param seconds its default, then its value
  RowBuilder duration(std::string name, double& seconds, Range range, std::string help);

  /// Numbers that increase: START:END:STEP, or a list with commas. Points of a range are decimals:
  /// 0.1 + 4 x 0.05 is 0.3. @param range of each number
  RowBuilder points(std::string name, std::vector<double>& points, Range range, std::string help);

  /// A choice among words, each of which stands for a value.
  template <std::copyable T>
  RowBuilder choice(const std::string& name, T& variable, const OptionWords<T>& words,
                    const std::string& help) {
    std::vector<std::string> names;
    std::vector<T> values;
    std::string default_value;
    for (const auto& [word, value] : words) {
      if (value == variable) default_value = word;
      names.push_back(word);
      values.push_back(value);
    }
    return word(
        name, std::move(names), std::move(default_value),
        [&variable, values](std::size_t at) { variable = values[at]; }, help);
  }

  /// A switch, which sets the variable to `on`.
  RowBuilder flag(std::string name, bool& variable, std::string help, bool on = true);

  /// The name of a file or a folder.
  RowBuilder file(std::string name, std::string& variable, Role role, std::string help);

  /// Any text. @param value placeholder in help
  RowBuilder text(std::string name, std::string& variable, const std::string& value,
                  std::string help);

  // Options common to several subcommands.
  void problem(std::string& file);  ///< the problem file, required
  /// --alpha of uncertain loads. @param when text about calls that use it
  RowBuilder alpha(std::optional<double>& half_width, const std::string& when);
  RowBuilder big_m(std::optional<double>& bound);
  void result(std::string& file);  ///< the result file that is read, required
  RowBuilder friction(double& coefficient);
  /// @param otherwise meaning of a call without it, if it is permitted
  RowBuilder load_case(std::string& name, const std::string& otherwise = "");
  /// --group-alpha: names, which may contain commas and equals signs, with their half-widths.
  RowBuilder group_alpha(std::vector<std::pair<std::string, double>>& half_widths);
  /// --vtu. @param each what a picture is of @param opened_by file that opens all
  void pictures(std::string& folder, const std::string& each, const std::string& opened_by);
  /// --prove. @param how meaning of the option
  void prove(bool& variable, const std::string& how);
  /// --whole.
  /// @param all the configurations of the result file
  /// @param otherwise those whose state of the whole structure is in it without the option
  void whole_states(bool& variable, const std::string& all, const std::string& otherwise);
  void output(std::string help = "result file (JSON)");
  /// --format, of a result file whose list may be in lines. @param help with both formats
  RowBuilder lines(bool& variable, const std::string& help);
  /// A list in lines has none of these outputs and options, which need the whole list, and is no
  /// standard output. @throws WrongInput
  void check_lines(std::initializer_list<std::string_view> excluded) const;
  void further_output(std::string name, std::string help);
  /// --csv. @param things objects of the rows
  void csv_of(const std::string& things);
  /// --top. @param order of the rows
  void top(std::uint64_t& rows, const std::string& order = "");
  /// --quiet and --serial, last of all.
  void quiet_and_serial(std::string quiet = "print errors only");
  void quiet(std::string help = "print errors only");
  void serial();
  /// --time-limit and --node-limit.
  void search_limits(engine::Limits& limits);
  void resume(CheckpointChoice& choice, const std::string& help = "");
  void save_on(CheckpointChoice& choice);  ///< for searches for an optimum
  void config(ConfigChoice& choice);

  [[nodiscard]] const std::deque<OptionRow>& rows() const { return rows_; }
  [[nodiscard]] std::deque<OptionRow>& rows() { return rows_; }
  /// The row of that name; null if there is none.
  [[nodiscard]] const OptionRow* find(std::string_view name) const;

  /// Sets the default of a number, if it depends on the problem: result files then have its value.
  void use_default(std::string_view name, double value);

  /// Options that results depend on, with their values or defaults.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> facts() const;

  /// The member `options` of a result file: what the answer may depend on, with values or defaults;
  /// null without either, and for an option that requires an absent one.
  [[nodiscard]] nlohmann::ordered_json asked() const;

  /// Limits that end with the batch job; null if there are none.
  [[nodiscard]] engine::Limits* ends_with_the_job() const { return ends_with_the_job_; }

  /// Variable of --time-limit; null if there is no such option.
  [[nodiscard]] const engine::Limits* limits() const { return limits_; }

  /// The options of the call, quoted for a shell, without those for which `leave_out` holds.
  [[nodiscard]] std::string call(const std::function<bool(const OptionRow&)>& leave_out) const;

 private:
  RowBuilder add(OptionRow row);
  void time_limit(engine::Limits& limits);
  RowBuilder word(std::string name, std::vector<std::string> words, std::string default_value,
                  std::function<void(std::size_t)> take, std::string help);

  std::deque<OptionRow> rows_;  // at fixed addresses
  // for switches that are only read through `OptionRow::given`
  bool switched_ = false;
  std::string named_;
  engine::Limits* ends_with_the_job_ = nullptr;
  const engine::Limits* limits_ = nullptr;
};

}  // namespace kusabi::run
