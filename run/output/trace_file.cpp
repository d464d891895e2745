// One line per event: "X" a slice, "i" an instant, "s" and "f" the ends of an arrow, "C" a point of
// a curve, "M" a name. A rank is a "process" with two "threads".
#include "run/output/trace_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace kusabi::run {
namespace {

using engine::RankTrace;
using engine::TraceEvent;
using Json = nlohmann::ordered_json;
using Kind = TraceEvent::Kind;

constexpr int work_track = 0;
constexpr int reduction_track = 1;

const char* activity_name(Kind kind) {
  switch (kind) {
    case Kind::busy:
      return "busy";
    case Kind::idle:
      return "idle";
    case Kind::pausing:
      return "pausing";
    case Kind::writing:
      return "writing a checkpoint";
    default:
      return "closing";
  }
}

class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(out) {}

  void write(const RankTrace& trace, int rank) {
    rank_ = rank;
    open_.reset();
    name_tracks();
    for (auto event = trace.events.begin(); event != trace.events.end(); ++event) {
      if (event->starts_activity()) {
        const auto next = std::find_if(event + 1, trace.events.end(),
                                       [](const auto& each) { return each.starts_activity(); });
        const double until = next != trace.events.end() ? next->time : end_of(trace);
        slice(activity_name(event->kind), work_track, event->time, until, Json::object());
      } else {
        write_message(*event);
      }
      if (open_ != event->open) curve(*event);
      open_ = event->open;
    }
    write_reductions(trace);
    if (trace.dropped != 0) {
      auto line = begin("i", fmt::format("{} later events were dropped", trace.dropped), work_track,
                        end_of(trace));
      line["s"] = "p";
      put(line);
    }
  }

 private:
  // With dropped events, the activity after the last recorded one is unknown.
  static double end_of(const RankTrace& trace) {
    return trace.dropped == 0 || trace.events.empty() ? trace.ended : trace.events.back().time;
  }

  void name_tracks() {
    name("process_name", 0, fmt::format("rank {}", rank_));
    name("thread_name", work_track, "work");
    name("thread_name", reduction_track, "reductions");
    put({{"ph", "M"},
         {"name", "process_sort_index"},
         {"pid", rank_},
         {"args", {{"sort_index", rank_}}}});
  }

  void name(const char* what, int track, const std::string& text) {
    put({{"ph", "M"}, {"name", what}, {"pid", rank_}, {"tid", track}, {"args", {{"name", text}}}});
  }

  void write_message(const TraceEvent& event) {
    switch (event.kind) {
      case Kind::request_sent:
        instant(event, "request", {{"to", event.peer}});
        break;
      case Kind::refusal_arrived:
        instant(event, "refusal", {{"from", event.peer}});
        break;
      case Kind::transfer_sent:
        instant(event, "transfer sent", {{"to", event.peer}, {"nodes", event.value}});
        arrow("s", "transfer", event, rank_, event.peer);
        break;
      case Kind::transfer_arrived:
        instant(event, "transfer", {{"from", event.peer}, {"nodes", event.value}});
        arrow("f", "transfer", event, event.peer, rank_);
        break;
      case Kind::lifeline_transfer_sent:
        instant(event, "lifeline transfer sent", {{"to", event.peer}, {"nodes", event.value}});
        arrow("s", "lifeline transfer", event, rank_, event.peer);
        break;
      case Kind::lifeline_transfer_arrived:
        instant(event, "lifeline transfer", {{"from", event.peer}, {"nodes", event.value}});
        arrow("f", "lifeline transfer", event, event.peer, rank_);
        break;
      case Kind::improved:
        instant(event, "better solution", Json::object());
        break;
      default:
        break;
    }
  }

  void write_reductions(const RankTrace& trace) {
    const TraceEvent* joined = nullptr;
    for (const auto& event : trace.events) {
      if (event.kind == Kind::reduction_joined) joined = &event;
      if (event.kind != Kind::reduction_arrived || joined == nullptr) continue;
      slice("reduction", reduction_track, joined->time, event.time, {{"idle ranks", event.value}});
      joined = nullptr;
    }
  }

  void slice(const char* name, int track, double from, double until, const Json& details) {
    auto line = begin("X", name, track, from);
    line["dur"] = microseconds(nanoseconds(until) - nanoseconds(from));
    line["args"] = details;
    put(line);
  }

  void instant(const TraceEvent& event, const char* name, const Json& details) {
    auto line = begin("i", name, work_track, event.time);
    line["s"] = "t";
    line["args"] = details;
    put(line);
  }

  // The n-th transfer sent to a rank is the n-th that arrives: messages of one kind between two
  // ranks keep their order. Both ends therefore compute the same number.
  void arrow(const char* end, const std::string& kind, const TraceEvent& event, int from, int to) {
    const auto number = ++transfers_[{kind, from, to, *end}];
    const auto id = arrows_.try_emplace({kind, from, to, number}, arrows_.size() + 1).first->second;
    auto line = begin(end, kind, work_track, event.time);
    line["cat"] = "transfer";
    line["id"] = id;
    put(line);
  }

  void curve(const TraceEvent& event) {
    auto line = begin("C", "open nodes", work_track, event.time);
    line["args"] = {{"open", event.open}};
    put(line);
  }

  [[nodiscard]] Json begin(const char* phase, const std::string& name, int track,
                           double time) const {
    return {{"ph", phase},
            {"name", name},
            {"pid", rank_},
            {"tid", track},
            {"ts", microseconds(nanoseconds(time))}};
  }

  static long long nanoseconds(double seconds) { return std::llround(seconds * 1e9); }

  // Unit of the format.
  static double microseconds(long long nanoseconds) {
    return static_cast<double>(nanoseconds) / 1e3;
  }

  void put(const Json& line) {
    out_ << separator_ << line.dump();
    separator_ = ",\n";
  }

  std::ostream& out_;
  const char* separator_ = "\n";
  int rank_ = 0;
  std::optional<std::uint64_t> open_;
  std::map<std::tuple<std::string, int, int, char>, std::uint64_t> transfers_;
  std::map<std::tuple<std::string, int, int, std::uint64_t>, std::uint64_t> arrows_;
};

}  // namespace

std::size_t trace_events_per_rank(int ranks) {
  constexpr std::size_t maximum = 1'000'000;
  constexpr std::size_t max_together = 4'000'000;
  return std::min(maximum,
                  std::max<std::size_t>(1, max_together / static_cast<std::size_t>(ranks)));
}

void write_trace(std::ostream& out, const std::vector<RankTrace>& traces) {
  out << R"({"displayTimeUnit": "ms", "traceEvents": [)";
  Writer writer(out);
  for (std::size_t rank = 0; rank < traces.size(); ++rank) {
    writer.write(traces[rank], static_cast<int>(rank));
  }
  out << "\n]}\n";
}

}  // namespace kusabi::run
