// One Cholesky factorisation of order n = dm + k, and products with the m rows of U.
#include "nodes/wedged/quadratic/whole_form.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "solvers/conic/dense_product.hpp"
#include "solvers/conic/motions.hpp"

namespace kusabi::wedged {
namespace {

/// Powers of -cos of the angle between two rows of H that are tried as N.
constexpr int max_powers = 4;
/// H'N H must be below minus this share of its size.
constexpr double min_share = 1e-6;

/// The largest eigenvalue of the first N times that of F_nn.
constexpr double first_share = 1;
/// Part of it that is spread over all pairs.
constexpr double share_of_all = 0.01;

/// Bisection of the largest coefficient, relative.
constexpr double close_enough = 1e-7;
constexpr double min_factor = 1e-6;

template <int D>
FormMotions ordered(const problems::RigidModes& modes) {
  const auto motions = conic::ordered_motions<D, double>(modes.matrix, modes.error);
  const Eigen::Index m = modes.matrix.rows() / D;
  const Eigen::Index p = motions.count();
  FormMotions result{.lifting = Eigen::MatrixXd(m, motions.lifting),
                     .equilibrium = Eigen::MatrixXd(D * m, p),
                     .error = motions.error};
  for (Eigen::Index i = 0; i < m; ++i) {
    for (Eigen::Index k = 0; k < motions.lifting; ++k)
      result.lifting(i, k) = motions.at_cones(D * i, k);
    for (Eigen::Index c = 0; c < D; ++c)
      result.equilibrium.row(c * m + i) = motions.at_cones.row(D * i + c);
  }
  return result;
}

double size_of(const Eigen::MatrixXd& symmetric) {
  return symmetric.selfadjointView<Eigen::Lower>().operatorNorm();
}

}  // namespace

FormMotions form_motions(const problems::WedgedProblem& block) {
  const auto& modes = block.modes;
  if (modes.matrix.cols() == 0) {
    const auto rows = static_cast<Eigen::Index>(block.contact_names.size());
    return {.lifting = Eigen::MatrixXd(rows, 0),
            .equilibrium = Eigen::MatrixXd(block.dimension * rows, 0)};
  }
  return block.dimension == 2 ? ordered<2>(modes) : ordered<3>(modes);
}

Eigen::MatrixXd opposite_pairs(const Eigen::MatrixXd& lifting) {
  const auto m = lifting.rows();
  if (lifting.cols() == 0) return Eigen::MatrixXd::Zero(m, m);
  // Orthonormal columns: no motion counts more than another.
  const Eigen::MatrixXd h = Eigen::HouseholderQR<Eigen::MatrixXd>(lifting).householderQ() *
                            Eigen::MatrixXd::Identity(m, lifting.cols());
  const Eigen::VectorXd lengths = h.rowwise().norm().cwiseMax(std::numeric_limits<double>::min());
  const Eigen::MatrixXd cosines = lengths.cwiseInverse().asDiagonal() * (h * h.transpose()) *
                                  lengths.cwiseInverse().asDiagonal();
  Eigen::MatrixXd pairs = (-cosines).cwiseMax(0);
  for (int power = 0; power < max_powers; ++power, pairs = pairs.cwiseAbs2().eval()) {
    const Eigen::MatrixXd form = h.transpose() * pairs * h;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> values(form, Eigen::EigenvaluesOnly);
    const auto& ends = values.eigenvalues();
    if (ends[ends.size() - 1] < -min_share * std::abs(ends[0])) return pairs / size_of(pairs);
  }
  return {};
}

Eigen::MatrixXd restrict_to_equilibrium(const Eigen::MatrixXd& equilibrium, double level,
                                        Eigen::MatrixXd& form) {
  const auto rows = equilibrium.rows();
  const auto p = equilibrium.cols();
  // C = S (-2 G'T + (G'T G - level G'G) S G') with S = (G'G)^-1.
  const Eigen::MatrixXd square = equilibrium.transpose() * equilibrium;
  const Eigen::LDLT<Eigen::MatrixXd> inverse(square);
  const Eigen::MatrixXd shares = inverse.solve(equilibrium.transpose());
  const Eigen::MatrixXd moved = equilibrium.transpose() * form.topRows(rows);
  Eigen::MatrixXd factors = -2 * moved;
  factors.leftCols(rows) += (moved.leftCols(rows) * equilibrium - level * square) * shares;
  factors = inverse.solve(factors);
  if (p == 0) return factors;
  const Eigen::MatrixXd half = equilibrium * factors / 2;
  form.topRows(rows) += half;
  form.leftCols(rows) += half.transpose();
  return factors;
}

WholeForm::WholeForm(const problems::WedgedProblem& block, FormMotions motions,
                     Eigen::MatrixXd pairs)
    : QuadraticForm(block), first_pairs_(std::move(pairs)) {
  const auto m = candidates();
  const auto k = motions.lifting.cols();
  const auto p = motions.equilibrium.cols();
  all_rows_.resize(m, rows().cols() + k);
  all_rows_ << rows(), motions.lifting;
  for (Eigen::Index c = 1; c <= tangents(); ++c)
    motions.equilibrium.middleRows(c * m, m) =
        friction().asDiagonal() * motions.equilibrium.middleRows(c * m, m);
  basis_.setZero(all_rows_.cols(), p);
  basis_.topRows(rows().cols()) =
      Eigen::HouseholderQR<Eigen::MatrixXd>(motions.equilibrium).householderQ() *
      Eigen::MatrixXd::Identity(rows().cols(), p);
}

QuadraticPoint WholeForm::first_point() const {
  QuadraticPoint point(candidates(), tangents(), PairProducts::all);
  const auto m = candidates();
  const double size = size_of(rows().leftCols(m));
  // A root of zero would stay there.
  const double everywhere = share_of_all / static_cast<double>(m);
  point.pair_roots() = (first_share / size * (first_pairs_.array() + everywhere)).sqrt();
  return point;
}

void WholeForm::assemble(QuadraticPoint& point) {
  const auto m = candidates();
  // P r_n + N u_n
  Eigen::MatrixXd acting = conic::product_with_transpose(pairs_of(point), all_rows_.transpose());
  acting.leftCols(m) += products_;
  fixed_ = conic::product_with_transpose(all_rows_.transpose(), acting.transpose());
  fixed_ = (fixed_ + fixed_.transpose()).eval() / 2;
  fixed_.block(0, m, m, tangents() * m) += point.slips() / 2;
  fixed_.block(m, 0, tangents() * m, m) += point.slips().transpose() / 2;
}

// In units of the subspace G'r = 0, the rest of the form is -1.
Eigen::MatrixXd WholeForm::opposite(double factor) const {
  const auto m = candidates();
  Eigen::MatrixXd result = -fixed_;
  result.topLeftCorner(m, m) -= factor / 2 * (sizes_ + sizes_.transpose());
  result.diagonal().head(m) -= factor * squares_;
  for (Eigen::Index k = 1; k <= tangents(); ++k)
    result.diagonal().segment(k * m, m) += squares_ / factor;
  if (basis_.cols() == 0) return result;
  const Eigen::MatrixXd moved = result * basis_;
  const Eigen::MatrixXd own = basis_.transpose() * moved;
  Eigen::MatrixXd half = -moved + basis_ * (own / 2);
  half += basis_ / 2;
  result += half * basis_.transpose();
  result += basis_ * half.transpose();
  return result;
}

double WholeForm::potential(double factor, double weight) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  factor_ = factor;
  const Eigen::LLT<Eigen::MatrixXd> factors(opposite(factor));
  if (factors.info() != Eigen::Success) return infinity;
  // log s/f: without N the value is that of the form in the normal reactions.
  const auto e = static_cast<double>(tangents());
  const double value = -2 * factors.matrixLLT().diagonal().array().log().sum() +
                       e * (squares_.array().log() - std::log(factor)).sum() -
                       weight * std::log(factor);
  if (!std::isfinite(value)) return infinity;
  inverse_ = factors.solve(Eigen::MatrixXd::Identity(all_rows_.cols(), all_rows_.cols()));
  inverse_ -= basis_ * basis_.transpose();
  return value;
}

