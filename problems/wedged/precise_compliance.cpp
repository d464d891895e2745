// Assembly in 104 bits, refinement, and the bound of what is left.
#include "problems/wedged/precise_compliance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "problems/structure/contact_frame.hpp"
#include "problems/structure/elongation.hpp"
#include "problems/structure/quadrilateral.hpp"
#include "problems/structure/truss.hpp"

namespace kusabi::problems {
namespace {

/// A direction written with sixteen digits is off by so much of a unit: an entry of F that a right
/// angle makes zero comes out with so much of its neighbours.
constexpr long double noise_of_decimals = 1e-15L;

using numbers::Precise;
using SparseMatrix = Eigen::SparseMatrix<Precise>;
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unit = numbers::unit_roundoff<Precise>;

/// Sums of a few hundred roundings in doubles, all of numbers >= 0, are right to this factor.
constexpr double safety = 1.001;

/// Roundings that the product of a bar's stiffness and two entries of its vector goes through, and
/// those of the sum at an entry of K, with room.
constexpr double member_roundings = 64;

/// The same for the twelve vectors of an element, relative to the trace of its stiffness: each
/// entry of B_g is right to some 40 roundings times the ratio below.
constexpr double element_roundings = 400;

/// Entries of a normal or tangent.
constexpr double frame_roundings = 32;

/// Each step of refinement gains the digits of a long double less those of the condition.
constexpr int most_refinements = 12;

/// The least eigenvalue is tried at half of its estimate, and at smaller shares.
constexpr int most_trials = 4;

/// How much the geometry of an element loses to cancellation: the square of its largest side over
/// the least area at a corner.
double slenderness(const Structure& structure, const Quadrilateral& element) {
  double side = 0;
  for (std::size_t corner = 0; corner < 4; ++corner) {
    side = std::max(side, (structure.coordinates.col(element.nodes[corner]) -
                           structure.coordinates.col(element.nodes[(corner + 1) % 4]))
                              .norm());
  }
  return 4 * side * side / corner_areas(structure, element).cwiseAbs().minCoeff();
}

/// The stiffness over the free displacements, D K D with D = diag(scale) of powers of two that
/// bring the diagonal near one, and how wrong it may be.
struct ScaledStiffness {
  SparseMatrix matrix;
  Eigen::VectorXd scale;  ///< D
  double error = 0;       ///< bound of the norm of what the roundings of the assembly add
  double row_sum = 0;     ///< bound of the largest sum of sizes in a row
};

ScaledStiffness assemble(const Structure& structure, const FreeDegrees& degrees) {
  std::vector<Eigen::Triplet<Precise>> entries;
  // Of each bar or element: displacements, and what an entry of its stiffness may be wrong by,
  // over the square root of the diagonal entries it belongs to (bars), or altogether (elements).
  struct Share {
    std::vector<int> numbers;
    std::vector<double> sizes;
    double error;
  };
  std::vector<Share> shares;
  for (const Member& member : structure.members) {
    const auto vector = elongation_vector<Precise>(structure, degrees, member);
    const auto weight = bar_stiffness<Precise>(structure, member);
    add_square(vector, weight, entries);
    Share share{{}, {}, member_roundings * unit * numbers::rounded(weight)};
    for (const auto& entry : vector) {
      share.numbers.push_back(entry.number);
      share.sizes.push_back(std::abs(numbers::rounded(entry.value)));
    }
    shares.push_back(std::move(share));
  }
  for (const Quadrilateral& element : structure.elements) {
    double trace = 0;
    Share share{{}, {}, 0};
    // One matrix for each element first: a twelfth of the entries.
    const auto vectors = strain_vectors<Precise>(structure, degrees, element);
    const auto size = static_cast<Eigen::Index>(vectors.front().size());
    numbers::PreciseMatrix sum = numbers::PreciseMatrix::Zero(size, size);
    for (const auto& vector : vectors) {
      for (Eigen::Index i = 0; i < size; ++i) {
        for (Eigen::Index j = 0; j < size; ++j) {
          sum(i, j) +=
              vector[static_cast<std::size_t>(i)].value * vector[static_cast<std::size_t>(j)].value;
        }
        trace += std::pow(numbers::rounded(vector[static_cast<std::size_t>(i)].value), 2);
      }
    }
    for (Eigen::Index i = 0; i < size; ++i) {
      const int row = vectors.front()[static_cast<std::size_t>(i)].number;
      for (Eigen::Index j = 0; j < size; ++j)
        entries.emplace_back(row, vectors.front()[static_cast<std::size_t>(j)].number, sum(i, j));
      share.numbers.push_back(row);
      share.sizes.push_back(1);
    }
    share.error = element_roundings * unit * slenderness(structure, element) * trace;
    shares.push_back(std::move(share));
  }
  ScaledStiffness result;
  result.matrix.resize(degrees.size(), degrees.size());
  result.matrix.setFromTriplets(entries.begin(), entries.end());
  result.scale.setOnes(degrees.size());
  for (int i = 0; i < degrees.size(); ++i) {
    const double stiffness = numbers::rounded(result.matrix.coeff(i, i));
    if (stiffness > 0) result.scale(i) = std::exp2(-std::round(std::log2(stiffness) / 2));
  }
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(degrees.size());
  for (int column = 0; column < result.matrix.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator entry(result.matrix, column); entry; ++entry) {
      entry.valueRef() *= result.scale(entry.row()) * result.scale(column);
      sums(column) += std::abs(numbers::rounded(entry.value()));
    }
  }
  Eigen::VectorXd errors = Eigen::VectorXd::Zero(degrees.size());
  for (const Share& share : shares) {
    double sum = 0;
    for (std::size_t i = 0; i < share.numbers.size(); ++i)
      sum += result.scale(share.numbers[i]) * share.sizes[i];
    for (std::size_t i = 0; i < share.numbers.size(); ++i)
      errors(share.numbers[i]) +=
          share.error * result.scale(share.numbers[i]) * share.sizes[i] * sum;
  }
  result.error = degrees.size() == 0 ? 0 : safety * errors.maxCoeff();
  result.row_sum = degrees.size() == 0 ? 0 : safety * sums.maxCoeff();
  return result;
}

/// A factor of the scaled stiffness, to solve with and to prove by.
template <class Real>
class Factor {
 public:
  using Matrix = Eigen::SparseMatrix<Real>;

