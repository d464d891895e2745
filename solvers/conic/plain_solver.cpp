// PlainSolver: the interior-point iteration of interior_point.cpp without packs and padding.
#include "solvers/conic/plain_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "solvers/conic/iteration_rules.hpp"

namespace kusabi::conic {

using support::IndexSet;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr int most_projections = 3;

// Extended precision takes more iterations.
constexpr int most_iterations = 150;

// As in node_solver.cpp.
constexpr double least_force = 1e-6;

// Threshold, relative to the largest mode, below which a mode does not displace the cones of a
// node, up to the rounding of positions and directions in the file.
constexpr double not_felt = 1e-10;

// Limit of the modes' coefficients, where displacements are of the order of one: above it they are
// taken as unbounded, and a candidate that moves by this part of the largest normal displacement is
// certainly separated.
constexpr double runs_away = 1e4;
constexpr double clear_lift = 1e-3;

IndexSet set_of(const std::vector<int>& candidates) {
  IndexSet set;
  for (const int i : candidates) set.insert(i);
  return set;
}

std::vector<int> one_each(std::size_t count) {
  std::vector<int> owners(count);
  for (std::size_t i = 0; i < count; ++i) owners[i] = static_cast<int>(i);
  return owners;
}

}  // namespace

template <int D, class Real>
PlainSolver<D, Real>::PlainSolver(Matrix compliance, std::span<const double> friction,
                                  Tolerances tolerances, double error, Motions<Real> motions,
                                  int loads)
    : compliance_(std::move(compliance)),
      motions_(std::move(motions)),
      friction_(friction.begin(), friction.end()),
      tolerances_(tolerances),
      bounds_(compliance_, error, one_each(friction.size()), motions_, loads),
      loads_(loads),
      reaction_(Vector::Zero(compliance_.rows())),
      motion_(Vector::Zero(motions_.lifting)),
      multipliers_(Vector::Zero(compliance_.rows() / D + motions_.count())) {
  // the constructor allocates; solvers are copied with their state
  schur_.compute(Matrix::Identity(motions_.lifting, motions_.lifting));
  const Eigen::Index m = compliance_.rows() / D;
  normal_compliance_.resize(m + motions_.count(), compliance_.cols());
  for (Eigen::Index i = 0; i < m; ++i) normal_compliance_.row(i) = compliance_.row(D * i);
  for (Eigen::Index l = 0; l < motions_.count(); ++l)
    normal_compliance_.row(m + l) = motions_.at_cones.col(l).transpose();
}

template <int D, class Real>
void PlainSolver<D, Real>::select(const IndexSet& contact, const IndexSet& separated,
                                  const IndexSet& ignored) {
  contact_ = contact;
  cones_.clear();
  gap_rows_.clear();
  contact_rows_.clear();
  rows_.clear();
  slack_.clear();
  omega_ = Real(0);
  for (std::size_t i = 0; i < friction_.size(); ++i) {
    const auto candidate = static_cast<int>(i);
    if (ignored.contains(candidate)) continue;
    if (i + static_cast<std::size_t>(loads_) < friction_.size()) {
      const bool touches = contact.contains(candidate);
      (touches ? contact_rows_ : gap_rows_).push_back(candidate);
      if (!lifted_.contains(candidate)) {
        rows_.push_back(candidate);
        slack_.push_back(!touches);
      }
    }
    if (separated.contains(candidate)) continue;
    cones_.push_back(candidate);
    omega_ += friction_[i] == 0 ? Real(1) : Real(1) / Real(friction_[i]);
  }
  motion_cost_ = bounds_.motion_cost(sets(), friction_);
  choose_motions();
  choose_equations();
  slack_.insert(slack_.end(), static_cast<std::size_t>(equations_.cols()), false);
  const auto rows = static_cast<Eigen::Index>(slack_.size());
  free_columns_ = Matrix::Zero(rows, free_motions_.cols());
  free_columns_.topRows(static_cast<Eigen::Index>(rows_.size())) =
      normal_motions(rows_) * free_motions_;
  right_side_ = Vector::Zero(rows);
  columns_.resize(cones_.size());
  for (std::size_t c = 0; c < cones_.size(); ++c) {
    const int k = cones_[c];
    const double mu = friction_[static_cast<std::size_t>(k)];
    columns_[c].resize(rows, D);
    for (int d = 0; d < D; ++d) {
      columns_[c].col(d) = by_rows(normal_compliance_.col(D * k + d));
      if (d > 0) columns_[c].col(d) *= Real(mu);
    }
    right_side_ += mu == 0 ? Vector(columns_[c].col(0)) : Vector(columns_[c].col(0) / Real(mu));
  }
  for (Eigen::Index i = 0; i < rows; ++i) {
    if (slack_[static_cast<std::size_t>(i)]) right_side_[i] -= Real(1);
    right_side_[i] /= -omega_;
  }
  for (Matrix& column : columns_) column.col(0) += right_side_;
}

