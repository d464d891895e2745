// Exchange: collective operation on arrays, between processes that compute together outside of
// searches.
#pragma once

#include <cstddef>
#include <span>

namespace kusabi::engine {

/// Interface of a transport between processes; transports without it have a single rank, or only
/// search.
class Exchange {
 public:
  Exchange() = default;
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;
  virtual ~Exchange() = default;

  /// Completes an array of which each rank has set a part. Blocks until every rank has called it.
  /// @param ends end of each rank's part, in the order of the ranks
  virtual void complete(std::span<double> numbers, std::span<const std::size_t> ends) = 0;
};

}  // namespace kusabi::engine
