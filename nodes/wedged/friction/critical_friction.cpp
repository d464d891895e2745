// Programs, bisection and bounds for the critical friction coefficient of one node.
#include "nodes/wedged/friction/critical_friction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace kusabi::wedged {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Bound of the rounding error of a displacement of the multipliers that is zero, relative to the
// products in its sum. A quotient of two such displacements is arbitrary.
constexpr double rounding = 1e-13;

// First coefficient for the bound of a node without prior bound; for smaller ones the friction
// cones are extremely narrow.
constexpr double first_probe = 1e-3;

// Bounds need two or three digits only, since children have bounds of their own.
constexpr int bound_steps = 4;
constexpr double bound_digits = 1e-3;

}  // namespace

CriticalFriction::Range CriticalFriction::range(const problems::WedgedProblem& problem) {
  Range range{.minimum = min_friction, .maximum = max_friction};
  for (const double own : problem.friction) {
    if (own == 0) continue;  // at any coefficient
    range.minimum = std::max(range.minimum, min_friction / own);
    range.maximum = std::min(range.maximum, max_friction / own);
  }
  return range;
}

CriticalFriction::CriticalFriction(const problems::WedgedProblem& problem, double width,
                                   Precision precision)
    : grid_(width),
      range_(range(problem)),
      own_(problem.friction.empty() ? std::vector<double>(problem.contact_names.size(), 1)
                                    : problem.friction),
      friction_(own_),
      solver_(problem, own_, tolerances, precision) {
  if (!(width > 0))
    throw std::invalid_argument("the width of a bracket is not positive; expected one above 0");
  const auto m = static_cast<Eigen::Index>(own_.size());
  normal_compliance_.resize(m + problem.modes.matrix.cols(), problem.compliance.matrix.cols());
  for (Eigen::Index i = 0; i < m; ++i)
    normal_compliance_.row(i) =
        problem.compliance.matrix.row(problem.dimension * i) / solver_.unit();
  if (problem.modes.matrix.cols() > 0) {
    normal_compliance_.bottomRows(problem.modes.matrix.cols()) = problem.modes.matrix.transpose();
    unconstrained_ = problem;
  }
  largest_ = normal_compliance_.cwiseAbs().maxCoeff();
}

void CriticalFriction::set_friction(double factor) {
  // Between programs; within one only higher precision levels ask.
  support::throw_if_requested(stop_);
  for (std::size_t i = 0; i < own_.size(); ++i) friction_[i] = factor * own_[i];
  solver_.set_friction(friction_);
}

double CriticalFriction::min_coefficient(const Eigen::VectorXd& pull,
                                         const SignPattern& node) const {
  const double noise = rounding * largest_ * solver_.multipliers().lpNorm<1>();
  double minimum = infinity;
  for (std::size_t i = 0; i < own_.size(); ++i) {
    if (node.separated.contains(static_cast<int>(i))) continue;
    const auto at = solver_.normal(static_cast<int>(i));
    const double slip = own_[i] * (pull.segment(at + 1, solver_.dimension() - 1).norm() + noise);
    const double down = -pull[at] - noise;
    minimum = std::min(minimum, down > 0 ? down / slip : 0);
  }
  return std::max(0.0, minimum * (1 - rounding));
}

double CriticalFriction::coefficient_of_point(const SignPattern& node, double lower) const {
  double gap = infinity;    // smallest u_n of the candidates not in U
  double slack = infinity;  // of the friction cones
  double sum = 0;
  const auto tangential = [&](Eigen::Index at) {
    return solver_.reaction().segment(at + 1, solver_.dimension() - 1).norm();
  };
  for (std::size_t i = 0; i < own_.size(); ++i) {
    const int candidate = static_cast<int>(i);
    const auto at = solver_.normal(candidate);
    if (!node.contact.contains(candidate))
      gap = std::min(gap, solver_.normal_displacement(candidate));
    if (node.separated.contains(candidate)) continue;
    sum += solver_.reaction()[at];
    slack = std::min(slack, friction_[i] * solver_.reaction()[at] - tangential(at));
  }
  const double cost = std::max(0.0, std::min(gap, slack) - lower * sum) + tolerances.sign;
  if (!(gap > cost)) return infinity;
  double coefficient = 0;
  for (std::size_t i = 0; i < own_.size(); ++i) {
    if (node.separated.contains(static_cast<int>(i))) continue;
    const auto at = solver_.normal(static_cast<int>(i));
    const double normal = solver_.reaction()[at];
    if (!(normal > 0)) return infinity;
    coefficient = std::max(coefficient, (tangential(at) + cost) / (own_[i] * normal));
  }
  return coefficient;
}

