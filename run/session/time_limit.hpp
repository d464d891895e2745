// Time limit of a run: a duration (90s, 1h30m, 5400), or the end of the batch job.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "engine/analysis/analysis.hpp"
#include "run/session/launch.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// Seconds of a text like "5400", "90s", "1h30m" or "2d"; nothing if it is none of these or not
/// positive.
std::optional<double> seconds_in(std::string_view text);

/// Time reserved for writing the results: a tenth of the remaining time of the job, two minutes at
/// most.
/// @param left seconds
double margin_before_the_end(double left);

/// Upper estimate of the time to sort and write a line of a list, in seconds (bench/history.md).
inline constexpr double seconds_per_written_line = 3e-5;

/// Upper estimate of the time to write so many results, such as patterns.
double seconds_to_write(std::uint64_t results);

/// Output of a shell command; empty if it fails. popen, except in tests.
using Shell = std::function<std::string(const std::string& command)>;

/// Seconds until Slurm ends the job of this process, less the margin: by SLURM_JOB_END_TIME, or by
/// squeue.
/// @param now seconds since 1970
/// @throws WrongInput if this is no job of Slurm, or its end is unknown
double seconds_of_slurm_job(const Environment& environment, const Shell& shell, double now);

/// The same for this process.
double seconds_of_slurm_job();

/// The time by which a run must have written its results: the end of a batch job (--time-limit
/// slurm), or a time limit that includes the writing.
class JobEnd {
 public:
  /// Reads it on rank 0, once for all ranks: squeue serves others, too.
  /// @return remaining seconds @throws WrongInput on every rank, as seconds_of_slurm_job()
  double read(Session& session);

  /// @param seconds from now
  void set(double seconds);

  /// True after read() or set().
  [[nodiscard]] bool is_known() const { return at_.has_value(); }
  /// @pre is_known()
  [[nodiscard]] double remaining_seconds() const;

  /// Makes a search end the earlier before the end of the job the more results it has to write.
  /// @pre is_known() @param seconds_to_write upper estimate for a number of results
  void reserve_time_to_write(std::function<double(std::uint64_t results)> seconds_to_write,
                             engine::AnalysisOptions& analysis_options) const;

 private:
  std::optional<std::chrono::steady_clock::time_point> at_;
};

}  // namespace kusabi::run
