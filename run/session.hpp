// One run of the command on one or many ranks: MPI or not, who speaks, who reads files.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "engine/transport/transport.hpp"

namespace kusabi::run {

/// Something that rank 0 found wrong with the input or the call; thrown on every rank.
class WrongInput : public std::runtime_error {
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

  /// Whether `--serial` keeps one of several processes from joining its fellows: each would do the
  /// whole search.
  [[nodiscard]] static bool serial_among_many();

  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session();

  [[nodiscard]] engine::Transport& transport();
  [[nodiscard]] int ranks() { return transport().size(); }

  /// Rank 0 is the one that reads files, prints and writes.
  [[nodiscard]] bool speaks() { return transport().rank() == 0; }

  /// Calls `prepare` on rank 0 and gives its result to all ranks, so that they agree on what was
  /// read even if their file systems do not. If it throws a WrongInput or a problems::InputError,
  /// every rank throws a WrongInput that says the same.
  std::string on_first_rank(const std::function<std::string()>& prepare);

  /// Returns when all ranks have come here, with what they brought, merged. Not for use during a
  /// search.
  engine::Survey meet(const engine::Survey& own);

 private:
  struct Mpi;  // keeps mpi.h out of the command
  std::unique_ptr<Mpi> mpi_;
  std::unique_ptr<engine::Transport> alone_;
};

}  // namespace kusabi::run
