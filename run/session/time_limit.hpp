// Time limit of a run: a duration (90s, 1h30m, 5400), or the end of the batch job.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "run/session/launch.hpp"

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

}  // namespace kusabi::run
