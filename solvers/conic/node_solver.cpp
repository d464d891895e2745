// NodeSolver: proved bracket of t* from the interior-point iteration, and its early stop.
#include "solvers/conic/node_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solvers/conic/iteration_rules.hpp"

namespace kusabi::conic {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Each repetition of the projection gains several digits; more repetitions only change rounding.
constexpr int most_projections = 4;

// Ratio of a residual to its rounding level above which another projection is made, if it costs a
// noticeable part of the level.
constexpr double visible_residual = 4;
constexpr double visible_cost = 1e-2;

// Programs with fewer rows take microseconds an iteration.
constexpr int rows_that_take_long = 64;

// Normal forces below this part of the largest one are treated as tending to zero.
constexpr double least_force = 1e-6;

}  // namespace

template <int D>
NodeSolver<D>::NodeSolver(const Eigen::MatrixXd& compliance, std::span<const double> friction,
                          Tolerances tolerances, double error)
    : NodeSolver(NodeProgram<D>(compliance, friction), tolerances, error) {}

template <int D>
NodeSolver<D>::NodeSolver(const Eigen::MatrixXd& compliance, std::span<const double> friction,
                          std::vector<int> owners, Tolerances tolerances, double error,
                          const Motions<double>& motions, int loads)
    : NodeSolver(NodeProgram<D>(compliance, friction, std::move(owners), motions, loads),
                 tolerances, error) {}

template <int D>
NodeSolver<D>::NodeSolver(NodeProgram<D> program, Tolerances tolerances, double error)
    : program_(std::move(program)),
      iteration_(program_),
      bounds_(program_.compliance(), error, program_.owners(), program_.motions(),
              program_.loads()),
      tolerances_(tolerances),
      reaction_(Eigen::VectorXd::Zero(D * program_.most_cones())),
      displacement_(reaction_),
      motion_(Eigen::VectorXd::Zero(program_.motions().lifting)),
      multipliers_(Eigen::VectorXd::Zero(program_.first_cut())),
      trial_(reaction_),
      face_distances_(static_cast<std::size_t>(program_.candidates())),
      best_(Eigen::VectorXd::Zero(padded(program_.most_rows()))) {}

template <int D>
void NodeSolver<D>::make_room(int most_cuts) {
  program_.make_room(most_cuts);
  iteration_ = InteriorPoint<D>(program_);
  best_.setZero(padded(program_.most_rows()));
}

template <int D>
ConicResult NodeSolver<D>::solve(const support::IndexSet& contact,
                                 const support::IndexSet& separated, StopEarly stop,
                                 const support::IndexSet& ignored, std::span<const Cut> cuts) {
  program_.select(contact, separated, ignored, cuts);
  reaction_.setZero();
  displacement_.setZero();
  motion_.setZero();
  multipliers_.setZero();
  best_.setZero();
  ConicResult answer;
  answer.lower = -infinity;
  if (program_.cones().empty()) {  // no r has sum_i r_n = 1: the maximum over the empty set
    answer.sign = Sign::infeasible;
    answer.upper = -infinity;
    return answer;
  }
  answer.upper = infinity;
  best_value_ = infinity;
  proved_ = true;
  motion_cost_ = bounds_.motion_cost(program_.sets(), program_.friction());
  iterate(answer, stop);
  prove_upper(answer);
  multipliers_ = best_.head(multipliers_.size());
  answer.sign = sign_of(answer, tolerances_);
  answer.gap = answer.upper - answer.lower;
  program_.displacement(reaction_, motion_, displacement_);
  return answer;
}

template <int D>
void NodeSolver<D>::iterate(ConicResult& answer, StopEarly stop) {
  iteration_.start(program_);
  for (;;) {
    sink_upper(answer);
    if (is_settled(answer, stop, tolerances_) || answer.iterations == tolerances_.iterations)
      return;
    ++answer.iterations;
    if (program_.rows() >= rows_that_take_long) support::leave_if(stop_);
    if (!iteration_.factorise(program_)) return;
    raise_lower(answer);
    if (is_settled(answer, stop, tolerances_) || !iteration_.advance(program_)) return;
  }
}

