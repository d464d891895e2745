// Permitted values of each kind of option, and messages for wrong ones.
#include "run/command/option_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "run/command/output_set.hpp"
#include "run/output/wrong_input.hpp"
#include "run/session/time_limit.hpp"

namespace kusabi::run {
namespace {

/// A finite number; nothing if the text is anything else.
inline std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) return {};
  return value;
}

using nlohmann::ordered_json;

template <class Number>
constexpr bool whole = std::is_integral_v<Number>;

// "a number above 0", "a whole number from 1 to 1000".
template <class Number>
std::string expected(const Range& range) {
  const auto* const kind = range.even      ? "an even number"
                           : whole<Number> ? "a whole number"
                                           : "a number";
  const bool below = std::isfinite(range.maximum);
  if (range.min_is_excluded) return fmt::format("{} above {:g}", kind, range.minimum);
  if (!std::isfinite(range.minimum)) return kind;
  if (!below) return fmt::format("{} of {:g} or more", kind, range.minimum);
  return fmt::format("{} from {:g} to {:.10g}", kind, range.minimum, range.maximum);
}

template <class Number>
bool is_in(const Range& range, Number number) {
  const auto value = static_cast<double>(number);
  if (!std::isfinite(value) || value < range.minimum || value > range.maximum) return false;
  if (range.min_is_excluded && value == range.minimum) return false;
  return !range.even || std::fmod(value, 2) == 0;
}

template <class Number, class Variable>
std::string take_number(const std::string& text, const Range& range, Variable& variable) {
  Number number{};
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number);
  if (error == std::errc{} && end == last && is_in(range, number)) {
    variable = number;
    return {};
  }
  return fmt::format("'{}', expected {}", text, expected<Number>(range));
}

std::string default_of(const Range& /*range*/, const std::optional<double>& /*empty*/) {
  return {};
}

// One spelling per number, since facts are compared as text.
std::string as_fact(const std::string& text) {
  double number = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number);
  return error == std::errc{} && end == last ? fmt::format("{}", number) : text;
}

// A value out of range means that there is no default.
template <class Number>
std::string default_of(const Range& range, const Number& variable) {
  if (!is_in(range, variable) || variable == std::numeric_limits<Number>::max()) return {};
  return fmt::format("{}", variable);
}

template <class Number>
ordered_json typed_number(const std::string& text) {
  Number number{};
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

// START:END:STEP, or a list with commas, such as 0.1:1.0:0.05, from 0.1 to 1 in steps of 0.05.
class PointsReader {
 public:
  PointsReader(const std::string& text, const Range& range) : text_(text), range_(range) {}

  // Increasing. @throws WrongInput
  [[nodiscard]] std::vector<double> points() const {
    auto points = text_.find(':') == std::string::npos ? numbers(',') : in_steps();
    if (points.size() > max_points) wrong(too_many);
    if (std::ranges::adjacent_find(points, std::greater_equal()) != points.end())
      wrong("numbers that increase");
    if (!is_in(range_, points.front()))
      wrong(range_.min_is_excluded ? "numbers above 0" : "numbers that are not negative");
    return points;
  }

 private:
  static constexpr std::size_t max_points = 10000;
  static constexpr const char* too_many = "no more than 10000 points";

  [[nodiscard]] std::vector<double> numbers(char between) const {
    std::vector<double> list;
    for (std::size_t from = 0; from <= text_.size();) {
      const auto to = std::min(text_.find(between, from), text_.size());
      const auto value = number_in(text_.substr(from, to - from));
      if (!value) wrong("START:END:STEP, such as 0.1:1.0:0.05, or numbers separated by commas");
      list.push_back(*value);
      from = to + 1;
    }
    return list;
  }

  [[nodiscard]] std::vector<double> in_steps() const {
    const auto three = numbers(':');
    if (three.size() != 3 || !(three[2] > 0) || !(three[0] <= three[1]))
      wrong("START:END:STEP with START not above END and STEP above 0");
    if ((three[1] - three[0]) / three[2] >= static_cast<double>(max_points)) wrong(too_many);
    std::vector<double> points;
    for (int step = 0;; ++step) {
      // The decimals of START and STEP, without the rounding errors of the sum.
      const double point =
          step == 0 ? three[0] : *number_in(fmt::format("{:.12g}", three[0] + step * three[2]));
      if (point > three[1]) return points;
      points.push_back(point);
    }
  }

  [[noreturn]] void wrong(const char* expected) const {
    throw WrongInput(fmt::format("'{}', expected {}", text_, expected));
  }

  const std::string& text_;
  const Range& range_;
};

// A name ends at the first equals sign that is followed by a number and the end of its entry.
std::vector<std::pair<std::string, double>> half_widths_in(const std::string& text) {
  std::vector<std::pair<std::string, double>> groups;
  for (std::size_t from = 0; from < text.size();) {
    from = std::min(text.find_first_not_of(' ', from), text.size() - 1);
    auto equals = text.find('=', from + 1);
    for (;; equals = text.find('=', equals + 1)) {
      if (equals == std::string::npos) {
        throw WrongInput(fmt::format(
            "'{}', expected NAME=NUMBER,NAME=NUMBER,... with numbers that are not negative", text));
      }
      const auto end = std::min(text.find(',', equals), text.size());
      const auto value = number_in(text.substr(equals + 1, end - equals - 1));
      if (!value || *value < 0) continue;
      groups.emplace_back(text.substr(from, equals - from), *value);
      from = end + 1;
      break;
    }
  }
  return groups;
}

// Message of a reader that throws; empty: none.
template <class Read>
std::string message_of(Read read) {
  try {
    read();
  } catch (const WrongInput& error) {
    return error.what();
  }
  return {};
}

}  // namespace

