// Solution, residual, and the bound of the error that is quadratic in it.
#include "problems/wedged/precise_compliance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/SparseCore>
#include <fmt/format.h>

#include "problems/structure/factor/blas_product.hpp"
#include "problems/structure/model/truss.hpp"
#include "problems/wedged/precise_residual.hpp"
#include "problems/wedged/scaled_stiffness.hpp"
#include "problems/wedged/stiffness_factor.hpp"
#include "problems/wedged/tangential_springs.hpp"
#include "problems/wedged/unit_loads.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::problems {
namespace {

/// Relative error of directions written with sixteen digits: an entry of F that is zero by a right
/// angle becomes this share of its neighbours.
constexpr long double noise_of_decimals = 1e-15L;

using numbers::Precise;
using SparseMatrix = Eigen::SparseMatrix<Precise>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unit = numbers::unit_roundoff<Precise>;

/// Factor for the rounding errors of sums of a few hundred nonnegative doubles.
constexpr double safety = 1.001;

/// Maximum number of refinement steps. Each gains the digits of the factor minus those of the
/// condition number.
constexpr int max_refinements = 12;

/// Number of columns solved at once; more would only increase memory.
constexpr Eigen::Index columns_at_once = 4 * PreciseResidual::columns_at_once;

/// Product of two residuals, relative to F, from which on no step is taken. With a factor in
/// doubles it is below the error of F that is enough; otherwise the displacements also become exact
/// to the last digit of a double.
constexpr double negligible_in_doubles = 1e-21;
constexpr double negligible_otherwise = 1e-32;
template <class Real>
constexpr double negligible() {
  return std::is_same_v<Real, double> ? negligible_in_doubles : negligible_otherwise;
}

Eigen::VectorXd column_norms(const numbers::PreciseMatrix& matrix) {
  return matrix.cast<double>().colwise().stableNorm().transpose();
}

double share(Eigen::Index done, Eigen::Index all) {
  return static_cast<double>(done) / static_cast<double>(all);
}

/// Some columns of X and of the residuals R = B - K X.
struct Columns {
  numbers::PreciseMatrix displacements;  ///< X, f x c
  Eigen::MatrixXd residuals;             ///< R, rounded to doubles
  Eigen::VectorXd sizes;                 ///< norms of the columns of X
  Eigen::VectorXd computed;              ///< norms of the computed residuals
  Eigen::VectorXd rounded_off;           ///< bounds of the norms of their rounding errors
};

/// Solution of K X = B with a factor of K.
template <class Real>
class Condensation {
 public:
  /// @param minimum lower bound of the least eigenvalue of K
  Condensation(const ScaledStiffness& stiffness, const StiffnessFactor<Real>& factor,
               const Loads& loads, double minimum)
      : factor_(factor), loads_(loads), minimum_(minimum), residual_(stiffness.matrix) {
    int longest = 0;
    for (int k = 0; k < stiffness.matrix.outerSize(); ++k)
      longest = std::max(longest, static_cast<int>(stiffness.matrix.innerVector(k).nonZeros()));
    rounding_ = (longest + 4) * unit * stiffness.row_sum + stiffness.error;
  }

  /// Refines the columns until the product of two residuals is negligible, or they no longer
  /// decrease, or are below the bound of their own rounding errors.
  [[nodiscard]] Columns solve(Eigen::Index first, Eigen::Index count,
                              const support::Stop& stop) const {
    const numbers::PreciseMatrix right = loads_.dense(first, count);
    const Eigen::VectorXd certain =
        2 * unit * column_norms(right) + loads_.errors.segment(first, count);
    Columns best;
    double before = infinity;
    numbers::PreciseMatrix displacements = numbers::PreciseMatrix::Zero(right.rows(), count);
    numbers::PreciseMatrix left = right;
    for (int step = 0; step < max_refinements; ++step) {
      support::throw_if_requested(stop);
      typename StiffnessFactor<Real>::Matrix correction = left.template cast<Real>();
      factor_.solve(correction);
      displacements += correction.template cast<Precise>();
      left = residual(displacements, right);
      const Eigen::VectorXd sizes = column_norms(displacements);
      const Eigen::VectorXd computed = column_norms(left);
      const Eigen::VectorXd rounded_off = rounding_ * sizes + certain;
      const double now = (computed + rounded_off).maxCoeff();
      if (!(now < before)) break;
      best = {displacements, left.template cast<double>(), sizes, computed, rounded_off};
      if (now > before / 4 || (computed.array() <= rounded_off.array()).all() ||
          is_negligible(computed, right, displacements))
        break;
      before = now;
    }
    return best;
  }

