// Variables, multipliers and scales of forms; -log det is convex in P, S, N and s.
#include "nodes/wedged/quadratic/quadratic_form.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace kusabi::wedged {
namespace {

// Lower bound of |S_jk| in denominators.
constexpr double min_size = 1e-12;

// Multiple of the mean of P or N added to an entry in estimated curvatures, which vanish at zero.
constexpr double share_of_mean = 5;

// Lower bound of second derivatives with respect to logarithms.
constexpr double min_curvature = 1e-3;

// Lower bound of a root in a quotient.
constexpr double tiny = 1e-12;

void append_rows(const Eigen::MatrixXd& matrix, std::vector<double>& numbers) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) numbers.push_back(matrix(i, j));
}

// Inverse second derivatives with respect to the root of an entry with the size left_j right_i.
template <class Roots, class Slopes, class Scales>
void scale_roots(const Roots& roots, const Slopes& slopes, const Eigen::VectorXd& right,
                 const Eigen::VectorXd& left, Scales scales) {
  const double mean = roots.squaredNorm() / static_cast<double>(roots.size());
  for (Eigen::Index j = 0; j < roots.cols(); ++j)
    for (Eigen::Index i = 0; i < roots.rows(); ++i) {
      const double root = roots(i, j);
      scales(i, j) = 1 / (4 * (root * root + share_of_mean * mean) * left[j] * right[i] +
                          std::max(0.0, slopes(i, j) / (root + tiny)));
    }
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
  append_rows(products, result);
  for (Eigen::Index j = 0; j < m; ++j)
    for (Eigen::Index k = 0; k < m; ++k)
      for (Eigen::Index c = k; c < slips.cols(); c += m) result.push_back(slips(j, c));
  result.insert(result.end(), squares.begin(), squares.end());
  append_rows(pairs, result);
  return result;
}

Eigen::MatrixXd pairs_of(QuadraticPoint& point) {
  const Eigen::MatrixXd squares = point.pair_roots().cwiseAbs2();
  return (squares + squares.transpose()) / 2;
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
  sizes_ = Eigen::MatrixXd::Constant(m, m, rounded_off * rounded_off);
  for (Eigen::Index k = 0; k < tangents_; ++k)
    sizes_ += point.slips().middleCols(k * m, m).cwiseAbs2();
  sizes_ = sizes_.cwiseSqrt().cwiseMax(min_size).eval();
  assemble(point);
}

void QuadraticForm::derivatives(QuadraticPoint& point, double weight, QuadraticPoint& result) {
  const auto m = candidates();
  auto by = slopes();
  const Eigen::MatrixXd of_sizes = factor_ * normal_inverse().cwiseQuotient(sizes_);
  for (Eigen::Index k = 0; k < tangents_; ++k)
    result.slips().middleCols(k * m, m) = by.by_slips.middleCols(k * m, m) +
                                          of_sizes.cwiseProduct(point.slips().middleCols(k * m, m));
  result.log_squares() = by.by_squares.cwiseProduct(squares_);
  const Eigen::VectorXd by_weights = -by.by_products.diagonal();
  const double mean = weights_.dot(by_weights) / static_cast<double>(m);
  result.log_weights() = weights_.cwiseProduct((by_weights.array() - mean).matrix());
  by.by_products.diagonal().setZero();
  result.roots() = 2 * by.by_products.cwiseProduct(point.roots());
  if (point.has_pairs()) result.pair_roots() = 2 * by.by_pairs.cwiseProduct(point.pair_roots());
  result.log_factor() = by.by_log_factor - weight;
}

void QuadraticForm::scales(QuadraticPoint& point, double weight, QuadraticPoint& result) {
  const auto m = candidates();
  const double f = factor_;
  QuadraticPoint slopes(point);
  derivatives(point, weight, slopes);
  const Eigen::MatrixXd inverse = normal_inverse();
  const Eigen::VectorXd own = inverse.diagonal();
  const Eigen::VectorXd of_rows = row_sizes();
  result.log_weights() =
      (weights_.cwiseAbs2().array() * own.array() * of_rows.array() + min_curvature).inverse();
  result.log_squares() = (2 * f * own.array() * squares_.array() + min_curvature).inverse();
  scale_roots(point.roots(), slopes.roots(), of_rows, own, result.roots());
  if (point.has_pairs())
    scale_roots(point.pair_roots(), slopes.pair_roots(), of_rows, of_rows, result.pair_roots());
  for (Eigen::Index k = 0; k < tangents_; ++k)
    for (Eigen::Index j = 0; j < m; ++j)
      for (Eigen::Index i = 0; i < m; ++i) {
        const double part = point.slips()(i, k * m + j) / sizes_(i, j);
        const double bend = std::abs(inverse(i, j)) / sizes_(i, j) * (1 - part * part / 2);
        result.slips()(i, k * m + j) = 1 / (f * own[i] / (2 * squares_[j]) + f * bend);
      }
  result.log_factor() = 1 / weight;
}

// In units of the candidates' own friction phi, the tangential reactions are r_t / phi.
QuadraticMultipliers QuadraticForm::multipliers(QuadraticPoint& point, double factor) const {
  QuadraticMultipliers result{
      .products = products_, .slips = unit_ * point.slips(), .squares = unit_ / factor * squares_};
  if (point.has_pairs()) result.pairs = pairs_of(point) / unit_;
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
