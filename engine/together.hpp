// What all ranks do together before, between and after their searches: what one of them knows is
// told to all, and all wait for each other. Every rank makes the same calls in the same order; none
// of them is for use during a search.
#pragma once

#include <cstdint>
#include <exception>
#include <optional>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "engine/survey.hpp"
#include "engine/transport/transport.hpp"
#include "engine/wire.hpp"

namespace kusabi::engine {

/// The ranks have not come to the same; thrown on every rank.
class Disagreement : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What `make` returns on rank 0, on every rank; nobody else calls it.
///
/// If it throws, the exception goes to the caller in a process that is alone; over MPI one line is
/// printed and all ranks end, since the others wait.
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

/// Returns when all ranks have come here, with what they brought, merged.
Survey meet(Transport& transport, const Survey& own = {});

/// Throws a Disagreement on every rank unless all bring the same number, say the fingerprint of
/// the problem that each has worked out by itself: machines of different kinds, or another build
/// on one of them, would search different trees.
void agree(Transport& transport, std::uint64_t fingerprint);

}  // namespace kusabi::engine
