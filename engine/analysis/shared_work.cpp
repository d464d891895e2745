// Independent pieces of work with packed results, as searches of the engine.
#include "engine/analysis/shared_work.hpp"

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/analysis/analysis.hpp"
#include "engine/collectives.hpp"
#include "engine/search.hpp"

namespace kusabi::engine {
namespace {

std::vector<Bytes> results_on_all(Transport& transport, Outcome<SharedWork<Bytes>>& outcome) {
  return from_first_rank(transport, [&] {
    std::vector<Bytes> results;
    if (outcome.status != Status::solved) return results;
    for (auto& found : outcome.solutions) results.push_back(std::move(found.solution));
    return results;
  });
}

}  // namespace

std::vector<Bytes> share_packed_work(Transport& transport, std::uint64_t pieces,
                                     std::function<Bytes(std::uint64_t)> piece) {
  SharedWork<Bytes> work(pieces, std::move(piece));
  auto outcome = search(work, transport);
  return results_on_all(transport, outcome);
}

std::vector<Bytes> Analysis::share_packed(std::uint64_t pieces,
                                          std::function<Bytes(std::uint64_t)> piece) {
  SharedWork<Bytes> work(pieces, std::move(piece));
  auto outcome = search(work, {});
  return results_on_all(transport_, outcome);
}

}  // namespace kusabi::engine
