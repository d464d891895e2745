// Stages of a run, and the work common to all subcommands.
#include "run/command/command_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "answer/ending.hpp"
#include "answer/values.hpp"
#include "answer/verdict_json.hpp"
#include "answer/words.hpp"
#include "engine/collectives.hpp"
#include "engine/signals.hpp"
#include "engine/transport/mpi.hpp"
#include "run/output/output_file.hpp"
#include "run/output/standard_output.hpp"
#include "run/output/terminal_page.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"
#include "run/session/kept_state.hpp"
#include "run/session/progress_line.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::run {
namespace {

constexpr const char* status_ending = ".status";

}  // namespace

CommandRun::CommandRun(Session& session, const CommandList::Entry& entry, const Defaults& defaults)
    : session_(session),
      name_(entry.name()),
      command_(*entry.subcommand),
      table_(entry.table),
      defaults_(defaults),
      outputs_(entry.table) {
  const auto* const quiet = table_.find("--quiet");
  quiet_ = quiet != nullptr && quiet->given;
  if (quiet_) session_.silence_warnings();
  // Output on standard output is read by programs, so no table is printed.
  for (const auto& row : table_.rows())
    quiet_ = quiet_ || (row.role == Role::output && row.given == standard_output);
}

int CommandRun::execute() {
  check();
  if (auto* const limits = table_.ends_with_the_job()) limits->seconds = job_end_.read(session_);
  command_.read(*this);
  outputs_.open(session_, input());
  if (table_.limits() != nullptr) engine::install_signal_handlers();
  try {
    command_.prepare(*this);
  } catch (const support::Stopped&) {
    return stopped_before_the_search();
  }
  if (shows()) announce();
  command_.search(*this);
  std::uint64_t code = answer::solved;
  if (session_.is_first()) {
    auto steps = command_.results(*this);
    if (journal_options_) steps.insert(steps.begin(), [this] { write_status(); });
    do_all(steps);
    if (!quiet_) {
      for (const auto& name : outputs_.written()) print_message("wrote {}\n", name);
    }
    const auto reached = verdict();
    const auto exit = answer::exit_code(reached);
    print_open_reservations(reached);
    auto remarks = command_.remarks(*this);
    if (journal_options_ && reached.ended != engine::Status::solved)
      remarks.insert(remarks.begin(), how_to_go_on(reached.ended));
    for (const auto& remark : remarks) {
      if (exit == answer::solved) {
        print_message("{}\n", remark);
      } else {
        print_warning(remark);
      }
    }
    if (journal_ && exit == answer::solved) journal_->finish();
    code = static_cast<std::uint64_t>(exit);
  }
  // Reduction of a value of rank 0 only; the other ranks sleep until it has written.
  return static_cast<int>(
      engine::all_reduce(session_.transport(), {.ranks = 1, .found = code}).found);
}

// The end of the search, before long results are written: a job script knows it even if the process
// is killed meanwhile.
void CommandRun::write_status() const {
  OutputFile file("--resume", journal_options_->file + status_ending, input());
  file.stream() << answer::status_text(verdict()) << '\n';
  file.put_in_place();
}

answer::Verdict CommandRun::verdict() const {
  auto reached = command_.verdict();
  const auto& warnings = session_.warnings();
  reached.warnings.insert(reached.warnings.end(), warnings.begin(), warnings.end());
  return reached;
}

// True if a terminal shows the table and standard error.
bool CommandRun::shows_both_streams() const {
  const auto is_terminal = [](const Page& page) { return page.width != Page::endless; };
  return !quiet_ && is_terminal(page()) && is_terminal(page_of(STDERR_FILENO));
}

// Prints open reservations on standard error, unless the table shows them beside it.
void CommandRun::print_open_reservations(const answer::Verdict& verdict) const {
  if (shows_both_streams()) return;
  for (const auto& [sentence, open] : answer::reservations(verdict)) {
    if (open) print_warning(sentence);
  }
}

double CommandRun::seconds() const {
  const std::chrono::duration<double> since = std::chrono::steady_clock::now() - started_;
  return since.count();
}

