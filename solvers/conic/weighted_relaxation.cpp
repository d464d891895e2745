// Interior-point iteration with Nesterov-Todd scaling and Mehrotra's predictor and corrector.
#include "solvers/conic/weighted_relaxation.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "solvers/conic/iteration_rules.hpp"

namespace kusabi::conic {

namespace {

/// Accuracy of a program without proof: residuals and gap.
constexpr double digits = 1e-8;
constexpr int max_iterations = 60;

/// Shift of the diagonal of the normal equations, relative to it.
constexpr double relaxed_shift = 1e-14;

/// Multipliers beyond this belong to an empty relaxation.
constexpr double without_end = 1e13;

double inverse_length(const Eigen::VectorXd& point, const Eigen::VectorXd& step) {
  return (-step.array() / point.array()).maxCoeff();
}

}  // namespace

template <int D>
WeightedRelaxation<D>::WeightedRelaxation(const Eigen::MatrixXd& compliance,
                                          const Motions<double>& motions)
    : m_(static_cast<int>(compliance.rows()) / D),
      rows_(m_ + motions.count() + 1),
      stride_(padded(m_)),
      equations_(rows_) {
  unit_matrix_.setZero(padded(rows_), D * stride_);
  free_.setZero(padded(rows_), motions.lifting);
  for (int c = 0; c < m_; ++c) {
    unit_matrix_(rows_ - 1, c) = 1;
    for (int d = 0; d < D; ++d) {
      for (int i = 0; i < m_; ++i) unit_matrix_(i, d * stride_ + c) = compliance(D * i, D * c + d);
      for (int l = 0; l < motions.count(); ++l)
        unit_matrix_(m_ + l, d * stride_ + c) = motions.at_cones(D * c + d, l);
    }
    for (int l = 0; l < motions.lifting; ++l) free_(c, l) = motions.at_cones(D * c, l);
  }
  scaled_.setZero(unit_matrix_.rows(), unit_matrix_.cols());
  right_side_.setZero(padded(rows_));
  right_side_[rows_ - 1] = 1;
  scaling_.resize(static_cast<std::size_t>(m_));
}

template <int D>
PackedColumns<> WeightedRelaxation<D>::columns(const Eigen::MatrixXd& matrix) const {
  return {matrix.data(), static_cast<int>(matrix.rows()), D, m_, stride_};
}

template <int D>
auto WeightedRelaxation<D>::at(const Vector& points, int cone) const -> Point {
  Point point;
  for (int d = 0; d < D; ++d) point[static_cast<std::size_t>(d)] = points[d * stride_ + cone];
  return point;
}

template <int D>
void WeightedRelaxation<D>::put(Vector& points, int cone, const Point& point) const {
  for (int d = 0; d < D; ++d) points[d * stride_ + cone] = point[static_cast<std::size_t>(d)];
}

template <int D>
Eigen::VectorXd WeightedRelaxation<D>::times(const Vector& points) const {
  Vector sum(matrix_.rows());
  product(columns(matrix_), points.data(), sum.data());
  return sum;
}

template <int D>
Eigen::VectorXd WeightedRelaxation<D>::transposed_times(const Vector& weights) const {
  Vector products = Vector::Zero(matrix_.cols());
  transposed_product(columns(matrix_), weights.data(), products.data());
  return products;
}

template <int D>
void WeightedRelaxation<D>::start(const Vector& gap, const Vector& reaction) {
  const double largest = std::max(gap.maxCoeff(), reaction.maxCoeff());
  cost_.setZero(D * stride_);
  cost_.head(m_) = reaction / largest;
  gap_cost_ = gap / largest;
  x_.setZero(D * stride_);
  z_.setZero(D * stride_);
  x_.head(m_).setConstant(1.0 / m_);
  z_.head(m_).setOnes();
  v_.setConstant(m_, 1.0 / m_);
  s_.setOnes(m_);
  y_.setZero(padded(rows_));
  alpha_.setZero(free_.cols());
}

template <int D>
void WeightedRelaxation<D>::set_residuals() {
  primal_residual_ = right_side_ - times(x_) - free_ * alpha_;
  primal_residual_.head(m_) += v_;
  dual_residual_ = cost_ - transposed_times(y_) - z_;
  slack_residual_ = gap_cost_ + y_.head(m_) - s_;
  balance_ = -(free_.transpose() * y_);
  complementarity_ = (x_.dot(z_) + v_.dot(s_)) / (2 * m_);
}

template <int D>
bool WeightedRelaxation<D>::converged() const {
  const double dual =
      std::max({dual_residual_.cwiseAbs().maxCoeff(), slack_residual_.cwiseAbs().maxCoeff(),
                balance_.size() == 0 ? 0 : balance_.cwiseAbs().maxCoeff()});
  const double value = cost_.dot(x_) + gap_cost_.dot(v_);
  return primal_residual_.cwiseAbs().maxCoeff() < digits && dual < digits &&
         2 * m_ * complementarity_ < digits * (1 + std::abs(value));
}

template <int D>
bool WeightedRelaxation<D>::factorise() {
  const auto rows = unit_matrix_.rows();
  for (int c = 0; c < m_; ++c) {
    auto& scaling = scaling_[static_cast<std::size_t>(c)];
    scaling = NesterovToddScaling<D>(at(x_, c), at(z_, c));
    for (int d = 0; d < D; ++d) {
      auto column = scaled_.col(d * stride_ + c);
      column = matrix_.col(c) * scaling.entry(0, static_cast<std::size_t>(d));
      for (int e = 1; e < D; ++e)
        column += matrix_.col(e * stride_ + c) *
                  scaling.entry(static_cast<std::size_t>(e), static_cast<std::size_t>(d));
    }
  }
  equations_.resize(rows_);
  equations_.assemble(columns(scaled_));
  double trace = 0;
  for (int i = 0; i < rows_; ++i) trace += equations_.diagonal(i);
  for (int i = 0; i < rows_; ++i)
    equations_.add_to_diagonal(i, relaxed_shift * (equations_.diagonal(i) + trace / rows_));
  for (int i = 0; i < m_; ++i) equations_.add_to_diagonal(i, v_[i] / s_[i]);
  hold_ = free_.cols() == 0 ? 0 : trace / free_.squaredNorm();
  for (Eigen::Index l = 0; l < free_.cols(); ++l) equations_.add_square(free_.col(l).data(), hold_);
  Vector first = Vector::Zero(rows), second = Vector::Zero(rows);
  if (!equations_.factorise(first.data(), second.data())) return false;
  moved_ = free_;
  for (Eigen::Index l = 0; l < moved_.cols(); ++l) equations_.solve(moved_.col(l).data());
  if (moved_.cols() == 0) return true;
  const Eigen::LDLT<Eigen::MatrixXd> schur(free_.transpose() * moved_);
  schur_inverse_ = schur.solve(Eigen::MatrixXd::Identity(moved_.cols(), moved_.cols()));
  return schur_inverse_.allFinite();
}

// The Newton step to centring_ in all pairs, with the residuals taken off by `share`; of the
// corrector with the second-order term of the predictor, by its length.
template <int D>
void WeightedRelaxation<D>::direct(double share, bool corrected, double centring, double damping) {
  Vector pull = Vector::Zero(D * stride_), quotient = pull;
  for (int c = 0; c < m_; ++c) {
    const auto& scaling = scaling_[static_cast<std::size_t>(c)];
    const Point lambda = scaling.lambda();
    Point target = jordan_product(lambda, lambda);
    for (double& each : target) each = -each;
    if (corrected) {
      const Point second = jordan_product(at(affine_x_, c), at(affine_z_, c));
      for (std::size_t d = 0; d < target.size(); ++d) target[d] -= damping * second[d];
      target[0] += centring;
    }
    const Point q = scaling.jordan_divide(target);
    put(quotient, c, q);
    Point own = scaling.times(at(dual_residual_, c));
    for (std::size_t d = 0; d < own.size(); ++d) own[d] = q[d] - share * own[d];
    put(pull, c, scaling.times(own));
  }
  Vector slack_target = -v_.cwiseProduct(s_);
  if (corrected) slack_target.array() += centring - damping * affine_v_.array() * affine_s_.array();
  dy_ = share * primal_residual_ - times(pull);
  dy_.head(m_) += (slack_target - share * v_.cwiseProduct(slack_residual_)).cwiseQuotient(s_);
  dalpha_.setZero(free_.cols());
  if (free_.cols() > 0) {
    const Vector unbalanced = share * balance_;
    dy_ += hold_ * (free_ * unbalanced);
    dalpha_ = schur_inverse_ * (moved_.transpose() * dy_ - unbalanced);
    dy_ -= free_ * dalpha_;
  }
  equations_.solve(dy_.data());
  ds_ = share * slack_residual_ + dy_.head(m_);
  dv_ = (slack_target - v_.cwiseProduct(ds_)).cwiseQuotient(s_);
  const Vector moved = share * dual_residual_ - transposed_times(dy_);
  dx_.setZero(D * stride_);
  dz_.setZero(D * stride_);
  for (int c = 0; c < m_; ++c) {  // scaled: W dz and W^-1 dx
    const Point dz = scaling_[static_cast<std::size_t>(c)].times(at(moved, c));
    Point dx = at(quotient, c);
    for (std::size_t d = 0; d < dx.size(); ++d) dx[d] -= dz[d];
    put(dz_, c, dz);
    put(dx_, c, dx);
  }
}

template <int D>
auto WeightedRelaxation<D>::longest_steps() const -> Steps {
  double primal = inverse_length(v_, dv_), dual = inverse_length(s_, ds_);
  for (int c = 0; c < m_; ++c) {
    const auto& scaling = scaling_[static_cast<std::size_t>(c)];
    primal = std::max(primal, scaling.inverse_step_length(at(dx_, c)));
    dual = std::max(dual, scaling.inverse_step_length(at(dz_, c)));
  }
  return {primal, dual};
}

template <int D>
std::optional<RelaxedPoint> WeightedRelaxation<D>::minimise(std::span<const double> friction,
                                                            const Vector& gap,
                                                            const Vector& reaction) {
  matrix_ = unit_matrix_;
  for (int c = 0; c < m_; ++c)
    for (int d = 1; d < D; ++d)
      matrix_.col(d * stride_ + c) *= friction[static_cast<std::size_t>(c)];
  start(gap, reaction);
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    set_residuals();
    if (converged()) return RelaxedPoint{x_.head(m_), v_};
    if (!std::isfinite(complementarity_) || !(y_.cwiseAbs().maxCoeff() < without_end)) return {};
    support::throw_if_requested(stop_);
    if (!factorise()) return {};
    direct(1, false, 0, 0);
    const Steps predicted = longest_steps();
    const double length = 1 / std::max({1.0, predicted.primal, predicted.dual});
    affine_x_ = dx_, affine_z_ = dz_, affine_v_ = dv_, affine_s_ = ds_;
    const double sigma = (1 - length) * (1 - length) * (1 - length);
    direct(1 - sigma, true, sigma * complementarity_, length);
    const Steps inverse = longest_steps();
    const double primal = step_length(boundary_fraction, inverse.primal);
    const double dual = step_length(boundary_fraction, inverse.dual);
    for (int c = 0; c < m_; ++c) {
      const auto& scaling = scaling_[static_cast<std::size_t>(c)];
      Point x = at(x_, c);
      const Point step = scaling.times(at(dx_, c));
      for (std::size_t d = 0; d < x.size(); ++d) x[d] += primal * step[d];
      put(x_, c, x);
    }
    // z is moved with its residual, as s is: W^-1 (W dz) would cancel.
    z_ += dual * ((1 - sigma) * dual_residual_ - transposed_times(dy_));
    v_ += primal * dv_;
    alpha_ += primal * dalpha_;
    s_ += dual * ds_;
    y_ += dual * dy_;
  }
  return {};
}

template class WeightedRelaxation<2>;
template class WeightedRelaxation<3>;

}  // namespace kusabi::conic