template <int D, class Real>
auto PlainSolver<D, Real>::normal_motions(const std::vector<int>& candidates) const -> Matrix {
  Matrix normal(static_cast<Eigen::Index>(candidates.size()), motions_.lifting);
  // A constrained body has no rows of modes.
  for (Eigen::Index i = 0; motions_.lifting > 0 && i < normal.rows(); ++i)
    normal.row(i) =
        motions_.at_cones.row(D * candidates[static_cast<std::size_t>(i)]).head(motions_.lifting);
  return normal;
}

// Restricts the modes to those visible in the rows; any other would give a zero column.
template <int D, class Real>
void PlainSolver<D, Real>::choose_motions() {
  Matrix seen = normal_motions(rows_);
  Matrix combination = Matrix::Identity(seen.cols(), seen.cols());
  const Eigen::Index independent = eliminate(seen, combination, 1, not_felt).pivots;
  free_motions_ = combination.leftCols(independent);
}

// Drops redundant equilibrium equations: on few cones some read 0 = 0, and their multipliers drift.
template <int D, class Real>
void PlainSolver<D, Real>::choose_equations() {
  const Eigen::Index p = motions_.count();
  Matrix felt(D * static_cast<Eigen::Index>(cones_.size()), p);
  for (std::size_t c = 0; p > 0 && c < cones_.size(); ++c) {
    const auto row = D * static_cast<Eigen::Index>(c);
    felt.template middleRows<D>(row) = motions_.at_cones.template middleRows<D>(D * cones_[c]);
    felt.template middleRows<D - 1>(row + 1) *=
        Real(friction_[static_cast<std::size_t>(cones_[c])]);
  }
  Matrix combination = Matrix::Identity(p, p);
  const Eigen::Index independent = eliminate(felt, combination, 1, not_felt).pivots;
  equations_ = combination.leftCols(independent);
}

template <int D, class Real>
auto PlainSolver<D, Real>::by_rows(const Vector& all) const -> Vector {
  const auto own = static_cast<Eigen::Index>(rows_.size());
  Vector rows(own + equations_.cols());
  for (Eigen::Index i = 0; i < own; ++i) rows[i] = all[rows_[static_cast<std::size_t>(i)]];
  rows.tail(equations_.cols()) = equations_.transpose() * all.tail(equations_.rows());
  return rows;
}

template <int D, class Real>
auto PlainSolver<D, Real>::multipliers_of_all() const -> Vector {
  Vector all = Vector::Zero(normal_compliance_.rows());
  for (std::size_t i = 0; i < rows_.size(); ++i) all[rows_[i]] = y_[static_cast<Eigen::Index>(i)];
  all.tail(equations_.rows()) = equations_ * y_.tail(equations_.cols());
  return all;
}

template <int D, class Real>
auto PlainSolver<D, Real>::transposed(std::size_t cone, const Vector& y) const -> Cone {
  Cone product;
  for (int d = 0; d < D; ++d) product[static_cast<std::size_t>(d)] = columns_[cone].col(d).dot(y);
  return product;
}

template <int D, class Real>
auto PlainSolver<D, Real>::products(const std::vector<Cone>& points) const -> Vector {
  Vector sum = Vector::Zero(right_side_.size());
  for (std::size_t c = 0; c < points.size(); ++c)
    for (int d = 0; d < D; ++d) sum += columns_[c].col(d) * points[c][static_cast<std::size_t>(d)];
  return sum;
}

template <int D, class Real>
auto PlainSolver<D, Real>::reaction_of(const std::vector<Cone>& x) const -> Vector {
  Vector r = Vector::Zero(compliance_.rows());
  Real sum = 0;
  for (const Cone& point : x) sum += point[0];
  const Real t = level(sum);
  for (std::size_t c = 0; c < cones_.size(); ++c) {
    const int k = cones_[c];
    const double mu = friction_[static_cast<std::size_t>(k)];
    r[D * k] = x[c][0] + (mu == 0 ? t : Real(t / Real(mu)));
    for (int d = 1; d < D; ++d) r[D * k + d] = Real(mu) * x[c][static_cast<std::size_t>(d)];
  }
  return r;
}

