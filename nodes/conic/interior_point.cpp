// The interior-point iteration; the header states the pair of programs it solves.
#include "nodes/conic/interior_point.hpp"

#include <algorithm>
#include <cmath>

namespace kusabi::conic {

namespace {

// The dual start leaves each z_i at least this share of its distance from the boundary at y = 0.
constexpr double start_share = 0.5;

// No multiplier starts above this: where the rows with a slack push z into the cone, nothing else
// bounds them.
constexpr double start_limit = 1;

// The primal start, times the size 1 / |C| of a reaction that sums to one. The better start of
// those we measured: the sign is proved half an iteration earlier than from the identity.
constexpr double start_point = 1;
constexpr double start_slack = 0.5;

// A step goes this share of the way to the boundary; the rest keeps the next scaling computable.
constexpr double boundary_share = 0.99;

// Shorter steps than this no longer change the bracket.
constexpr double shortest_step = 1e-6;

// Added to the diagonal of A W^2 A', relative to its size before cancellation (A has b in it): of
// the order of its rounding. A candidate in contact whose normal and tangents are decoupled makes a
// row of A vanish, and then u_n = 0 has no solution; the shift lets y run along that row, which
// proves the node dead.
constexpr double diagonal_shift = 1e-15;

// A rounding-level step may put the new z on the wrong side of the boundary; halving this often
// goes back far enough, or the digits are used up.
constexpr int most_halvings = 8;

}  // namespace

template <int D>
InteriorPoint<D>::InteriorPoint(int candidates, int most_cones) {
  const Eigen::Index m = candidates;
  const Eigen::Index cones = most_cones;
  for (Points* points : {&x_, &z_, &projected_, &step_x_, &step_z_}) points->setZero(D, cones);
  for (Eigen::VectorXd* rows : {&v_, &y_, &slack_scale_, &slack_point_, &predictor_, &correction_,
                                &dy_, &trial_, &step_v_, &step_y_})
    rows->setZero(m);
  scaling_.resize(static_cast<std::size_t>(most_cones));
  scaled_matrix_.setZero(m, D * cones);
  normal_matrix_.setZero(m, m);
  factor_ = Eigen::LLT<Eigen::MatrixXd>(m);
}

template <int D>
void InteriorPoint<D>::start(const NodeProgram<D>& program) {
  const auto count = static_cast<Eigen::Index>(program.cones().size());
  const auto matrix = program.matrix();
  v_.setZero();
  y_.setZero();
  for (const int j : program.gap_rows()) y_[j] = 1;
  double size = start_limit;
  for (Eigen::Index c = 0; c < count; ++c) {
    const Point<D> push = matrix.template middleCols<D>(D * c).transpose() * y_;
    const double outward = push[0] + push.template tail<D - 1>().norm();
    if (outward * size > start_share) size = start_share / outward;
  }
  y_ *= size;
  x_.leftCols(count).setZero();
  x_.row(0).head(count).setConstant(start_point / static_cast<double>(count));
  for (const int j : program.gap_rows()) v_[j] = start_slack / static_cast<double>(count);
  refresh_dual(program, y_);
}

template <int D>
bool InteriorPoint<D>::refresh_dual(const NodeProgram<D>& program, const Eigen::VectorXd& y) {
  const auto count = static_cast<Eigen::Index>(program.cones().size());
  Eigen::Map<Eigen::VectorXd> flat(z_.data(), D * count);
  z_.leftCols(count).setZero();
  z_.row(0).head(count).setOnes();
  flat.noalias() -= program.matrix().transpose() * y;
  bool feasible = true;
  for (Eigen::Index c = 0; c < count; ++c) feasible = feasible && inside<D>(z_.col(c));
  for (const int j : program.gap_rows()) feasible = feasible && y[j] > 0;
  return feasible;
}

template <int D>
bool InteriorPoint<D>::factorise(const NodeProgram<D>& program) {
  const auto count = static_cast<Eigen::Index>(program.cones().size());
  const auto matrix = program.matrix();
  double widest = 0;
  for (Eigen::Index c = 0; c < count; ++c) {
    Scaling<D>& scaling = scaling_[static_cast<std::size_t>(c)];
    scaling = Scaling<D>(x_.col(c), z_.col(c));
    widest = std::max(widest, scaling.matrix()(0, 0));
    scaled_matrix_.template middleCols<D>(D * c).noalias() =
        matrix.template middleCols<D>(D * c).lazyProduct(scaling.matrix());
  }
  normal_matrix_.template triangularView<Eigen::Lower>().setZero();
  normal_matrix_.template selfadjointView<Eigen::Lower>().rankUpdate(
      scaled_matrix_.leftCols(D * count));
  const double largest = std::max(normal_matrix_.diagonal().maxCoeff(),
                                  widest * widest * program.right_side().cwiseAbs2().maxCoeff());
  normal_matrix_.diagonal().array() += diagonal_shift * largest;
  for (const int j : program.gap_rows()) {
    slack_scale_[j] = std::sqrt(v_[j] / y_[j]);
    slack_point_[j] = std::sqrt(v_[j] * y_[j]);
    normal_matrix_(j, j) += v_[j] / y_[j];
  }
  factor_.compute(normal_matrix_);
  return factor_.info() == Eigen::Success;
}

template <int D>
const typename InteriorPoint<D>::Points& InteriorPoint<D>::project(const NodeProgram<D>& program) {
  const auto count = static_cast<Eigen::Index>(program.cones().size());
  const Eigen::Map<const Eigen::VectorXd> x(x_.data(), D * count);
  correction_ = program.right_side() + v_;
  correction_.noalias() -= program.matrix() * x;
  factor_.solveInPlace(correction_);
  projected_.leftCols(count) = x_.leftCols(count);
  shift_projected(correction_, count);
  return projected_;
}

template <int D>
const typename InteriorPoint<D>::Points& InteriorPoint<D>::project_again(
    const Eigen::VectorXd& discrepancy, const NodeProgram<D>& program) {
  trial_ = discrepancy;
  factor_.solveInPlace(trial_);
  shift_projected(trial_, static_cast<Eigen::Index>(program.cones().size()));
  return projected_;
}

template <int D>
void InteriorPoint<D>::shift_projected(const Eigen::VectorXd& weights, Eigen::Index count) {
  Eigen::Map<Eigen::VectorXd> scaled(step_x_.data(), D * count);
  scaled.noalias() = scaled_matrix_.leftCols(D * count).transpose() * weights;
  for (Eigen::Index c = 0; c < count; ++c)
    projected_.col(c).noalias() += scaling_[static_cast<std::size_t>(c)].matrix() * step_x_.col(c);
}

template <int D>
double InteriorPoint<D>::dual_direction(const NodeProgram<D>& program, const Eigen::VectorXd& dy) {
  const auto count = static_cast<Eigen::Index>(program.cones().size());
  Eigen::Map<Eigen::VectorXd> flat(step_z_.data(), D * count);
  flat.setZero();
  flat.noalias() -= scaled_matrix_.leftCols(D * count).transpose() * dy;
  double inverse = 0;
  for (Eigen::Index c = 0; c < count; ++c)
    inverse = std::max(inverse, scaling_[static_cast<std::size_t>(c)].inverse_step(step_z_.col(c)));
  for (const int j : program.gap_rows()) {
    step_y_[j] = slack_scale_[j] * dy[j];
    inverse = std::max(inverse, -dy[j] / y_[j]);
  }
  return inverse;
}

template <int D>
double InteriorPoint<D>::primal_direction(const NodeProgram<D>& program) {
  const auto count = static_cast<Eigen::Index>(program.cones().size());
  double inverse = 0;
  for (Eigen::Index c = 0; c < count; ++c) {
    const auto& scaling = scaling_[static_cast<std::size_t>(c)];
    step_x_.col(c) -= scaling.point() + step_z_.col(c);
    inverse = std::max(inverse, scaling.inverse_step(step_x_.col(c)));
  }
  for (const int j : program.gap_rows()) {
    step_v_[j] -= slack_point_[j] + step_y_[j];
    inverse = std::max(inverse, -step_v_[j] / slack_point_[j]);
  }
  return inverse;
}

template <int D>
bool InteriorPoint<D>::advance(const NodeProgram<D>& program) {
  const auto count = static_cast<Eigen::Index>(program.cones().size());
  const auto& gap_rows = program.gap_rows();

  // Predictor: W^-1 dx + W dz = -lambda and A dx = b - A x reduce to M dy = b.
  predictor_ = program.right_side();
  factor_.solveInPlace(predictor_);
  step_x_.leftCols(count).setZero();
  step_v_.setZero();
  const double dual_inverse = dual_direction(program, predictor_);
  const double reach = 1 / std::max({1.0, dual_inverse, primal_direction(program)});

  // Corrector: W^-1 dx + W dz = -lambda + q with lambda o q = target e - reach dx~ o dz~, and
  // A dx = (1 - centring) (b - A x), hence M dy = b - centring (b - A x) - B q. Mehrotra's method
  // has the second-order term in full; where the predictor gets nowhere it is out of proportion,
  // and the iteration can cycle.
  double product = 0;  // x'z + v'y
  for (Eigen::Index c = 0; c < count; ++c)
    product += scaling_[static_cast<std::size_t>(c)].point().squaredNorm();
  for (const int j : gap_rows) product += slack_point_[j] * slack_point_[j];
  const auto degree = static_cast<double>(static_cast<std::size_t>(count) + gap_rows.size());
  const double centring = (1 - reach) * (1 - reach) * (1 - reach);
  const double target = centring * product / degree;
  for (Eigen::Index c = 0; c < count; ++c) {
    Point<D> right_side = -reach * jordan_product<D>(step_x_.col(c), step_z_.col(c));
    right_side[0] += target;
    step_x_.col(c) = scaling_[static_cast<std::size_t>(c)].jordan_divide(right_side);
  }
  trial_.noalias() =
      scaled_matrix_.leftCols(D * count) * Eigen::Map<Eigen::VectorXd>(step_x_.data(), D * count);
  for (const int j : gap_rows) {
    step_v_[j] = (target - reach * step_v_[j] * step_y_[j]) / slack_point_[j];
    trial_[j] -= slack_scale_[j] * step_v_[j];
  }
  factor_.solveInPlace(trial_);
  dy_ = predictor_ - trial_ - centring * correction_;
  const double dual_step = boundary_share / std::max(boundary_share, dual_direction(program, dy_));
  const double primal_step = boundary_share / std::max(boundary_share, primal_direction(program));
  return std::max(primal_step, dual_step) > shortest_step && move_primal(program, primal_step) &&
         move_dual(program, dual_step);
}

template <int D>
bool InteriorPoint<D>::move_primal(const NodeProgram<D>& program, double step) {
  const auto count = static_cast<Eigen::Index>(program.cones().size());
  bool feasible = true;
  for (Eigen::Index c = 0; c < count; ++c) {
    x_.col(c).noalias() += step * scaling_[static_cast<std::size_t>(c)].matrix() * step_x_.col(c);
    feasible = feasible && inside<D>(x_.col(c));
  }
  for (const int j : program.gap_rows()) {
    v_[j] += step * slack_scale_[j] * step_v_[j];
    feasible = feasible && v_[j] > 0;
  }
  return feasible;
}

template <int D>
bool InteriorPoint<D>::move_dual(const NodeProgram<D>& program, double step) {
  for (int halving = 0; halving <= most_halvings; ++halving, step /= 2) {
    trial_ = y_ + step * dy_;
    if (refresh_dual(program, trial_)) {
      y_.swap(trial_);
      return true;
    }
  }
  return false;
}

template class InteriorPoint<2>;
template class InteriorPoint<3>;

}  // namespace kusabi::conic
