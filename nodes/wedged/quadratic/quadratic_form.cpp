// Values, derivatives and scales of the form; -log det is convex in P, S and s.
#include "nodes/wedged/quadratic/quadratic_form.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace kusabi::wedged {
namespace {

// Lower bound of |S_jk| in denominators.
constexpr double least_size = 1e-12;

// Multiple of the mean of P added to P_ij in estimated curvatures, which vanish at P_ij = 0.
constexpr double share_of_mean = 5;

// Lower bound of second derivatives with respect to logarithms.
constexpr double least_curvature = 1e-3;

Eigen::MatrixXd symmetric_part(const Eigen::MatrixXd& matrix) {
  return (matrix + matrix.transpose()) / 2;
}

}  // namespace

Eigen::MatrixXd normal_rows(const problems::WedgedProblem& block) {
  const Eigen::Index d = block.dimension;
  const auto m = static_cast<Eigen::Index>(block.contact_names.size());
  Eigen::MatrixXd rows(m, d * m);
  for (Eigen::Index k = 0; k < d; ++k)
    for (Eigen::Index j = 0; j < m; ++j)
      for (Eigen::Index i = 0; i < m; ++i)
        rows(i, k * m + j) = block.compliance.matrix(d * i, d * j + k);
  return rows;
}

std::vector<double> QuadraticMultipliers::numbers() const {
  const auto m = squares.size();
  std::vector<double> result;
  for (Eigen::Index i = 0; i < m; ++i)
    for (Eigen::Index j = 0; j < m; ++j) result.push_back(products(i, j));
  for (Eigen::Index j = 0; j < m; ++j)
    for (Eigen::Index k = 0; k < m; ++k)
      for (Eigen::Index c = k; c < slips.cols(); c += m) result.push_back(slips(j, c));
  result.insert(result.end(), squares.begin(), squares.end());
  return result;
}

QuadraticForm::QuadraticForm(const problems::WedgedProblem& block)
    : tangents_(block.dimension - 1),
      unit_(problems::mean_normal_compliance(block)),
      friction_(Eigen::VectorXd::Ones(static_cast<Eigen::Index>(block.contact_names.size()))),
      rows_(normal_rows(block) / unit_) {
  for (std::size_t i = 0; i < block.friction.size(); ++i)
    friction_[static_cast<Eigen::Index>(i)] = block.friction[i];
  for (Eigen::Index k = 1; k <= tangents_; ++k)
    rows_.middleCols(k * candidates(), candidates()) *= friction_.asDiagonal();
}

void QuadraticForm::set(QuadraticPoint& point, double rounded_off) {
  const auto m = candidates();
  weights_ = point.log_weights().array().exp();
  weights_ /= weights_.mean();
  squares_ = point.log_squares().array().exp();
  products_ = point.roots().cwiseAbs2();
  products_.diagonal() = -weights_;
  responses_.noalias() = products_.transpose() * rows_;
  sums_ = responses_.rightCols(tangents_ * m) + point.slips();
  shares_ = sums_;
  sizes_ = Eigen::MatrixXd::Constant(m, m, rounded_off * rounded_off);
  for (Eigen::Index k = 0; k < tangents_; ++k) {
    sizes_ += point.slips().middleCols(k * m, m).cwiseAbs2();
    shares_.middleCols(k * m, m) *= squares_.cwiseInverse().asDiagonal();
  }
  sizes_ = sizes_.cwiseSqrt().cwiseMax(least_size).eval();
  minus_linear_ = -symmetric_part(responses_.leftCols(m));
  friction_part_ = symmetric_part(sizes_);
  friction_part_.diagonal() += squares_;
  friction_part_.noalias() += sums_ * shares_.transpose() / 4;
}

double QuadraticForm::potential(double factor, double weight) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  factor_ = factor;
  const Eigen::LLT<Eigen::MatrixXd> factors(minus_linear_ - factor * friction_part_);
  if (factors.info() != Eigen::Success) return infinity;
  const double value =
      -2 * factors.matrixLLT().diagonal().array().log().sum() - weight * std::log(factor);
  if (!std::isfinite(value)) return infinity;
  inverse_ = factors.solve(Eigen::MatrixXd::Identity(candidates(), candidates()));
  return value;
}

