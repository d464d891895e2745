// One run of the command on one or many ranks: MPI or not, who speaks, who reads files.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <boost/serialization/string.hpp>

#include "engine/transport/transport.hpp"
#include "engine/wire.hpp"
#include "run/output/wrong_input.hpp"

namespace kusabi::run {

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

  /// The warnings of the input, which belong to its answer.
  void note(const std::string& warning) { warnings_.push_back(warning); }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

  /// Calls `prepare` on rank 0 and gives its result, if any, to all ranks, so that they agree on
  /// what was read even if their file systems do not. If it throws a WrongInput or a
  /// support::InputError, every rank throws a WrongInput that says the same.
  /// @tparam Prepare its result is Boost-serialisable, or void
  template <class Prepare>
  std::invoke_result_t<Prepare> from_first_rank(Prepare prepare);

 private:
  /// What `prepare` returns on rank 0, on every rank, or its WrongInput.
  engine::Bytes told(const std::function<engine::Bytes()>& prepare);

  struct Mpi;  // keeps mpi.h out of the command
  std::unique_ptr<Mpi> mpi_;
  std::unique_ptr<engine::Transport> alone_;
  std::vector<std::string> warnings_;
};

template <class Prepare>
std::invoke_result_t<Prepare> Session::from_first_rank(Prepare prepare) {
  using Value = std::invoke_result_t<Prepare>;
  if constexpr (std::is_void_v<Value>) {
    told([&] {
      prepare();
      return engine::Bytes();
    });
  } else {
    std::optional<Value> own;
    const auto bytes = told([&] {
      own.emplace(prepare());
      return ranks() == 1 ? engine::Bytes() : engine::pack(*own);
    });
    if (own) return *std::move(own);
    return engine::unpack<Value>(std::span<const char>(bytes.data(), bytes.size()));
  }
}

}  // namespace kusabi::run
