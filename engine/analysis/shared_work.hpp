// share_work: independent pieces of work, distributed over all ranks as the leaves of a tree. Every
// rank gets all results, in the order of the pieces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/index_range.hpp"
#include "engine/search.hpp"
#include "engine/together.hpp"

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
    if (node.size() == 1) {
      out.solution(piece_(node.first));
      return;
    }
    const auto [lower, upper] = node.halves();
    out.branch(lower);
    out.branch(upper);
  }

 private:
  std::uint64_t pieces_;
  std::function<Result(std::uint64_t)> piece_;
};

/// Computes all pieces; every rank makes the same call. @pre pieces > 0
template <class Result>
std::vector<Result> share_work(Transport& transport, std::uint64_t pieces,
                               std::function<Result(std::uint64_t)> piece) {
  std::vector<Result> results;
  if (transport.size() == 1) {
    for (std::uint64_t i = 0; i < pieces; ++i) results.push_back(piece(i));
    return results;
  }
  SharedWork<Result> work(pieces, std::move(piece));
  auto outcome = search(work, transport);
  return from_first_rank(transport, [&] {
    for (auto& found : outcome.solutions) results.push_back(std::move(found.solution));
    return std::move(results);
  });
}

}  // namespace kusabi::engine