  explicit Factor(const SparseMatrix& matrix) : matrix_(matrix.cast<Real>()) {
    factor_.analyzePattern(matrix_);
    factor_.factorize(matrix_);
  }

  [[nodiscard]] bool exists() const { return factor_.info() == Eigen::Success; }

  template <class Right>
  [[nodiscard]] auto solve(const Right& right) const {
    return factor_.solve(right);
  }

  /// A number that the least eigenvalue is not below, whatever the roundings: where Cholesky's
  /// method goes through for M - s I, M - s I + E is positive semidefinite with
  /// |E_ij| <= g sqrt(M_ii M_jj), g = (n + 4) u, so |E| <= g trace M. Zero if there is none.
  [[nodiscard]] double least_eigenvalue() {
    if (!exists()) return 0;
    const auto size = matrix_.rows();
    using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
    Vector motion(size);
    for (Eigen::Index i = 0; i < size; ++i) motion(i) = Real(1.0 + 0.37 * std::sin(double(i)));
    double estimate = 0;
    for (int step = 0; step < 8; ++step) {
      const Vector next = factor_.solve(motion);
      const double growth = numbers::rounded(Real(next.norm()));
      estimate = numbers::rounded(Real(motion.norm())) / growth;
      motion = next / Real(growth);
    }
    const auto n = static_cast<double>(size);
    const double trace = safety * numbers::rounded(Real(matrix_.diagonal().sum()));
    // The cast, the shift and the factorisation.
    const double rounding = 2 * (n + 6) * numbers::unit_roundoff<Real> * trace;
    double shift = estimate / 2;
    for (int trial = 0; trial < most_trials && shift > 2 * rounding; ++trial, shift /= 8) {
      Eigen::SimplicialLLT<Matrix> shifted;
      shifted.setShift(Real(-shift));
      shifted.compute(matrix_);
      if (shifted.info() == Eigen::Success) return shift - rounding;
    }
    return 0;
  }

