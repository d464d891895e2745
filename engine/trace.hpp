// What happened when on each rank, for a person who wants to see it: a recorder of events.
//
// It sees changes of what the rank does, messages and surveys, never single nodes; a search that
// keeps no trace pays one test at each of these. It keeps a bounded number of events, the first
// ones, and counts the others.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <boost/serialization/vector.hpp>

namespace kusabi::engine {

/// Something that happened on one rank.
struct TraceEvent {
  enum class Kind : std::uint8_t {
    busy,             ///< from here on the rank opens nodes
    idle,             ///< … has no node
    pausing,          ///< … opens none, so that all can come to rest
    writing,          ///< … has written its part of a checkpoint and waits for the others
    closing,          ///< … knows that the search is over
    request_sent,     ///< asked `peer` for nodes
    refusal_arrived,  ///< `peer` has none to spare
    gift_sent,        ///< gave `peer` a number of nodes: `value`
    gift_arrived,     ///< got as many from `peer`
    parcel_sent,      ///< gave, unasked, to a rank that had left its name (lifelines.hpp)
    parcel_arrived,
    improved,  ///< found a solution better than the best known here
    survey_joined,
    survey_arrived,  ///< complete; `value` ranks were idle
  };

  double time = 0;          ///< seconds by the rank's own clock
  std::uint64_t value = 0;  ///< see `Kind`
  std::uint64_t open = 0;   ///< nodes waiting on this rank at that time
  std::int32_t peer = -1;   ///< the other rank
  Kind kind = Kind::busy;

  /// Whether this is one of the kinds that last until the next such event.
  [[nodiscard]] bool starts_activity() const { return kind <= Kind::closing; }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& time& value& open& peer& kind;
  }
};

/// The events of one rank.
struct RankTrace {
  double joined = 0;          ///< when the rank joined the survey that precedes the search, and
  double began = 0;           ///< when it saw that survey complete; the search begins here
  double ended = 0;           ///< the search is over
  std::uint64_t dropped = 0;  ///< events after the last one here, for which there was no room
  std::vector<TraceEvent> events;  ///< in order of time

  /// The same in pieces of at most `most` events, to be put together again by `append`.
  [[nodiscard]] std::vector<RankTrace> pieces(std::size_t most) const {
    std::vector<RankTrace> list;
    for (auto first = events.begin(); first != events.end();) {
      const auto count = std::min(static_cast<std::ptrdiff_t>(most), events.end() - first);
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

/// Keeps the events of one rank, while they last.
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

/// Puts the traces of all ranks on one time axis, 0 when the search begins.
///
/// Clocks of different machines have nothing in common. But one survey precedes the search, and
/// there was a moment at which it became complete: after every rank had joined it, before any rank
/// saw its result. If one moment by all clocks lies between these for every rank, then the clocks
/// are taken as one, as they are on a single machine; otherwise each rank's time counts from when
/// it saw the result, which is right to within the time that a survey takes to reach all.
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
