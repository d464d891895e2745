// Collective operations between searches: broadcast, reduction and agreement. Every rank makes the
// same calls in the same order; none of them may be used during a search.
#pragma once

#include <cstdint>
#include <exception>
#include <optional>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "engine/reduction.hpp"
#include "engine/transport/transport.hpp"
#include "engine/wire.hpp"

namespace kusabi::engine {

/// Ranks with different results where equal ones are required; thrown on every rank.
class RankMismatch : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Broadcast of the result of `make`, which only rank 0 calls.
///
/// If `make` throws in a process without other ranks, the exception goes to the caller; over MPI
/// one line is printed and all ranks end, since the others wait.
/// @tparam Make its result is Boost-serialisable
template <class Make>
std::invoke_result_t<Make> from_first_rank(Transport& transport, Make make) {
  using Value = std::invoke_result_t<Make>;
  if (transport.size() == 1) return make();
  Bytes bytes;
  std::optional<Value> own;
  if (transport.rank() == 0) {
    try {
      own.emplace(make());
      bytes = pack(*own);
    } catch (const std::exception& error) {
      transport.abandon(error.what());
      throw;
    }
  }
  transport.broadcast(bytes);
  if (own) return *std::move(own);
  return unpack<Value>(std::span<const char>(bytes.data(), bytes.size()));
}

/// Merges the contributions of all ranks. Blocks until every rank has called it.
Reduction all_reduce(Transport& transport, const Reduction& own = {});

/// Requires the same fingerprint on all ranks, for example of a problem that each rank has
/// computed: machines of different kinds, or different builds, could search different trees.
/// @throws RankMismatch on every rank if the fingerprints differ
void require_equal_on_all_ranks(Transport& transport, std::uint64_t fingerprint);

}  // namespace kusabi::engine
