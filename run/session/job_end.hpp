// JobEnd: the time by which a run must have written its results: the end of a batch job
// (--time-limit slurm), or a time limit that includes the writing.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

#include "engine/analysis/analysis.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

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
