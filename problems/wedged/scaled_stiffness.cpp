// Assembly of bars, springs, elements and superelements, each with a bound of its rounding errors.
#include "problems/wedged/scaled_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "problems/structure/assembly/solid_element.hpp"
#include "problems/structure/model/elongation.hpp"
#include "problems/structure/model/superelement.hpp"

namespace kusabi::problems {
namespace {

using numbers::Precise;
using SparseMatrix = Eigen::SparseMatrix<Precise>;

/// Factor for the rounding errors of sums of a few thousand nonnegative doubles.
constexpr double bound_safety = 1.001;

/// Bound of the rounding errors of the product of a bar's stiffness and two entries of its vector.
constexpr double member_roundings = 32;

/// Error bound of entry (i, j) of the stiffness of a bar or an element, divided by size i times
/// size j.
struct Part {
  std::vector<int> numbers;  ///< of the free displacements
  std::vector<double> sizes;
  double error;
};

/// The nodes and the nodes of their master degrees of freedom.
std::vector<int> with_master_nodes(const FreeDegrees& degrees, std::vector<int> nodes) {
  if (degrees.master_degrees.empty()) return nodes;
  for (std::size_t i = 0, own = nodes.size(); i < own; ++i) {
    for (int axis = 0; axis < static_cast<int>(degrees.number.rows()); ++axis) {
      for (const auto& part : parts_of<double>(degrees, axis, nodes[i]))
        nodes.push_back(degrees.free[static_cast<std::size_t>(part.number)].node);
    }
  }
  return nodes;
}

/// Index of the node of a displacement, or of an internal unknown of a superelement, which follow
/// the nodes.
int place_of(const FreeDegrees& degrees, int number) {
  return number < degrees.of_nodes()
             ? degrees.free[static_cast<std::size_t>(number)].node
             : static_cast<int>(degrees.number.cols()) + number - degrees.of_nodes();
}

/// The free displacements at such an index.
std::vector<int> numbers_at(const FreeDegrees& degrees, int place) {
  const auto nodes = static_cast<int>(degrees.number.cols());
  if (place >= nodes) return {degrees.of_nodes() + place - nodes};
  std::vector<int> numbers;
  for (const int number : degrees.number.col(place)) {
    if (number >= 0) numbers.push_back(number);
  }
  return numbers;
}

/// For each index those that a bar, element, spring or superelement connects with it, in any order.
std::vector<std::vector<int>> neighbours(const Structure& structure, const FreeDegrees& degrees) {
  std::vector<std::vector<int>> places(structure.node_names.size() +
                                       static_cast<std::size_t>(degrees.internal_count));
  const auto join = [&](const std::vector<int>& touched) {
    const auto together = with_master_nodes(degrees, touched);
    for (const int node : together) {
      auto& own = places[static_cast<std::size_t>(node)];
      own.insert(own.end(), together.begin(), together.end());
    }
  };
  for (const Member& member : structure.members) join({member.first, member.second});
  for (const Element& element : structure.elements) join(element.nodes);
  for (const Spring& spring : structure.springs) join({spring.node});
  for (std::size_t index = 0; index < structure.superelements.size(); ++index) {
    for_each_entry<double>(structure, degrees, index, [&](int row, int column, double) {
      const int other = place_of(degrees, row);
      auto& own = places[static_cast<std::size_t>(place_of(degrees, column))];
      if (own.empty() || own.back() != other)
        own.push_back(other);  // rows of a node are consecutive
    });
  }
  return places;
}

/// The matrix of zeros with all its entries, rows of each column in increasing order. Additions to
/// it need no further memory.
SparseMatrix empty_matrix(const Structure& structure, const FreeDegrees& degrees) {
  auto places = neighbours(structure, degrees);
  SparseMatrix matrix(degrees.size(), degrees.size());
  int last = -1;
  for (int column = 0; column < degrees.size(); ++column) {
    const int place = place_of(degrees, column);
    auto& own = places[static_cast<std::size_t>(place)];
    if (place != last) {
      own.push_back(place);
      std::ranges::sort(own);
      own.erase(std::unique(own.begin(), own.end()), own.end());
      last = place;
    }
    matrix.startVec(column);
    for (const int other : own) {
      for (const int row : numbers_at(degrees, other)) matrix.insertBack(row, column) = 0.0;
    }
  }
  matrix.finalize();
  return matrix;
}

/// Maximum number of bars, elements, springs and superelements at one node, which bounds the number
/// of terms in an entry of K. A node with dependents also counts theirs, once for each pair of
/// dependents, and their weights.
int max_terms(const Structure& structure, const FreeDegrees& degrees) {
  std::vector<int> terms(structure.node_names.size(), 0);
  for (const Member& member : structure.members) {
    ++terms[static_cast<std::size_t>(member.first)];
    ++terms[static_cast<std::size_t>(member.second)];
  }
  for (const Element& element : structure.elements) {
    for (const int node : element.nodes) ++terms[static_cast<std::size_t>(node)];
  }
  for (const Spring& spring : structure.springs) ++terms[static_cast<std::size_t>(spring.node)];
  for (const Superelement& each : structure.superelements) {
    for (const int node : nodes_of(each)) ++terms[static_cast<std::size_t>(node)];
  }
  if (degrees.master_degrees.empty()) return *std::ranges::max_element(terms);
  constexpr int weight_roundings = 8;
  auto all = terms;
  std::vector<int> dependents(terms.size(), 1);
  for (std::size_t node = 0; node < terms.size(); ++node) {
    for (const int master : with_master_nodes(degrees, {static_cast<int>(node)})) {
      all[static_cast<std::size_t>(master)] += terms[node];
      ++dependents[static_cast<std::size_t>(master)];
    }
  }
  return *std::ranges::max_element(all) * *std::ranges::max_element(dependents) + weight_roundings;
}

/// Adds a bar. Its entries have member_roundings rounding errors, and one for each term of a sum.
Part add_member(const Structure& structure, const FreeDegrees& degrees, const Member& member,
                int terms, SparseMatrix& matrix) {
  const auto vector = elongation_vector<Precise>(structure, degrees, member);
  const auto weight = bar_stiffness<Precise>(structure, member);
  Part part{
      {},
      {},
      (member_roundings + terms) * numbers::unit_roundoff<Precise> * numbers::rounded(weight)};
  for (const auto& row : vector) {
    part.numbers.push_back(row.number);
    part.sizes.push_back(std::abs(numbers::rounded(row.value)));
    for (const auto& column : vector) {
      // The product of the two entries is computed first, so that (i, j) and (j, i) have the same
      // rounding.
      matrix.coeffRef(row.number, column.number) += weight * (row.value * column.value);
    }
  }
  return part;
}

/// Adds a spring, unless its displacement is fixed.
Part add_spring(const FreeDegrees& degrees, const Spring& spring, int terms, SparseMatrix& matrix) {
  const auto parts = parts_of<Precise>(degrees, spring.axis, spring.node);
  Part part{{}, {}, terms * numbers::unit_roundoff<Precise> * spring.stiffness};
  for (const auto& row : parts) {
    part.numbers.push_back(row.number);
    part.sizes.push_back(std::abs(numbers::rounded(row.value)));
    for (const auto& column : parts)
      matrix.coeffRef(row.number, column.number) += spring.stiffness * (row.value * column.value);
  }
  return part;
}

/// Adds an element. Its error bound is that of a running error analysis, divided by the square
/// roots of the diagonal entries.
Part add_element(const Structure& structure, const FreeDegrees& degrees, const Element& element,
                 int terms, SparseMatrix& matrix) {
  const auto stiffness = element_matrix<Precise>(structure, element);
  const auto bounds = element_matrix<numbers::RunningError>(structure, element);
  const auto places = element_parts<Precise>(degrees, element);
  const Eigen::VectorXd sizes = stiffness.diagonal().cast<double>().cwiseAbs().cwiseSqrt();
  Part part{{}, {}, 0};
  for (const auto& column : places) {
    part.numbers.push_back(column.number);
    part.sizes.push_back(sizes(column.place) * std::abs(numbers::rounded(column.weight)));
    for (const auto& row : places) {
      matrix.coeffRef(row.number, column.number) +=
          degrees.master_degrees.empty()
              ? stiffness(row.place, column.place)
              : stiffness(row.place, column.place) * (row.weight * column.weight);
      const auto& bound = bounds(row.place, column.place);
      part.error = std::max(part.error, (bound.error + terms * bound.maximum()) /
                                            (sizes(row.place) * sizes(column.place)));
    }
  }
  part.error *= numbers::unit_roundoff<Precise>;
  return part;
}

/// Adds the superelements, whose entries are exact.
void add_superelements(const Structure& structure, const FreeDegrees& degrees,
                       SparseMatrix& matrix) {
  for (std::size_t index = 0; index < structure.superelements.size(); ++index) {
    for_each_entry<Precise>(
        structure, degrees, index,
        [&](int row, int column, const Precise& value) { matrix.coeffRef(row, column) += value; });
  }
}

/// Rounding errors of sums with entries of superelements, by rows of the scaled matrix.
void add_superelement_errors(const Structure& structure, const FreeDegrees& degrees, int terms,
                             const Eigen::VectorXd& scale, Eigen::VectorXd& errors) {
  for (std::size_t index = 0; index < structure.superelements.size(); ++index) {
    for_each_entry<double>(structure, degrees, index, [&](int row, int column, double value) {
      errors(row) +=
          terms * numbers::unit_roundoff<Precise> * std::abs(value) * scale(row) * scale(column);
    });
  }
}

/// Scales to a diagonal of about one.
void scale(ScaledStiffness& stiffness) {
  auto& [matrix, scale, error, row_sum] = stiffness;
  scale.setOnes(matrix.rows());
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const double diagonal = numbers::rounded(matrix.coeff(i, i));
    if (diagonal > 0) scale(i) = std::exp2(-std::round(std::log2(diagonal) / 2));
  }
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(matrix.rows());
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
      entry.valueRef() *= scale(entry.row()) * scale(column);
      sums(column) += std::abs(numbers::rounded(entry.value()));
    }
  }
  row_sum = matrix.rows() == 0 ? 0 : bound_safety * sums.maxCoeff();
}

}  // namespace