template <int D, class Real>
bool PlainSolver<D, Real>::refresh_dual(const Vector& y) {
  bool inside = true;
  for (std::size_t c = 0; c < cones_.size(); ++c) {
    const Cone product = transposed(c, y);
    z_[c][0] = Real(1) - product[0];
    for (std::size_t d = 1; d < D; ++d) z_[c][d] = -product[d];
    inside = inside && margin(z_[c]) > Real(0);
  }
  for (std::size_t i = 0; i < slack_.size(); ++i)
    inside = inside && (!slack_[i] || y[static_cast<Eigen::Index>(i)] > Real(0));
  return inside;
}

template <int D, class Real>
void PlainSolver<D, Real>::start() {
  const auto rows = static_cast<Eigen::Index>(slack_.size());
  const auto count = static_cast<double>(cones_.size());
  y_ = Vector::Zero(rows);
  v_ = Vector::Zero(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    if (!slack_[static_cast<std::size_t>(i)]) continue;
    y_[i] = Real(1);
    v_[i] = Real(start_slack / count);
  }
  double size = start_limit;
  for (std::size_t c = 0; c < cones_.size(); ++c) {
    const Cone push = transposed(c, y_);
    const double outward = numbers::rounded(Real(push[0] + radius(push)));
    if (outward * size > start_share) size = start_share / outward;
  }
  y_ *= Real(size);
  Cone centre;
  centre.fill(Real(0));
  centre[0] = Real(start_point / count);
  x_.assign(cones_.size(), centre);
  z_.assign(cones_.size(), centre);
  scaling_.resize(cones_.size());
  best_value_ = Real(infinity);
  projected_motion_ = Vector::Zero(free_motions_.cols());
  refresh_dual(y_);
}

template <int D, class Real>
ConicResult PlainSolver<D, Real>::nothing_known() {
  reaction_.setZero();
  motion_.setZero();
  multipliers_.setZero();
  lifted_ = {};
  ConicResult answer;
  answer.lower = -infinity;
  answer.upper = infinity;
  return answer;
}

template <int D, class Real>
bool PlainSolver<D, Real>::factorise() {
  const auto rows = static_cast<Eigen::Index>(slack_.size());
  Matrix scaled(rows, D * static_cast<Eigen::Index>(cones_.size()));
  Real widest = 0;
  complementarity_ = Real(0);
  for (std::size_t c = 0; c < cones_.size(); ++c) {
    scaling_[c] = NesterovToddScaling<D, Real>(x_[c], z_[c]);
    const Cone lambda = scaling_[c].lambda();
    complementarity_ += dot(lambda, lambda);
    if (scaling_[c].entry(0, 0) > widest) widest = scaling_[c].entry(0, 0);
    for (Eigen::Index i = 0; i < rows; ++i) {
      Cone entries;
      for (int d = 0; d < D; ++d) entries[static_cast<std::size_t>(d)] = columns_[c](i, d);
      const Cone product = scaling_[c].times(entries);
      for (int d = 0; d < D; ++d)
        scaled(i, D * static_cast<Eigen::Index>(c) + d) = product[static_cast<std::size_t>(d)];
    }
  }
  Matrix normal = scaled * scaled.transpose();
  w_ = Vector::Zero(rows);
  lambda_ = Vector::Ones(rows);
  // Bound of rounding in a linearly dependent row (Higham, theorem 10.3).
  const Real shift = Real(4 * static_cast<double>(rows) * numbers::unit_roundoff<Real>);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Real b = right_side_[i];
    normal(i, i) += shift * (normal(i, i) + widest * widest * b * b);
    if (!slack_[static_cast<std::size_t>(i)]) continue;
    w_[i] = root(Real(v_[i] / y_[i]));
    lambda_[i] = root(Real(v_[i] * y_[i]));
    complementarity_ += v_[i] * y_[i];
    normal(i, i) += v_[i] / y_[i];
  }
  Real weight = 0;  // see InteriorPoint::hold_motions
  if (free_motions_.cols() > 0) {
    for (Eigen::Index i = 0; i < rows; ++i) weight += normal(i, i) - w_[i] * w_[i];
    weight /= free_columns_.squaredNorm();
    normal += weight * (free_columns_ * free_columns_.transpose());
  }
  const Eigen::LLT<Matrix> factor(normal);
  if (factor.info() != Eigen::Success) return false;
  factor_ = factor.matrixL();
  primal_residual_ = right_side_ + v_ - products(x_);
  Vector target = right_side_;
  if (free_motions_.cols() > 0)
    target -= weight * (free_columns_ * (free_columns_.transpose() * y_));
  predictor_ = solved(target);
  correction_ = solved(primal_residual_);
  if (free_motions_.cols() > 0 && !solve_for_motions()) return false;
  const Real check = predictor_.dot(right_side_) + correction_.dot(primal_residual_);
  return std::isfinite(numbers::rounded(check));
}

