// A list of independent pieces of work, done by all ranks: a tree whose leaves are the pieces, so
// that the engine shares them. Every rank gets all results, in the order of the pieces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/search.hpp"
#include "run/session.hpp"

namespace kusabi::run {

/// The problem type that engine::search searches.
/// @tparam Result Boost-serialisable
template <class Result>
class SharedWork {
 public:
  /// Pieces `first` to `last` - 1.
  struct Node {
    std::uint64_t first = 0;
    std::uint64_t last = 0;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& first& last;
    }
  };
  using Solution = Result;

  /// @param piece must hang on its number alone, whatever rank it is done on and in what order
  SharedWork(std::uint64_t pieces, std::function<Result(std::uint64_t)> piece)
      : pieces_(pieces), piece_(std::move(piece)) {}

  Node root() const { return {0, pieces_}; }

  void expand(Node&& node, engine::Expansion<SharedWork>& out) {
    if (node.last - node.first == 1) {
      out.solution(piece_(node.first));
      return;
    }
    const auto middle = node.first + (node.last - node.first) / 2;
    out.branch({node.first, middle});
    out.branch({middle, node.last});
  }

 private:
  std::uint64_t pieces_;
  std::function<Result(std::uint64_t)> piece_;
};

/// Does all pieces; every rank makes the same call. @pre pieces > 0
template <class Result>
std::vector<Result> share_work(Session& session, std::uint64_t pieces,
                               std::function<Result(std::uint64_t)> piece) {
  std::vector<Result> results;
  if (session.ranks() == 1) {
    for (std::uint64_t i = 0; i < pieces; ++i) results.push_back(piece(i));
    return results;
  }
  SharedWork<Result> work(pieces, std::move(piece));
  auto outcome = engine::search(work, session.transport());
  const std::string packed = session.on_first_rank([&]() -> std::string {
    for (auto& found : outcome.solutions) results.push_back(std::move(found.solution));
    const auto bytes = engine::pack(results);
    return {bytes.begin(), bytes.end()};
  });
  if (!session.speaks()) {
    results = engine::unpack<std::vector<Result>>(std::span(packed.data(), packed.size()));
  }
  return results;
}

}  // namespace kusabi::run
