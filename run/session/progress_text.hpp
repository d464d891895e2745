// Text of progress: rows of the log and the bar, and the remaining time, by exponential smoothing
// over unequal intervals with a correction of the initial bias. Times and destination are chosen by
// run/session/progress_line.hpp.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "engine/options.hpp"
#include "engine/shown_objective.hpp"

namespace kusabi::run {

using engine::ShownObjective;

/// Contents of one line.
struct ProgressState {
  engine::Progress progress;
  double nodes_per_second = 0;      ///< recent rate
  std::optional<double> remaining;  ///< seconds; empty: unknown
  bool has_objective = false;       ///< objective, bound and gap instead of solutions found
  ShownObjective shown = {};        ///< format of objective and bound
};

/// Seconds as "0:07", "12:34", "3:07:09", "2 d 03 h", or "> 99 d"; "?" if unknown.
std::string duration(std::optional<double> seconds);

/// A count in at most five characters: 99999 as it is, then "123k", "45.6M", "7.89G".
std::string count(double value);

/// (objective - bound) / |objective| in percent; "-" if one of both is unknown.
std::string gap(double objective, double bound);

/// Column headings of `progress_row` for the same kind of search.
std::string progress_header(bool has_objective);

/// One line of the log, without a line end.
std::string progress_row(const ProgressState& state);

/// An example row with an explanation of each column, for help and the manual page.
std::string progress_explained(bool has_objective);

/// The bar and as many figures as fit into `width` columns, the most important first.
std::string progress_bar(const ProgressState& state, std::size_t width);

/// Seconds between two rows, as a function of elapsed seconds: 2 s at first, 10 s after 20 s, 1 min
/// after 2 min, 10 min after 2 h. Twelve hours give less than two hundred lines.
double row_interval(double seconds);

/// Shares of a tree predict work poorly: a large branch may be pruned at once, a tiny one may last
/// for hours. The rate is therefore exponentially smoothed over a quarter of the elapsed time (10 s
/// at least).
class RemainingTime {
 public:
  /// Records the closed share, 0 to 1, at a time since the start. The first call sets the origin:
  /// shares closed before a restart do not count towards the rate of this run.
  void observe(double seconds, double closed);

  /// Remaining seconds; nothing without enough data: one second, half a percent of the tree, and
  /// ten increases of the closed share.
  [[nodiscard]] std::optional<double> seconds() const;

 private:
  bool begun_ = false;
  double first_seconds_ = 0;
  double first_closed_ = 0;
  double last_seconds_ = 0;
  double last_closed_ = 0;
  double rate_ = 0;    // weighted sum of rates
  double weight_ = 0;  // sum of weights; tends to 1
  int advances_ = 0;
};

}  // namespace kusabi::run
