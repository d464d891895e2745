// Definiteness by Cholesky factorisations of the scaled stiffness with a shift for rounding errors.
#include "problems/structure/checks/superelement_check.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "problems/structure/assembly/solid_element.hpp"
#include "problems/structure/bodies/mechanism.hpp"
#include "problems/structure/checks/structure_check.hpp"
#include "problems/structure/factor/sparse_factor.hpp"
#include "problems/structure/model/superelement.hpp"

namespace kusabi::problems {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// Rounding errors of the assembly and of the factorisation in doubles, relative to that of one
/// number.
constexpr double own_roundings = 64;

/// A node moves if its displacement exceeds this part of the largest one; smaller ones are elastic.
constexpr double visible = 1e-3;

double rounding_of(const Superelement& superelement) {
  return superelement.rounding + own_roundings * std::numeric_limits<double>::epsilon();
}

[[noreturn]] void fail(const Structure& structure, std::size_t index, const std::string& message) {
  throw structure_error(
      structure, position_of(structure.sources.superelements, static_cast<int>(index)), message);
}

void check_rows(const Structure& structure, std::size_t index) {
  const Superelement& own = structure.superelements[index];
  std::set<std::pair<int, int>> seen;
  for (const auto& [node, axis] : own.rows) {
    if (node < 0) continue;
    if (node >= std::ssize(structure.node_names) || axis < 0 || axis >= structure.dimension) {
      fail(structure, index, "a row of a stiffness names a node or an axis that does not exist");
    }
    if (!seen.emplace(node, axis).second) {
      fail(structure, index,
           fmt::format("the stiffness has two rows of {} along {}; expected one",
                       quoted_name(structure, node), axis_name(axis)));
    }
  }
  const auto size = static_cast<Eigen::Index>(own.rows.size());
  if (size == 0 || own.stiffness.rows() != size || own.stiffness.cols() != size) {
    fail(structure, index,
         fmt::format("the stiffness is {} x {}; expected {} x {}, the number of named rows",
                     own.stiffness.rows(), own.stiffness.cols(), size, size));
  }
}

void check_entries(const Structure& structure, std::size_t index) {
  const Matrix& stiffness = structure.superelements[index].stiffness;
  for (int column = 0; column < static_cast<int>(stiffness.outerSize()); ++column) {
    for (Matrix::InnerIterator entry(stiffness, column); entry; ++entry) {
      const auto row = static_cast<int>(entry.row());
      // The condition is false for NaN.
      if (!(std::abs(entry.value()) <= largest_magnitude)) {
        fail(structure, index,
             fmt::format("entry ({}, {}) of the stiffness is {:g}; expected at most {:g} in size",
                         row + 1, column + 1, entry.value(), largest_magnitude));
      }
      if (entry.value() != stiffness.coeff(column, row)) {
        fail(structure, index,
             fmt::format("entry ({}, {}) of the stiffness is {:g}, but ({}, {}) is {:g}; expected "
                         "a symmetric matrix",
                         row + 1, column + 1, entry.value(), column + 1, row + 1,
                         stiffness.coeff(column, row)));
      }
    }
    if (const double own = stiffness.coeff(column, column); !(own >= smallest_magnitude)) {
      fail(structure, index,
           fmt::format("entry ({}, {}) of the stiffness is {:g}; expected more than 0 on the "
                       "diagonal",
                       column + 1, column + 1, own));
    }
  }
}

/// Scales the diagonal to ones, where it is positive.
Eigen::VectorXd unit_scale(const Matrix& matrix) {
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(matrix.rows());
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    if (const double own = matrix.coeff(i, i); own > 0) scale(i) = 1 / std::sqrt(own);
  }
  return scale;
}

/// The largest row sum of absolute values.
double row_sum(const Matrix& symmetric) {
  double largest = 0;
  for (int column = 0; column < static_cast<int>(symmetric.outerSize()); ++column) {
    double sum = 0;
    for (Matrix::InnerIterator entry(symmetric, column); entry; ++entry)
      sum += std::abs(entry.value());
    largest = std::max(largest, sum);
  }
  return largest;
}

Matrix scaled(const Matrix& matrix, const Eigen::VectorXd& scale) {
  return scale.asDiagonal() * matrix * scale.asDiagonal();
}

/// True if the matrix plus `shift` times the unit matrix is positive definite.
bool definite(const Matrix& matrix, double shift) {
  return SparseFactor<double>(matrix, shift).exists();
}

void require_semidefinite(const Structure& structure, std::size_t index) {
  const Superelement& own = structure.superelements[index];
  const Matrix matrix = scaled(own.stiffness, unit_scale(own.stiffness));
  if (definite(matrix, rounding_of(own) * row_sum(matrix))) return;
  fail(structure, index,
       "the stiffness has a negative eigenvalue, beyond the rounding of its numbers; expected the "
       "positive semidefinite matrix of an elastic body");
}

Matrix from(const Triplets& entries, int size) {
  Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

void check_superelements(const Structure& structure) {
  for (std::size_t index = 0; index < structure.superelements.size(); ++index) {
    check_rows(structure, index);
    check_entries(structure, index);
    require_semidefinite(structure, index);
  }
}

void refuse_unconstrained(const Structure& structure, const FreeDegrees& degrees) {
  Triplets entries;
  Triplets uncertain;
  for (const Spring& spring : structure.springs)
    add_square(parts_of<double>(degrees, spring.axis, spring.node), spring.stiffness, entries);
  for (std::size_t index = 0; index < structure.superelements.size(); ++index) {
    const double rounding = rounding_of(structure.superelements[index]);
    for_each_entry<double>(structure, degrees, index, [&](int row, int column, double value) {
      entries.emplace_back(row, column, value);
      uncertain.emplace_back(row, column, rounding * std::abs(value));
    });
  }
  Matrix stiffness = truss_stiffness(structure, degrees, member_stiffnesses(structure));
  stiffness += element_stiffness(structure, degrees);
  stiffness += from(entries, degrees.size());
  const Eigen::VectorXd scale = unit_scale(stiffness);
  stiffness = scaled(stiffness, scale);
  const double rounding =
      row_sum(scaled(from(uncertain, degrees.size()), scale)) +
      own_roundings * std::numeric_limits<double>::epsilon() * row_sum(stiffness);
  if (definite(stiffness, -rounding)) return;
  Matrix identity(degrees.size(), degrees.size());
  identity.setIdentity();
  const Eigen::VectorXd motion = softest_motion(stiffness + 2 * rounding * identity);
  const auto moving = nodes_moved(degrees, motion, visible);
  if (moving.empty()) {
    fail(structure, 0,
         "an internal unknown of a stiffness, such as a rotation, is constrained only by the "
         "rounding "
         "of its numbers; expected a stiffness that constrains all internal unknowns");
  }
  throw structure_error(
      structure, position_of(structure.sources.nodes, moving.front()),
      fmt::format("{} can move: a [[stiffness]] resists it only by the rounding of its numbers; "
                  "expected supports or springs on its body",
                  some_names(structure, moving)));
}

}  // namespace kusabi::problems