 private:
  [[nodiscard]] numbers::PreciseMatrix residual(const numbers::PreciseMatrix& displacements,
                                                const numbers::PreciseMatrix& right) const {
    numbers::PreciseMatrix result(right.rows(), right.cols());
    constexpr Eigen::Index width = PreciseResidual::columns_at_once;
    for (Eigen::Index first = 0; first < right.cols(); first += width) {
      const Eigen::Index count = std::min(width, right.cols() - first);
      result.middleCols(first, count) =
          residual_(displacements.middleCols(first, count), right.middleCols(first, count));
    }
    return result;
  }

  [[nodiscard]] bool is_negligible(const Eigen::VectorXd& computed,
                                   const numbers::PreciseMatrix& right,
                                   const numbers::PreciseMatrix& displacements) const {
    const Eigen::VectorXd works =
        right.cast<double>().cwiseProduct(displacements.cast<double>()).colwise().sum();
    return (computed.array().square() <= negligible<Real>() * minimum_ * works.array()).all();
  }

  const StiffnessFactor<Real>& factor_;
  const Loads& loads_;
  double minimum_;
  PreciseResidual residual_;
  double rounding_;  // of a residual, relative to the displacements
};

/// F~ = X'B + R'X, the displacements, and what bounds the error.
struct Solution {
  explicit Solution(const Loads& loads)
      : displacements(loads.matrix.rows(), loads.matrix.cols()),
        matrix(loads.matrix.cols(), loads.matrix.cols()),
        sizes(loads.matrix.cols()),
        computed(loads.matrix.cols()),
        rounded_off(loads.matrix.cols()) {}

  numbers::PreciseMatrix displacements;
  numbers::PreciseMatrix matrix;
  Eigen::VectorXd sizes, computed, rounded_off;  ///< as in `Columns`
};

/// Adds columns of X and, with those before them, rows of F~ and columns of its other triangle.
/// @param doubles X rounded to doubles, up to these columns
void add(const Columns& columns, Eigen::Index first, const Loads& loads, Eigen::MatrixXd& doubles,
         Solution& solution) {
  const Eigen::Index count = columns.sizes.size();
  doubles.middleCols(first, count) = columns.displacements.cast<double>();
  solution.displacements.middleCols(first, count) = columns.displacements;
  solution.sizes.segment(first, count) = columns.sizes;
  solution.computed.segment(first, count) = columns.computed;
  solution.rounded_off.segment(first, count) = columns.rounded_off;
  const Eigen::MatrixXd corrections =
      product_of_columns(doubles.leftCols(first + count), columns.residuals);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j <= first + i; ++j) {
      Precise sum = 0.0;
      for (SparseMatrix::InnerIterator entry(loads.matrix, j); entry; ++entry)
        sum += entry.value() * columns.displacements(entry.row(), i);
      solution.matrix(first + i, j) = solution.matrix(j, first + i) = sum + corrections(j, i);
    }
  }
}

template <class Real>
Solution solve(const ScaledStiffness& stiffness, const StiffnessFactor<Real>& factor,
               const Loads& loads, double minimum, const support::LongWork& work) {
  const Condensation<Real> condensation(stiffness, factor, loads, minimum);
  Solution solution(loads);
  Eigen::MatrixXd doubles(loads.matrix.rows(), loads.matrix.cols());
  for (Eigen::Index first = 0; first < loads.matrix.cols(); first += columns_at_once) {
    work.report_share("condensing the stiffness: displacements under unit loads",
                      share(first, loads.matrix.cols()));
    const Eigen::Index count = std::min(columns_at_once, loads.matrix.cols() - first);
    const Columns columns = condensation.solve(first, count, work.stop);
    if (columns.sizes.size() == 0) {  // not finite
      solution.computed.setConstant(infinity);
      return solution;
    }
    add(columns, first, loads, doubles, solution);
  }
  return solution;
}

