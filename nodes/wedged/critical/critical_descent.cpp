// Starts, dives and searches, one after another.
#include "nodes/wedged/critical/critical_descent.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "nodes/wedged/critical/critical_dive.hpp"
#include "nodes/wedged/critical/smallest_search.hpp"

namespace kusabi::wedged {
namespace {

/// Where a descent starts, and how much farther up it starts anew where everything is dead.
constexpr double first_start = 1;
constexpr double next_start = 4;

/// Of a start.
constexpr double few_digits = 1e-2;

/// Where a descent looks next, of where something lives, until it knows where nothing does.
constexpr double share_of_last = 0.6;

/// Dives end where what is left to be told is from so much of it on.
constexpr double near_enough = 0.9;

class Descent {
 public:
  Descent(engine::Analysis& analysis, const problems::WedgedProblem& problem,
          const CriticalGrid& grid, Tightening tightening, CriticalBracket& bracket,
          CriticalFindings& findings)
      : analysis_(analysis),
        problem_(problem),
        tightening_(tightening),
        grid_(grid),
        bracket_(bracket),
        findings_(findings),
        known_dead_(bracket.lower()),
        alive_(bracket.upper()) {}

  void run() {
    const double most = grid_.most;
    for (double start = std::min(alive_.value_or(first_start), most);;
         start = std::min(most, next_start * start)) {
      if (start <= known_dead_ && start < most) continue;
      coarse_ = grid_.width;
      while (coarse_ < few_digits * start) coarse_ *= 2;
      dead_ = std::max(dead_, coarse_ * std::floor(known_dead_ / coarse_));
      // A search says nothing of what is beyond the last point of its grid.
      const double reach = coarse_ == grid_.width ? start : coarse_ * std::floor(start / coarse_);
      dive(reach);
      if (!narrow()) return;
      if (alive_ || dead_ < reach) {  // something lives, or may live
        if (coarse_ != grid_.width) search(CriticalPhase::fine, grid_.width, alive_.value_or(most));
        return;
      }
      if (start >= most) {
        if (reach != most) search(CriticalPhase::fine, grid_.width, most);
        return;
      }
    }
  }

 private:
  // From where something lives down to a share of that, then to the middle of what is left between
  // that and where nothing lives, or a dive could not tell.
  void dive(double reach) {
    from_ = reach;
    bounds_ = {};
    double untold = 0;
    if (alive_ && !goes_on(untold)) return;
    for (;;) {
      const CriticalGrid coarse{.width = coarse_, .most = grid_.most, .precision = grid_.precision};
      const auto found =
          dive_at(analysis_, problem_, std::llround(from_ / coarse_), coarse, bounds_);
      findings_.costs.push_back(
          {CriticalPhase::dive, from_, found.opened, found.opened + bounds_.programs});
      bounds_.programs = 0;  // they are told of
      if (std::isfinite(found.alive)) {
        alive_ = found.alive;
        bracket_.sink(found.alive, found.leaf);
      } else {
        (found.all_dead ? dead_ : untold) = from_;
        if (found.all_dead) bracket_.raise(from_);
      }
      bracket_.show();
      if (analysis_.ended()) return;
      if (!alive_ || !goes_on(untold)) return;
    }
  }

  // Where to look next, below what is alive. @return whether by a dive
  bool goes_on(double untold) {
    const double last = coarse_ * static_cast<double>(std::llround(*alive_ / coarse_) - 1);
    if (last <= dead_) return false;
    const double least = std::max(dead_, untold);
    const bool near = least > near_enough * *alive_;
    const double next = least > 0 ? std::sqrt(least * *alive_) : share_of_last * *alive_;
    const double below = std::max(coarse_ * std::floor(next / coarse_), dead_ + coarse_);
    from_ = near ? last : std::min(below, last);
    bounds_ = bounds_at(analysis_, problem_, from_, tightening_);
    return !near;
  }

  // What the dives have left. @return whether there was time to
  bool narrow() {
    const double end = alive_ ? *alive_ - 1.5 * coarse_ : from_;  // below its last point
    if (analysis_.ended()) return stopped(CriticalPhase::dive);
    return !(dead_ < end) || search(CriticalPhase::coarse, coarse_, from_);
  }

  bool search(CriticalPhase phase, double width, double from) {
    if (phase == CriticalPhase::fine || bounds_.blocks.empty())
      bounds_ = bounds_at(analysis_, problem_, from, tightening_);
    const auto found = find_smallest(analysis_, problem_,
                                     {CriticalDirection::down,
                                      phase,
                                      {.width = width, .most = from, .precision = grid_.precision},
                                      std::max(dead_, known_dead_),
                                      bounds_},
                                     findings_.costs, findings_.global_ranks);
    dead_ = std::max(dead_, found.lower);
    if (std::isfinite(found.upper)) alive_ = found.upper;
    found.narrow(bracket_, grid_.width);
    bracket_.show();
    findings_.status = found.status;
    if (found.status != engine::Status::solved) findings_.stopped_in = phase;
    return found.status == engine::Status::solved;
  }

  bool stopped(CriticalPhase phase) {
    findings_.status =
        engine::from_first_rank(analysis_.transport(), [&] { return analysis_.budget().why(); });
    findings_.stopped_in = phase;
    return false;
  }

  engine::Analysis& analysis_;
  const problems::WedgedProblem& problem_;
  Tightening tightening_;
  CriticalGrid grid_;
  CriticalBracket& bracket_;
  CriticalFindings& findings_;
  double known_dead_;            // as dead_, but not on that grid
  double coarse_ = 0;            // the width of the grid of a start
  double from_ = 0;              // where the next search begins
  double dead_ = 0;              // nothing lives here, nor below
  std::optional<double> alive_;  // something does
  BlockBounds bounds_;           // at `from_`
};

}  // namespace

void descend(engine::Analysis& analysis, const problems::WedgedProblem& problem,
             const CriticalGrid& grid, Tightening tightening, CriticalBracket& bracket,
             CriticalFindings& findings) {
  Descent(analysis, problem, grid, tightening, bracket, findings).run();
}

}  // namespace kusabi::wedged
