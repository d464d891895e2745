// Turns the interior-point iteration into a proved bracket of t* and stops when it says enough.
#include "solvers/conic/node_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace kusabi::conic {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Each repetition of the projection gains several digits; more than this only chases rounding.
constexpr int most_projections = 4;

// A residual this many times larger than what rounding alone may leave is worth another projection,
// if it costs a visible part of the level.
constexpr double visible_residual = 4;
constexpr double visible_cost = 1e-2;

}  // namespace

template <int D>
NodeSolver<D>::NodeSolver(const Eigen::MatrixXd& compliance, std::span<const double> friction,
                          Tolerances tolerances, double error)
    : NodeSolver(NodeProgram<D>(compliance, friction), tolerances, error) {}

template <int D>
NodeSolver<D>::NodeSolver(const Eigen::MatrixXd& compliance, std::span<const double> friction,
                          std::vector<int> owners, Tolerances tolerances, double error)
    : NodeSolver(NodeProgram<D>(compliance, friction, std::move(owners)), tolerances, error) {}

template <int D>
NodeSolver<D>::NodeSolver(NodeProgram<D> program, Tolerances tolerances, double error)
    : program_(std::move(program)),
      iteration_(program_.candidates(), program_.most_cones()),
      bounds_(program_.compliance(), error, program_.owners()),
      tolerances_(tolerances),
      reaction_(Eigen::VectorXd::Zero(D * program_.most_cones())),
      displacement_(reaction_),
      multipliers_(Eigen::VectorXd::Zero(program_.candidates())),
      trial_(reaction_),
      best_(Eigen::VectorXd::Zero(padded(program_.candidates()))) {}

template <int D>
Answer NodeSolver<D>::solve(std::uint64_t contact, std::uint64_t separated, StopEarly stop,
                            std::uint64_t ignored) {
  program_.select(contact, separated, ignored);
  reaction_.setZero();
  displacement_.setZero();
  multipliers_.setZero();
  best_.setZero();
  Answer answer;
  answer.lower = -infinity;
  if (program_.cones().empty()) {  // no r has sum_i r_n = 1: the maximum over nothing
    answer.sign = Sign::dead;
    answer.upper = -infinity;
    return answer;
  }
  answer.upper = infinity;
  best_value_ = infinity;
  proved_ = true;
  iterate(answer, stop);
  prove_upper(answer);
  multipliers_ = best_.head(multipliers_.size());
  answer.sign = sign_of(answer, tolerances_);
  answer.gap = answer.upper - answer.lower;
  program_.displacement(reaction_, displacement_);
  return answer;
}

template <int D>
void NodeSolver<D>::iterate(Answer& answer, StopEarly stop) {
  iteration_.start(program_);
  for (;;) {
    sink_upper(answer);
    if (is_settled(answer, stop, tolerances_) || answer.iterations == tolerances_.iterations)
      return;
    ++answer.iterations;
    if (!iteration_.factorise(program_)) return;
    raise_lower(answer);
    if (is_settled(answer, stop, tolerances_) || !iteration_.advance(program_)) return;
  }
}

// Both bounds only ever improve, so an early stop and a full run cannot disagree on a sign.
template <int D>
void NodeSolver<D>::sink_upper(Answer& answer) {
  const double upper = program_.level(iteration_.dual_value(program_));
  if (!(upper < best_value_)) return;
  best_value_ = upper;
  best_ = iteration_.multipliers();
  proved_ = false;
  // The proof takes a product. Where the bracket is wide and says nothing yet, it can wait.
  if (upper <= tolerances_.sign || upper - answer.lower <= 2 * sharp * std::abs(upper))
    prove_upper(answer);
}

template <int D>
void NodeSolver<D>::prove_upper(Answer& answer) {
  if (proved_) return;
  proved_ = true;
  answer.upper = std::min(answer.upper, bounds_.above(program_.sets(), program_.friction(), best_,
                                                      program_.pull(best_)));
}

template <int D>
void NodeSolver<D>::raise_lower(Answer& answer) {
  program_.reaction(iteration_.project(program_), trial_);
  if (answer.has_point && program_.friction_level(trial_) <= answer.lower) return;
  const auto examine = [&] {
    return bounds_.below(program_.sets(), program_.friction(), trial_,
                         program_.normal_displacements(trial_));
  };
  auto proof = examine();
  for (int more = 1; more < most_projections; ++more) {
    if (proof.residual <= visible_residual * proof.noise ||
        proof.cost <= visible_cost * std::abs(proof.level))
      break;
    program_.reaction(iteration_.project_again(program_.discrepancy(), program_), trial_);
    proof = examine();
  }
  const bool proves = proof.level > answer.lower;
  if (!proves && answer.has_point) return;
  reaction_.swap(trial_);
  answer.primal_residual = proof.residual;
  if (!proves) return;
  answer.lower = proof.level;
  answer.has_point = true;
}

template class NodeSolver<2>;
template class NodeSolver<3>;

}  // namespace kusabi::conic