template <int D, class Real>
bool PlainSolver<D, Real>::solve_for_motions() {
  moved_ = free_columns_;
  for (Eigen::Index l = 0; l < moved_.cols(); ++l) moved_.col(l) = solved(moved_.col(l));
  schur_.compute(free_columns_.transpose() * moved_);
  if (schur_.info() != Eigen::Success) return false;
  projected_motion_ = balance(correction_);
  balance(predictor_);
  predictor_ -= moved_ * schur_.solve(free_columns_.transpose() * y_);
  return true;
}

template <int D, class Real>
auto PlainSolver<D, Real>::balance(Vector& solution) const -> Vector {
  const Vector motion = schur_.solve(free_columns_.transpose() * solution);
  solution -= moved_ * motion;
  return motion;
}

template <int D, class Real>
auto PlainSolver<D, Real>::normal_displacements(const Vector& r, const Vector& motion) const
    -> Vector {
  Vector normal = normal_compliance_ * r;
  if (motion.size() > 0)
    for (std::size_t i = 0; i < friction_.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      normal[row] += motions_.at_cones.row(D * row).head(motion.size()).dot(motion);
    }
  return normal;
}

template <int D, class Real>
auto PlainSolver<D, Real>::displacement() const -> Vector {
  Vector u = compliance_ * reaction_;
  if (motion_.size() > 0) u += motions_.at_cones.leftCols(motion_.size()) * motion_;
  return u;
}

template <int D, class Real>
auto PlainSolver<D, Real>::solved(Vector right_side) const -> Vector {
  factor_.template triangularView<Eigen::Lower>().solveInPlace(right_side);
  factor_.transpose().template triangularView<Eigen::Upper>().solveInPlace(right_side);
  return right_side;
}

template <int D, class Real>
auto PlainSolver<D, Real>::shifted(const std::vector<Cone>& x, const Vector& weights) const
    -> std::vector<Cone> {
  std::vector<Cone> result = x;
  for (std::size_t c = 0; c < result.size(); ++c) {
    const Cone shift = scaling_[c].times(scaling_[c].times(transposed(c, weights)));
    for (std::size_t d = 0; d < D; ++d) result[c][d] += shift[d];
  }
  return result;
}

template <int D, class Real>
auto PlainSolver<D, Real>::direction(const Vector& dy, const std::vector<Cone>& q,
                                     const Vector& q_rows) const -> Step {
  Step step{q, q, q_rows, Vector::Zero(dy.size()), Real(0), Real(0)};
  const auto widen = [](Real& inverse, const Real& candidate) {
    if (candidate > inverse) inverse = candidate;
  };
  for (std::size_t c = 0; c < cones_.size(); ++c) {
    const Cone lambda = scaling_[c].lambda();
    step.z[c] = scaling_[c].times(transposed(c, dy));
    for (std::size_t d = 0; d < D; ++d) {
      step.z[c][d] = -step.z[c][d];
      step.x[c][d] = q[c][d] - lambda[d] - step.z[c][d];
    }
    widen(step.inverse_dual_length, scaling_[c].inverse_step_length(step.z[c]));
    widen(step.inverse_primal_length, scaling_[c].inverse_step_length(step.x[c]));
  }
  for (Eigen::Index i = 0; i < dy.size(); ++i) {
    if (!slack_[static_cast<std::size_t>(i)]) continue;
    step.y[i] = w_[i] * dy[i];
    step.v[i] = q_rows[i] - lambda_[i] - step.y[i];
    widen(step.inverse_dual_length, -step.y[i] / lambda_[i]);
    widen(step.inverse_primal_length, -step.v[i] / lambda_[i]);
  }
  return step;
}

