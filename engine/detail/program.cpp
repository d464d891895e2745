// A program around a search: MPI, state to resume from, progress and summary.
#include "engine/detail/program.hpp"

#include <cmath>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "engine/checkpoint.hpp"
#include "engine/collectives.hpp"
#include "engine/node_record.hpp"
#include "engine/path.hpp"
#include "engine/signals.hpp"
#include "engine/transport/single_process.hpp"

namespace kusabi::engine {
namespace {

constexpr double seconds_between_lines = 2;

// FNV-1a over the characters, mixed into what was hashed before.
std::uint64_t hash_of(std::uint64_t before, const std::string& text) {
  for (const char character : text)
    before = (before ^ static_cast<unsigned char>(character)) * 0x100000001B3U;
  return branch_hash(before, static_cast<std::uint32_t>(text.size()));
}

const char* reason(Status status) {
  switch (status) {
    case Status::solved:
      return "the whole tree is searched";
    case Status::time_limit:
      return "stopped at the time limit";
    case Status::node_limit:
      return "stopped at the node limit";
    case Status::solution_limit:
      return "stopped at the limit of solutions";
    case Status::gap_limit:
      return "stopped within the gap";
    case Status::interrupted:
      return "stopped by a signal";
  }
  return "";
}

}  // namespace

Program::Program(int& argc, char**& argv, ProblemKind kind, const Options& options) {
  if (MpiEnvironment::launched()) {
    mpi_.emplace(argc, argv);
    transport_ = std::make_unique<MpiTransport>();
  } else {
    transport_ = std::make_unique<SingleProcess>();
  }
  begun_ = transport_->now();
  try {
    line_ = read_command_line(argc, argv, kind, options);
  } catch (const std::invalid_argument& wrong) {
    if (is_first()) std::cerr << "error: " << wrong.what() << '\n';
    exit_code_ = 2;
    return;
  }
  if (line_.help.empty()) return;
  if (is_first()) std::cout << line_.help;
  exit_code_ = 0;
}

void Program::prepare(const std::string& type, std::uint64_t instance) {
  auto& checkpoint = line_.options.checkpoint;
  std::uint64_t problem = hash_of(instance, type);
  if (instance == 0) {
    for (const auto& word : line_.words) problem = hash_of(problem, word);
  }
  require_equal_on_all_ranks(*transport_, problem);
  checkpoint.problem = problem;
  checkpoint.file = line_.resume;
  if (!line_.resume.empty()) {
    checkpoint.resume_from = from_first_rank(*transport_, [&] {
      if (!checkpoint_exists(line_.resume)) return std::string();
      std::string warning;
      auto usable = usable_checkpoint(line_.resume, problem, warning);
      if (!warning.empty()) std::cerr << "warning: " << warning << '\n';
      return usable;
    });
  }
  if (!line_.record.empty()) record_tree();
  install_signal_handlers();
  if (!line_.options.interrupt) line_.options.interrupt = asked_by_signal;
  if (!line_.options.warn)
    line_.options.warn = [](const std::string& line) { std::cerr << "warning: " << line << '\n'; };
  if (!line_.quiet && !line_.options.progress)
    line_.options.progress = [this](const Progress& progress) { show(progress); };
}

void Program::record_tree() {
  if (transport_->size() > 1) {
    throw std::invalid_argument("--record: the search has " + std::to_string(transport_->size()) +
                                " ranks; expected one process");
  }
  recording_.open(line_.record);
  recording_ << node_record_header;
  if (!recording_) {
    throw std::invalid_argument("--record: " + line_.record +
                                " cannot be written; expected a file in an existing folder");
  }
  line_.options.record = [this](std::size_t depth, double seconds) {
    write_node_record(recording_, depth, seconds);
  };
}

double Program::seconds() const {
  return transport_->now() - begun_;
}

void Program::show(const Progress& progress) {
  if (progress.seconds - shown_ < seconds_between_lines) return;
  shown_ = progress.seconds;
  std::ostringstream line;
  line << std::llround(progress.seconds) << " s: " << progress.opened << " nodes opened, "
       << progress.open << " open, " << progress.found << " found, " << std::fixed;
  line.precision(1);
  line << 100 * progress.closed << " % of the tree";
  if (std::isfinite(progress.objective)) {
    line << std::defaultfloat;
    line.precision(8);
    line << "; objective " << progress.objective;
    if (std::isfinite(progress.bound)) line << ", bound " << progress.bound;
  }
  std::cerr << line.str() << '\n';
}

int Program::finish(const End& end) {
  const bool solved = end.status == Status::solved || end.status == Status::gap_limit;
  if (recording_.is_open() && end.status != Status::solved) recording_ << incomplete_record << '\n';
  if (recording_.is_open() && !recording_.flush()) {
    throw std::runtime_error("--record: " + line_.record + " cannot be written; expected space");
  }
  if (is_first()) {
    std::cout.flush();
    if (!line_.quiet) {
      const int ranks = transport_->size();
      std::cerr << reason(end.status) << ": " << end.opened << " nodes opened";
      if (end.open > 0) std::cerr << ", " << end.open << " left open";
      std::cerr << "; " << ranks << (ranks == 1 ? " rank, " : " ranks, ") << seconds() << " s\n";
      if (!solved && end.saved) std::cerr << "the same call resumes from " << line_.resume << '\n';
      if (recording_.is_open() && end.status != Status::solved)
        std::cerr << line_.record << " has the nodes opened before the early end only\n";
    }
    if (end.status == Status::solved && !line_.resume.empty()) remove_checkpoint(line_.resume);
  }
  return from_first_rank(*transport_, [&] { return !std::cout ? 1 : solved ? 0 : 3; });
}

}  // namespace kusabi::engine
