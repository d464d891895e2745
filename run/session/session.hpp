// Session: a run of the command on one or many ranks, with or without MPI; rank 0 reads files and
// prints.
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

/// A single process or one rank of an MPI job. MPI is not called if the process was not started by
/// an MPI launcher or if `--serial` is among the arguments.
class Session {
 public:
  Session(int& argc, char**& argv);

  /// Error message if a launcher has started several processes that are not joined by MPI, so that
  /// each would do the whole work (run/session/launch.hpp). The text is empty on all processes but
  /// the first; these end without a message.
  [[nodiscard]] std::optional<std::string> fault_of_launch(bool serial);

  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session();

  [[nodiscard]] engine::Transport& transport();
  [[nodiscard]] int ranks() { return transport().size(); }

  /// True on rank 0, which reads files, prints and writes.
  [[nodiscard]] bool is_first() { return transport().rank() == 0; }

  /// Restricts warnings about the input and the call to the answer (--quiet).
  void silence_warnings() { silent_ = true; }
  [[nodiscard]] bool silent() const { return silent_; }

  /// Adds a warning about the input, to be repeated with the answer.
  void note(const std::string& warning) { warnings_.push_back(warning); }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

  /// Calls `prepare` on rank 0 and broadcasts its result, if any, so that all ranks have the same
  /// input even if their file systems differ. If it throws a WrongInput or a support::InputError,
  /// every rank throws a WrongInput with the same message.
  /// @tparam Prepare its result is Boost-serialisable, or void
  template <class Prepare>
  std::invoke_result_t<Prepare> from_first_rank(Prepare prepare);

 private:
  /// Result of `prepare` on rank 0, broadcast to every rank, or its WrongInput.
  engine::Bytes broadcast(const std::function<engine::Bytes()>& prepare);

  struct Mpi;  // hides mpi.h from the command
  std::unique_ptr<Mpi> mpi_;
  std::unique_ptr<engine::Transport> alone_;
  bool silent_ = false;
  std::vector<std::string> warnings_;
};

template <class Prepare>
std::invoke_result_t<Prepare> Session::from_first_rank(Prepare prepare) {
  using Value = std::invoke_result_t<Prepare>;
  if constexpr (std::is_void_v<Value>) {
    broadcast([&] {
      prepare();
      return engine::Bytes();
    });
  } else {
    std::optional<Value> own;
    const auto bytes = broadcast([&] {
      own.emplace(prepare());
      return ranks() == 1 ? engine::Bytes() : engine::pack(*own);
    });
    if (own) return *std::move(own);
    return engine::unpack<Value>(std::span<const char>(bytes.data(), bytes.size()));
  }
}

}  // namespace kusabi::run
