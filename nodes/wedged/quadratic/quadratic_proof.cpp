// The form is computed in doubles; its errors are bounded in the Frobenius norm by |fl(AB) - AB| <=
// gamma_k |A||B|, and Cholesky's method bears the rest (Higham, theorems 3.5 and 10.3).
#include "nodes/wedged/quadratic/quadratic_proof.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Cholesky>

namespace kusabi::wedged {
namespace {

/// Bounds are themselves computed in doubles: they are raised by this factor.
constexpr double raised = 1 + 1e-9;

/// gamma_k of Higham with the roundings of some operations more than k.
double gamma(Eigen::Index k) {
  constexpr double more = 16;
  const double share = (static_cast<double>(k) + more) * std::numeric_limits<double>::epsilon();
  return share / (1 - share);
}

bool allowed(const QuadraticMultipliers& multipliers) {
  const auto& products = multipliers.products;
  for (Eigen::Index j = 0; j < products.cols(); ++j)
    for (Eigen::Index i = 0; i < products.rows(); ++i)
      if (i != j && !(products(i, j) >= 0)) return false;
  return (multipliers.squares.array() > 0).all() && products.allFinite() &&
         multipliers.slips.allFinite() && multipliers.squares.allFinite();
}

// The form in doubles, symmetric, and a bound of its error in the Frobenius norm.
struct RoundedForm {
  Eigen::MatrixXd matrix;
  double error = 0;
};

RoundedForm rounded_form(const problems::WedgedProblem& block, std::span<const double> friction,
                         const QuadraticMultipliers& multipliers) {
  const auto m = multipliers.products.rows();
  const Eigen::Index e = block.dimension - 1;
  const auto rows = normal_rows(block);
  const double size = multipliers.products.norm();
  const double off = gamma(m);
  const Eigen::MatrixXd responses = multipliers.products.transpose() * rows;
  const double product_error = off * size * rows.norm();
  Eigen::MatrixXd sums = responses.rightCols(e * m) + multipliers.slips;
  const Eigen::Map<const Eigen::VectorXd> mu(friction.data(), m);
  Eigen::MatrixXd sizes = Eigen::MatrixXd::Zero(m, m);
  Eigen::VectorXd shares(m);  // scales of the columns of E; 0 without friction
  for (Eigen::Index k = 0; k < m; ++k)
    shares[k] = mu[k] > 0 ? 1 / (2 * std::sqrt(multipliers.squares[k])) : 0;
  for (Eigen::Index c = 0; c < e; ++c) {
    sizes += multipliers.slips.middleCols(c * m, m).cwiseAbs2();
    sums.middleCols(c * m, m) *= shares.asDiagonal();
  }
  sizes = sizes.cwiseSqrt() * mu.asDiagonal();
  Eigen::MatrixXd form = responses.leftCols(m) + sizes;
  form.diagonal() += (mu.array().square() * multipliers.squares.array()).matrix();
  form.noalias() += sums * sums.transpose();
  const double scaled = sums.norm();
  const double sum_error = product_error * shares.maxCoeff() + off * scaled;
  // Error of F: P'(F* - F) acts on r_n and r_t, and |r_t| <= mu |r_n|.
  double normal = 0;
  double trace = 0;
  for (Eigen::Index i = 0; i < block.compliance.matrix.rows(); ++i) {
    trace += block.compliance.matrix(i, i);
    if (i % block.dimension == 0) normal += block.compliance.matrix(i, i);
  }
  const double compliance_error = 2 * block.compliance.error * std::sqrt(normal * trace);
  const double of_compliance = compliance_error * size * (1 + mu.maxCoeff());
  const double of_terms = off * (size * rows.norm() + sizes.norm() + form.norm());
  return {(form + form.transpose()) / 2,
          raised * (product_error + 2 * scaled * sum_error + sum_error * sum_error +
                    off * scaled * scaled + of_terms + of_compliance)};
}

}  // namespace

bool quadratic_is_infeasible(const problems::WedgedProblem& block, std::span<const double> friction,
                             const QuadraticMultipliers& multipliers) {
  if (block.modes.matrix.cols() > 0 || !multipliers.is_known() || !allowed(multipliers))
    return false;
  auto [matrix, error] = rounded_form(block, friction, multipliers);
  if (!matrix.allFinite() || !std::isfinite(error)) return false;
  // If the factor exists, no eigenvalue is below -gamma |L|_F^2; |L|_F^2 is the trace up to gamma.
  const double trace = matrix.diagonal().cwiseAbs().sum();
  const double lift = error + 2 * gamma(matrix.rows()) * trace * raised;
  matrix = -matrix;
  matrix.diagonal().array() -= 2 * lift;
  return Eigen::LLT<Eigen::MatrixXd>(matrix).info() == Eigen::Success;
}

}  // namespace kusabi::wedged