std::string quoted(const std::string& word) {
  constexpr std::string_view plain = "%+,-./:=@_";
  const auto is_plain = [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           plain.find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, is_plain)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + '\'';
}

RowBuilder& RowBuilder::swept() {
  row_.store = [store = row_.store, name = row_.name](const std::string& text) {
    auto wrong = store(text);
    if (!wrong.empty() && text.find(':') != std::string::npos)
      wrong += fmt::format("; for a range: kusabi sweep FILE {} {}", name, text);
    return wrong;
  };
  return *this;
}

RowBuilder OptionTable::add(OptionRow row) {
  return RowBuilder(rows_.emplace_back(std::move(row)));
}

RowBuilder OptionTable::number(std::string name, NumberOption variable, Range range,
                               std::string help) {
  return std::visit(
      [&](auto* its) {
        using Variable = std::remove_pointer_t<decltype(its)>;
        using Number =
            std::conditional_t<std::is_same_v<Variable, std::optional<double>>, double, Variable>;
        return add({.name = std::move(name),
                    .value = whole<Number> ? "COUNT" : "NUMBER",
                    .shows_range = true,
                    .expected = expected<Number>(range),
                    .default_value = default_of(range, *its),
                    .help = std::move(help),
                    .store =
                        [its, range](const std::string& text) {
                          return take_number<Number>(text, range, *its);
                        },
                    .typed = typed_number<Number>});
      },
      variable);
}

RowBuilder OptionTable::duration(std::string name, double& seconds, Range range, std::string help) {
  auto expected_text = expected<double>(range) + ", in seconds, or 90s, 1h30m";
  return add({.name = std::move(name),
              .value = "TIME",
              .shows_range = true,
              .expected = expected_text,
              .default_value = fmt::format("{}s", seconds),
              .help = std::move(help),
              .store = [&seconds, range, expected_text](const std::string& text) -> std::string {
                if (take_number<double>(text, range, seconds).empty()) return {};
                const auto given = seconds_in(text);
                if (!given || !is_in(range, *given))
                  return fmt::format("'{}', expected {}", text, expected_text);
                seconds = *given;
                return {};
              }});
}

RowBuilder OptionTable::points(std::string name, std::vector<double>& points, Range range,
                               std::string help) {
  return add({.name = std::move(name),
              .value = "POINTS",
              .expected = "POINTS",
              .help = std::move(help),
              .store =
                  [&points, range](const std::string& text) {
                    return message_of([&] { points = PointsReader(text, range).points(); });
                  },
              .typed =
                  [range](const std::string& text) {
                    return ordered_json(PointsReader(text, range).points());
                  }});
}

RowBuilder OptionTable::word(std::string name, std::vector<std::string> words,
                             std::string default_value, std::function<void(std::size_t)> take,
                             std::string help) {
  auto row_value = fmt::format("{}", fmt::join(words, "|"));
  return add({.name = std::move(name),
              .value = std::move(row_value),
              .expected = fmt::format("one of {}", fmt::join(words, ", ")),
              .words = words,
              .default_value = std::move(default_value),
              .help = std::move(help),
              .store = [words = std::move(words), take = std::move(take)](const std::string& text) {
                const auto at = std::ranges::find(words, text);
                if (at == words.end()) {
                  return fmt::format("'{}', expected one of {}", text, fmt::join(words, ", "));
                }
                take(static_cast<std::size_t>(at - words.begin()));
                return std::string{};
              }});
}