ScaledStiffness scaled_stiffness(const Structure& structure, const FreeDegrees& degrees) {
  ScaledStiffness result;
  result.matrix = empty_matrix(structure, degrees);
  const int terms = max_terms(structure, degrees);
  std::vector<Part> parts;
  for (const Member& member : structure.members)
    parts.push_back(add_member(structure, degrees, member, terms, result.matrix));
  for (const Spring& spring : structure.springs)
    parts.push_back(add_spring(degrees, spring, terms, result.matrix));
  for (const Element& element : structure.elements)
    parts.push_back(add_element(structure, degrees, element, terms, result.matrix));
  add_superelements(structure, degrees, result.matrix);
  scale(result);
  Eigen::VectorXd errors = Eigen::VectorXd::Zero(degrees.size());
  for (const Part& part : parts) {
    double sum = 0;
    for (std::size_t i = 0; i < part.numbers.size(); ++i)
      sum += result.scale(part.numbers[i]) * part.sizes[i];
    for (std::size_t i = 0; i < part.numbers.size(); ++i)
      errors(part.numbers[i]) += part.error * result.scale(part.numbers[i]) * part.sizes[i] * sum;
  }
  add_superelement_errors(structure, degrees, terms, result.scale, errors);
  result.error = degrees.size() == 0 ? 0 : bound_safety * errors.maxCoeff();
  return result;
}

}  // namespace kusabi::problems