 private:
  Matrix matrix_;
  Eigen::SimplicialLLT<Matrix> factor_;
};

/// Unit loads along the directions of all candidates, D times: f x dm, column by column n, t1[,
/// t2], and the norm of what the roundings of each may add.
struct Loads {
  numbers::PreciseMatrix matrix;
  Eigen::VectorXd errors;
};

Loads unit_loads(const Structure& structure, const FreeDegrees& degrees,
                 const Eigen::VectorXd& scale) {
  const auto d = static_cast<Eigen::Index>(structure.dimension);
  const auto columns = d * static_cast<Eigen::Index>(structure.contact.size());
  Loads loads{numbers::PreciseMatrix::Zero(degrees.size(), columns), Eigen::VectorXd(columns)};
  Eigen::Index column = 0;
  for (const ContactCandidate& candidate : structure.contact) {
    const auto frame = precise_contact_frame(candidate);
    const double sine =
        candidate.tangent ? tangent_sine(candidate.normal, *candidate.tangent) / 2 : 0.5;
    for (Eigen::Index direction = 0; direction < d; ++direction, ++column) {
      double largest = 0;
      for (int axis = 0; axis < structure.dimension; ++axis) {
        const int number = degrees.number(axis, candidate.node);
        loads.matrix(number, column) = frame(axis, direction) * scale(number);
        largest = std::max(largest, scale(number));
      }
      loads.errors(column) = frame_roundings * unit * 2 * largest / (direction == 0 ? 1 : sine);
    }
  }
  return loads;
}

/// K X as a product of sparse and dense, one column after the other.
numbers::PreciseMatrix residual(const SparseMatrix& matrix, const numbers::PreciseMatrix& solution,
                                const numbers::PreciseMatrix& right) {
  numbers::PreciseMatrix left = right;
  for (Eigen::Index column = 0; column < right.cols(); ++column) {
    for (int k = 0; k < matrix.outerSize(); ++k) {
      const Precise factor = solution(k, column);
      if (factor.is_zero()) continue;
      for (SparseMatrix::InnerIterator entry(matrix, k); entry; ++entry)
        left(entry.row(), column) -= entry.value() * factor;
    }
  }
  return left;
}

Eigen::VectorXd column_norms(const numbers::PreciseMatrix& matrix) {
  return matrix.cast<double>().colwise().stableNorm().transpose();
}

/// X with K X = B up to a residual whose norms are bounded.
struct Solution {
  numbers::PreciseMatrix displacements;
  Eigen::VectorXd residuals;  ///< norm of K X - B, column by column
};

template <class Real>
Solution solve(const ScaledStiffness& stiffness, const Factor<Real>& factor, const Loads& loads) {
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  const Eigen::Index size = loads.matrix.rows();
  double longest = 0;
  for (int k = 0; k < stiffness.matrix.outerSize(); ++k) {
    longest = std::max(longest, static_cast<double>(stiffness.matrix.innerVector(k).nonZeros()));
  }
  const Eigen::VectorXd right = column_norms(loads.matrix);
  Solution best;
  best.residuals.setConstant(loads.matrix.cols(), infinity);
  numbers::PreciseMatrix displacements = numbers::PreciseMatrix::Zero(size, loads.matrix.cols());
  numbers::PreciseMatrix left = loads.matrix;
  for (int step = 0; step < most_refinements; ++step) {
    const Matrix correction = factor.solve(Matrix(left.cast<Real>()));
    displacements += correction.template cast<Precise>();
    left = residual(stiffness.matrix, displacements, loads.matrix);
    const Eigen::VectorXd sizes = column_norms(displacements);
    const double rounding = (longest + 4) * unit * stiffness.row_sum + stiffness.error;
    const Eigen::VectorXd residuals =
        safety * (column_norms(left) + rounding * sizes + 2 * unit * right + loads.errors);
    const double before = best.residuals.maxCoeff();
    const double now = residuals.maxCoeff();
    if (!(now < before)) break;
    best = {displacements, residuals};
    if (now > before / 4) break;
  }
  return best;
}

/// The bound that EnclosedCompliance promises. With K X = B + R, F - B'X = -B'K^-1 R, and
/// |b_i'K^-1 R_j| <= sqrt(F_ii) |R_j| / sqrt(s), s the least eigenvalue of K.
double compliance_error(const numbers::PreciseMatrix& matrix, const Loads& loads,
                        const Solution& solution, double least_eigenvalue) {
  const Eigen::VectorXd diagonal = matrix.diagonal().cast<double>();
  if (!(diagonal.minCoeff() > 0)) return infinity;
  const Eigen::VectorXd roots = diagonal.cwiseSqrt();
  const Eigen::VectorXd sizes = column_norms(solution.displacements);
  const Eigen::VectorXd right = column_norms(loads.matrix);
  const double first =
      (solution.residuals.array() / roots.array()).maxCoeff() / std::sqrt(least_eigenvalue);
  // The rounding of the product of B and X, and what the loads themselves are wrong by.
  const double second = ((16 * unit * right + loads.errors).array() / roots.array()).maxCoeff() *
                        (sizes.array() / roots.array()).maxCoeff();
  const double error = safety * (first + second);
  // The diagonal of F itself is known up to the error.
  return error < 1e-3 ? error * (1 + 2 * error) : infinity;
}

template <class Real>
EnclosedCompliance enclosed(const Structure& structure, const FreeDegrees& degrees,
                            const ScaledStiffness& stiffness) {
  Factor<Real> factor(stiffness.matrix);
  const double least = factor.least_eigenvalue() - stiffness.error;
  if (!(least > 0)) return {{}, infinity, {}};
  const Loads loads = unit_loads(structure, degrees, stiffness.scale);
  const Solution solution = solve(stiffness, factor, loads);
  if (solution.displacements.size() == 0) return {{}, infinity, {}};
  const Eigen::Index size = loads.matrix.cols();
  numbers::PreciseMatrix product = numbers::PreciseMatrix::Zero(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index k = 0; k < loads.matrix.rows(); ++k) {
      if (loads.matrix(k, i).is_zero()) continue;
      for (Eigen::Index j = 0; j < size; ++j)
        product(i, j) += loads.matrix(k, i) * solution.displacements(k, j);
    }
  }
  const numbers::PreciseMatrix matrix = (product + product.transpose()) * Precise(0.5);
  numbers::PreciseMatrix response = solution.displacements;
  for (Eigen::Index i = 0; i < response.rows(); ++i) response.row(i) *= Precise(stiffness.scale(i));
  return {matrix, compliance_error(matrix, loads, solution, least), std::move(response)};
}