void QuadraticForm::derivatives(QuadraticPoint& point, double weight, QuadraticPoint& result) {
  const auto m = candidates();
  const double f = factor_;
  Eigen::MatrixXd by_sums(m, tangents_ * m);  // derivatives by E
  by_sums.noalias() = f / 2 * inverse_ * shares_;
  Eigen::VectorXd by_squares = f * inverse_.diagonal();
  for (Eigen::Index k = 0; k < tangents_; ++k) {
    const auto own = by_sums.middleCols(k * m, m);
    result.slips().middleCols(k * m, m) =
        own + (f * inverse_.array() * point.slips().middleCols(k * m, m).array() / sizes_.array())
                  .matrix();
    by_squares -= own.cwiseProduct(shares_.middleCols(k * m, m)).colwise().sum().transpose() / 2;
  }
  result.log_squares() = by_squares.cwiseProduct(squares_);
  Eigen::MatrixXd by_products(m, m);
  by_products.noalias() = rows_.leftCols(m) * inverse_;
  by_products.noalias() += rows_.rightCols(tangents_ * m) * by_sums.transpose();
  const Eigen::VectorXd by_weights = -by_products.diagonal();
  const double mean = weights_.dot(by_weights) / static_cast<double>(m);
  result.log_weights() = weights_.cwiseProduct((by_weights.array() - mean).matrix());
  by_products.diagonal().setZero();
  result.roots() = 2 * by_products.cwiseProduct(point.roots());
  result.log_factor() = f * inverse_.cwiseProduct(friction_part_).sum() - weight;
}

void QuadraticForm::scales(QuadraticPoint& point, double weight, QuadraticPoint& result) {
  const auto m = candidates();
  const double f = factor_;
  QuadraticPoint slopes(m, tangents_);
  derivatives(point, weight, slopes);
  const Eigen::VectorXd own = inverse_.diagonal();
  const auto normal = rows_.leftCols(m);
  Eigen::VectorXd of_rows = (normal * inverse_).cwiseProduct(normal).rowwise().sum();
  for (Eigen::Index k = 1; k <= tangents_; ++k) {
    const auto tangential = rows_.middleCols(k * m, m);
    of_rows += f / 2 * tangential.cwiseAbs2() * squares_.cwiseInverse();
  }
  result.log_weights() =
      (weights_.cwiseAbs2().array() * own.array() * of_rows.array() + least_curvature).inverse();
  result.log_squares() = (2 * f * own.array() * squares_.array() + least_curvature).inverse();
  const double mean = point.roots().squaredNorm() / static_cast<double>(m * m);
  constexpr double tiny = 1e-12;
  for (Eigen::Index j = 0; j < m; ++j)
    for (Eigen::Index i = 0; i < m; ++i) {
      const double root = point.roots()(i, j);
      result.roots()(i, j) = 1 / (4 * (root * root + share_of_mean * mean) * own[j] * of_rows[i] +
                                  std::max(0.0, slopes.roots()(i, j) / (root + tiny)));
    }
  for (Eigen::Index k = 0; k < tangents_; ++k)
    for (Eigen::Index j = 0; j < m; ++j)
      for (Eigen::Index i = 0; i < m; ++i) {
        const double part = point.slips()(i, k * m + j) / sizes_(i, j);
        const double bend = std::abs(inverse_(i, j)) / sizes_(i, j) * (1 - part * part / 2);
        result.slips()(i, k * m + j) = 1 / (f * own[i] / (2 * squares_[j]) + f * bend);
      }
  result.log_factor() = 1 / weight;
}

double QuadraticForm::largest_factor() const {
  const Eigen::LLT<Eigen::MatrixXd> factors(minus_linear_);
  if (factors.info() != Eigen::Success) return 0;
  Eigen::MatrixXd ratio = factors.matrixL().solve(friction_part_);
  ratio = factors.matrixL().solve(ratio.transpose().eval());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> values(ratio, Eigen::EigenvaluesOnly);
  return 1 / values.eigenvalues()[candidates() - 1];
}

// In units of the candidates' own friction phi, the tangential reactions are r_t / phi.
QuadraticMultipliers QuadraticForm::multipliers(QuadraticPoint& point, double factor) const {
  QuadraticMultipliers result{
      .products = products_, .slips = unit_ * point.slips(), .squares = unit_ / factor * squares_};
  const auto m = candidates();
  for (Eigen::Index i = 0; i < m; ++i) {
    const double own = friction_[i];
    if (!(own > 0)) continue;
    result.squares[i] /= own * own;
    for (Eigen::Index k = 0; k < tangents_; ++k) result.slips.col(k * m + i) /= own;
  }
  return result;
}

}  // namespace kusabi::wedged