template <int D, class Real>
bool PlainSolver<D, Real>::advance() {
  const auto rows = static_cast<Eigen::Index>(slack_.size());
  Cone nothing;
  nothing.fill(Real(0));
  const Step predicted =
      direction(predictor_, std::vector<Cone>(cones_.size(), nothing), Vector::Zero(rows));
  Real most(1);
  if (predicted.inverse_dual_length > most) most = predicted.inverse_dual_length;
  if (predicted.inverse_primal_length > most) most = predicted.inverse_primal_length;
  const Real affine_length = Real(1) / most;
  const Real rest = Real(1) - affine_length;
  const Real sigma = rest * rest * rest;
  const auto slacks = std::count(slack_.begin(), slack_.end(), true);
  const auto degree = static_cast<double>(cones_.size()) + static_cast<double>(slacks);
  const Real sigma_mu = sigma * complementarity_ / Real(degree);

  std::vector<Cone> q(cones_.size());
  std::vector<Cone> scaled(cones_.size());
  for (std::size_t c = 0; c < cones_.size(); ++c) {
    Cone right_side = jordan_product(predicted.x[c], predicted.z[c]);
    for (Real& component : right_side) component *= -affine_length;
    right_side[0] += sigma_mu;
    q[c] = scaling_[c].jordan_divide(right_side);
    scaled[c] = scaling_[c].times(q[c]);
  }
  Vector right = products(scaled);
  Vector q_rows = Vector::Zero(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    if (!slack_[static_cast<std::size_t>(i)]) continue;
    q_rows[i] = (sigma_mu - affine_length * predicted.v[i] * predicted.y[i]) / lambda_[i];
    right[i] -= w_[i] * q_rows[i];
  }
  Vector rest_of_centring = solved(right);
  if (free_motions_.cols() > 0) balance(rest_of_centring);
  const Vector dy = predictor_ - rest_of_centring - sigma * correction_;
  const Step corrected = direction(dy, q, q_rows);
  const Real share(boundary_fraction);
  const auto length = [&](const Real& edge) { return edge > share ? share / edge : Real(1); };
  const Real primal_length = length(corrected.inverse_primal_length);
  Real dual_length = length(corrected.inverse_dual_length);
  if (!(std::max(numbers::rounded(primal_length), numbers::rounded(dual_length)) >
        least_step_length))
    return false;

  bool inside = true;
  for (std::size_t c = 0; c < cones_.size(); ++c) {
    const Cone change = scaling_[c].times(corrected.x[c]);
    for (std::size_t d = 0; d < D; ++d) x_[c][d] += primal_length * change[d];
    inside = inside && margin(x_[c]) > Real(0);
  }
  for (Eigen::Index i = 0; i < rows; ++i) {
    if (!slack_[static_cast<std::size_t>(i)]) continue;
    v_[i] += primal_length * w_[i] * corrected.v[i];
    inside = inside && v_[i] > Real(0);
  }
  if (!inside) return false;
  for (int halving = 0; halving <= most_halvings; ++halving, dual_length *= Real(0.5)) {
    const Vector trial = y_ + dual_length * dy;
    if (!refresh_dual(trial)) continue;
    y_ = trial;
    return true;
  }
  return false;
}

template <int D, class Real>
void PlainSolver<D, Real>::prove_upper(ConicResult& answer) {
  if (motions_.count() > 0) return prove_upper_unconstrained(answer);
  const Real value = level(right_side_.dot(y_));
  if (!(value < best_value_)) return;
  best_value_ = value;
  const Vector y = multipliers_of_all();
  const Vector pull = normal_compliance_.transpose() * y;
  const double upper = bounds_.above(sets(), friction_, y, pull);
  if (upper < answer.upper) {
    answer.upper = upper;
    multipliers_ = y;
  }
}

// As NodeSolver::prove_upper_unconstrained.
template <int D, class Real>
void PlainSolver<D, Real>::prove_upper_unconstrained(ConicResult& answer) {
  const auto m = static_cast<Eigen::Index>(friction_.size());
  const Vector y = multipliers_of_all();
  const double largest = numbers::rounded(Real(y.head(m).cwiseAbs().maxCoeff()));
  for (const double least : {0.0, least_force * largest, infinity}) {
    Vector forces = y;
    for (Eigen::Index i = 0; i < m; ++i)
      if (std::abs(numbers::rounded(Real(y[i]))) < least) forces[i] = Real(0);
    const Vector pull = normal_compliance_.transpose() * forces;
    const double upper = bounds_.above(sets(), friction_, forces, pull);
    if (upper < answer.upper) {
      answer.upper = upper;
      multipliers_ = forces;
    }
    if (answer.upper < -tolerances_.least_resolved()) return;
  }
}

