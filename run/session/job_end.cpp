// The clock of this process, from the remaining time when it was read.
#include "run/session/job_end.hpp"

#include <memory>
#include <utility>

#include "run/session/time_limit.hpp"

namespace kusabi::run {

using Clock = std::chrono::steady_clock;

double JobEnd::read(Session& session) {
  const double left = session.from_first_rank([] { return seconds_of_slurm_job(); });
  set(left);
  return left;
}

void JobEnd::set(double seconds) {
  at_ = Clock::now() +
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

double JobEnd::remaining_seconds() const {
  const std::chrono::duration<double> left = *at_ - Clock::now();
  return left.count();
}

void JobEnd::reserve_time_to_write(std::function<double(std::uint64_t results)> seconds_to_write,
                                   engine::AnalysisOptions& analysis_options) const {
  const auto found = std::make_shared<std::uint64_t>(0);
  analysis_options.watch = [found, watch = analysis_options.watch](
                               engine::Goal goal, const engine::ShownObjective& shown) {
    const auto show = watch ? watch(goal, shown) : std::function<void(const engine::Progress&)>();
    return [found, show](const engine::Progress& progress) {
      *found = progress.found;
      if (show) show(progress);
    };
  };
  analysis_options.interrupt = [end = *this, found, seconds_to_write = std::move(seconds_to_write),
                                asked = analysis_options.interrupt] {
    if (*found != 0 && end.remaining_seconds() <= seconds_to_write(*found))
      return engine::Interrupt::stop;
    return asked();
  };
}

}  // namespace kusabi::run
