// NodeSolver: proved bracket of t* from the interior-point iteration, and its early stop.
#include "solvers/conic/node_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/QR>

#include "solvers/conic/iteration_rules.hpp"

namespace kusabi::conic {

using support::IndexSet;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Each repetition of the projection gains several digits; more repetitions only change rounding.
template <class Real>
constexpr int max_projections = extended<Real> ? 3 : 4;

// Ratio of a residual to its rounding level above which another projection is made, if it costs a
// noticeable part of the level.
constexpr double visible_residual = 4;
constexpr double visible_cost = 1e-2;

// Corrections with longer numbers of the equations of a point in doubles.
constexpr int max_corrections = 4;

// Normal forces below this part of the largest one are treated as tending to zero.
constexpr double min_force = 1e-6;

// Limit of the modes' coefficients, where displacements are of the order of one: above it they are
// taken as unbounded, and a candidate that moves by this part of the largest normal displacement is
// certainly separated.
constexpr double runs_away = 1e4;
constexpr double clear_lift = 1e-3;

}  // namespace

template <int D, class Real>
NodeSolver<D, Real>::NodeSolver(const Matrix& compliance, std::span<const double> friction,
                                Tolerances tolerances, double error)
    : NodeSolver(NodeProgram<D, Real>(compliance, friction), tolerances, error) {}

template <int D, class Real>
NodeSolver<D, Real>::NodeSolver(const Matrix& compliance, std::span<const double> friction,
                                std::vector<int> owners, Tolerances tolerances, double error,
                                const Motions<Real>& motions, int loads)
    : NodeSolver(NodeProgram<D, Real>(compliance, friction, std::move(owners), motions, loads),
                 tolerances, error) {}

template <int D, class Real>
NodeSolver<D, Real>::NodeSolver(NodeProgram<D, Real> program, Tolerances tolerances, double error)
    : program_(std::move(program)),
      iteration_(program_),
      bounds_(program_.compliance(), error, program_.owners(), program_.motions(),
              program_.loads()),
      tolerances_(tolerances),
      reaction_(Vector::Zero(D * program_.max_cones())),
      displacement_(reaction_),
      motion_(Vector::Zero(program_.motions().lifting)),
      multipliers_(Vector::Zero(program_.first_cut())),
      trial_(reaction_),
      trial_motion_(motion_),
      face_distances_(static_cast<std::size_t>(program_.candidates())),
      best_(Vector::Zero(padded<Real>(program_.max_rows()))) {}

template <int D, class Real>
void NodeSolver<D, Real>::make_room(int max_cuts) {
  program_.make_room(max_cuts);
  iteration_ = InteriorPoint<D, Real>(program_);
  best_.setZero(padded<Real>(program_.max_rows()));
}

template <int D, class Real>
ConicResult NodeSolver<D, Real>::nothing_known() {
  for (Vector* part :
       {&reaction_, &displacement_, &motion_, &multipliers_, &best_, &trial_, &trial_motion_})
    part->setZero();
  lifted_ = {};
  ConicResult answer;
  answer.lower = -infinity;
  answer.upper = infinity;
  return answer;
}

template <int D, class Real>
bool NodeSolver<D, Real>::begin(const IndexSet& contact, const IndexSet& separated,
                                const IndexSet& ignored, std::span<const Cut> cuts) {
  program_.select(contact, separated, ignored, cuts, lifted_);
  if (program_.cones().empty()) return false;
  motion_cost_ = bounds_.motion_cost(program_.sets(), program_.friction());
  best_value_ = Real(infinity);
  proved_ = true;
  iteration_.start(program_);
  return true;
}

template <int D, class Real>
ConicResult NodeSolver<D, Real>::solve(const IndexSet& contact, const IndexSet& separated,
                                       StopEarly stop, const IndexSet& ignored,
                                       std::span<const Cut> cuts) {
  ConicResult answer = nothing_known();
  const auto settled = [&](ExaminedBound) { return is_settled(answer, stop, tolerances_); };
  do {
    if (!begin(contact, separated, ignored, cuts)) {  // the maximum over the empty set
      answer.sign = Sign::infeasible;
      answer.upper = -infinity;
      return answer;
    }
    if (!iterate(answer, Keep::best, settled) && extended<Real>) prove_contradiction(answer);
    prove_upper(answer);
  } while (extended<Real> && !settled(ExaminedBound::upper) && lift_off());
  finish(answer);
  return answer;
}