// If the equations alone exclude sum r_n = 1, M is singular, and the modes cannot be solved for.
// Some multipliers of the equations then have w = -e_n.
template <int D, class Real>
void PlainSolver<D, Real>::prove_contradiction(ConicResult& answer) {
  const auto width = D * static_cast<Eigen::Index>(cones_.size());
  std::vector<Eigen::Index> equations;
  for (std::size_t i = 0; i < slack_.size(); ++i)
    if (!slack_[i]) equations.push_back(static_cast<Eigen::Index>(i));
  Eigen::MatrixXd pulls(width + free_columns_.cols(), static_cast<Eigen::Index>(equations.size()));
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(pulls.rows());
  for (std::size_t c = 0; c < cones_.size(); ++c) {
    const auto at = D * static_cast<Eigen::Index>(c);
    wanted[at] = -1;
    for (int d = 0; d < D; ++d)
      pulls.row(at + d) =
          by_rows(normal_compliance_.col(D * cones_[c] + d))(equations).template cast<double>();
  }
  pulls.bottomRows(free_columns_.cols()) =
      free_columns_(equations, Eigen::all).transpose().template cast<double>();
  y_.setZero();
  y_(equations) = pulls.completeOrthogonalDecomposition().solve(wanted).template cast<Real>();
  best_value_ = Real(infinity);
  prove_upper(answer);
}

// Candidates without a row are displaced by as much as t can be at most.
template <int D, class Real>
auto PlainSolver<D, Real>::lifting_motion(const Vector& r, Vector motion) const -> Vector {
  if (lifted_.empty()) return motion;
  const Vector normal = normal_displacements(r, motion);
  const Vector lifts = normal_displacements(Vector::Zero(r.size()), lift_);
  Real times = 0;
  for (const int j : lifted_) {
    const Real wanted = (Real(1) / omega_ - normal[j]) / lifts[j];
    if (wanted > times) times = wanted;
  }
  return motion + times * lift_;
}

template <int D, class Real>
bool PlainSolver<D, Real>::lift_off() {
  if (free_motions_.cols() == 0) return false;
  const Vector motion = free_motions_ * projected_motion_;
  const Vector lifts = normal_displacements(Vector::Zero(compliance_.rows()), motion);
  double largest = 0;
  for (const int i : rows_) largest = std::max(largest, std::abs(numbers::rounded(Real(lifts[i]))));
  if (!(largest > runs_away)) return false;
  std::vector<int> held;
  IndexSet lifted;
  for (const int i : rows_) {
    const bool leaves =
        !contact_.contains(i) && numbers::rounded(Real(lifts[i])) > clear_lift * largest;
    if (leaves)
      lifted.insert(i);
    else
      held.push_back(i);
  }
  Matrix seen = normal_motions(held);
  Matrix combination = Matrix::Identity(seen.cols(), seen.cols());
  const Eigen::Index fixed = eliminate(seen, combination, 1, not_felt).pivots;
  const Matrix unseen = combination.rightCols(combination.cols() - fixed);
  if (lifted.empty() || unseen.cols() == 0) return false;
  const Matrix squares = unseen.transpose() * unseen;
  Vector lift = unseen * squares.llt().solve(unseen.transpose() * motion);
  lift /= Real(largest);
  const Vector of_lift = normal_displacements(Vector::Zero(compliance_.rows()), lift);
  for (const int j : lifted)
    if (!(numbers::rounded(Real(of_lift[j])) > clear_lift / 2)) return false;
  lift_ = lifted_.empty() ? lift : Vector(lift_ + lift);
  lifted_ |= lifted;
  return true;
}

