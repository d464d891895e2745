// The transport between the ranks of an MPI job.
#pragma once

#include <chrono>
#include <list>

#include <mpi.h>

#include "engine/transport/transport.hpp"

namespace kusabi::engine {

/// MPI_Init and MPI_Finalize as one object's life. Threads are not used.
class MpiEnvironment {
 public:
  MpiEnvironment(int& argc, char**& argv);
  MpiEnvironment(const MpiEnvironment&) = delete;
  MpiEnvironment& operator=(const MpiEnvironment&) = delete;
  ~MpiEnvironment();

  /// Whether this process was started by an MPI launcher (Open MPI's mpirun, or any that speaks
  /// PMI or PMIx), told from the environment without a call of MPI.
  static bool launched();
};

/// Non-blocking messages with owned buffers, and surveys by a non-blocking reduction.
///
/// Requires: MPI is initialised, and every rank of `communicator` makes one. The communicator is
/// duplicated, so messages of others cannot be mistaken for ours.
class MpiTransport final : public Transport {
 public:
  explicit MpiTransport(MPI_Comm communicator = MPI_COMM_WORLD);
  ~MpiTransport() override;

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return size_; }
  /// The system's clock, which all ranks of one machine share, and not MPI_Wtime, which Open MPI
  /// counts from the first call in each process.
  [[nodiscard]] double now() const override {
    const auto since_boot = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(since_boot).count();
  }

  void send(int to, Tag tag, Bytes body) override;
  std::optional<Message> receive() override;
  void join_survey(const Survey& own) override;
  std::optional<Survey> survey() override;

  /// Prints one line and ends all ranks with exit code 1 (MPI_Abort): a rank that is deep in a long
  /// computation could not be told in any other way.
  [[noreturn]] void abandon(const std::string& reason) override;

  void broadcast(Bytes& bytes) override;

 private:
  struct Outgoing {
    Bytes body;
    MPI_Request request;
  };

  void release_sent();

  MPI_Comm messages_ = MPI_COMM_NULL;
  MPI_Comm surveys_ = MPI_COMM_NULL;
  MPI_Datatype survey_type_ = MPI_DATATYPE_NULL;
  MPI_Op merge_ = MPI_OP_NULL;
  int rank_ = 0;
  int size_ = 1;
  std::list<Outgoing> outgoing_;
  Survey own_;
  Survey merged_;
  MPI_Request wave_ = MPI_REQUEST_NULL;
};

}  // namespace kusabi::engine
