// Termination detection: Mattern's four-counter method on reduction waves.
//
// One wave is not sufficient: ranks join it at different moments, so a transfer may be sent by a
// rank that has not joined yet to one that already has. The method requires two successive waves in
// which every rank was idle, every message sent had been received, and the sums of the second equal
// those of the first.
//
// Proof. Every rank joins wave 2 after wave 1 was complete; let t be a moment between the two.
// Counters only grow. Since the sums are equal, no rank sent or received a transfer between joining
// wave 1 and joining wave 2; at t, therefore, all ranks have sent and received exactly the sums: as
// many transfers were received as were sent, and none is in flight. A rank that was idle when it
// joined wave 1 and has received nothing since is still idle. At t, therefore, all ranks are idle
// and nothing is in flight, and this state is final.
#pragma once

#include <cstdint>

#include "engine/reduction.hpp"

namespace kusabi::engine {

/// Detects termination from the sequence of reductions. Every rank sees the same sequence, so all
/// decide at the same wave.
class Termination {
 public:
  /// Processes the next reduction. @return true if the search is over
  bool observe(const Reduction& wave) {
    const bool quiet = wave.idle == wave.ranks && wave.sent == wave.received;
    const bool over = quiet && was_quiet_ && wave.sent == sent_before_;
    was_quiet_ = quiet;
    sent_before_ = wave.sent;
    return over;
  }

 private:
  bool was_quiet_ = false;
  std::uint64_t sent_before_ = 0;
};

}  // namespace kusabi::engine