/// The error bound of EnclosedCompliance. With R = B - K X, F - X'B - R'X = R'K^-1 R, and
/// |R_i'K^-1 R_j| <= |R_i| |R_j| / s, s the least eigenvalue of K.
double compliance_error(const Loads& loads, const Solution& solution, double min_eigenvalue) {
  const Eigen::VectorXd diagonal = solution.matrix.diagonal().cast<double>();
  if (!(diagonal.minCoeff() > 0)) return infinity;
  const Eigen::VectorXd roots = diagonal.cwiseSqrt();
  const auto largest = [&](const Eigen::VectorXd& norms) {
    return (norms.array() / roots.array()).maxCoeff();
  };
  Eigen::VectorXd right = loads.errors;
  for (Eigen::Index column = 0; column < right.size(); ++column) {
    double squares = 0;
    double roundings = 4;
    for (SparseMatrix::InnerIterator entry(loads.matrix, column); entry; ++entry, ++roundings)
      squares += std::pow(numbers::rounded(entry.value()), 2);
    right(column) += roundings * unit * std::sqrt(squares);
  }
  // Rounding errors of X'B, of the loads in it, of R, and of R'X in doubles with R and X rounded.
  const double doubles = (static_cast<double>(loads.matrix.rows()) + 8) *
                         numbers::unit_roundoff<double> * largest(solution.computed);
  const double rounding =
      (largest(right) + largest(solution.rounded_off) + doubles) * largest(solution.sizes);
  const double residual = largest(solution.computed + solution.rounded_off);
  const double error = safety * (residual * residual / min_eigenvalue + rounding);
  // The diagonal of F is known up to the error.
  return error < 1e-3 ? error * (1 + 2 * error) : infinity;
}

/// Announces the factorisation, and the memory for X and F, in doubles and in 104 bits, if it is a
/// gigabyte.
void announce(const ScaledStiffness& stiffness, Eigen::Index loads, const support::LongWork& work) {
  const auto columns = static_cast<double>(loads);
  const double entries = columns * (static_cast<double>(stiffness.matrix.rows()) + columns);
  const double gigabytes = 1e-9 * entries * (sizeof(double) + sizeof(Precise));
  const auto memory =
      gigabytes < 1 ? std::string() : fmt::format(", which takes {:.1f} GB of memory", gigabytes);
  work.report_share(fmt::format("condensing the stiffness{}: its factor", memory).c_str(), 0);
}

template <class Real>
EnclosedCompliance enclosed(const Structure& structure, const FreeDegrees& degrees,
                            const Eigen::MatrixXd& forces, const ScaledStiffness& stiffness,
                            const support::LongWork& work) {
  announce(stiffness, structure.dimension * std::ssize(structure.contact) + forces.cols(), work);
  const StiffnessFactor<Real> factor(stiffness.matrix);
  work.report_share("condensing the stiffness: its least eigenvalue", 0);
  const double minimum = factor.min_eigenvalue() - stiffness.error;
  if (!(minimum > 0)) return {{}, infinity, {}};
  const Loads loads = unit_loads(structure, degrees, forces, stiffness.scale);
  Solution solution = solve(stiffness, factor, loads, minimum, work);
  if (!(solution.computed.maxCoeff() < infinity)) return {{}, infinity, {}};
  const double spring_error =
      add_tangential_springs(structure, degrees, stiffness, solution.matrix);
  const double error = compliance_error(loads, solution, minimum) + spring_error;
  auto& response = solution.displacements;
  for (Eigen::Index i = 0; i < response.rows(); ++i) response.row(i) *= Precise(stiffness.scale(i));
  return {std::move(solution.matrix), error, std::move(response)};
}

/// Larger problems are first factorised in doubles: a factor in long doubles takes four times as
/// long, and solutions with it ten times.
constexpr int fewest_for_doubles = 4000;

/// An error that more digits in the factor would hardly decrease.
constexpr double enough_in_doubles = 1e-20;

