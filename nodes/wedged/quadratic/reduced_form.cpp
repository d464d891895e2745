// One Cholesky factorisation and some products of m x m matrices for a value and its derivatives.
#include "nodes/wedged/quadratic/reduced_form.hpp"

#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "solvers/conic/dense_product.hpp"

namespace kusabi::wedged {
namespace {

Eigen::MatrixXd symmetric_part(const Eigen::MatrixXd& matrix) {
  return (matrix + matrix.transpose()) / 2;
}

}  // namespace

QuadraticPoint ReducedForm::first_point() const {
  return {candidates(), tangents(), PairProducts::none};
}

void ReducedForm::assemble(QuadraticPoint& point) {
  const auto m = candidates();
  if (products_.isDiagonal(0.0))
    responses_ = products_.diagonal().asDiagonal() * rows();
  else
    responses_ = conic::product_with_transpose(products_.transpose(), rows().transpose());
  sums_ = responses_.rightCols(tangents() * m) + point.slips();
  shares_ = sums_;
  for (Eigen::Index k = 0; k < tangents(); ++k)
    shares_.middleCols(k * m, m) *= squares_.cwiseInverse().asDiagonal();
  minus_linear_ = -symmetric_part(responses_.leftCols(m));
  friction_part_ = symmetric_part(sizes_);
  friction_part_.diagonal() += squares_;
  friction_part_ += conic::product_with_transpose(sums_, shares_) / 4;
}

double ReducedForm::potential(double factor, double weight) {
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

QuadraticForm::Slopes ReducedForm::slopes() {
  const auto m = candidates();
  const auto e = tangents();
  Slopes by{.by_products = {},
            .by_slips = {},
            .by_squares = factor_ * inverse_.diagonal(),
            .by_pairs = {},
            .by_log_factor = factor_ * inverse_.cwiseProduct(friction_part_).sum()};
  by.by_slips = factor_ / 2 * conic::product_with_transpose(inverse_, shares_.transpose());
  for (Eigen::Index k = 0; k < e; ++k)
    by.by_squares -= by.by_slips.middleCols(k * m, m)
                         .cwiseProduct(shares_.middleCols(k * m, m))
                         .colwise()
                         .sum()
                         .transpose() /
                     2;
  Eigen::MatrixXd moved(m, rows().cols());
  moved << inverse_, by.by_slips;
  by.by_products = conic::product_with_transpose(rows(), moved);
  return by;
}

Eigen::VectorXd ReducedForm::row_sizes() const {
  const auto m = candidates();
  const auto normal = rows().leftCols(m);
  Eigen::VectorXd sizes = (normal * inverse_).cwiseProduct(normal).rowwise().sum();
  for (Eigen::Index k = 1; k <= tangents(); ++k)
    sizes += factor_ / 2 * rows().middleCols(k * m, m).cwiseAbs2() * squares_.cwiseInverse();
  return sizes;
}

double ReducedForm::largest_factor(double above) {
  // Most points of a search are refused by this factorisation.
  if (above > 0 &&
      Eigen::LLT<Eigen::MatrixXd>(minus_linear_ - above * friction_part_).info() != Eigen::Success)
    return 0;
  const Eigen::LLT<Eigen::MatrixXd> factors(minus_linear_);
  if (factors.info() != Eigen::Success) return 0;
  Eigen::MatrixXd ratio = factors.matrixL().solve(friction_part_);
  ratio = factors.matrixL().solve(ratio.transpose().eval());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> values(ratio, Eigen::EigenvaluesOnly);
  const double largest = 1 / values.eigenvalues()[candidates() - 1];
  return largest > above ? largest : 0;
}

}  // namespace kusabi::wedged
