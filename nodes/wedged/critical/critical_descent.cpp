// Sequence of starting points, dives and searches.
#include "nodes/wedged/critical/critical_descent.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "nodes/wedged/critical/critical_dive.hpp"
#include "nodes/wedged/critical/smallest_search.hpp"

namespace kusabi::wedged {
namespace {

/// Coefficient of the first start, and factor of the next one if everything is infeasible there.
constexpr double first_start = 1;
constexpr double next_start = 4;

/// Relative width of the bracket after the searches of a start.
constexpr double few_digits = 1e-2;

/// Ratio of the next coefficient to the last feasible one while no infeasible one is known.
constexpr double share_of_last = 0.6;

/// Dives end when the undecided interval begins above this share of its upper bound.
constexpr double near_enough = 0.9;

class CriticalDescent {
 public:
  CriticalDescent(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                  const CriticalGrid& grid, Tightening tightening, NarrowingBracket& bracket,
                  CriticalFindings& findings)
      : analysis_(analysis),
        problem_(problem),
        tightening_(tightening),
        grid_(grid),
        bracket_(bracket),
        findings_(findings),
        known_infeasible_(bracket.lower()),
        feasible_(bracket.upper()) {}

  void run() {
    const double maximum = grid_.maximum;
    for (double start = std::min(feasible_.value_or(first_start), maximum);;
         start = std::min(maximum, next_start * start)) {
      if (start <= known_infeasible_ && start < maximum) continue;
      coarse_ = grid_.width;
      while (coarse_ < few_digits * start) coarse_ *= 2;
      if (coarse_ * std::floor(start / coarse_) < bracket_.minimum()) coarse_ = grid_.width;
      infeasible_ = std::max(infeasible_, coarse_ * std::floor(known_infeasible_ / coarse_));
      // A search does not decide coefficients beyond the last point of its grid.
      const double top = coarse_ == grid_.width ? start : coarse_ * std::floor(start / coarse_);
      dive(top);
      if (!narrow()) return;
      if (feasible_ || infeasible_ < top) {  // a leaf is feasible, or numerically undecided
        if (coarse_ != grid_.width)
          search(CriticalPhase::fine, grid_.width, feasible_.value_or(maximum));
        return;
      }
      if (start >= maximum) {
        if (top != maximum) search(CriticalPhase::fine, grid_.width, maximum);
        return;
      }
    }
  }

 private:
  // Dives at a share of the least feasible coefficient, then at the middle between it and the
  // largest coefficient that is infeasible or undecided by a dive.
  void dive(double top) {
    from_ = top;
    bounds_ = {};
    double undecided = 0;
    if (feasible_ && !goes_on(undecided)) return;
    for (;;) {
      const CriticalGrid coarse{
          .width = coarse_, .maximum = grid_.maximum, .precision = grid_.precision};
      const auto found =
          dive_at(analysis_, problem_, std::llround(from_ / coarse_), coarse, bounds_);
      findings_.costs.push_back(
          {CriticalPhase::dive, from_, found.opened, found.opened + bounds_.programs});
      bounds_.programs = 0;  // counted once
      if (std::isfinite(found.feasible)) {
        bracket_.reduce_upper(found.feasible, found.leaf);
        feasible_ = bracket_.upper();
      } else {
        (found.all_infeasible ? infeasible_ : undecided) = from_;
        if (found.all_infeasible) bracket_.raise_lower(from_);
      }
      bracket_.show();
      if (analysis_.ended()) return;
      if (!feasible_ || !goes_on(undecided)) return;
    }
  }

  // Chooses the next coefficient below the feasible one. @return true: by a dive
  bool goes_on(double undecided) {
    const double last = coarse_ * static_cast<double>(std::llround(*feasible_ / coarse_) - 1);
    const double first = coarse_ * std::ceil(bracket_.minimum() / coarse_);
    if (last <= infeasible_ || last < first) return false;
    const double minimum = std::max(infeasible_, undecided);
    const bool near = minimum > near_enough * *feasible_;
    const double next = minimum > 0 ? std::sqrt(minimum * *feasible_) : share_of_last * *feasible_;
    const double below =
        std::max({coarse_ * std::floor(next / coarse_), infeasible_ + coarse_, first});
    from_ = near ? last : std::min(below, last);
    bounds_ = bounds_at(analysis_, problem_, from_, tightening_);
    return !near;
  }

  // Searches the interval that the dives leave. @return false if the search was stopped
  bool narrow() {
    const double end = feasible_ ? *feasible_ - 1.5 * coarse_ : from_;  // below its last point
    if (analysis_.ended()) return stopped(CriticalPhase::dive);
    return !(infeasible_ < end) || search(CriticalPhase::coarse, coarse_, from_);
  }

  bool search(CriticalPhase phase, double width, double from) {
    if (phase == CriticalPhase::fine || bounds_.blocks.empty())
      bounds_ = bounds_at(analysis_, problem_, std::max(from, bracket_.minimum()), tightening_);
    const auto found =
        find_smallest(analysis_, problem_,
                      {CriticalDirection::down,
                       phase,
                       {.width = width, .maximum = from, .precision = grid_.precision},
                       std::max(infeasible_, known_infeasible_),
                       bounds_},
                      findings_.costs, findings_.global_ranks);
    infeasible_ = std::max(infeasible_, found.lower);
    found.narrow(bracket_, grid_.width);
    if (std::isfinite(found.upper)) feasible_ = std::max(found.upper, bracket_.minimum());
    bracket_.show();
    findings_.status = found.status;
    if (found.status != engine::Status::solved) findings_.stopped_in = phase;
    return found.status == engine::Status::solved;
  }

  bool stopped(CriticalPhase phase) {
    findings_.status = analysis_.stop_reason();
    findings_.stopped_in = phase;
    return false;
  }

  engine::Analysis& analysis_;
  const problems::WedgedProblem& problem_;
  Tightening tightening_;
  CriticalGrid grid_;
  NarrowingBracket& bracket_;
  CriticalFindings& findings_;
  double known_infeasible_;         // as infeasible_, but on another grid
  double coarse_ = 0;               // width of the grid of a start
  double from_ = 0;                 // start of the next search
  double infeasible_ = 0;           // no leaf is feasible at this coefficient or below
  std::optional<double> feasible_;  // a leaf is feasible at this coefficient
  BlockBounds bounds_;              // at `from_`
};

}  // namespace

void descend(engine::Analysis& analysis, const problems::WedgedProblem& problem,
             const CriticalGrid& grid, Tightening tightening, NarrowingBracket& bracket,
             CriticalFindings& findings) {
  CriticalDescent(analysis, problem, grid, tightening, bracket, findings).run();
}

}  // namespace kusabi::wedged