FrictionProbe CriticalFriction::probe(const SignPattern& node, double factor,
                                      conic::StopEarly stop) {
  ++programs_;
  set_friction(factor);
  const auto answer = solver_.solve(node.contact, node.separated, stop);
  pull_.noalias() = normal_compliance_.transpose() * solver_.multipliers();
  FrictionProbe probe{.sign = answer.sign,
                      .degenerate = answer.sign == conic::Sign::unproved &&
                                    conic::is_within_tolerance(answer, tolerances),
                      .infeasible_below = min_coefficient(pull_, node),
                      .feasible_from = 0,
                      .newton = infinity,
                      .margin = 0.5 * (answer.lower + answer.upper)};

  // The multipliers are normal forces y, and w their displacements. For every configuration of the
  // node y'u_n >= 0, while y'u_n = sum w_i'r_i <= sum (w_ni + mu_i |w_ti|) r_ni: the node is
  // infeasible if all of these factors are negative. The slope of t* is sum (sigma t* - w_ni) r_ni
  // / (sigma factor).
  double sigma = 0;
  double weighted = 0;
  for (std::size_t i = 0; i < own_.size(); ++i) {
    if (node.separated.contains(static_cast<int>(i))) continue;
    const auto at = solver_.normal(static_cast<int>(i));
    sigma += 1 / friction_[i];
    weighted -= pull_[at] * solver_.reaction()[at];
  }
  probe.feasible_from = answer.has_point ? coefficient_of_point(node, answer.lower) : infinity;
  if (answer.has_point && std::isfinite(answer.upper)) {
    const double slope = (sigma * probe.margin + weighted) / (sigma * factor);
    if (slope > 0) probe.newton = factor - probe.margin / slope;
  }
  // The requested coefficient itself is decided by the sign.
  if (probe.sign == conic::Sign::infeasible)
    probe.infeasible_below = std::max(probe.infeasible_below, factor);
  if (probe.sign == conic::Sign::feasible)
    probe.feasible_from = std::min(probe.feasible_from, factor);
  // Smaller coefficients have no programs that confirm it.
  probe.feasible_from = std::max(probe.feasible_from, range_.minimum);
  return probe;
}

// Moves the bounds of the cell to the grid points that the probe proves. A quotient may be rounded
// past a grid point that equals it exactly.
void CriticalFriction::narrow(CriticalCell& cell, const FrictionProbe& probe,
                              std::int64_t maximum) const {
  const double below = std::min(probe.infeasible_below, at(std::min(cell.feasible, maximum)));
  auto infeasible = static_cast<std::int64_t>(std::floor(below / width()));
  if (at(infeasible + 1) <= below) ++infeasible;
  cell.infeasible = std::max(cell.infeasible, std::min(infeasible, maximum));
  if (probe.feasible_from < at(cell.feasible) && probe.feasible_from <= at(maximum)) {
    cell.feasible = static_cast<std::int64_t>(std::ceil(probe.feasible_from / width()));
    if (at(cell.feasible - 1) >= probe.feasible_from) --cell.feasible;
  }
  cell.feasible = std::max(cell.feasible, cell.infeasible + 1);
}

bool CriticalFriction::decide(const SignPattern& pattern, CriticalCell& cell, std::int64_t point) {
  if (at(point) < range_.minimum) return false;
  const auto said = probe(pattern, at(point), sign_only);
  switch (said.sign) {
    case conic::Sign::infeasible:
      cell.infeasible = point;
      return true;
    case conic::Sign::feasible:
      cell.feasible = point;
      return true;
    case conic::Sign::unproved:
      if (!said.degenerate || !is_flat(pattern, at(point))) return false;
      cell.feasible = point;
      return true;
  }
  return false;
}