RowBuilder OptionTable::flag(std::string name, bool& variable, std::string help, bool on) {
  return add({.name = std::move(name),
              .help = std::move(help),
              .store = [&variable, on](const std::string& /*nothing*/) {
                variable = on;
                return std::string{};
              }});
}

RowBuilder OptionTable::text(std::string name, std::string& variable, const std::string& value,
                             std::string help) {
  return add({.name = std::move(name),
              .value = value,
              .expected = value,
              .help = std::move(help),
              .store = [&variable](const std::string& text) {
                variable = text;
                return std::string{};
              }});
}

RowBuilder OptionTable::file(std::string name, std::string& variable, Role role, std::string help) {
  auto row =
      text(std::move(name), variable, role == Role::folder ? "DIR" : "FILE", std::move(help));
  rows_.back().role = role;
  rows_.back().expected = role == Role::folder ? "the name of a folder" : "the name of a file";
  return row;
}

void OptionTable::output(std::string help) {
  file("--output", named_, Role::output, std::move(help)).letter("-o");
}

void OptionTable::further_output(std::string name, std::string help) {
  file(std::move(name), named_, Role::output, std::move(help));
}

void OptionTable::csv_of(const std::string& things) {
  further_output("--csv", fmt::format("CSV file of the {}, one row each", things));
}

void OptionTable::top(std::uint64_t& rows, const std::string& order) {
  number("--top", &rows, above(0),
         fmt::format("maximum number of rows{}; files contain all patterns", order))
      .varies();
}

void OptionTable::problem(std::string& file) {
  this->file("file", file, Role::input, "problem file (TOML)").required();
}

void OptionTable::result(std::string& file) {
  this->file("file", file, Role::input, "result file (JSON)").required();
}

RowBuilder OptionTable::friction(double& coefficient) {
  return number("--mu", &coefficient, above(0), "friction coefficient").required();
}

RowBuilder OptionTable::load_case(std::string& name, const std::string& otherwise) {
  return text("--case", name, "NAME", "name of the load case" + otherwise);
}

RowBuilder OptionTable::alpha(std::optional<double>& half_width, const std::string& when) {
  return number("--alpha", &half_width, at_least(0), "half-width of each uncertain load" + when)
      .unit("in the file's unit of force");
}

RowBuilder OptionTable::big_m(std::optional<double>& bound) {
  return number("--big-m", &bound, above(0),
                "M of (29), for collapse modes scaled to f_R'u = 1 in the unit of force; 5 in the "
                "paper. Default: a safe value for each component, derived from the problem");
}

RowBuilder OptionTable::group_alpha(std::vector<std::pair<std::string, double>>& half_widths) {
  return add({.name = "--group-alpha",
              .value = "NAME=NUMBER,...",
              .expected = "NAME=NUMBER,...",
              .help = "half-widths of uncertain loads or groups by name",
              .store =
                  [&half_widths](const std::string& text) {
                    return message_of([&] { half_widths = half_widths_in(text); });
                  },
              .typed =
                  [](const std::string& text) {
                    auto all = ordered_json::object();
                    for (const auto& [group, half_width] : half_widths_in(text))
                      all[group] = half_width;
                    return all;
                  }})
      .unit("in the file's unit of force");
}

void OptionTable::pictures(std::string& folder, const std::string& each,
                           const std::string& opened_by) {
  file(
      "--vtu", folder, Role::folder,
      fmt::format("folder for a VTU picture of each {}; {} opens all in ParaView", each, opened_by))
      .ends_in({"/" + opened_by});
}

void OptionTable::whole_states(bool& variable, const std::string& all,
                               const std::string& otherwise) {
  flag("--whole", variable,
       fmt::format("displacements of all nodes, member forces and support reactions of all {} in "
                   "the result file. Default: of {}",
                   all, otherwise))
      .needs("--output")
      .varies();
}

void OptionTable::prove(bool& variable, const std::string& how) {
  flag("--prove", variable,
       how +
           ". Default: only if the stiffnesses or lengths of the structure differ by a factor of "
           "more "
           "than 1e7");
}

void OptionTable::quiet_and_serial(std::string quiet) {
  this->quiet(std::move(quiet));
  serial();
}

void OptionTable::quiet(std::string help) {
  flag("--quiet", switched_, std::move(help)).letter("-q").varies();
}

void OptionTable::serial() {
  flag("--serial", switched_, "run in one process, without MPI").varies();
}

