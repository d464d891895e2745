// share_work: independent pieces of work, distributed over all ranks as the leaves of a tree. Every
// rank gets all results, in the order of the pieces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "engine/expansion.hpp"
#include "engine/index_range.hpp"
#include "engine/transport/transport.hpp"
#include "engine/wire.hpp"

namespace kusabi::engine {

/// The pieces as a problem type.
/// @tparam Result Boost-serialisable
template <class Result>
class SharedWork {
 public:
  using Node = IndexRange;  ///< indices of pieces
  using Solution = Result;

  /// @param piece its result must depend on the index alone, not on the rank or the order
  SharedWork(std::uint64_t pieces, std::function<Result(std::uint64_t)> piece)
      : pieces_(pieces), piece_(std::move(piece)) {}

  Node root() const { return {0, pieces_}; }

  void expand(Node&& node, Expansion<SharedWork>& out) {
    if (!branch_into_halves(node, 1, out)) out.solution(piece_(node.first));
  }

 private:
  std::uint64_t pieces_;
  std::function<Result(std::uint64_t)> piece_;
};

/// Computes all pieces, whose results are packed; every rank makes the same call. @pre pieces > 0
std::vector<Bytes> share_packed_work(Transport& transport, std::uint64_t pieces,
                                     std::function<Bytes(std::uint64_t)> piece);

/// Computes all pieces; every rank makes the same call. @pre pieces > 0
template <class Result>
std::vector<Result> share_work(Transport& transport, std::uint64_t pieces,
                               const std::function<Result(std::uint64_t)>& piece) {
  std::vector<Result> results;
  if (transport.size() == 1) {
    for (std::uint64_t i = 0; i < pieces; ++i) results.push_back(piece(i));
    return results;
  }
  // One search, compiled once, serves all types of results.
  const auto packed = share_packed_work(transport, pieces,
                                        [&](std::uint64_t number) { return pack(piece(number)); });
  for (const auto& bytes : packed) results.push_back(unpack<Result>(bytes));
  return results;
}

}  // namespace kusabi::engine