template <int D, class Real>
template <class Shorter>
ConicResult NodeSolver<D, Real>::solve_from(const NodeSolver<D, Shorter>& start,
                                            const IndexSet& contact, const IndexSet& separated,
                                            StopEarly stop, const IndexSet& ignored) {
  ConicResult answer = nothing_known();
  if (!begin(contact, separated, ignored, {}) ||
      !iteration_.start_from(start.iteration_, start.program_, program_))
    return answer;
  iterate(answer, Keep::best, [&](ExaminedBound) { return is_settled(answer, stop, tolerances_); });
  prove_upper(answer);
  finish(answer);
  return answer;
}

template <int D, class Real>
void NodeSolver<D, Real>::finish(ConicResult& answer) {
  multipliers_ = best_.head(multipliers_.size());
  answer.sign = sign_of(answer, tolerances_);
  answer.gap = answer.upper - answer.lower;
  program_.displacement(reaction_, motion_, displacement_);
}

// Both bounds improve monotonically, so an early stop and a full run cannot disagree on a sign.
template <int D, class Real>
void NodeSolver<D, Real>::decrease_upper(ConicResult& answer) {
  if (program_.motions().count() > 0) return take_equilibrated(answer, iteration_.multipliers());
  const Real value = program_.level(iteration_.dual_value(program_));
  if (!(value < best_value_)) return;
  best_value_ = value;
  if (extended<Real>) return take_multipliers(answer, iteration_.multipliers());
  best_ = iteration_.multipliers();
  proved_ = false;
  // The proof takes a product, and is postponed while the bracket is wide.
  const double upper = numbers::rounded(value);
  if (upper <= tolerances_.sign || upper - answer.lower <= 2 * known_digits_width * std::abs(upper))
    prove_upper(answer);
}

template <int D, class Real>
void NodeSolver<D, Real>::prove_upper(ConicResult& answer) {
  if (proved_) return;
  proved_ = true;
  answer.upper = std::min(answer.upper, bounds_.above(program_.sets(), program_.friction(), best_,
                                                      program_.pull(best_)));
}

template <int D, class Real>
void NodeSolver<D, Real>::take_multipliers(ConicResult& answer, const Vector& y) {
  const double upper = bounds_.above(program_.sets(), program_.friction(), y, program_.pull(y));
  if (!(upper < answer.upper)) return;
  answer.upper = upper;
  best_ = y;
}

// The multipliers of an unconstrained body prove nothing unless they are in equilibrium. Forces
// that tend to zero can prevent this; without them, or with the modes alone, the multipliers may
// prove the rest.
template <int D, class Real>
void NodeSolver<D, Real>::take_equilibrated(ConicResult& answer, const Vector& y) {
  const auto m = static_cast<Eigen::Index>(program_.candidates());
  const double largest = numbers::rounded(Real(y.head(m).cwiseAbs().maxCoeff()));
  for (const double minimum : {0.0, min_force * largest, infinity}) {
    Vector forces = y;
    for (Eigen::Index i = 0; i < m; ++i)
      if (std::abs(numbers::rounded(y[i])) < minimum) forces[i] = Real(0);
    if (minimum == infinity) forces.tail(forces.size() - program_.first_cut()).setZero();
    program_.to_multipliers(forces);
    take_multipliers(answer, forces);
    if (answer.upper < -tolerances_.min_resolved()) return;
  }
}

template <int D, class Real>
double NodeSolver<D, Real>::max_of(std::size_t cut) {
  const double force = numbers::rounded(cut_multiplier(cut));
  const double reach =
      bounds_.reach(program_.sets(), program_.friction(), best_, program_.pull(best_));
  if (!(force > 0)) return reach < 0 ? -infinity : infinity;
  const double maximum = reach / force;
  return maximum + 0x1p-51 * std::abs(maximum);
}