template <int D, class Real>
void PlainSolver<D, Real>::prove_lower(ConicResult& answer, Keep keep) {
  std::vector<Cone> x = shifted(x_, correction_);
  Vector share = projected_motion_;
  for (int projection = 1;; ++projection) {
    const Vector r = reaction_of(x);
    const Vector motion = lifting_motion(r, free_motions_ * share);
    const Vector normal = normal_displacements(r, motion);
    const auto proof = bounds_.below(sets(), friction_, r, normal, motion, motion_cost_);
    if (keep == Keep::latest || proof.level > answer.lower || !answer.has_point) {
      reaction_ = r;
      motion_ = motion;
      answer.primal_residual = proof.residual;
    }
    if (proof.level > answer.lower) {
      answer.lower = proof.level;
      answer.has_point = true;
    }
    if (projection == most_projections || proof.residual <= 4 * proof.noise) return;
    Vector right = -by_rows(normal);
    for (std::size_t i = 0; i < slack_.size(); ++i)
      if (slack_[i]) right[static_cast<Eigen::Index>(i)] = Real(0);
    Vector weights = solved(right);
    if (free_motions_.cols() > 0) share += balance(weights);
    x = shifted(x, weights);
  }
}

template <int D, class Real>
ConicResult PlainSolver<D, Real>::solve(const IndexSet& contact, const IndexSet& separated,
                                        StopEarly stop, const IndexSet& ignored) {
  ConicResult answer = nothing_known();
  do {
    select(contact, separated, ignored);
    start();
    for (int iteration = 0;; ++iteration) {
      prove_upper(answer);
      if (is_settled(answer, stop, tolerances_) || iteration == most_iterations) break;
      ++answer.iterations;
      support::leave_if(stop_);
      if (!factorise()) {
        prove_contradiction(answer);
        break;
      }
      prove_lower(answer, Keep::best);
      if (is_settled(answer, stop, tolerances_) || !advance()) break;
    }
  } while (!is_settled(answer, stop, tolerances_) && lift_off());
  answer.sign = sign_of(answer, tolerances_);
  answer.gap = answer.upper - answer.lower;
  return answer;
}

// sum_k R_k |r_k| over all components, R = sqrt(F_kk). Times R_j it is the magnitude of u_nj
// without cancellation, and large compared with the rounding of directions and positions in the
// file, carried into F. (F_jk itself is not a measure: for a candidate held by a single bar it
// consists of that rounding.)
template <int D, class Real>
double PlainSolver<D, Real>::reaction_size() const {
  double sum = 0;
  for (Eigen::Index i = 0; i < compliance_.rows(); ++i)
    sum +=
        std::sqrt(numbers::rounded(compliance_(i, i))) * std::abs(numbers::rounded(reaction_[i]));
  return sum;
}

// r_n and u_n of all candidates relative to that magnitude, in two groups of m numbers. Zero for
// values that the node fixes at zero.
template <int D, class Real>
void PlainSolver<D, Real>::take_sizes(std::vector<double>& sizes) const {
  const auto m = static_cast<Eigen::Index>(friction_.size());
  sizes.assign(static_cast<std::size_t>(2 * m), 0.0);
  const double whole = reaction_size();
  const Vector normal = normal_displacements(reaction_, motion_);
  for (const int k : cones_) {
    const double root = std::sqrt(numbers::rounded(normal_compliance_(k, D * k)));
    sizes[static_cast<std::size_t>(k)] =
        std::max(0.0, numbers::rounded(reaction_[D * k]) * root / whole);
  }
  for (const int j : gap_rows_) {
    const double root = std::sqrt(numbers::rounded(normal_compliance_(j, D * j)));
    sizes[static_cast<std::size_t>(m + j)] =
        std::max(0.0, numbers::rounded(Real(normal[j])) / (root * whole));
  }
}

namespace {

/// A range of widths of the bracket, in which sizes are compared at its beginning and at its end.
struct Window {
  double widest, opens, closes, least;
};

/// The window above the rounding of the file: a normal with sixteen digits that should be parallel
/// to a bar gives a degenerate node at t* = 1e-17 only, and below that the points tend to a vertex
/// of X.
constexpr Window shallow{1e-5, 1e-7, 1e-12, 3e-15};
/// The window for small values that do not vanish, if t* is exactly zero.
constexpr Window deep{1e-9, 1e-11, 1e-19, 0};

/// A size that decreases by less than `stays` does not vanish. A size that vanishes decreases at
/// least with the root of the ratio of the widths, within a factor `miss`.
constexpr double stays = 0.1, miss = 3;

/// Rounding level of the file.
constexpr double file_rounding = 1e-13;

}  // namespace

