// Iterative refinement and the bound of the remaining error.
#include "problems/wedged/precise_compliance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/SparseCore>

#include "problems/structure/assembly/contact_frame.hpp"
#include "problems/structure/bodies/grounding_springs.hpp"
#include "problems/structure/bodies/rigid_motions.hpp"
#include "problems/structure/model/elongation.hpp"
#include "problems/structure/model/several_normals.hpp"
#include "problems/structure/model/truss.hpp"
#include "problems/wedged/precise_residual.hpp"
#include "problems/wedged/scaled_stiffness.hpp"
#include "problems/wedged/stiffness_factor.hpp"
#include "problems/wedged/tangential_springs.hpp"
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

/// Bound of the rounding errors of entries of a normal or tangent.
constexpr double frame_roundings = 32;

/// Maximum number of refinement steps. Each gains the digits of the factor minus those of the
/// condition number.
constexpr int max_refinements = 12;

/// Number of columns refined at once; more would only increase memory.
constexpr Eigen::Index columns_at_once = PreciseResidual::columns_at_once;

/// Unit loads along the directions of all candidates, times D: f x dm, columns n, t1[, t2] of each,
/// and the norm of the rounding errors of each column.
struct Loads {
  numbers::PreciseMatrix matrix;
  Eigen::VectorXd errors;
};

// Adds forces on nodes, transferred to the free displacements and scaled, as the last columns.
void add_node_forces(const FreeDegrees& degrees, const Eigen::MatrixXd& forces,
                     const Eigen::VectorXd& scale, Loads& loads) {
  const Eigen::Index d = degrees.number.rows();
  Eigen::Index column = loads.matrix.cols() - forces.cols();
  for (Eigen::Index load = 0; load < forces.cols(); ++load, ++column) {
    double sizes = 0;
    for (Eigen::Index row = 0; row < forces.rows(); ++row) {
      const double force = forces(row, load);
      if (force == 0) continue;
      for (const auto& part :
           parts_of<Precise>(degrees, static_cast<int>(row % d), static_cast<int>(row / d))) {
        loads.matrix(part.number, column) += part.value * Precise(force) * scale(part.number);
        sizes += std::abs(numbers::rounded(part.value) * force) * scale(part.number);
      }
    }
    loads.errors(column) = frame_roundings * unit * 2 * sizes;
  }
}

Loads unit_loads(const Structure& structure, const FreeDegrees& degrees,
                 const Eigen::MatrixXd& forces, const Eigen::VectorXd& scale) {
  const auto d = static_cast<Eigen::Index>(structure.dimension);
  const auto columns = d * static_cast<Eigen::Index>(structure.contact.size()) + forces.cols();
  Loads loads{numbers::PreciseMatrix::Zero(degrees.size(), columns), Eigen::VectorXd(columns)};
  Eigen::Index column = 0;
  for (const ContactCandidate& candidate : structure.contact) {
    const auto frame = precise_contact_frame(candidate);
    const double sine =
        candidate.tangent ? tangent_sine(candidate.normal, *candidate.tangent) / 2 : 0.5;
    for (Eigen::Index direction = 0; direction < d; ++direction, ++column) {
      double sizes = 0;
      for (int axis = 0; axis < structure.dimension; ++axis) {
        // The displacement is fixed where a roller acts.
        for (const auto& part : candidate_displacement<Precise>(degrees, candidate, axis)) {
          loads.matrix(part.number, column) +=
              part.value * frame(axis, direction) * scale(part.number);
          sizes += std::abs(numbers::rounded(part.value)) * scale(part.number);
        }
      }
      loads.errors(column) = frame_roundings * unit * 2 * sizes / (direction == 0 ? 1 : sine);
    }
  }
  add_node_forces(degrees, forces, scale, loads);
  return loads;
}

Eigen::VectorXd column_norms(const numbers::PreciseMatrix& matrix) {
  return matrix.cast<double>().colwise().stableNorm().transpose();
}

double share(Eigen::Index done, Eigen::Index all) {
  return static_cast<double>(done) / static_cast<double>(all);
}

/// X with K X = B up to a residual with bounded column norms.
struct Solution {
  numbers::PreciseMatrix displacements;
  Eigen::VectorXd residuals;  ///< norm of K X - B for each column
};

/// Refines the columns from `first` on until the residual no longer decreases, or is below the
/// bound of its own rounding errors.
template <class Real>
void refine(const ScaledStiffness& stiffness, const StiffnessFactor<Real>& factor,
            const Loads& loads, Eigen::Index first, double rounding, const support::Stop& stop,
            Solution& solution) {
  const Eigen::Index count = std::min(columns_at_once, loads.matrix.cols() - first);
  const numbers::PreciseMatrix right = loads.matrix.middleCols(first, count);
  const Eigen::VectorXd certain =
      2 * unit * column_norms(right) + loads.errors.segment(first, count);
  auto best = solution.residuals.segment(first, count);
  const PreciseResidual residual(stiffness.matrix);
  numbers::PreciseMatrix displacements = numbers::PreciseMatrix::Zero(right.rows(), count);
  numbers::PreciseMatrix left = right;
  for (int step = 0; step < max_refinements; ++step) {
    support::leave_if(stop);
    typename StiffnessFactor<Real>::Matrix correction = left.cast<Real>();
    factor.solve(correction);
    displacements += correction.template cast<Precise>();
    left = residual(displacements, right);
    const Eigen::VectorXd computed = column_norms(left);
    const Eigen::VectorXd rounded_off = rounding * column_norms(displacements) + certain;
    const Eigen::VectorXd residuals = safety * (computed + rounded_off);
    const double before = best.maxCoeff();
    const double now = residuals.maxCoeff();
    if (!(now < before)) break;
    solution.displacements.middleCols(first, count) = displacements;
    best = residuals;
    if (now > before / 4 || (computed.array() <= rounded_off.array()).all()) break;
  }
}

