// Termination detection by one reduction wave: counted messages with stamps.
//
// *Counted* are the messages that change what their receiver does or knows: transfers, lifeline
// transfers and incumbents. Each carries as its stamp the number of waves that its sender had
// joined (T. H. Lai, T. H. Yang: On distributed snapshots, 1987). A rank that receives a stamp
// greater than the number of waves it has joined itself reports in its next wave that it was
// crossed. A rank is *quiet* if it opens no node, none of its requests is unanswered, and it
// requests nothing: while all search, because it is registered with all its lifelines; while all
// pause, because a pausing rank requests nothing. The search is over, or at rest, when in one wave
//
//   all ranks are quiet, no rank was crossed, and as many messages were received as sent.
//
// Proof. Call a rank's moment of joining the wave its cut, and what it does sooner or later than
// that before or after the cut.
//
// (1) A counted message sent after the sender's cut is received after the receiver's. Its stamp
//     counts this wave; a receiver that had not joined it would be crossed, since no rank joins the
//     next wave before all have joined this one, and would report it in this very wave.
// (2) A counted message sent before the sender's cut is received before the receiver's. By (1) all
//     messages received before the cuts were sent before the cuts; there are as many of one as of
//     the other, so none is left that was sent before and not received before.
// (3) No counted message is sent after the cuts. Consider the first one. Its sender was quiet at
//     its cut, and a quiet rank gets nodes or a better incumbent only by a counted message; one
//     that it received after its cut was sent after a cut, by (2), and is earlier than the first.
// (4) So every rank remains quiet, and sends no request after its cut. A request that it sent
//     before its cut was answered before its cut, since none was unanswered.
//
// All messages ever sent, requests and refusals included, have therefore been received when the
// wave is complete, and none follows: a rank may leave as soon as it knows the result. Conversely,
// when all ranks have become quiet and nothing is in flight, the next wave that begins says so.
//
// Requests and refusals are not counted: at the end an idle rank requests nodes from ranks that
// have joined the wave, and their refusals would cross it.
#pragma once

#include "engine/reduction.hpp"

namespace kusabi::engine {

/// True if a wave shows that all ranks are quiet and remain so.
inline bool all_quiet(const Reduction& wave) {
  return wave.quiet == wave.ranks && wave.crossed == 0 && wave.sent == wave.received;
}

}  // namespace kusabi::engine
