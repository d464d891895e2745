// When is the search over? Mattern's four-counter rule on survey waves.
//
// One wave cannot tell: ranks join it at different moments, so a gift may slip behind its back,
// sent by a rank that has not joined yet to one that already has. The rule asks for two successive
// waves in which every rank was idle, every message sent had been received, and the sums of the
// second are those of the first.
//
// Why that suffices. Let every rank join wave 2 after wave 1 was complete, and let t be a moment
// between the two. Counters only grow. From equal sums, no rank sent or received a gift between its
// joining of wave 1 and its joining of wave 2; so at the moment t all ranks have sent and received
// just what the sums say: as many gifts were received as were sent, and none is in flight. A rank
// that was idle when it joined wave 1 and has received nothing since is idle still. So at t all
// ranks are idle and nothing is in flight: nothing can ever happen again.
#pragma once

#include <cstdint>

#include "engine/survey.hpp"

namespace kusabi::engine {

/// Watches the merged surveys go by, in order, and tells the end. Every rank sees the same waves,
/// so every rank comes to the same verdict at the same wave.
class Termination {
 public:
  /// Takes note of the next merged survey. @return true if the search is over.
  bool observe(const Survey& wave) {
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