QuadraticForm::Slopes WholeForm::slopes() {
  const auto m = candidates();
  const auto e = tangents();
  const double f = factor_;
  const Eigen::MatrixXd images = conic::product_with_transpose(all_rows_, inverse_);
  const Eigen::VectorXd own = inverse_.diagonal();
  Slopes by{.by_products = images.leftCols(m),
            .by_slips = inverse_.block(0, m, m, e * m),
            .by_squares = f * own.head(m),
            .by_pairs = conic::product_with_transpose(images, all_rows_)};
  by.by_log_factor =
      f * (inverse_.topLeftCorner(m, m).cwiseProduct(sizes_).sum() + own.head(m).dot(squares_)) -
      static_cast<double>(e * m);
  by.by_squares += static_cast<double>(e) * squares_.cwiseInverse();
  for (Eigen::Index k = 1; k <= e; ++k) {
    by.by_squares -= own.segment(k * m, m) / f;
    by.by_log_factor += own.segment(k * m, m).dot(squares_) / f;
  }
  return by;
}

Eigen::VectorXd WholeForm::row_sizes() const {
  return (all_rows_ * inverse_).cwiseProduct(all_rows_).rowwise().sum();
}

double WholeForm::largest_factor(double above) {
  const auto definite = [&](double factor) {
    return Eigen::LLT<Eigen::MatrixXd>(opposite(factor)).info() == Eigen::Success;
  };
  double low = std::max(above, 1.0);
  while (low > std::max(above, min_factor) && !definite(low)) low = std::max(low / 2, above);
  if (!definite(low)) return 0;
  double high = 2 * low;
  while (definite(high)) low = std::exchange(high, 2 * high);
  while (high - low > close_enough * low) {
    const double middle = low + (high - low) / 2;
    (definite(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace kusabi::wedged
