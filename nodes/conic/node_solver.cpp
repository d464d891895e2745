// Turns the interior-point iteration into a proved bracket of t* and stops when it says enough.
#include "nodes/conic/node_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace kusabi::conic {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// A reaction counts as feasible when its equations (u_n = 0 on U, sum 1) hold to this, in the
// scaled units: above the rounding of F r, far below the tolerance of the sign.
constexpr double feasibility_tolerance = 1e-12;

// A bound this low only says that u_n = 0 on U has no solution: t* is minus infinity, and further
// iterations would push the bound down for ever.
constexpr double bottom = -1e9;

// Each repetition of the projection gains several digits; more than this only chases rounding.
constexpr int most_projections = 4;

}  // namespace

template <int D>
NodeSolver<D>::NodeSolver(const Eigen::MatrixXd& compliance, std::span<const double> friction,
                          Tolerances tolerances)
    : NodeSolver(NodeProgram<D>(compliance, friction), tolerances) {}

template <int D>
NodeSolver<D>::NodeSolver(const Eigen::MatrixXd& compliance, std::span<const double> friction,
                          std::vector<int> owners, Tolerances tolerances)
    : NodeSolver(NodeProgram<D>(compliance, friction, std::move(owners)), tolerances) {}

template <int D>
NodeSolver<D>::NodeSolver(NodeProgram<D> program, Tolerances tolerances)
    : program_(std::move(program)),
      iteration_(program_.candidates(), program_.most_cones()),
      tolerances_(tolerances),
      reaction_(Eigen::VectorXd::Zero(D * program_.most_cones())),
      displacement_(reaction_),
      multipliers_(Eigen::VectorXd::Zero(program_.candidates())),
      trial_(reaction_) {}

template <int D>
Answer NodeSolver<D>::solve(std::uint64_t contact, std::uint64_t separated, StopEarly stop) {
  program_.select(contact, separated);
  reaction_.setZero();
  displacement_.setZero();
  multipliers_.setZero();
  Answer answer;
  answer.lower = -infinity;
  if (program_.cones().empty()) {  // no r has sum_i r_n = 1: the maximum over nothing
    answer.sign = Sign::dead;
    answer.upper = -infinity;
    return answer;
  }
  answer.upper = infinity;
  iterate(answer, stop);
  if (answer.upper < -tolerances_.sign)
    answer.sign = Sign::dead;
  else if (answer.lower > tolerances_.sign)
    answer.sign = Sign::alive;
  answer.gap = answer.upper - answer.lower;
  program_.displacement(reaction_, displacement_);
  return answer;
}

template <int D>
void NodeSolver<D>::iterate(Answer& answer, StopEarly stop) {
  iteration_.start(program_);
  for (;;) {
    sink_upper(answer);
    if (settled(answer, stop) || answer.iterations == tolerances_.iterations) return;
    ++answer.iterations;
    if (!iteration_.factorise(program_)) return;
    raise_lower(answer);
    if (settled(answer, stop) || !iteration_.advance(program_)) return;
  }
}

// Both bounds only ever improve, so an early stop and a full run cannot disagree on a sign.
template <int D>
void NodeSolver<D>::sink_upper(Answer& answer) {
  const double upper = program_.level(iteration_.dual_value(program_));
  if (upper < answer.upper) {
    answer.upper = upper;
    multipliers_ = iteration_.multipliers(program_);
  }
}

template <int D>
void NodeSolver<D>::raise_lower(Answer& answer) {
  program_.reaction(iteration_.project(program_), trial_);
  if (answer.has_point && program_.friction_level(trial_) <= answer.lower) return;
  auto evidence = program_.examine(trial_);
  for (int more = 1; more < most_projections; ++more) {
    if (evidence.residual <= feasibility_tolerance) break;
    program_.reaction(iteration_.project_again(program_.discrepancy(), program_), trial_);
    evidence = program_.examine(trial_);
  }
  const bool feasible = evidence.residual <= feasibility_tolerance;
  if (feasible ? evidence.level > answer.lower : !answer.has_point) {
    reaction_.swap(trial_);
    answer.primal_residual = evidence.residual;
    if (feasible) {
      answer.lower = evidence.level;
      answer.has_point = true;
    }
  }
}

template <int D>
bool NodeSolver<D>::settled(const Answer& answer, StopEarly stop) const {
  const double zero = tolerances_.sign;
  if (stop.when_dead && answer.upper < -zero) return true;
  if (stop.when_alive && answer.lower > zero) return true;
  if (stop.when_dead && stop.when_alive && answer.upper <= zero && answer.lower >= -zero)
    return true;
  if (answer.upper < bottom) return true;
  return answer.upper - answer.lower <= tolerances_.value * std::max(1.0, std::abs(answer.upper));
}

template class NodeSolver<2>;
template class NodeSolver<3>;

}  // namespace kusabi::conic