bool CriticalFriction::infeasible(const SignPattern& pattern, std::int64_t point) {
  if (at(point) < range_.minimum)
    return point == 0;  // without friction no configuration is wedged, since K is definite
  return probe(pattern, at(point), {}).sign == conic::Sign::infeasible;
}

CriticalCell CriticalFriction::feasible_from(const SignPattern& pattern, CriticalCell cell,
                                             std::int64_t maximum) {
  const auto end = cell.feasible;
  cell.feasible = maximum;
  for (std::int64_t step = 0; end + step < maximum; step = std::max<std::int64_t>(1, 2 * step)) {
    if (decide(pattern, cell, end + step)) break;
  }
  return cell;
}

CriticalCell CriticalFriction::halve(const SignPattern& pattern, CriticalCell cell) {
  const auto middle = std::midpoint(cell.infeasible, cell.feasible);
  if (cell.feasible - cell.infeasible < 2 || at(middle) < range_.minimum) return cell;
  if (decide(pattern, cell, middle)) return cell;
  decide_around(pattern, cell, middle);
  return cell;
}

// The nearest decided points on both sides of an undecided one, at increasing distances.
void CriticalFriction::decide_around(const SignPattern& pattern, CriticalCell& cell,
                                     std::int64_t marginal) {
  for (std::int64_t step = 1; cell.infeasible < marginal - step; step *= 2) {
    if (at(marginal - step) < range_.minimum || decide(pattern, cell, marginal - step)) break;
  }
  for (std::int64_t step = 1; marginal + step < cell.feasible; step *= 2) {
    if (decide(pattern, cell, marginal + step)) break;
  }
}

CriticalCell CriticalFriction::bisect(const SignPattern& pattern, CriticalCell cell) {
  for (;;) {
    const auto half = halve(pattern, cell);
    if (half == cell) return cell;
    cell = half;
  }
}

CriticalCell CriticalFriction::locate(const SignPattern& pattern, CriticalCell cell,
                                      CriticalMethod method, std::int64_t maximum) {
  if (at(std::min(cell.feasible, maximum)) < range_.minimum) return cell;
  if (method == CriticalMethod::newton) return approach(pattern, cell, maximum);
  if (cell.feasible == CriticalCell::nowhere && !decide(pattern, cell, maximum)) return cell;
  return cell.feasible == CriticalCell::nowhere ? cell : bisect(pattern, cell);
}

double CriticalFriction::bound(const SignPattern& node, double from, double cutoff) {
  double known = from;
  double factor = std::max({from, range_.minimum, std::min(first_probe, cutoff)});
  for (int step = 0; step < bound_steps; ++step) {
    const auto said = probe(node, factor, {.when_infeasible = false, .when_feasible = true});
    known = std::max(known, said.infeasible_below);
    if (said.sign != conic::Sign::infeasible || known > cutoff) break;
    // Slightly below the zero of the tangent, such that the point remains infeasible.
    const double next = known + (1 - bound_digits) * (said.newton - known);
    if (!(next > known * (1 + bound_digits)) || !(next <= range_.maximum)) break;
    factor = next;
  }
  return known;
}

void CriticalFriction::tighten(std::vector<CandidateBounds> bounds) {
  solver_.make_room(static_cast<int>(bounds.size()));
  bounds_ = std::move(bounds);
}

std::optional<double> CriticalFriction::infeasible_below_with_cuts(const SignPattern& node,
                                                                   double factor) {
  const auto free =
      support::IndexSet::below(static_cast<int>(own_.size())) - (node.contact | node.separated);
  if (bounds_.empty() || free.empty()) return {};
  ++programs_;
  set_friction(factor);
  const auto cuts = cuts_of(free, bounds_);
  const auto sign = solver_.solve_with(cuts, node.contact, node.separated, {}).sign;
  if (sign == conic::Sign::unproved) return {};
  const double below = min_coefficient(solver_.pull(), node);
  return sign == conic::Sign::infeasible ? std::max(below, factor) : below;
}

double CriticalFriction::infeasible_below(const SignPattern& node, double factor) {
  const double at = std::max(factor, range_.minimum);
  if (const auto known = infeasible_below_with_cuts(node, at)) return *known;
  return probe(node, at, {.when_infeasible = true, .when_feasible = true}).infeasible_below;
}

}  // namespace kusabi::wedged