template <int D, class Real>
std::optional<RelativeInterior> PlainSolver<D, Real>::relative_interior(const IndexSet& contact,
                                                                        const IndexSet& separated,
                                                                        const IndexSet& ignored) {
  ConicResult answer = nothing_known();
  std::vector<Snapshot> path;
  do {
    select(contact, separated, ignored);
    if (cones_.empty()) return std::nullopt;
    start();
    path.clear();
    for (int iteration = 0;; ++iteration) {
      prove_upper(answer);
      if (iteration == most_iterations) break;
      ++answer.iterations;
      support::leave_if(stop_);
      if (!factorise()) break;
      prove_lower(answer, Keep::latest);
      // Bracket of the iteration itself, without the rounding errors of the bounds.
      path.push_back({numbers::rounded(Real(complementarity_ / omega_)), {}, reaction_, motion_});
      take_sizes(path.back().sizes);
      if (path.back().width <= deep.closes || !advance()) break;
    }
  } while (lift_off());
  if (!is_tie(answer, tolerances_)) return std::nullopt;
  // Infeasible by more than the rounding of the file: X is empty.
  if (answer.upper < 0 && violation() > 10 * file_rounding) return RelativeInterior{};
  const IndexSet carriers = set_of(cones_);
  const IndexSet movers = set_of(gap_rows_);
  if (answer.lower > 0) {  // feasible, though within the tolerance: nothing vanishes
    const auto& sizes = path.back().sizes;
    bool all = true;
    for (const int i : cones_) all = all && sizes[static_cast<std::size_t>(i)] > file_rounding;
    for (const int i : gap_rows_)
      all = all && sizes[friction_.size() + static_cast<std::size_t>(i)] > file_rounding;
    if (all) return RelativeInterior{carriers, movers};
  }
  for (const Window& window : {shallow, deep}) {
    const Snapshot* open = nullptr;
    const Snapshot* closed = nullptr;
    for (const Snapshot& snapshot : path) {
      if (snapshot.width <= window.widest && (open == nullptr || snapshot.width >= window.opens))
        open = &snapshot;
      if (snapshot.width >= window.least) closed = &snapshot;
      if (snapshot.width <= window.closes && closed == &snapshot) break;
    }
    if (open == nullptr || closed == nullptr) continue;
    const double falls = miss * std::sqrt(closed->width / open->width);
    if (!(falls < stays / 2)) continue;
    if (window.least == 0 && (answer.lower > 0 || answer.upper < 0)) continue;
    RelativeInterior result;
    bool clear = true;
    for (std::size_t i = 0; i < 2 * friction_.size(); ++i) {
      const auto candidate = static_cast<int>(i % friction_.size());
      if (!(i < friction_.size() ? carriers : movers).contains(candidate)) continue;
      // A value fixed at zero by an equation does not decrease: it is rounding from the start.
      if (closed->sizes[i] <= std::max(falls * open->sizes[i], file_rounding)) continue;
      if (closed->sizes[i] < stays * open->sizes[i]) clear = false;
      (i < friction_.size() ? result.loaded : result.moved).insert(candidate);
    }
    if (!clear) continue;
    reaction_ = closed->reaction;
    motion_ = closed->motion;
    return result;
  }
  return std::nullopt;
}

// Violation of the wedging conditions by the reaction, relative to the magnitudes compared.
template <int D, class Real>
double PlainSolver<D, Real>::violation() const {
  double most = 0;
  const double whole = reaction_size();
  const Vector normal = normal_displacements(reaction_, motion_);
  for (const int j : gap_rows_) {
    const double root = std::sqrt(numbers::rounded(normal_compliance_(j, D * j)));
    most = std::max(most, -numbers::rounded(Real(normal[j])) / (root * whole));
  }
  for (const int k : cones_) {
    const double mu = friction_[static_cast<std::size_t>(k)];
    Real tangential = 0;
    for (int d = 1; d < D; ++d) tangential += reaction_[D * k + d] * reaction_[D * k + d];
    tangential = root(tangential);
    const double outside = numbers::rounded(Real(tangential - Real(mu) * reaction_[D * k]));
    const double root = std::sqrt(numbers::rounded(normal_compliance_(k, D * k)));
    most = std::max(most, outside * root / (whole * std::max(mu, 1.0)));
  }
  return most;
}

template class PlainSolver<2, long double>;
template class PlainSolver<3, long double>;
template class PlainSolver<2, numbers::Precise>;
template class PlainSolver<3, numbers::Precise>;

}  // namespace kusabi::conic
