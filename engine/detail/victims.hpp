// Victims: choice of the rank that an idle rank requests work from, and the back-off.
#pragma once

#include <cstdint>

namespace kusabi::engine {

/// The rank that gave last, as long as it gives; otherwise any other rank with equal probability.
/// After a refusal the pause before the next request doubles, to limit the load on busy ranks.
class Victims {
 public:
  /// @pre ranks >= 2
  Victims(int self, int ranks, std::uint64_t seed);

  /// Rank of the next request.
  [[nodiscard]] int choose();

  /// True if the next request is due. @param now in seconds
  [[nodiscard]] bool due(double now) const { return now >= next_request_; }
  [[nodiscard]] double next_request() const { return next_request_; }

  /// True after several successive refusals.
  [[nodiscard]] bool in_vain() const { return refusals_ >= patience; }

  void gave(int victim);
  void refused(int victim, double now);

 private:
  // While most ranks have work, the first request succeeds; three successive refusals indicate that
  // few have.
  static constexpr unsigned patience = 3;

  int self_;
  int ranks_;
  std::uint64_t random_;
  int favourite_ = -1;
  double pause_;
  double next_request_ = 0;
  unsigned refusals_ = 0;  // since the last transfer
};

}  // namespace kusabi::engine
