// Columns of progress lines and their widths.
#include "run/session/progress_text.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace kusabi::run {
namespace {

// Rounded down, since the last open node may contain half of the work.
std::string percent(double share) {
  const double rounded_down = std::floor(std::clamp(share, 0.0, 1.0) * 1000) / 10;
  return fmt::format("{:.1f} %", rounded_down);
}

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.5g}", value) : "-";
}

std::string idle(const engine::Progress& progress) {
  return fmt::format("{}/{}", progress.idle, progress.ranks);
}

double objective(const ProgressState& state) {
  return state.shown.unit * std::min(state.progress.objective, state.shown.upper);
}

// Bounds beyond the objective are not reported: nodes there are discarded.
double bound(const ProgressState& state) {
  const double best = std::min(state.progress.objective, state.shown.upper);
  return state.shown.unit * std::min(std::max(state.progress.bound, state.shown.lower), best);
}

// True if no better solution is left and the open nodes are only discarded.
bool proof_is_over(const ProgressState& state) {
  const double best = std::min(state.progress.objective, state.shown.upper);
  return state.has_objective && std::isfinite(best) && state.progress.bound >= best;
}

// The estimated remaining time, or the name of the last steps of a search.
std::string left(const ProgressState& state) {
  if (state.progress.open == 0) return "ending";
  return proof_is_over(state) ? "closing" : duration(state.remaining);
}

}  // namespace

