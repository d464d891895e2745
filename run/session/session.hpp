// One run of the command on one or many ranks: MPI or not, who speaks, who reads files.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "engine/transport/transport.hpp"
#include "run/output/wrong_input.hpp"

namespace kusabi::run {

/// The ranks have not come to the same; thrown on every rank.
class Disagreement : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Whether the command runs alone or as one rank of an MPI job.
///
/// It runs alone, without a call of MPI, if it was not started by an MPI launcher or if
/// `--serial` is among the arguments.
class Session {
 public:
  Session(int& argc, char**& argv);

  /// Whether a launcher has started several processes that are not joined, so that each would do
  /// the whole work (run/session/launch.hpp); what to say of it, but only on the first of them. An
  /// empty text: the others say nothing, but must not go on.
  [[nodiscard]] std::optional<std::string> fault_of_launch(bool serial);

  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session();

  [[nodiscard]] engine::Transport& transport();
  [[nodiscard]] int ranks() { return transport().size(); }

  /// Rank 0 is the one that reads files, prints and writes.
  [[nodiscard]] bool speaks() { return transport().rank() == 0; }

  /// Calls `prepare` on rank 0 and gives its result to all ranks, so that they agree on what was
  /// read even if their file systems do not. If it throws a WrongInput or a support::InputError,
  /// every rank throws a WrongInput that says the same.
  std::string on_first_rank(const std::function<std::string()>& prepare);

  /// Throws a Disagreement on every rank unless all bring the same number, say the fingerprint of
  /// the problem that each has worked out by itself: machines of different kinds, or another build
  /// on one of them, would search different trees. Not for use during a search.
  void agree(std::uint64_t fingerprint);

  /// Returns when all ranks have come here, with what they brought, merged. Not for use during a
  /// search.
  engine::Survey meet(const engine::Survey& own);

 private:
  struct Mpi;  // keeps mpi.h out of the command
  std::unique_ptr<Mpi> mpi_;
  std::unique_ptr<engine::Transport> alone_;
};

}  // namespace kusabi::run