// Both bounds improve monotonically, so an early stop and a full run cannot disagree on a sign.
template <int D>
void NodeSolver<D>::sink_upper(ConicResult& answer) {
  if (program_.motions().count() > 0) return prove_upper_unconstrained(answer);
  const double upper = program_.level(iteration_.dual_value(program_));
  if (!(upper < best_value_)) return;
  best_value_ = upper;
  best_ = iteration_.multipliers();
  proved_ = false;
  // The proof takes a product, and is postponed while the bracket is wide.
  if (upper <= tolerances_.sign || upper - answer.lower <= 2 * sharp * std::abs(upper))
    prove_upper(answer);
}

template <int D>
void NodeSolver<D>::prove_upper(ConicResult& answer) {
  if (proved_) return;
  proved_ = true;
  answer.upper = std::min(answer.upper, bounds_.above(program_.sets(), program_.friction(), best_,
                                                      program_.pull(best_)));
}

// The multipliers of an unconstrained body prove nothing unless they are in equilibrium. Forces
// that tend to zero can prevent this; without them, or with the modes alone, the multipliers may
// prove the rest.
template <int D>
void NodeSolver<D>::prove_upper_unconstrained(ConicResult& answer) {
  const Eigen::VectorXd& y = iteration_.multipliers();
  const auto m = static_cast<Eigen::Index>(program_.candidates());
  const double largest = y.head(m).cwiseAbs().maxCoeff();
  for (const double least : {0.0, least_force * largest, infinity}) {
    Eigen::VectorXd forces = y;
    for (Eigen::Index i = 0; i < m; ++i)
      if (std::abs(y[i]) < least) forces[i] = 0;
    if (least == infinity) forces.tail(forces.size() - program_.first_cut()).setZero();
    const double upper =
        bounds_.above(program_.sets(), program_.friction(), forces, program_.pull(forces));
    if (upper < answer.upper) {
      answer.upper = upper;
      best_ = forces;
    }
    if (answer.upper < -tolerances_.least_resolved()) return;
  }
}

template <int D>
double NodeSolver<D>::most_of(std::size_t cut) {
  const double force = best_[program_.first_cut() + static_cast<Eigen::Index>(cut)];
  const double reach =
      bounds_.reach(program_.sets(), program_.friction(), best_, program_.pull(best_));
  if (!(force > 0)) return reach < 0 ? -infinity : infinity;
  const double most = reach / force;
  return most + 0x1p-51 * std::abs(most);
}

template <int D>
void NodeSolver<D>::raise_lower(ConicResult& answer) {
  program_.reaction(iteration_.project(program_), trial_);
  if (answer.has_point && program_.friction_level(trial_) <= answer.lower) return;
  const auto examine = [&] {
    return bounds_.below(program_.sets(), program_.friction(), trial_,
                         program_.normal_displacements(trial_, iteration_.motion()),
                         iteration_.motion(), motion_cost_);
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
  motion_ = iteration_.motion();
  answer.primal_residual = proof.residual;
  if (!proves) return;
  answer.lower = proof.level;
  answer.has_point = true;
}

// On the central path the width of the bracket of t is the sum of all complementarities, over
// omega.
template <int D>
std::span<const FaceDistances> NodeSolver<D>::face_distances() {
  const auto pairs = static_cast<double>(program_.cones().size() + program_.slacks());
  const double width = centring_depth * program_.level(iteration_.dual_value(program_));
  const double per_unit = program_.level(0) - program_.level(1);
  if (!iteration_.centre(program_, width / per_unit / pairs)) return {};
  iteration_.measure(program_, face_distances_);
  return face_distances_;
}

template class NodeSolver<2>;
template class NodeSolver<3>;

}  // namespace kusabi::conic
