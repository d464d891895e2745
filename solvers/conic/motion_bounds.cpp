// Rigid-mode bounds from the least singular values of the rows of G at a node.
#include "solvers/conic/motion_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <Eigen/QR>
#include <Eigen/SVD>

namespace kusabi::conic {
namespace {

// Singular values below this part of the largest belong to modes that do not move the part, up to
// the rounding of positions and directions in the file.
constexpr double negligible = 1e-10;

using Decomposition = Eigen::BDCSVD<Eigen::MatrixXd>;

// Reciprocal of the least singular value above the threshold; zero for a zero matrix.
double inverse_of_minimum(const Eigen::VectorXd& values, double negligible_share) {
  const double floor = negligible_share * values[0];
  double minimum = std::numeric_limits<double>::infinity();
  for (const double value : values)
    if (value > floor || negligible_share == 0) minimum = std::min(minimum, value);
  return std::isfinite(minimum) ? 1.001 / minimum : 0;
}

// A matrix with the same singular values and no more rows than columns.
Eigen::MatrixXd reduced(const Eigen::MatrixXd& part) {
  if (part.rows() < part.cols()) return part;
  const Eigen::HouseholderQR<Eigen::MatrixXd> factor(part);
  return factor.matrixQR().topRows(part.cols()).triangularView<Eigen::Upper>();
}

// Singular values. The errors of bidiagonalisation are those of the largest value: a smaller one that
// has fewer digits than the bounds need is computed by rotations, which takes ten times as long.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& part) {
  constexpr double few_digits = 1e-12;
  const Eigen::MatrixXd small = reduced(part);
  Eigen::VectorXd values = Decomposition(small).singularValues();
  if (values.tail(1)[0] < few_digits * values[0])
    values = Eigen::JacobiSVD<Eigen::MatrixXd>(small).singularValues();
  return values;
}

// Magnitude of the least x with A'x = b for all b within `noise` of the load, if no singular value of
// A is negligible: |R'^-1 b| with A = Q R, and the rounding of the factor. Singular values would give
// the bound for the worst direction of b, at three times the cost, and the interior-point method needs
// one per iteration.
std::optional<double> least_solution(const Eigen::MatrixXd& part, const Eigen::VectorXd& load,
                                     double noise) {
  if (part.rows() < part.cols()) return {};
  const Eigen::MatrixXd triangle = reduced(part);
  if ((triangle.diagonal().array() == 0).any()) return {};
  const Eigen::Index p = triangle.cols();
  const Eigen::MatrixXd inverse =
      triangle.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(p, p));
  const double size = inverse.norm();
  const double condition = size * triangle.norm();
  const double wrong = 4 * static_cast<double>(part.size()) * 0x1p-53 * condition;
  if (!(condition * negligible < 1) || !(wrong < 1)) return {};
  return 1.001 / (1 - wrong) * ((inverse.transpose() * load).norm() + size * noise);
}

double inverse_of_minimum(const Eigen::MatrixXd& part, double negligible_share) {
  if (part.size() == 0) return 0;
  if (negligible_share == 0 && part.rows() < part.cols())
    return std::numeric_limits<double>::infinity();
  return inverse_of_minimum(singular_values(part), negligible_share);
}

// True if a load has a part orthogonal to all rows of a matrix, which is taken as zero below the
// threshold.
bool acts_alone(const Decomposition& part, const Eigen::VectorXd& load) {
  const double size = load.norm();
  if (size == 0) return false;
  const auto& values = part.singularValues();
  Eigen::VectorXd left = load;
  for (Eigen::Index l = 0; l < values.size() && values[l] > negligible * values[0]; ++l)
    left -= part.matrixV().col(l).dot(load) * part.matrixV().col(l);
  return left.norm() > negligible * size;
}

}  // namespace

RigidModeBounds::RigidModeBounds(Eigen::MatrixXd motions, int lifting, double error,
                                 Eigen::VectorXd roots, std::vector<Eigen::Index> first_rows)
    : motions_(std::move(motions)),
      roots_(std::move(roots)),
      first_rows_(std::move(first_rows)),
      lifting_(lifting),
      error_(error) {
  min_root_ = roots_.size() == 0 ? 0 : roots_.minCoeff();
  largest_ = motions_.size() == 0 ? 0 : motions_.cwiseAbs().maxCoeff();
}

double RigidModeBounds::carrying_reaction(std::span<const int> cones, int dimension,
                                          std::span<const double> friction,
                                          std::span<const int> loads) const {
  const auto acting = [&](int k) {
    return friction[static_cast<std::size_t>(k)] == 0 ? 1 : dimension;
  };
  Eigen::Index rows = 0;
  for (const int k : cones) rows += acting(k);
  Eigen::MatrixXd part(rows, motions_.cols());
  Eigen::Index row = 0;
  for (const int k : cones)
    for (int d = 0; d < acting(k); ++d, ++row)
      part.row(row) = motions_.row(dimension * k + d) / roots_[dimension * k + d];
  if (part.cols() == 0) return 0;
  if (rows == 0) {
    const auto acts = [&](int j) { return !motions_.row(dimension * j).isZero(0); };
    return std::ranges::any_of(loads, acts) ? std::numeric_limits<double>::infinity() : 0;
  }
  const Eigen::VectorXd values = Decomposition(reduced(part)).singularValues();
  const bool carries_all = rows >= part.cols() && values.tail(1)[0] > negligible * values[0];
  if (carries_all) return inverse_of_minimum(values, negligible);
  const Decomposition decomposition(part, Eigen::ComputeThinV);
  for (const int j : loads)
    if (acts_alone(decomposition, motions_.row(dimension * j) / roots_[dimension * j]))
      return std::numeric_limits<double>::infinity();
  return inverse_of_minimum(decomposition.singularValues(), negligible);
}

double RigidModeBounds::closing_displacement(std::span<const int> contact) const {
  Eigen::MatrixXd part(static_cast<Eigen::Index>(contact.size()), lifting_);
  Eigen::Index row = 0;
  for (const int i : contact) {
    const auto at = first_rows_[static_cast<std::size_t>(i)];
    part.row(row++) = motions_.row(at).head(lifting_) / roots_[at];
  }
  return inverse_of_minimum(part, negligible);
}

double RigidModeBounds::normal_displacement(int candidate) const {
  return motions_.row(first_rows_[static_cast<std::size_t>(candidate)]).head(lifting_).norm() +
         error_ * lifting_;
}

double RigidModeBounds::balance(std::span<const int> rows, const std::vector<double>& sizes,
                                const Eigen::VectorXd& load, double noise, bool whole) const {
  Eigen::MatrixXd part(static_cast<Eigen::Index>(rows.size()), lifting_);
  for (std::size_t place = 0; place < rows.size(); ++place) {
    const auto at = first_rows_[static_cast<std::size_t>(rows[place])];
    part.row(static_cast<Eigen::Index>(place)) = sizes[place] * motions_.row(at).head(lifting_);
  }
  const double noises = noise * std::sqrt(static_cast<double>(lifting_));
  const double size = load.norm() + noises;
  if (size == 0) return 0;
  if (const auto change = least_solution(part, load, noises)) return *change;
  return size * inverse_of_minimum(part, whole ? 0 : negligible);
}

}  // namespace kusabi::conic
