// MpiTransport: messages by MPI_Isend and probing, reductions by MPI_Iallreduce.
#include "engine/transport/mpi.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <stdexcept>
#include <vector>

#include <unistd.h>

#include "engine/detail/contract.hpp"
#include "engine/transport/reason.hpp"

namespace kusabi::engine {
namespace {

// User-defined MPI operation of a reduction wave: into[i] := from[i] merged with into[i].
void merge_reductions(void* from, void* into, int* count, MPI_Datatype* /*type*/) {
  const std::span sources(static_cast<const Reduction*>(from), static_cast<std::size_t>(*count));
  const std::span targets(static_cast<Reduction*>(into), static_cast<std::size_t>(*count));
  for (std::size_t i = 0; i < targets.size(); ++i) targets[i].merge(sources[i]);
}

// All ranks on this machine, this one included.
std::vector<int> ranks_of_machine(MPI_Comm communicator, int rank) {
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  int size = 1;
  MPI_Comm_size(machine, &size);
  std::vector<int> ranks(static_cast<std::size_t>(size));
  MPI_Allgather(&rank, 1, MPI_INT, ranks.data(), 1, MPI_INT, machine);
  MPI_Comm_free(&machine);
  return ranks;
}

int message_length(const Bytes& body) {
  // Transfers and reports are split long before this size.
  if (body.size() > 0x7FFFFFFFU) throw std::length_error("a message of 2 GiB or more");
  return static_cast<int>(body.size());
}

}  // namespace

MpiEnvironment::MpiEnvironment(int& argc, char**& argv) {
  MPI_Init(&argc, &argv);
}

MpiEnvironment::~MpiEnvironment() {
  MPI_Finalize();
}

bool MpiEnvironment::launched() {
  constexpr std::array launcher_variables{"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"};
  return std::any_of(launcher_variables.begin(), launcher_variables.end(),
                     [](const char* name) { return std::getenv(name) != nullptr; });
}

MpiTransport::MpiTransport(MPI_Comm communicator) {
  for (auto& messages : messages_) MPI_Comm_dup(communicator, &messages);
  MPI_Comm_dup(communicator, &reductions_);
  MPI_Comm_rank(reductions_, &rank_);
  MPI_Comm_size(reductions_, &size_);
  machine_ = ranks_of_machine(reductions_, rank_);
  // Of the machine's cores, not of those to which the launcher bound this rank.
  oversubscribed_ = static_cast<long>(machine_.size()) > sysconf(_SC_NPROCESSORS_ONLN);
  std::erase(machine_, rank_);
  MPI_Type_contiguous(static_cast<int>(sizeof(Reduction)), MPI_BYTE, &reduction_type_);
  MPI_Type_commit(&reduction_type_);
  MPI_Op_create(&merge_reductions, 1, &merge_);
}

MpiTransport::~MpiTransport() {
  // After a search all messages have been received, so this does not block.
  for (auto& sent : outgoing_) MPI_Wait(&sent.request, MPI_STATUS_IGNORE);
  MPI_Op_free(&merge_);
  MPI_Type_free(&reduction_type_);
  MPI_Comm_free(&reductions_);
  for (auto& messages : messages_) MPI_Comm_free(&messages);
}

void MpiTransport::send(int to, MessageTag tag, Bytes body) {
  ensure(to != rank_, "no rank sends to itself");
  auto& sent = outgoing_.emplace_back(Outgoing{std::move(body), MPI_REQUEST_NULL});
  MPI_Isend(sent.body.data(), message_length(sent.body), MPI_BYTE, to, static_cast<int>(tag),
            messages_[search_], &sent.request);
}

std::optional<Message> MpiTransport::receive() {
  if (!outgoing_.empty()) release_sent();
  int arrived = 0;
  MPI_Message handle = MPI_MESSAGE_NULL;
  MPI_Status status;
  MPI_Improbe(MPI_ANY_SOURCE, MPI_ANY_TAG, messages_[search_], &arrived, &handle, &status);
  if (arrived == 0) return std::nullopt;
  int length = 0;
  MPI_Get_count(&status, MPI_BYTE, &length);
  Message message{status.MPI_SOURCE, static_cast<MessageTag>(status.MPI_TAG),
                  Bytes(static_cast<std::size_t>(length))};
  MPI_Mrecv(message.body.data(), length, MPI_BYTE, &handle, MPI_STATUS_IGNORE);
  return message;
}

void MpiTransport::release_sent() {
  constexpr std::size_t batch = 16;
  for (auto tests = std::min(batch, outgoing_.size()); tests > 0; --tests) {
    int done = 0;
    MPI_Test(&outgoing_.front().request, &done, MPI_STATUS_IGNORE);
    if (done != 0) {
      outgoing_.pop_front();
    } else {
      outgoing_.splice(outgoing_.end(), outgoing_, outgoing_.begin());
    }
  }
}

void MpiTransport::join_reduction(const Reduction& own) {
  ensure(wave_ == MPI_REQUEST_NULL,
         "a rank joins a reduction only after it has fetched the one before");
  own_ = own;
  MPI_Iallreduce(&own_, &merged_, 1, reduction_type_, merge_, reductions_, &wave_);
}

std::optional<Reduction> MpiTransport::reduction() {
  if (wave_ == MPI_REQUEST_NULL) return std::nullopt;
  int done = 0;
  MPI_Test(&wave_, &done, MPI_STATUS_IGNORE);
  if (done == 0) return std::nullopt;
  return merged_;
}

void MpiTransport::abandon(const std::string& reason) {
  std::fflush(stdout);
  std::fprintf(stderr, "rank %d of %d: %s\n", rank_, size_, reason_of(reason).c_str());
  std::fflush(stderr);
  MPI_Abort(reductions_, EXIT_FAILURE);
  std::abort();  // MPI_Abort does not return, but is not declared so
}

void MpiTransport::broadcast(Bytes& bytes) {
  auto length = static_cast<unsigned long long>(bytes.size());
  MPI_Bcast(&length, 1, MPI_UNSIGNED_LONG_LONG, 0, reductions_);
  bytes.resize(length);
  // MPI counts in int; a broadcast may be longer.
  constexpr std::size_t maximum = std::size_t{1} << 30U;
  for (std::size_t from = 0; from < bytes.size(); from += maximum) {
    MPI_Bcast(bytes.data() + from, static_cast<int>(std::min(maximum, bytes.size() - from)),
              MPI_BYTE, 0, reductions_);
  }
}

void MpiTransport::complete(std::span<double> numbers, std::span<const std::size_t> ends) {
  std::vector<int> counts;
  std::vector<int> offsets;
  std::size_t begin = 0;
  for (const auto end : ends) {
    counts.push_back(static_cast<int>(end - begin));
    offsets.push_back(static_cast<int>(begin));
    begin = end;
  }
  ensure(begin == numbers.size() && begin <= 0x7FFFFFFFU, "the ranks' parts make up the array");
  MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, numbers.data(), counts.data(), offsets.data(),
                 MPI_DOUBLE, reductions_);
}

}  // namespace kusabi::engine
