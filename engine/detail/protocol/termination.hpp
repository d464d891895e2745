// Termination detection by one reduction wave: counted messages with stamps.
//
// *Counted* are the messages that change what their receiver does or knows: transfers, lifeline
// transfers and incumbents. Each carries as its stamp the number of waves that its sender had
// joined (T. H. Lai, T. H. Yang: On distributed snapshots, 1987). A rank that receives a stamp
// greater than the number of waves it has joined itself reports in its next wave that it was
// crossed. A rank is *quiet* if it opens no node, none of its requests is unanswered, and it
// requests nothing: while all search, because it is registered with all its lifelines; while all
// pause, because a pausing rank requests nothing. The search is over, or pauses, when in one wave
//
//   all ranks are quiet, no rank was crossed, and as many messages were received as sent.
//
// docs/engine.md ("Termination") proves this, and that the wave after the last message satisfies
// it. Requests and refusals are not counted: at the end an idle rank requests nodes from ranks that
// have joined the wave, and their refusals would cross it.
#pragma once

#include "engine/reduction.hpp"

namespace kusabi::engine {

/// True if a wave shows that all ranks are quiet and remain so.
inline bool all_quiet(const Reduction& wave) {
  return wave.quiet == wave.ranks && wave.crossed == 0 && wave.sent == wave.received;
}

}  // namespace kusabi::engine
