// How long a run may take, as people say it (90s, 1h30m, 5400) or as the batch system has it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "run/session/launch.hpp"

namespace kusabi::run {

/// Seconds that a text like "5400", "90s", "1h30m" or "2d" means; nothing if it is none of these or
/// not above zero.
std::optional<double> seconds_in(std::string_view text);

/// What is kept back of a job's time, to write what was found: a tenth of what is left of it, two
/// minutes at most. @param left seconds
double margin_before_the_end(double left);

/// Prints what a command of the shell prints; empty if it fails. popen, but for tests.
using Shell = std::function<std::string(const std::string& command)>;

/// Seconds until Slurm ends the job that this process is of, less the margin: by
/// SLURM_JOB_END_TIME, or by what squeue says.
/// @param now seconds since 1970
/// @throws WrongInput if this is no job of Slurm, or it cannot be told when it ends
double seconds_of_slurm_job(const Environment& environment, const Shell& shell, double now);

/// The same of this process.
double seconds_of_slurm_job();

}  // namespace kusabi::run
