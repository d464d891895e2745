// Whom an idle rank asks for work, and when.
#pragma once

#include <cstdint>

namespace kusabi::engine {

/// One rank's choice of victims: the one that gave last, as long as it gives; otherwise any other
/// rank with equal chance. After a refusal the next request waits, twice as long each time: idle
/// ranks must not storm the ones that work.
class Victims {
 public:
  /// @pre ranks >= 2
  Victims(int self, int ranks, std::uint64_t seed);

  /// The rank to ask next.
  [[nodiscard]] int choose();

  /// Whether the time for the next request has come. @param now in seconds
  [[nodiscard]] bool due(double now) const { return now >= next_request_; }
  [[nodiscard]] double next_request() const { return next_request_; }

  /// Whether asking around has been in vain for some time.
  [[nodiscard]] bool in_vain() const { return refusals_ >= patience; }

  void gave(int victim);
  void refused(int victim, double now);

 private:
  // While most ranks have work, the first one asked gives; three refusals in a row tell that few
  // have.
  static constexpr unsigned patience = 3;

  int self_;
  int ranks_;
  std::uint64_t random_;
  int favourite_ = -1;
  double pause_;
  double next_request_ = 0;
  unsigned refusals_ = 0;  // since the last gift
};

}  // namespace kusabi::engine
