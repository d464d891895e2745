// MpiTransport: transport between the ranks of an MPI job.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <list>
#include <span>

#include <mpi.h>

#include "engine/transport/exchange.hpp"
#include "engine/transport/transport.hpp"

namespace kusabi::engine {

/// MPI_Init and MPI_Finalize as an RAII object. Threads are not used.
class MpiEnvironment {
 public:
  MpiEnvironment(int& argc, char**& argv);
  MpiEnvironment(const MpiEnvironment&) = delete;
  MpiEnvironment& operator=(const MpiEnvironment&) = delete;
  ~MpiEnvironment();

  /// True if an MPI launcher started this process (Open MPI's mpirun, or any that uses PMI or
  /// PMIx). It reads the environment and makes no MPI call.
  static bool launched();
};

/// Non-blocking messages with owned buffers, and non-blocking reductions.
///
/// @pre MPI is initialised, and every rank of `communicator` constructs one. The communicator is
///     duplicated, so that messages of others are not received here.
class MpiTransport final : public Transport, public Exchange {
 public:
  explicit MpiTransport(MPI_Comm communicator = MPI_COMM_WORLD);
  ~MpiTransport() override;

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return size_; }
  /// The system clock, which all ranks of one machine share. MPI_Wtime is not used, since Open MPI
  /// counts it from the first call in each process.
  [[nodiscard]] double now() const override {
    const auto since_boot = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(since_boot).count();
  }

  void begin_search() override { search_ = 1 - search_; }
  [[nodiscard]] bool oversubscribed() const override { return oversubscribed_; }
  [[nodiscard]] std::vector<int> machine() const override { return machine_; }
  void send(int to, MessageTag tag, Bytes body) override;
  std::optional<Message> receive() override;
  void join_reduction(const Reduction& own) override;
  std::optional<Reduction> reduction() override;

  /// Prints one line and ends all ranks with exit code 1 (MPI_Abort): a rank deep in a long
  /// computation cannot be reached otherwise.
  [[noreturn]] void abandon(const std::string& reason) override;

  void broadcast(Bytes& bytes) override;
  void complete(std::span<double> numbers, std::span<const std::size_t> ends) override;

 private:
  struct Outgoing {
    Bytes body;
    MPI_Request request;
  };

  // Releases some of the messages that are sent; the rest are tested at the next calls, in turn.
  void release_sent();

  // Of searches with odd and even numbers. Ranks are at most one search apart, since none ends
  // before all have begun it.
  std::array<MPI_Comm, 2> messages_{MPI_COMM_NULL, MPI_COMM_NULL};
  std::size_t search_ = 0;
  bool oversubscribed_ = false;
  std::vector<int> machine_;  // the other ranks on this machine
  MPI_Comm reductions_ = MPI_COMM_NULL;
  MPI_Datatype reduction_type_ = MPI_DATATYPE_NULL;
  MPI_Op merge_ = MPI_OP_NULL;
  int rank_ = 0;
  int size_ = 1;
  std::list<Outgoing> outgoing_;
  Reduction own_;
  Reduction merged_;
  MPI_Request wave_ = MPI_REQUEST_NULL;
};

}  // namespace kusabi::engine