template <class Real>
Solution solve(const ScaledStiffness& stiffness, const StiffnessFactor<Real>& factor,
               const Loads& loads, const support::LongWork& work) {
  double longest = 0;
  for (int k = 0; k < stiffness.matrix.outerSize(); ++k) {
    longest = std::max(longest, static_cast<double>(stiffness.matrix.innerVector(k).nonZeros()));
  }
  const double rounding = (longest + 4) * unit * stiffness.row_sum + stiffness.error;
  Solution solution;
  solution.displacements.setZero(loads.matrix.rows(), loads.matrix.cols());
  solution.residuals.setConstant(loads.matrix.cols(), infinity);
  for (Eigen::Index first = 0; first < loads.matrix.cols(); first += columns_at_once) {
    work.reached("condensing the stiffness: displacements under unit loads",
                 share(first, loads.matrix.cols()));
    refine(stiffness, factor, loads, first, rounding, work.stop, solution);
  }
  return solution;
}

/// The error bound of EnclosedCompliance. With K X = B + R, F - B'X = -B'K^-1 R, and
/// |b_i'K^-1 R_j| <= sqrt(F_ii) |R_j| / sqrt(s), s the least eigenvalue of K.
double compliance_error(const numbers::PreciseMatrix& matrix, const Loads& loads,
                        const Solution& solution, double min_eigenvalue) {
  const Eigen::VectorXd diagonal = matrix.diagonal().cast<double>();
  if (!(diagonal.minCoeff() > 0)) return infinity;
  const Eigen::VectorXd roots = diagonal.cwiseSqrt();
  const Eigen::VectorXd sizes = column_norms(solution.displacements);
  const Eigen::VectorXd right = column_norms(loads.matrix);
  const double first =
      (solution.residuals.array() / roots.array()).maxCoeff() / std::sqrt(min_eigenvalue);
  // Rounding errors of the product of B and X, and errors of the loads.
  const double second = ((16 * unit * right + loads.errors).array() / roots.array()).maxCoeff() *
                        (sizes.array() / roots.array()).maxCoeff();
  const double error = safety * (first + second);
  // The diagonal of F is known up to the error.
  return error < 1e-3 ? error * (1 + 2 * error) : infinity;
}

template <class Real>
EnclosedCompliance enclosed(const Structure& structure, const FreeDegrees& degrees,
                            const Eigen::MatrixXd& forces, const ScaledStiffness& stiffness,
                            const support::LongWork& work) {
  work.reached("condensing the stiffness: its factor", 0);
  const StiffnessFactor<Real> factor(stiffness.matrix);
  work.reached("condensing the stiffness: its least eigenvalue", 0);
  const double minimum = factor.min_eigenvalue() - stiffness.error;
  if (!(minimum > 0)) return {{}, infinity, {}};
  const Loads loads = unit_loads(structure, degrees, forces, stiffness.scale);
  Solution solution = solve(stiffness, factor, loads, work);
  if (!(solution.residuals.maxCoeff() < infinity)) return {{}, infinity, {}};
  const Eigen::Index size = loads.matrix.cols();
  numbers::PreciseMatrix product = numbers::PreciseMatrix::Zero(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    work.reached("condensing the stiffness: the compliance of the candidates", share(i, size));
    for (Eigen::Index k = 0; k < loads.matrix.rows(); ++k) {
      if (loads.matrix(k, i).is_zero()) continue;
      for (Eigen::Index j = 0; j < size; ++j)
        product(i, j) += loads.matrix(k, i) * solution.displacements(k, j);
    }
  }
  numbers::PreciseMatrix matrix = (product + product.transpose()) * Precise(0.5);
  const double spring_error = add_tangential_springs(structure, degrees, stiffness, matrix);
  const double error = compliance_error(matrix, loads, solution, minimum) + spring_error;
  auto& response = solution.displacements;
  for (Eigen::Index i = 0; i < response.rows(); ++i) response.row(i) *= Precise(stiffness.scale(i));
  return {matrix, error, std::move(response)};
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
  work.reached("stiffness of the candidates: its factor", 0);
  const Eigen::LLT<numbers::PreciseMatrix> factor(scaled);
  if (factor.info() != Eigen::Success)
    return numbers::PreciseMatrix::Constant(size, size, dd_real::_nan);
  const auto& lower = factor.matrixLLT();
  numbers::PreciseMatrix inverse(size, size);
  for (Eigen::Index first = 0; first < size; first += columns_at_once) {
    const Eigen::Index left = size - first;
    const Eigen::Index count = std::min(columns_at_once, left);
    const double rest = share(left, size);
    work.reached("stiffness of the candidates: its columns", 1 - rest * rest * rest);
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
