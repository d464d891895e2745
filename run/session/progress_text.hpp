// How the state of a running search is written: the rows of the log table and the bar. Functions of
// their arguments alone; run/session/progress_line.hpp decides when and where.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "engine/options.hpp"
#include "engine/shown_objective.hpp"

namespace kusabi::run {

using engine::ShownObjective;

/// What one line says.
struct ProgressState {
  engine::Progress progress;
  double nodes_per_second = 0;      ///< lately
  std::optional<double> remaining;  ///< seconds; unknown if empty
  bool minimising = false;          ///< objective, bound and gap instead of solutions found
  ShownObjective shown = {};        ///< how those two are shown
};

/// Seconds as "0:07", "12:34", "3:07:09", "2 d 03 h", or "> 99 d"; "?" if unknown.
std::string duration(std::optional<double> seconds);

/// A count in at most five characters: 99999 as it is, then "123k", "45.6M", "7.89G".
std::string count(double value);

/// (objective - bound) / |objective| in percent; "-" while one of the two is unknown.
std::string gap(double objective, double bound);

/// The names of the columns of `progress_row`, for the same kind of search.
std::string progress_header(bool minimising);

/// One line of the log, without an end of line.
std::string progress_row(const ProgressState& state);

/// What a row says, column by column, below one for an example: for help and the manual page.
std::string progress_explained(bool minimising);

/// The bar and as many figures as fit into `width` columns, the most wanted first.
std::string progress_bar(const ProgressState& state, std::size_t width);

/// Seconds from one row to the next, after so many seconds: 2 s at first, 10 s after 20 s, 1 min
/// after 2 min, 10 min after 2 h. A night costs less than two hundred lines.
double row_interval(double seconds);

}  // namespace kusabi::run
