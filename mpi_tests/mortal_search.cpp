// Test program of kill_restart_test.cpp: a search with checkpoints that kills itself, or sends
// itself a signal, at given events. It resumes from the checkpoint if there is one.
//
//   mortal_search STATE RESULT SECONDS [EVENT:RANK:COUNT]...
//
// STATE is the checkpoint, "-" for none, SECONDS its interval. RESULT receives the outcome when the
// whole tree is done: one text, the same for all runs. EVENT is an action of rank RANK ("-1": of
// each rank):
//   node      kills itself when it opens its COUNT-th node
//   disk      kills itself at its COUNT-th call of fsync or rename
//   term, int, usr1    sends itself the signal when it opens its COUNT-th node
//   wait      opens its COUNT-th node only after a signal has requested a checkpoint
//
// Exit codes: 0 done, 2 the checkpoint is refused, 3 stopped by a signal.
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "engine/checkpoint.hpp"
#include "engine/search.hpp"
#include "engine/signals.hpp"
#include "engine/transport/mpi.hpp"

namespace {

namespace engine = kusabi::engine;

struct Event {
  std::string kind;
  int rank = 0;
  std::uint64_t count = 0;  // 0: never
};

std::vector<Event> planned;  // events of this rank
std::uint64_t disk_calls = 0;

Event parsed(const std::string& text) {
  std::istringstream words(text);
  Event event;
  char colon = 0;
  std::getline(words, event.kind, ':');
  words >> event.rank >> colon >> event.count;
  return event;
}

void die_at_disk_call() {
  ++disk_calls;
  for (const auto& event : planned) {
    if (event.kind == "disk" && event.count == disk_calls) std::raise(SIGKILL);
  }
}

// The pending request of a signal, and a flag for any earlier one.
engine::Interrupt pending = engine::Interrupt::none;
bool heard = false;

void listen() {
  if (pending == engine::Interrupt::none) pending = engine::asked_by_signal();
  heard |= pending != engine::Interrupt::none;
}

engine::Interrupt asked() {
  listen();
  return std::exchange(pending, engine::Interrupt::none);
}

void wait_for_a_signal() {
  for (listen(); !heard; listen()) usleep(1000);
}

void happen_at_node(std::uint64_t opened) {
  for (const auto& event : planned) {
    if (event.count != opened) continue;
    if (event.kind == "node") std::raise(SIGKILL);
    if (event.kind == "term") std::raise(SIGTERM);
    if (event.kind == "int") std::raise(SIGINT);
    if (event.kind == "usr1") std::raise(SIGUSR1);
    if (event.kind == "wait") wait_for_a_signal();
  }
}

}  // namespace

// The engine's calls of these functions come here instead of to the C library, so that a kill can
// happen at each of them.
extern "C" int fsync(int descriptor) {
  die_at_disk_call();
  return static_cast<int>(syscall(SYS_fsync, descriptor));
}
extern "C" int rename(const char* from, const char* to) noexcept {
  die_at_disk_call();
  return renameat(AT_FDCWD, from, AT_FDCWD, to);
}

namespace {

// A random, uneven tree of 193,480 nodes of about ten microseconds each (in rounds, not by a
// clock). The result depends on every solution and every node.
class Tree {
 public:
  struct Node {
    std::uint64_t state = 0;
    std::uint32_t depth = 0;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& state& depth;
    }
  };
  using Solution = std::uint64_t;
  using Tally = std::uint64_t;

  Node root() const { return {engine::branch_hash(2, 0), 0}; }

  void expand(Node&& node, engine::Expansion<Tree>& out) {
    happen_at_node(++opened_);
    work_ += work(node.state);
    const auto children = node.depth == deepest ? 0 : node.depth < 3 ? 3 : (node.state >> 40U) & 3U;
    for (std::uint32_t child = 0; child < children; ++child) {
      out.branch({engine::branch_hash(node.state, child), node.depth + 1});
    }
    if (children == 0 && (node.state & 63U) == 0) out.solution(node.state);
  }

  /// Sum over the opened nodes, independent of the engine's own counts.
  Tally tally() const { return work_; }

 private:
  static constexpr std::uint32_t deepest = 22;

  static std::uint64_t work(std::uint64_t state) {
    for (std::uint32_t round = 0; round < 1500; ++round) state = engine::branch_hash(state, round);
    return state;
  }

  std::uint64_t opened_ = 0;
  std::uint64_t work_ = 0;
};

void write(const std::string& name, const engine::Outcome<Tree>& outcome) {
  std::ofstream file(name);
  file << "opened " << outcome.opened() << "\nfingerprint " << outcome.fingerprint() << "\nwork "
       << outcome.tally() << "\nsolutions " << outcome.solutions.size() << '\n';
  for (const auto& found : outcome.solutions) {
    for (const auto branch : found.path) file << branch << '.';
    file << ' ' << found.solution << '\n';
  }
  if (!file.flush()) std::abort();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return EXIT_FAILURE;
  const std::string state = argv[1];
  std::unique_ptr<engine::MpiEnvironment> mpi;
  std::unique_ptr<engine::Transport> transport = std::make_unique<engine::SingleProcess>();
  if (engine::MpiEnvironment::launched()) {
    mpi = std::make_unique<engine::MpiEnvironment>(argc, argv);
    transport = std::make_unique<engine::MpiTransport>();
  }

  engine::Options options;
  options.reduction_interval = 2e-3;
  options.interrupt = asked;
  options.warn = [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); };
  engine::install_signal_handlers();
  if (state != "-") {
    options.checkpoint.file = state;
    options.checkpoint.interval = std::atof(argv[3]);
    options.checkpoint.problem = 22;
    if (engine::checkpoint_exists(state)) {
      // Every rank reads the checkpoint itself: the files do not change before all ranks search.
      try {
        std::string warning;
        options.checkpoint.resume_from =
            engine::usable_checkpoint(state, *options.checkpoint.problem, warning);
      } catch (const engine::CheckpointError& error) {
        std::fprintf(stderr, "refused: %s\n", error.what());
        return 2;
      }
    }
    // Process of this rank, for kills from outside; it handles signals from now on.
    std::ofstream(state + ".pid." + std::to_string(transport->rank())) << getpid();
  }
  for (int i = 4; i < argc; ++i) {
    auto event = parsed(argv[i]);
    if (event.rank == -1 || event.rank == transport->rank()) planned.push_back(std::move(event));
  }

  Tree tree;
  const auto outcome = engine::search(tree, *transport, options);
  const bool done = outcome.status == engine::Status::solved;
  if (done && transport->rank() == 0) write(argv[2], outcome);
  transport.reset();  // before MPI ends
  return done ? EXIT_SUCCESS : 3;
}