template <int D, class Real>
void NodeSolver<D, Real>::raise_lower(ConicResult& answer, Keep keep) {
  program_.reaction(iteration_.project(program_), trial_);
  if (!extended<Real> && answer.has_point && program_.friction_level(trial_) <= answer.lower)
    return;
  for (int projection = 1;; ++projection) {
    trial_motion_ = program_.motion(iteration_.motion());
    if (!lifted_.empty()) trial_motion_ = lifting_motion(trial_, trial_motion_);
    const auto proof = bounds_.below(program_.sets(), program_.friction(), trial_,
                                     program_.normal_displacements(trial_, trial_motion_),
                                     trial_motion_, motion_cost_);
    const bool last = projection == max_projections<Real> ||
                      proof.residual <= visible_residual * proof.noise ||
                      (!extended<Real> && proof.cost <= visible_cost * std::abs(proof.level));
    const bool proves = proof.level > answer.lower;
    if ((last || extended<Real>)&&(proves || keep == Keep::latest || !answer.has_point)) {
      reaction_ = trial_;
      motion_ = trial_motion_;
      answer.primal_residual = proof.residual;
      if (proves) answer.lower = proof.level;
      answer.has_point = answer.has_point || proves;
    }
    if (last) return;
    program_.reaction(iteration_.project_again(program_.discrepancy(), program_), trial_);
  }
}

template <int D, class Real>
template <class Longer>
ConicResult NodeSolver<D, Real>::examine_with(NodeSolver<D, Longer>& judge) {
  ConicResult answer = judge.nothing_known();
  examine_point(judge, answer);
  examine_multipliers(judge, answer);
  judge.multipliers_ = judge.best_.head(judge.multipliers_.size());
  judge.program_.displacement(judge.reaction_, judge.motion_, judge.displacement_);
  return answer;
}

// The residual is computed with longer numbers, and removed by the factor of the last iteration:
// each correction gains several digits.
template <int D, class Real>
template <class Longer>
void NodeSolver<D, Real>::examine_point(NodeSolver<D, Longer>& judge, ConicResult& answer) {
  using LongVector = VectorOf<Longer>;
  LongVector r = trial_.template cast<Longer>();
  LongVector motion = trial_motion_.template cast<Longer>();
  const NodeSets sets = program_.sets();
  Vector residual = Vector::Zero(best_.size());
  Vector change = Vector::Zero(r.size());
  Vector turn = Vector::Zero(program_.free_columns().cols());
  for (int correction = 0;; ++correction) {
    const LongVector& normal = judge.program_.normal_displacements(r, motion);
    const auto proof =
        judge.bounds_.below(sets, program_.friction(), r, normal, motion,
                            {motion_cost_.carrying_reaction, motion_cost_.closing_displacement});
    if (proof.level > answer.lower) {
      answer.lower = proof.level;
      answer.has_point = true;
      answer.primal_residual = proof.residual;
      judge.reaction_ = r;
      judge.motion_ = motion;
    }
    if (correction == max_corrections || proof.residual <= visible_residual * proof.noise) return;
    for (const int i : sets.contact_rows) residual[i] = -Real(numbers::rounded(normal[i]));
    const Eigen::Index m = program_.candidates();
    for (Eigen::Index l = m; l < program_.first_cut(); ++l)
      residual[l] = -Real(numbers::rounded(normal[l]));
    program_.to_rows(residual);
    program_.reaction_change(iteration_.correction(residual, program_, turn), change);
    r += change.template cast<Longer>();
    motion += program_.motion(turn).template cast<Longer>();
    if (!change.template cast<double>().allFinite() || !turn.template cast<double>().allFinite())
      return;  // the last factor was singular
  }
}