// Lines about work of less than a second are left out.
support::LongWork CommandRun::long_work() {
  constexpr double minimum = 1;
  static constexpr std::chrono::seconds between_lines(2);
  support::LongWork work;
  if (const auto* const limits = table_.limits()) {
    work.stop = [this, until = std::max(limits->seconds, minimum)] {
      return engine::end_asked_by_signal() || seconds() >= until;
    };
  }
  if (shows()) {
    work.on_share = [this](const char* name, double share) {
      const auto now = std::chrono::steady_clock::now();
      if (now - last_line_ < between_lines) return;
      last_line_ = now;
      print_message("{}: {:.0f} %\n", name, 100 * share);
    };
  }
  return work;
}

int CommandRun::stopped_before_the_search() {
  if (session_.is_first()) {
    const auto why =
        engine::end_asked_by_signal() ? engine::Status::interrupted : engine::Status::time_limit;
    print_warning(fmt::format(
        "stopped early ({}) during the preparation of the problem: no results, no files",
        answer::status_name(why)));
  }
  return answer::stopped_early;
}

// Combinations are checked on the whole call, after defaults are added.
void CommandRun::check() const {
  try {
    command_.check();
  } catch (const WrongInput& error) {
    if (defaults_.taken.empty()) throw;
    throw WrongInput(fmt::format("{} ({})", error.what(), defaults_text()));
  }
}

// "defaults of config.toml: --mu 0.65 --sort margin"
std::string CommandRun::defaults_text() const {
  auto text = fmt::format("defaults of {}:", defaults_.file);
  for (const auto& [option, value] : defaults_.taken) {
    text += ' ' + option;
    if (!value.empty()) text += ' ' + quoted(value);
  }
  return text;
}

// The verdict, after all files are written, and the source of defaults, if any.
nlohmann::ordered_json CommandRun::last_members() const {
  const auto reached = verdict();
  auto all = nlohmann::ordered_json::object();
  all["verdict"] = answer::verdict_json(reached);
  all["warnings"] = reached.warnings;
  all.update(defaults_json());
  return all;
}

nlohmann::ordered_json CommandRun::defaults_json() const {
  auto all = nlohmann::ordered_json::object();
  if (defaults_.taken.empty()) return all;
  auto& config = all["config"];
  config["file"] = defaults_.file;
  for (const auto& [option, value] : defaults_.taken) config["options"][option.substr(2)] = value;
  return all;
}

// The first input file, which messages name.
std::string CommandRun::input() const {
  for (const auto& row : table_.rows()) {
    if (row.role == Role::input && !row.named() && row.given) return *row.given;
  }
  return {};
}

void CommandRun::announce() {
  const auto line = command_.announcement(answer::counted(session_.ranks(), "rank"));
  if (line.empty()) return;
  auto text = fmt::format("kusabi {} · {} · {}\n{}\n", KUSABI_VERSION, name_, input(), line);
  if (!defaults_.taken.empty()) text += defaults_text() + '\n';
  show_heading(folded(text, page().width));
}

// The call that resumes an analysis that stopped early.
std::string CommandRun::how_to_go_on(engine::Status why) const {
  const int ranks = session_.ranks();
  return fmt::format("resume with: {}kusabi {}{}",
                     ranks == 1 ? "" : fmt::format("mpirun -np {} ", ranks), name_,
                     table_.call([&](const OptionRow& row) { return row.stops == why; }));
}

void CommandRun::keep_state(const CheckpointChoice& choice, engine::Facts problem) {
  if (choice.state.empty()) return;
  engine::Facts facts{{"kusabi", KUSABI_VERSION}, {"command", std::string(name_)}};
  std::move(problem.begin(), problem.end(), std::back_inserter(facts));
  for (auto& fact : table_.facts()) facts.push_back(std::move(fact));
  support::Fingerprint facts_fingerprint;
  for (const auto& [name, value] : facts) {
    facts_fingerprint.add(name);
    facts_fingerprint.add(value);
  }
  kept_ = session_.from_first_rank([&] {
    journal_ = opened_journal(choice.state, facts, facts_fingerprint.value(), choice.patience);
    std::error_code none;
    std::filesystem::remove(choice.state + status_ending, none);
    for (const auto& line : journal_->warnings()) warn(line);
    if (journal_->is_finished() && !quiet_) print_message("{}: finished before\n", choice.state);
    return state_of(*journal_);
  });
  journal_options_ = engine::JournalOptions{.journal = journal_.get(),
                                            .file = choice.state,
                                            .interval = choice.interval,
                                            .on_improvement = choice.on_improvement,
                                            .facts_fingerprint = facts_fingerprint.value()};
}