/// Beyond this many displacements a factor in 104 bits would take too long.
constexpr int most_for_precise_factor = 600;

}  // namespace

EnclosedCompliance enclosed_compliance(const Structure& structure) {
  const FreeDegrees degrees = free_degrees(structure);
  const ScaledStiffness stiffness = assemble(structure, degrees);
  auto result = enclosed<long double>(structure, degrees, stiffness);
  if (!(result.error < infinity) && degrees.size() <= most_for_precise_factor)
    result = enclosed<Precise>(structure, degrees, stiffness);
  return result;
}

numbers::PreciseMatrix stiffness_of(const numbers::PreciseMatrix& compliance) {
  // Scaled to a unit diagonal, which is exact: by powers of two.
  const Eigen::Index size = compliance.rows();
  Eigen::VectorXd scale(size);
  for (Eigen::Index i = 0; i < size; ++i)
    scale(i) = std::exp2(-std::round(std::log2(numbers::rounded(compliance(i, i))) / 2));
  numbers::PreciseMatrix scaled = compliance;
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j) scaled(i, j) *= scale(i) * scale(j);
  const Eigen::LLT<numbers::PreciseMatrix> factor(scaled);
  if (factor.info() != Eigen::Success)
    return numbers::PreciseMatrix::Constant(size, size, dd_real::_nan);
  numbers::PreciseMatrix inverse = factor.solve(numbers::PreciseMatrix::Identity(size, size));
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j) inverse(i, j) *= scale(i) * scale(j);
  return (inverse + inverse.transpose()) * Precise(0.5);
}

PreciseMatrix precise_compliance(const Structure& structure) {
  const auto enclosed = enclosed_compliance(structure);
  const auto& f = enclosed.matrix;
  PreciseMatrix result = f.cast<long double>();
  const Eigen::Index d = structure.dimension;
  for (Eigen::Index i = 0; i < f.rows(); ++i) {
    for (Eigen::Index j = 0; j < f.cols(); ++j) {
      // What one candidate does to another, in all directions.
      const long double together =
          result.block(d * (i / d), d * (j / d), d, d).cwiseAbs().maxCoeff();
      const long double unknown =
          enclosed.error * std::sqrt(result(i, i)) * std::sqrt(result(j, j));
      if (std::abs(result(i, j)) <= std::max(unknown, noise_of_decimals * together))
        result(i, j) = 0;
    }
  }
  return result;
}

}  // namespace kusabi::problems
