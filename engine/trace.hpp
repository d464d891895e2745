// Trace: recorded events of each rank, for display.
//
// A trace records changes of activity, messages and reductions, never single nodes; a search
// without a trace pays one test at each of these. It keeps the first events up to a given number,
// and counts the others.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <boost/serialization/vector.hpp>

namespace kusabi::engine {

/// An event on one rank.
struct TraceEvent {
  enum class Kind : std::uint8_t {
    busy,              ///< begins to open nodes
    idle,              ///< has no open node
    pausing,           ///< opens no nodes, so that all ranks come to rest
    writing,           ///< has written its part of a checkpoint and waits for the others
    closing,           ///< the search is over
    request_sent,      ///< requested nodes from `peer`
    refusal_arrived,   ///< `peer` has no nodes to spare
    transfer_sent,     ///< sent `value` nodes to `peer`
    transfer_arrived,  ///< received `value` nodes from `peer`
    /// sent `value` nodes, unasked, to a rank registered with this lifeline
    lifeline_transfer_sent,
    lifeline_transfer_arrived,
    improved,  ///< found a solution better than the incumbent of this rank
    reduction_joined,
    reduction_arrived,  ///< complete; `value` ranks were idle
  };

  double time = 0;          ///< seconds by the rank's own clock
  std::uint64_t value = 0;  ///< see `Kind`
  std::uint64_t open = 0;   ///< open nodes on this rank at that time
  std::int32_t peer = -1;   ///< the other rank
  Kind kind = Kind::busy;

  /// True for the kinds that begin an activity, which lasts until the next such event.
  [[nodiscard]] bool starts_activity() const { return kind <= Kind::closing; }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& time& value& open& peer& kind;
  }
};

/// Events of one rank.
struct RankTrace {
  double joined = 0;  ///< time at which the rank joined the reduction before the search
  /// time at which that reduction was complete on this rank; the search begins here
  double began = 0;
  double ended = 0;                ///< end of the search
  std::uint64_t dropped = 0;       ///< number of later events, for which there was no room
  std::vector<TraceEvent> events;  ///< in order of time

  /// The trace in pieces of at most `maximum` events, to be joined again by `append`.
  [[nodiscard]] std::vector<RankTrace> pieces(std::size_t maximum) const {
    std::vector<RankTrace> list;
    for (auto first = events.begin(); first != events.end();) {
      const auto count = std::min(static_cast<std::ptrdiff_t>(maximum), events.end() - first);
      list.push_back({joined, began, ended, dropped, {first, first + count}});
      first += count;
    }
    return list;
  }

  void append(const RankTrace& piece) {
    joined = piece.joined;
    began = piece.began;
    ended = piece.ended;
    dropped = piece.dropped;
    events.insert(events.end(), piece.events.begin(), piece.events.end());
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& joined& began& ended& dropped& events;
  }
};

/// Recorder of the events of one rank, up to a given number.
class TraceRecorder {
 public:
  explicit TraceRecorder(std::size_t capacity) : capacity_(capacity) {}

  void join(double time) { trace_.joined = time; }
  void begin(double time) { trace_.began = time; }
  void end(double time) { trace_.ended = time; }

  void record(const TraceEvent& event) {
    if (event.starts_activity()) {
      if (started_ && event.kind == activity_) return;
      started_ = true;
      activity_ = event.kind;
    }
    if (trace_.events.size() < capacity_) {
      trace_.events.push_back(event);
    } else {
      ++trace_.dropped;
    }
  }

  /// The trace. @post the recorder is empty
  [[nodiscard]] RankTrace take() { return std::exchange(trace_, {}); }

 private:
  std::size_t capacity_;
  RankTrace trace_;
  bool started_ = false;
  TraceEvent::Kind activity_ = TraceEvent::Kind::busy;
};

/// Shifts the traces of all ranks to one time axis, 0 at the beginning of the search.
///
/// Clocks of different machines are unrelated. The reduction before the search became complete at
/// one moment: after every rank had joined it, and before any rank received its result. If a common
/// moment satisfies this by all clocks, the clocks are taken as synchronous, as on a single
/// machine. Otherwise the time of each rank counts from the receipt of the result, which is
/// accurate to the latency of a reduction.
inline void align_clocks(std::vector<RankTrace>& traces) {
  double last_joined = -std::numeric_limits<double>::infinity();
  double first_began = std::numeric_limits<double>::infinity();
  for (const auto& trace : traces) {
    last_joined = std::max(last_joined, trace.joined);
    first_began = std::min(first_began, trace.began);
  }
  const bool one_clock = last_joined <= first_began;
  for (auto& trace : traces) {
    const double zero = one_clock ? first_began : trace.began;
    for (auto& event : trace.events) event.time -= zero;
    trace.joined -= zero;
    trace.ended -= zero;
    trace.began -= zero;
  }
}

}  // namespace kusabi::engine