engine::AnalysisOptions CommandRun::analysis_options(const engine::Limits& limits) {
  engine::Limits left = limits;
  left.seconds = std::max(0.0, limits.seconds - seconds());
  if (!job_end_.is_known() && command_.limit_includes_writing() && std::isfinite(left.seconds))
    job_end_.set(left.seconds);
  if (job_end_.is_known()) left.seconds = std::max(0.0, job_end_.remaining_seconds());
  auto result = run::analysis_options(kept_.finished ? engine::Limits{} : left, quiet_);
  if (job_end_.is_known() && session_.is_first()) {
    job_end_.reserve_time_to_write(
        [this](std::uint64_t found) { return command_.seconds_to_write(found); }, result);
  }
  if (kept_.finished) result.interrupt = {};  // too short to be stopped
  result.warn = warn;
  result.journal_options = journal_options_;
  return result;
}

namespace {

// Adds the members of an object, and the elements of equally long lists of objects to each other.
void complete(nlohmann::ordered_json& known, nlohmann::ordered_json more) {
  if (known.is_array() && more.is_array() && known.size() == more.size()) {
    for (std::size_t i = 0; i < known.size(); ++i) complete(known[i], std::move(more[i]));
  } else if (known.is_object() && more.is_object()) {
    for (auto& [key, value] : more.items()) complete(known[key], std::move(value));
  } else {
    known = std::move(more);
  }
}

}  // namespace

nlohmann::ordered_json CommandRun::head(nlohmann::ordered_json problem) const {
  const auto reached = verdict();
  return {{"command", name_},
          {"version", KUSABI_VERSION},
          {"problem", std::move(problem)},
          {"options", table_.asked()},
          {"status", answer::status_text(reached)},
          {"result", answer::answer_json(reached)}};
}

nlohmann::ordered_json CommandRun::result_json(nlohmann::ordered_json problem,
                                               nlohmann::ordered_json result,
                                               nlohmann::ordered_json statistics) const {
  auto json = head(std::move(problem));
  complete(json["result"], std::move(result));
  json["statistics"] = std::move(statistics);
  return json;
}

Step CommandRun::result(std::function<nlohmann::ordered_json()> make) {
  return result([make = std::move(make)](JsonWriter& json) { json.value(make()); });
}

Step CommandRun::result(std::function<void(JsonWriter&)> write) {
  return file("--output", [this, write = std::move(write)](std::ostream& out) {
    JsonWriter json(out, [this] { return last_members(); });
    write(json);
    out << '\n';
  });
}

Step CommandRun::result_lines(std::function<bool(std::ostream&)> write,
                              std::function<void()> done) {
  return [this, write = std::move(write), done = std::move(done)] {
    auto& out = outputs_.stream("--output");
    if (write(out)) {
      out << json_line(last_members()) << '\n';
      outputs_.put_in_place("--output");
    }
    done();
  };
}

Step CommandRun::answer(std::function<std::string()> make) {
  return [this, make = std::move(make)] {
    if (quiet_) return;
    auto reached = verdict();
    if (shows_both_streams()) reached.warnings.clear();  // they are above the table
    print_answer(folded(make() + conclusion_text(reached, page()), page().width));
  };
}

Page CommandRun::page() {
  return engine::MpiEnvironment::launched() ? Page{} : page_of(STDOUT_FILENO);
}

Step CommandRun::print(std::string text) {
  return [text = std::move(text)] { print_answer(text); };
}

}  // namespace kusabi::run