void OptionTable::time_limit(engine::Limits& limits) {
  limits_ = &limits;
  add({.name = "--time-limit",
       .value = "TIME",
       .help =
           "time limit, such as 5400 (seconds), 90s or 1h30m; slurm: until shortly before the end "
           "of the Slurm job",
       .matters = false,
       .store = [this, &limits](const std::string& text) -> std::string {
         if (text == "slurm") {
           ends_with_the_job_ = &limits;
           return {};
         }
         const auto seconds = seconds_in(text);
         if (!seconds) {
           return fmt::format("'{}', expected a number above 0, in seconds, or 90s, 1h30m, slurm",
                              text);
         }
         limits.seconds = *seconds;
         return {};
       }});
}

void OptionTable::search_limits(engine::Limits& limits) {
  time_limit(limits);
  number("--node-limit", &limits.nodes, above(0),
         "maximum number of opened nodes, over all searches; several ranks exceed it by those that "
         "they open before each knows the sum")
      .stops(engine::Status::node_limit)
      .varies();
}

void OptionTable::resume(CheckpointChoice& choice, const std::string& help) {
  file(
      "--resume", choice.state, Role::state,
      fmt::format("state file of the run, with further files beside it. The first call creates it; "
                  "the same call resumes the run, or repeats its result, on any number of ranks{}",
                  help));
  duration("--resume-wait", choice.patience, at_least(0),
           "maximum waiting time for another run that uses this file")
      .needs("--resume")
      .varies();
  duration("--checkpoint-interval", choice.interval, above(0),
           "time between two saved states of a search")
      .varies();
}

void OptionTable::save_on(CheckpointChoice& choice) {
  word(
      "--save-on", {"interval", "improvement"}, "interval",
      [&choice](std::size_t word) { choice.on_improvement = word == 1; },
      "times at which the state is saved: at intervals, or also at each better solution")
      .varies();
}

void OptionTable::config(ConfigChoice& choice) {
  file("--config", choice.file, Role::input, "TOML file with defaults of options").varies();
  flag("--no-config", choice.none, "ignore all files with defaults").varies();
}

const OptionRow* OptionTable::find(std::string_view name) const {
  const auto found = std::ranges::find(rows_, name, &OptionRow::name);
  return found == rows_.end() ? nullptr : &*found;
}

void OptionTable::use_default(std::string_view name, double value) {
  std::ranges::find(rows_, name, &OptionRow::name)->default_value = fmt::format("{}", value);
}

std::vector<std::pair<std::string, std::string>> OptionTable::facts() const {
  std::vector<std::pair<std::string, std::string>> facts;
  for (const auto& row : rows_) {
    const bool is_file = row.role != Role::plain;
    if (!row.matters.value_or(!is_file || row.role == Role::evidence)) continue;
    if (row.given) {
      facts.emplace_back(row.name, is_file ? std::string() : as_fact(*row.given));
    } else if (!row.default_value.empty()) {
      facts.emplace_back(row.name, as_fact(row.default_value));
    }
  }
  return facts;
}

ordered_json OptionTable::asked() const {
  auto all = ordered_json::object();
  for (const auto& row : rows_) {
    if (!row.is_asked()) continue;
    auto key = row.name.substr(2);
    std::ranges::replace(key, '-', '_');
    const bool applies = row.needs.empty() || row.is_met_by(find(row.needs)->given);
    const auto text = row.given.value_or(applies ? row.default_value : std::string());
    if (row.value.empty())
      all[key] = row.given.has_value();
    else if (text.empty())
      all[key] = nullptr;
    else
      all[key] = row.typed ? row.typed(text) : ordered_json(text);
  }
  return all;
}

std::string OptionTable::call(const std::function<bool(const OptionRow&)>& leave_out) const {
  std::string text;
  for (const auto& row : rows_) {
    if (!row.given || leave_out(row)) continue;
    if (row.named()) text += ' ' + row.name;
    if (!row.value.empty()) text += ' ' + quoted(*row.given);
  }
  return text;
}

RowBuilder OptionTable::lines(bool& variable, const std::string& help) {
  return choice("--format", variable, {{"json", false}, {"jsonl", true}}, help)
      .needs("--output")
      .of_file();
}

void OptionTable::check_lines(std::initializer_list<std::string_view> excluded) const {
  const auto refuse = [](std::string_view option) {
    throw WrongInput(
        fmt::format("--format jsonl: is not possible with {}; expected --format json, or no {}",
                    option, option));
  };
  for (const auto option : excluded) {
    if (find(option)->given) refuse(option);
  }
  if (find("--output")->given == standard_output) refuse("--output -");
}

}  // namespace kusabi::run
