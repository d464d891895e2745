// The options of a subcommand in one table: what each is called, takes and means, and what it is
// unless given. Parsing, range checks, help, the manual page and the call that goes on from a
// checkpoint all come from the table (run/command/command_line).
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "engine/options.hpp"
#include "engine/statistics.hpp"
#include "run/command/config_choice.hpp"

namespace kusabi::run {

/// The numbers that an option takes.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool least_is_out = false;
  bool even = false;
};

/// All that are greater; all that are not smaller; those between two, with both.
constexpr Range above(double bound) {
  return {.least = bound, .least_is_out = true};
}
constexpr Range at_least(double bound) {
  return {.least = bound};
}
constexpr Range between(double least, double most) {
  return {.least = least, .most = most};
}

/// What others than the subcommand need to know of an option.
enum class Role {
  plain,
  input,       ///< a file that is read
  output,      ///< a file that is opened before the work begins, and written at its end
  folder,      ///< a folder that is there before the work begins, and filled at its end
  evidence,    ///< files that are written while ranks search
  checkpoint,  ///< the file that keeps the state of a search
  restart,     ///< the file that the search goes on from
  state,       ///< the file that keeps what is finished of a question
};

/// One option, or the file that a subcommand is called with.
struct OptionRow {
  std::string name;        ///< "--mu"; "file" if it has no name in the call
  std::string letter{};    ///< its short form, "-o"; empty: it has none
  std::string value{};     ///< what it takes: "NUMBER", "FILE", "a|b|c"; empty: nothing, a switch
  std::string range{};     ///< which of these, as help shows it: "> 0"
  std::string expected{};  ///< the same as errors say it: "a number above 0"
  std::vector<std::string> words{};  ///< the choices, if it takes one of some words
  std::string unit{};                ///< of a number
  std::string usual{};               ///< what it is unless given; empty: nothing
  std::string help{};
  bool required = false;
  std::string needs{};  ///< an option without which it means nothing
  Role role = Role::plain;
  std::vector<std::string> endings{""};  ///< of its files' names
  /// How a search ends that it stops: who goes on from there does not want to stop there again.
  std::optional<engine::Status> stops{};
  /// Whether runs that go on with each other must have it alike: what is computed depends on it.
  /// Unless said, this holds for plain options and for evidence.
  std::optional<bool> matters{};
  /// Takes what the call has. @return what is wrong with it, empty if nothing is
  std::function<std::string(const std::string& text)> take{};
  std::optional<std::string> given{};  ///< what the call has

  [[nodiscard]] bool named() const { return name.starts_with('-'); }
  /// As a call may have it: {"-o", "--output"}.
  [[nodiscard]] std::vector<std::string> names() const {
    return letter.empty() ? std::vector{name} : std::vector{letter, name};
  }
};

/// A row that is being described.
class RowBuilder {
 public:
  explicit RowBuilder(OptionRow& row) : row_(row) {}
  RowBuilder& letter(std::string letter) { return row_.letter = std::move(letter), *this; }
  RowBuilder& required() { return row_.required = true, *this; }
  RowBuilder& needs(std::string option) { return row_.needs = std::move(option), *this; }
  RowBuilder& unit(std::string unit) { return row_.unit = std::move(unit), *this; }
  RowBuilder& stops(engine::Status how) { return row_.stops = how, *this; }
  /// A run that goes on with another need not have it alike.
  RowBuilder& varies() { return row_.matters = false, *this; }
  /// Or must, though it is a file.
  RowBuilder& matters() { return row_.matters = true, *this; }
  /// Who asks for a range of it is told of `kusabi sweep`.
  RowBuilder& swept();
  /// The files' names are what the call has and one of these.
  RowBuilder& ends_in(std::vector<std::string> endings) {
    return row_.endings = std::move(endings), *this;
  }

 private:
  OptionRow& row_;
};

/// A variable that takes a number. If it is empty, the greatest of its type or out of range before
/// the call is read, it has no usual value.
using NumberOption = std::variant<double*, std::optional<double>*, int*, unsigned*, std::uint64_t*>;

/// Where checkpoints are kept and found.
struct CheckpointChoice {
  std::string file;       ///< keep the state here; empty: where `restart` is, if that is anywhere
  double interval = 600;  ///< seconds between two
  bool on_improvement = false;  ///< and one whenever a better solution is found
  std::string restart;          ///< go on from here; empty: start anew
  std::string state;            ///< of --resume: go on from here or begin; empty: neither
  double patience = 30;         ///< seconds to wait for a state that another run has

  [[nodiscard]] const std::string& kept_in() const { return file.empty() ? restart : file; }
};

/// A word of a call, as a shell has to have it.
std::string quoted(const std::string& word);

class OptionTable {
 public:
  /// A number. @param name with its dashes
  RowBuilder number(std::string name, NumberOption variable, Range range, std::string help);

  /// One of some words, each of which stands for a value.
  template <std::copyable T>
  RowBuilder choice(const std::string& name, T& variable,
                    const std::vector<std::pair<std::string, T>>& words, const std::string& help) {
    std::vector<std::string> names;
    std::vector<T> values;
    std::string usual;
    for (const auto& [word, value] : words) {
      if (value == variable) usual = word;
      names.push_back(word);
      values.push_back(value);
    }
    return word(
        name, std::move(names), std::move(usual),
        [&variable, values](std::size_t at) { variable = values[at]; }, help);
  }

  /// A switch, which sets the variable to `on`.
  RowBuilder flag(std::string name, bool& variable, std::string help, bool on = true);

  /// The name of a file, or of a folder.
  RowBuilder file(std::string name, std::string& variable, Role role, std::string help);

  /// Any text. @param value what help calls it
  RowBuilder text(std::string name, std::string& variable, const std::string& value,
                  std::string help);

  // What several subcommands have alike.
  void output(std::string help = "write the result to this JSON file");
  void further_output(std::string name, std::string help);
  void quiet(std::string help = "print errors only");
  void serial();
  void time_limit(engine::Limits& limits);
  void node_limit(engine::Limits& limits);
  void checkpoints(CheckpointChoice& choice);  ///< with --resume
  void resume(CheckpointChoice& choice, const std::string& help = "");
  void save_on(CheckpointChoice& choice);  ///< of searches for the best
  void config(ConfigChoice& choice);

  [[nodiscard]] const std::deque<OptionRow>& rows() const { return rows_; }
  [[nodiscard]] std::deque<OptionRow>& rows() { return rows_; }
  /// The row of that name; null if there is none.
  [[nodiscard]] const OptionRow* find(std::string_view name) const;

  /// What the options say of what is computed: those that matter, with what was given or is usual.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> facts() const;

  /// What is to end with the job of the batch system; null if nothing is.
  [[nodiscard]] engine::Limits* ends_with_the_job() const { return ends_with_the_job_; }

  /// What --time-limit is stored in; null if there is no such option.
  [[nodiscard]] const engine::Limits* limits() const { return limits_; }

  /// The options as they were given, ready for a shell; those for which `leave_out` holds are not
  /// among them.
  [[nodiscard]] std::string call(const std::function<bool(const OptionRow&)>& leave_out) const;

 private:
  RowBuilder add(OptionRow row);
  RowBuilder word(std::string name, std::vector<std::string> words, std::string usual,
                  std::function<void(std::size_t)> take, std::string help);

  std::deque<OptionRow> rows_;  // which stay where they are
  // What nobody asks for but by `OptionRow::given`.
  bool switched_ = false;
  std::string named_;
  engine::Limits* ends_with_the_job_ = nullptr;
  const engine::Limits* limits_ = nullptr;
};

}  // namespace kusabi::run