// The multipliers of an unconstrained body prove nothing unless H'y = 0: each changes by a part of its
// largest change.
template <int D, class Real>
template <class Longer>
void NodeSolver<D, Real>::examine_multipliers(NodeSolver<D, Longer>& judge,
                                              ConicResult& answer) const {
  const NodeSets sets = program_.sets();
  VectorOf<Longer> y = VectorOf<Longer>::Zero(judge.best_.size());
  y.head(program_.first_cut()) = best_.head(program_.first_cut()).template cast<Longer>();
  if (program_.motions().count() > 0) {
    const std::vector<int> rows = Bounds<D, Longer>::force_rows(sets);
    const std::vector<double> each = judge.bounds_.force_sizes(sets, y);
    const Eigen::Map<const Eigen::VectorXd> sizes(each.data(),
                                                  static_cast<Eigen::Index>(each.size()));
    const auto& lifts = judge.program_.normal_motions();
    const Eigen::MatrixXd shares =
        sizes.asDiagonal() * lifts(rows, Eigen::all).template cast<double>();
    const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> equations(shares.transpose());
    for (int correction = 0; correction < max_corrections; ++correction) {
      VectorOf<Longer> load = VectorOf<Longer>::Zero(lifts.cols());
      for (const int i : rows) load += y[i] * lifts.row(i).transpose();
      const Eigen::VectorXd change = equations.solve(-load.template cast<double>());
      for (std::size_t place = 0; place < rows.size(); ++place) {
        const auto at = static_cast<Eigen::Index>(place);
        y[rows[place]] += Longer(sizes[at] * change[at]);
      }
    }
  }
  if (!y.template cast<double>().allFinite()) return;
  for (const int j : sets.gap_rows)
    if (y[j] < Longer(0)) y[j] = Longer(0);
  answer.upper = judge.bounds_.above(sets, program_.friction(), y, judge.program_.pull(y));
  judge.best_ = y;
}

// Certificate of equations that no reaction with a sum of one satisfies. M is singular then, and
// the modes cannot be solved for, but some multipliers of the equations have A'y = 0, H'y = 0 and
// b'y = 1.
template <int D, class Real>
void NodeSolver<D, Real>::prove_contradiction(ConicResult& answer) {
  std::vector<Eigen::Index> equations;
  for (int i = 0; i < program_.first_cut(); ++i)
    if (program_.slack()[i] == Real(0) && !program_.empty_rows().contains(i))
      equations.push_back(i);
  const auto& [data, rows, components, count, stride] = program_.matrix();
  const Eigen::Index width = Eigen::Index{components} * count;
  const Eigen::Index modes = program_.free_columns().cols();
  Eigen::MatrixXd pulls(width + modes + 1, static_cast<Eigen::Index>(equations.size()));
  for (Eigen::Index e = 0; e < pulls.cols(); ++e) {
    const auto i = equations[static_cast<std::size_t>(e)];
    for (Eigen::Index k = 0; k < width; ++k)
      pulls(k, e) = numbers::rounded(data[(k / count * stride + k % count) * rows + i]);
    for (Eigen::Index l = 0; l < modes; ++l)
      pulls(width + l, e) = numbers::rounded(program_.free_columns()(i, l));
    pulls(width + modes, e) = numbers::rounded(program_.right_side()[i]);
  }
  const Eigen::VectorXd wanted = Eigen::VectorXd::Unit(pulls.rows(), pulls.rows() - 1);
  Vector y = Vector::Zero(best_.size());
  const Eigen::VectorXd found = pulls.completeOrthogonalDecomposition().solve(wanted);
  for (Eigen::Index e = 0; e < found.size(); ++e)
    y[equations[static_cast<std::size_t>(e)]] = Real(found[e]);
  if (program_.motions().count() > 0) return take_equilibrated(answer, y);
  take_multipliers(answer, y);
}

// Candidates without a row are displaced by as much as t can be at most.
template <int D, class Real>
auto NodeSolver<D, Real>::lifting_motion(const Vector& r, Vector motion) -> Vector {
  const Vector& normal = program_.normal_displacements(r, motion);
  const Vector each = lifts(lift_);
  Real times = 0;
  for (const int j : lifted_) {
    const Real wanted = (program_.level(Real(0)) - normal[j]) / each[j];
    if (wanted > times) times = wanted;
  }
  return motion + times * lift_;
}

