// Newton's method for the critical friction coefficient of one node.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "nodes/wedged/friction/critical_friction.hpp"
#include "nodes/wedged/friction/margin_curve.hpp"

namespace kusabi::wedged {
namespace {

// Newton's method takes 4 to 5 steps. After this many it alternates with bisection, and after
// `max_steps` only bisection is used.
constexpr int trusted_steps = 8;
constexpr int max_steps = 30;

}  // namespace

// The cell of one pattern.
class CriticalFriction::Approach {
 public:
  Approach(CriticalFriction& critical, const SignPattern& pattern, CriticalCell cell,
           std::int64_t maximum)
      : critical_(critical),
        pattern_(pattern),
        known_(cell),
        cell_(cell),
        maximum_(maximum),
        curve_(critical.width()) {}

  [[nodiscard]] const CriticalCell& cell() const { return cell_; }

  // True if the cell is found; false: bisection continues from it.
  bool run() { return approach() && is_confirmed(); }

 private:
  bool approach() {
    double factor = is_open() ? floor() : critical_.at(cell_.feasible);
    for (int step = 1; step <= max_steps; ++step) {
      const auto said = ask(factor);
      const bool to_the_end =
          cell_.infeasible >= maximum_ || (factor >= critical_.at(maximum_) && !said.degenerate);
      if (is_one_cell() || (is_open() && to_the_end)) return true;
      if (!decide_tip()) return false;
      if (is_one_cell()) return true;
      auto estimate = curve_.next(floor(), top());
      if (estimate.settled) {
        const auto before = critical_.programs_;
        if (!decide_at(estimate.factor)) return false;
        if (is_one_cell()) return true;
        // The estimate was wrong; the additional programs lead to a new one.
        if (critical_.programs_ != before) estimate = curve_.next(floor(), top());
      }
      if (step > trusted_steps && step % 3 == 0 && std::isfinite(top()))
        estimate.factor = std::midpoint(floor(), top());
      factor = std::min(estimate.factor, critical_.at(maximum_));
    }
    return false;
  }

  // The multipliers and the configuration of a program are used at other coefficients as if they
  // satisfied their equations exactly. Programs at both ends of the cell exclude that one of them
  // is wrong for this reason; if one is, only the bounds that were known before remain, and this
  // one.
  bool is_confirmed() {
    const auto contradicts = [this](std::int64_t point, conic::Sign sign) {
      return critical_.at(point) >= critical_.range_.minimum && !solved_.contains(point) &&
             critical_.probe(pattern_, critical_.at(point), sign_only).sign == sign;
    };
    if (cell_.infeasible > known_.infeasible &&
        contradicts(cell_.infeasible, conic::Sign::feasible)) {
      cell_ = {known_.infeasible, cell_.infeasible};
      return false;
    }
    if (cell_.feasible < known_.feasible && contradicts(cell_.feasible, conic::Sign::infeasible)) {
      cell_ = {cell_.feasible, known_.feasible};
      return false;
    }
    return true;
  }

  [[nodiscard]] bool is_open() const { return cell_.feasible == CriticalCell::nowhere; }
  [[nodiscard]] bool is_one_cell() const { return cell_.feasible - cell_.infeasible <= 1; }

  // Range in which t* may become zero.
  [[nodiscard]] double floor() const {
    return std::max(critical_.at(cell_.infeasible), critical_.range_.minimum);
  }
  [[nodiscard]] double top() const {
    return is_open() ? curve_.min_degenerate()
                     : std::min(curve_.min_degenerate(), critical_.at(cell_.feasible));
  }

  FrictionProbe ask(double factor) {
    const auto said = critical_.probe(pattern_, factor);
    critical_.narrow(cell_, said, maximum_);
    if (said.degenerate)
      curve_.add_degenerate(factor);
    else
      curve_.add(factor, said.margin, said.newton);
    return said;
  }

  // True if a grid point within the cell is decided: infeasible, or feasible including flat cones.
  bool decided(std::int64_t point) {
    if (point <= cell_.infeasible || point >= cell_.feasible) return true;
    if (critical_.at(point) < critical_.range_.minimum) return false;
    const auto said = ask(critical_.at(point));
    solved_.insert(point);
    if (said.sign != conic::Sign::unproved) return true;
    if (!said.degenerate || !critical_.is_flat(pattern_, critical_.at(point))) return false;
    cell_.feasible = point;
    return true;
  }

  // Decides the grid points at both ends of a range of two cells. Degenerate points are tested for
  // flat cones only here: if one is a flat cone, so are those above.
  // @return false: one is undecided
  bool decide_tip() {
    const double end = std::min(top(), critical_.at(maximum_));
    const auto tip =
        std::min(cell_.feasible, static_cast<std::int64_t>(std::ceil(end / critical_.width())));
    return tip - cell_.infeasible > 2 || (decided(tip) && decided(cell_.infeasible + 1));
  }

  // Decides the two grid points around a coefficient. @return false: one is undecided
  bool decide_at(double factor) {
    const auto below = static_cast<std::int64_t>(std::floor(factor / critical_.width()));
    if (decided(below + 1) && decided(below)) return true;
    if (!is_open() && below > cell_.infeasible && below < cell_.feasible)
      critical_.decide_around(pattern_, cell_, below);
    return false;
  }

  CriticalFriction& critical_;
  const SignPattern& pattern_;
  CriticalCell known_;  // before
  CriticalCell cell_;
  std::int64_t maximum_;
  MarginCurve curve_;
  std::set<std::int64_t> solved_;  // grid points with a program
};

CriticalCell CriticalFriction::approach(const SignPattern& pattern, CriticalCell cell,
                                        std::int64_t maximum) {
  Approach newton(*this, pattern, cell, maximum);
  if (newton.run()) return newton.cell();
  return locate(pattern, newton.cell(), CriticalMethod::bisection, maximum);
}

}  // namespace kusabi::wedged