std::string duration(std::optional<double> seconds) {
  if (!seconds || !(*seconds >= 0)) return "?";
  constexpr double minute = 60;
  constexpr double hour = 60 * minute;
  constexpr double day = 24 * hour;
  if (*seconds >= 99.5 * day) return "> 99 d";
  const auto whole = std::llround(*seconds);
  if (*seconds >= day) return fmt::format("{} d {:02} h", whole / 86400, whole / 3600 % 24);
  if (whole >= 3600) {
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  }
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string count(double value) {
  constexpr double as_it_is = 99'999.5;
  if (!(value >= 0)) return "-";
  if (value < as_it_is) return fmt::format("{:.0f}", value);
  for (const char unit : {'k', 'M', 'G', 'T', 'P'}) {
    value /= 1000;
    if (value < 9.995) return fmt::format("{:.2f}{}", value, unit);
    if (value < 99.95) return fmt::format("{:.1f}{}", value, unit);
    if (value < 999.5) return fmt::format("{:.0f}{}", value, unit);
  }
  return "many";
}

std::string gap(double objective, double bound) {
  if (!std::isfinite(objective) || !std::isfinite(bound)) return "-";
  const double difference = std::abs(objective - bound);
  if (difference == 0) return "0 %";
  const double share = 100 * difference / std::abs(objective);
  return share < 999.5 ? fmt::format("{:.3g} %", share) : "> 999 %";
}

std::string progress_header(bool has_objective) {
  const std::string common =
      fmt::format("{:>9} {:>7} {:>7} {:>7}", "time", "nodes", "per s", "open");
  const std::string answer = has_objective
                                 ? fmt::format(" {:>12} {:>12} {:>7}", "objective", "bound", "gap")
                                 : fmt::format(" {:>7}", "found");
  return fmt::format("{}{} {:>9} {:>7} {:>9}", common, answer, "idle", "done", "left");
}

std::string progress_row(const ProgressState& state) {
  const auto& progress = state.progress;
  const std::string common =
      fmt::format("{:>9} {:>7} {:>7} {:>7}", duration(progress.seconds),
                  count(static_cast<double>(progress.opened)), count(state.nodes_per_second),
                  count(static_cast<double>(progress.open)));
  const std::string answer =
      state.has_objective ? fmt::format(" {:>12} {:>12} {:>7}", number(objective(state)),
                                        number(bound(state)), gap(objective(state), bound(state)))
                          : fmt::format(" {:>7}", count(static_cast<double>(progress.found)));
  return fmt::format("{}{} {:>9} {:>7} {:>9}", common, answer, idle(progress),
                     percent(progress.closed), left(state));
}

std::string progress_explained(bool has_objective) {
  ProgressState example;
  example.has_objective = has_objective;
  example.nodes_per_second = 4017;
  example.remaining = 8;
  auto& progress = example.progress;
  progress.seconds = 12;
  progress.opened = 48'211;
  progress.open = 153;
  progress.found = 27;
  progress.objective = 12.5;
  progress.bound = 12.25;
  progress.ranks = 8;
  progress.idle = 1;
  progress.closed = 0.613;
  return fmt::format(
      "Progress lines on standard error (a bar on a terminal):\n{}\n{}\n"
      "  time    since the start of the search\n"
      "  nodes   opened nodes, and their recent rate per second\n"
      "  open    nodes that wait to be opened\n"
      "{}"
      "  idle    ranks without work\n"
      "  done    closed share of the tree; the children of a node divide its share\n"
      "  left    estimated remaining time, from the growth of this share{}\n"
      "          ending: no open node is left, and the ranks terminate",
      progress_header(has_objective), progress_row(example),
      has_objective ? "  objective, bound, gap   best value, bound of all open nodes, and their "
                      "relative difference\n"
                    : "  found   solutions found\n",
      has_objective ? "\n          closing: no better value is left, and open nodes are discarded"
                    : "");
}

std::string progress_bar(const ProgressState& state, std::size_t width) {
  constexpr int bar_width = 20;
  const auto& progress = state.progress;
  const auto full = static_cast<int>(std::clamp(progress.closed, 0.0, 1.0) * bar_width);
  std::vector<std::string> fields{
      percent(progress.closed),
      state.progress.open == 0 ? "ending: the ranks terminate"
      : proof_is_over(state)   ? "closing: no better value is left"
                               : duration(state.remaining) + " left",
      state.has_objective ? fmt::format("best {}, gap {}", number(objective(state)),
                                        gap(objective(state), bound(state)))
                          : count(static_cast<double>(progress.found)) + " found",
      duration(progress.seconds),
      count(static_cast<double>(progress.opened)) + " nodes",
      count(state.nodes_per_second) + "/s",
      count(static_cast<double>(progress.open)) + " open",
  };
  if (progress.ranks > 1) fields.push_back(idle(progress) + " idle");
  std::string line = fmt::format("[{:#<{}}{:.<{}}]", "", full, "", bar_width - full);
  if (line.size() > width) line.clear();
  for (const auto& field : fields) {
    const std::string separator = line.empty() ? "" : "  ";
    if (line.size() + separator.size() + field.size() > width) break;
    line += separator + field;
  }
  return line;
}

double row_interval(double seconds) {
  if (seconds < 20) return 2;
  if (seconds < 120) return 10;
  if (seconds < 7200) return 60;
  return 600;
}

namespace {

constexpr double shortest_memory = 10;  // seconds
constexpr double memory_share = 0.25;   // of the elapsed time
constexpr double least_seconds = 1;
constexpr double min_closed = 0.005;
constexpr int min_advances = 10;

}  // namespace

void RemainingTime::observe(double seconds, double closed) {
  if (!begun_) {
    begun_ = true;
    first_seconds_ = last_seconds_ = seconds;
    first_closed_ = last_closed_ = closed;
    return;
  }
  const double elapsed = seconds - last_seconds_;
  if (!(elapsed > 0)) return;
  const double advance = std::max(0.0, closed - last_closed_);
  const double memory = std::max(shortest_memory, memory_share * (seconds - first_seconds_));
  const double fresh = -std::expm1(-elapsed / memory);
  rate_ += fresh * (advance / elapsed - rate_);
  weight_ += fresh * (1 - weight_);
  if (advance > 0) ++advances_;
  last_seconds_ = seconds;
  last_closed_ = std::max(last_closed_, closed);
}

std::optional<double> RemainingTime::seconds() const {
  if (last_seconds_ - first_seconds_ < least_seconds) return std::nullopt;
  if (last_closed_ - first_closed_ < min_closed || advances_ < min_advances) {
    return std::nullopt;
  }
  return std::max(0.0, 1 - last_closed_) * weight_ / rate_;
}

}  // namespace kusabi::run
