// The form is computed in doubles; its errors are bounded in the Frobenius norm by |fl(AB) - AB| <=
// gamma_k |A||B|, and Cholesky's method bears the rest (Higham, theorems 3.5 and 10.3).
#include "nodes/wedged/quadratic/quadratic_proof.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Cholesky>

#include "nodes/wedged/quadratic/whole_form.hpp"
#include "solvers/conic/dense_product.hpp"

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

bool is_nonnegative(const Eigen::MatrixXd& matrix, bool with_diagonal) {
  for (Eigen::Index j = 0; j < matrix.cols(); ++j)
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
      if ((i != j || with_diagonal) && !(matrix(i, j) >= 0)) return false;
  return matrix.allFinite();
}

bool allowed(const QuadraticMultipliers& multipliers) {
  return is_nonnegative(multipliers.products, false) && is_nonnegative(multipliers.pairs, true) &&
         (multipliers.squares.array() > 0).all() && multipliers.slips.allFinite() &&
         multipliers.squares.allFinite();
}

// Displacements and multipliers in units of length/force near the mean of the diagonal of F_nn, a
// power of two: the change of units is exact.
struct ScaledForm {
  Eigen::MatrixXd rows;  // U = [F_n, H]
  double row_error = 0;  // of U, in the Frobenius norm
  Eigen::MatrixXd equilibrium;
  double equilibrium_error = 0;  // of G
  QuadraticMultipliers multipliers;
};

ScaledForm scaled_form(const problems::WedgedProblem& block,
                       const QuadraticMultipliers& multipliers) {
  const double unit = std::exp2(std::round(std::log2(problems::mean_normal_compliance(block))));
  auto motions = form_motions(block);
  const auto m = multipliers.squares.size();
  const auto dm = block.dimension * m;
  ScaledForm form{.rows = Eigen::MatrixXd(m, dm + motions.lifting.cols()),
                  .equilibrium = std::move(motions.equilibrium),
                  .multipliers = multipliers};
  form.rows << normal_rows(block) / unit, motions.lifting;
  form.multipliers.slips /= unit;
  form.multipliers.squares /= unit;
  if (multipliers.pairs.rows() > 0)
    form.multipliers.pairs *= unit;
  else
    form.multipliers.pairs.setZero(m, m);
  double normal = 0;
  for (Eigen::Index i = 0; i < dm; i += block.dimension) normal += block.compliance.matrix(i, i);
  const double size = std::sqrt(normal * block.compliance.matrix.trace());
  const auto error_of = [&](const Eigen::MatrixXd& matrix) {
    return motions.error * std::sqrt(static_cast<double>(matrix.size()));
  };
  form.row_error = 2 * block.compliance.error * size / unit + error_of(motions.lifting);
  form.equilibrium_error = error_of(form.equilibrium);
  return form;
}

// The form in doubles, symmetric, and a bound of its error in the Frobenius norm.
struct RoundedForm {
  Eigen::MatrixXd matrix;
  double error = 0;
};

// (U'Q + Q'U)/2 with Q = P R + N U, R x = r_n.
RoundedForm products_of_rows(const ScaledForm& form) {
  const auto& [products, slips, squares, pairs] = form.multipliers;
  const auto m = squares.size();
  Eigen::MatrixXd acting = Eigen::MatrixXd::Zero(m, form.rows.cols());
  if (!pairs.isZero(0.0)) acting = conic::product_with_transpose(pairs, form.rows.transpose());
  acting.leftCols(m) += products;
  const Eigen::MatrixXd matrix =
      conic::product_with_transpose(form.rows.transpose(), acting.transpose());
  const double u = form.rows.norm();
  const double own = form.row_error;
  const double rounding = gamma(m) * u * (acting.norm() + pairs.norm() * u);
  const double of_rows = own * (products.norm() + 2 * pairs.norm() * u + pairs.norm() * own);
  return {(matrix + matrix.transpose()) / 2, 2 * rounding + of_rows};
}

RoundedForm rounded_form(const problems::WedgedProblem& block, std::span<const double> friction,
                         const QuadraticMultipliers& unscaled) {
  const auto form = scaled_form(block, unscaled);
  const auto& [products, slips, squares, pairs] = form.multipliers;
  const auto m = squares.size();
  const auto e = block.dimension - 1;
  const Eigen::Map<const Eigen::VectorXd> mu(friction.data(), m);
  auto [matrix, error] = products_of_rows(form);
  Eigen::MatrixXd sizes = Eigen::MatrixXd::Zero(m, m);
  for (Eigen::Index c = 0; c < e; ++c) sizes += slips.middleCols(c * m, m).cwiseAbs2();
  sizes = sizes.cwiseSqrt() * mu.asDiagonal();
  matrix.topLeftCorner(m, m) += (sizes + sizes.transpose()) / 2;
  matrix.block(0, m, m, e * m) += slips / 2;
  matrix.block(m, 0, e * m, m) += slips.transpose() / 2;
  for (Eigen::Index i = 0; i < m; ++i) {
    matrix(i, i) += mu[i] * mu[i] * squares[i];
    for (Eigen::Index k = i + m; k < block.dimension * m; k += m) {
      if (!(mu[i] > 0)) matrix.row(k).setZero(), matrix.col(k).setZero();  // r_t = 0
      matrix(k, k) -= squares[i];
    }
  }
  error += gamma(0) * (matrix.norm() + sizes.norm() + slips.norm() +
                       (1 + mu.cwiseAbs2().maxCoeff()) * squares.norm());
  const double level = matrix.diagonal().cwiseAbs().mean();
  const auto factors = restrict_to_equilibrium(form.equilibrium, level, matrix);
  const double size = form.equilibrium.norm() * factors.norm();
  error += form.equilibrium_error * factors.norm() + gamma(factors.rows()) * (size + matrix.norm());
  return {std::move(matrix), raised * error};
}

}  // namespace

bool form_proves_infeasible(const problems::WedgedProblem& block, std::span<const double> friction,
                            const QuadraticMultipliers& multipliers) {
  if (!multipliers.is_known() || !allowed(multipliers)) return false;
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
