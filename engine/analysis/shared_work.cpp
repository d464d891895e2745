// Independent pieces of work with packed results, as a search of the engine.
#include "engine/analysis/shared_work.hpp"

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/search.hpp"
#include "engine/together.hpp"

namespace kusabi::engine {

std::vector<Bytes> share_packed_work(Transport& transport, std::uint64_t pieces,
                                     std::function<Bytes(std::uint64_t)> piece) {
  SharedWork<Bytes> work(pieces, std::move(piece));
  auto outcome = search(work, transport);
  return from_first_rank(transport, [&] {
    std::vector<Bytes> results;
    for (auto& found : outcome.solutions) results.push_back(std::move(found.solution));
    return results;
  });
}

}  // namespace kusabi::engine