/// Maximum size for a factor in 104 bits, by computing time.
constexpr int max_for_precise_factor = 600;

}  // namespace

bool acts_on_supports_only(const FreeDegrees& degrees, const Eigen::VectorXd& force) {
  const auto d = static_cast<int>(degrees.number.rows());
  for (int row = 0; row < static_cast<int>(force.size()); ++row)
    if (force(row) != 0 && !parts_of<Precise>(degrees, row % d, row / d).empty()) return false;
  return true;
}

EnclosedCompliance enclosed_compliance(const Structure& structure, const FreeDegrees& degrees,
                                       const support::LongWork& work) {
  return enclosed_compliance(structure, degrees, Eigen::MatrixXd(), work);
}

EnclosedCompliance enclosed_compliance(const Structure& structure, const FreeDegrees& degrees,
                                       const Eigen::MatrixXd& forces,
                                       const support::LongWork& work) {
  const ScaledStiffness stiffness = scaled_stiffness(structure, degrees);
  if (degrees.size() >= fewest_for_doubles) {
    auto result = enclosed<double>(structure, degrees, forces, stiffness, work);
    if (result.error <= enough_in_doubles) return result;
  }
  auto result = enclosed<long double>(structure, degrees, forces, stiffness, work);
  if (!(result.error < infinity) && degrees.size() <= max_for_precise_factor)
    result = enclosed<Precise>(structure, degrees, forces, stiffness, work);
  return result;
}

// Columns are computed from the diagonal down, since L^-1 is triangular and K symmetric.
numbers::PreciseMatrix stiffness_of(const numbers::PreciseMatrix& compliance,
                                    const support::LongWork& work) {
  // Scaling to a unit diagonal by powers of two, which is exact.
  const Eigen::Index size = compliance.rows();
  Eigen::VectorXd scale(size);
  for (Eigen::Index i = 0; i < size; ++i)
    scale(i) = std::exp2(-std::round(std::log2(numbers::rounded(compliance(i, i))) / 2));
  numbers::PreciseMatrix scaled = compliance;
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j) scaled(i, j) *= scale(i) * scale(j);
  work.report_share("stiffness of the candidates: its factor", 0);
  const Eigen::LLT<numbers::PreciseMatrix> factor(scaled);
  if (factor.info() != Eigen::Success)
    return numbers::PreciseMatrix::Constant(size, size, dd_real::_nan);
  const auto& lower = factor.matrixLLT();
  numbers::PreciseMatrix inverse(size, size);
  constexpr Eigen::Index width = PreciseResidual::columns_at_once;
  for (Eigen::Index first = 0; first < size; first += width) {
    const Eigen::Index left = size - first;
    const Eigen::Index count = std::min(width, left);
    const double rest = share(left, size);
    work.report_share("stiffness of the candidates: its columns", 1 - rest * rest * rest);
    numbers::PreciseMatrix columns = numbers::PreciseMatrix::Identity(left, count);
    const auto own = lower.bottomRightCorner(left, left).triangularView<Eigen::Lower>();
    own.solveInPlace(columns);
    own.transpose().solveInPlace(columns);
    inverse.block(first, first, left, count) = columns;
  }
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      inverse(i, j) *= scale(i) * scale(j);
      inverse(j, i) = inverse(i, j);
    }
  }
  return inverse;
}

Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic> precise_compliance(
    const WedgedProblem& problem) {
  const auto& f = problem.compliance.precise;
  Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic> result = f.cast<long double>();
  const Eigen::Index d = problem.dimension;
  for (Eigen::Index i = 0; i < f.rows(); ++i) {
    for (Eigen::Index j = 0; j < f.cols(); ++j) {
      // Norm of the block of two candidates.
      const long double together =
          result.block(d * (i / d), d * (j / d), d, d).cwiseAbs().maxCoeff();
      const long double unknown =
          problem.compliance.precise_error * std::sqrt(result(i, i)) * std::sqrt(result(j, j));
      if (std::abs(result(i, j)) <= std::max(unknown, noise_of_decimals * together))
        result(i, j) = 0;
    }
  }
  return result;
}

}  // namespace kusabi::problems