template <int D, class Real>
bool NodeSolver<D, Real>::lift_off() {
  if (program_.free_columns().cols() == 0) return false;
  const Vector motion = program_.motion(iteration_.motion());
  const Vector normal = lifts(motion);
  const std::vector<int> rows = program_.candidates_with_row();
  double largest = 0;
  for (const int i : rows) largest = std::max(largest, std::abs(numbers::rounded(normal[i])));
  if (!(largest > runs_away)) return false;
  std::vector<int> held;
  IndexSet lifted;
  for (const int i : rows) {
    const bool leaves =
        program_.slack()[i] > 0 && numbers::rounded(normal[i]) > clear_lift * largest;
    if (leaves)
      lifted.insert(i);
    else
      held.push_back(i);
  }
  Matrix seen = program_.normal_motions()(held, Eigen::all);
  Matrix combination = Matrix::Identity(seen.cols(), seen.cols());
  const double largest_lift = largest_displacement(program_.normal_motions(), 0);
  const Eigen::Index fixed = eliminate(seen, combination, 1, negligible_mode, largest_lift).pivots;
  const Matrix unseen = combination.rightCols(combination.cols() - fixed);
  if (lifted.empty() || unseen.cols() == 0) return false;
  const Matrix squares = unseen.transpose() * unseen;
  Vector lift = unseen * squares.llt().solve(unseen.transpose() * motion);
  lift /= Real(largest);
  const Vector each = lifts(lift);
  for (const int j : lifted)
    if (!(numbers::rounded(each[j]) > clear_lift / 2)) return false;
  lift_ = lifted_.empty() ? lift : Vector(lift_ + lift);
  lifted_ |= lifted;
  return true;
}

// In the plane the distances are measured at the centre; in space at the last point of the
// iteration, the first at which the sign is certain. On faces of meshes in the plane distances from
// that point lead to twenty times the nodes, but in space to fewer than those from the centre (a
// truss of 50 candidates: 11,775 for 13,839; faces of cubes: half as many), and five or six
// factorisations are saved.
//
// On the central path the width of the bracket of t is the sum of all complementarities, over
// omega.
template <int D, class Real>
std::span<const FaceDistances> NodeSolver<D, Real>::face_distances() {
  if constexpr (D == 2) {
    const auto pairs = static_cast<double>(program_.cones().size() + program_.slacks());
    const Real width = centring_depth * program_.level(iteration_.dual_value(program_));
    const Real per_unit = program_.level(Real(0));
    if (!iteration_.centre(program_, width / per_unit / pairs)) return {};
  }
  iteration_.measure_faces(program_, face_distances_);
  return face_distances_;
}

template ConicResult NodeSolver<2>::examine_with(NodeSolver<2, numbers::Precise>& judge);
template ConicResult NodeSolver<3>::examine_with(NodeSolver<3, numbers::Precise>& judge);
template ConicResult NodeSolver<2, long double>::examine_with(
    NodeSolver<2, numbers::Precise>& judge);
template ConicResult NodeSolver<3, long double>::examine_with(
    NodeSolver<3, numbers::Precise>& judge);
#define KUSABI_SOLVE_FROM(D, Real, Shorter)                                                    \
  template ConicResult NodeSolver<D, Real>::solve_from(                                        \
      const NodeSolver<D, Shorter>& start, const IndexSet& contact, const IndexSet& separated, \
      StopEarly stop, const IndexSet& ignored)
KUSABI_SOLVE_FROM(2, long double, double);
KUSABI_SOLVE_FROM(3, long double, double);
KUSABI_SOLVE_FROM(2, numbers::Precise, long double);
KUSABI_SOLVE_FROM(3, numbers::Precise, long double);
#undef KUSABI_SOLVE_FROM
template class NodeSolver<2, double>;
template class NodeSolver<3, double>;
template class NodeSolver<2, long double>;
template class NodeSolver<3, long double>;
template class NodeSolver<2, numbers::Precise>;
template class NodeSolver<3, numbers::Precise>;

}  // namespace kusabi::conic
