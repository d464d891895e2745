// Rigid-body modes as the null space of support and spring conditions, by elimination.
#include "problems/structure/bodies/rigid_motions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "problems/structure/bodies/connected_bodies.hpp"
#include "problems/structure/model/superelement.hpp"

namespace kusabi::problems {
namespace {

using numbers::Precise;
using numbers::PreciseMatrix;
using numbers::PreciseVector;

/// Bound of the rounding errors of an elimination with at most six steps.
constexpr double elimination_roundings = 256;

/// Components of a mode below this are left out of its description.
constexpr double visible_part = 1e-6;

/// d x q: the displacement of a place is this times (velocity of the centre, size times angular
/// velocity).
PreciseMatrix lever(const Eigen::VectorXd& centre, double size, const Eigen::VectorXd& place) {
  const Eigen::Index d = centre.size();
  const PreciseVector arm = (place.cast<Precise>() - centre.cast<Precise>()) * Precise(1 / size);
  PreciseMatrix result = PreciseMatrix::Zero(d, d == 2 ? 3 : 6);
  for (Eigen::Index axis = 0; axis < d; ++axis) result(axis, axis) = 1.0;
  if (d == 2) {
    result(0, 2) = -arm(1);
    result(1, 2) = arm(0);
    return result;
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) {  // e_axis x arm
    const Eigen::Index next = (axis + 1) % 3;
    const Eigen::Index last = (axis + 2) % 3;
    result(next, 3 + axis) = -arm(last);
    result(last, 3 + axis) = arm(next);
  }
  return result;
}

struct Place {
  Eigen::Index row;
  Eigen::Index column;
};

/// The largest entry, starting from a row and a column.
Place largest(const PreciseMatrix& matrix, Eigen::Index row, Eigen::Index column) {
  Place place{row, column};
  const Eigen::MatrixXd sizes = matrix.cast<double>().cwiseAbs();
  for (Eigen::Index j = column; j < matrix.cols(); ++j) {
    for (Eigen::Index i = row; i < matrix.rows(); ++i) {
      if (sizes(i, j) > sizes(place.row, place.column)) place = {i, j};
    }
  }
  return place;
}

/// The first entry, row by row, that is at least half of the largest: x before y before z.
Place first_large(const PreciseMatrix& matrix) {
  const Eigen::MatrixXd sizes = matrix.cast<double>().cwiseAbs();
  const double minimum = sizes.size() == 0 ? 0 : sizes.maxCoeff() / 2;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      if (sizes(i, j) >= minimum) return {i, j};
    }
  }
  return {0, 0};
}

/// True if the elimination continues with a pivot.
/// @return nothing if numerically undecided
std::optional<bool> continues(double pivot) {
  if (pivot <= largest_zero_pivot) return false;
  if (pivot >= smallest_nonzero_pivot) return true;
  return {};
}

/// The null space of a matrix with q columns, and its smallest pivot; no columns and a pivot of
/// zero if numerically undecided.
struct NullSpace {
  PreciseMatrix columns;
  double min_pivot = 1;
};

NullSpace null_space(PreciseMatrix matrix) {
  const Eigen::Index q = matrix.cols();
  std::vector<Eigen::Index> order(static_cast<std::size_t>(q));
  for (Eigen::Index k = 0; k < q; ++k) order[static_cast<std::size_t>(k)] = k;
  NullSpace result;
  Eigen::Index rank = 0;
  for (; rank < std::min(q, matrix.rows()); ++rank) {
    const auto [row, column] = largest(matrix, rank, rank);
    const double pivot = std::abs(numbers::rounded(matrix(row, column)));
    const auto more = continues(pivot);
    if (!more) return {PreciseMatrix(q, 0), 0};
    if (!*more) break;
    result.min_pivot = std::min(result.min_pivot, pivot);
    matrix.row(row).swap(matrix.row(rank));
    matrix.col(column).swap(matrix.col(rank));
    std::swap(order[static_cast<std::size_t>(column)], order[static_cast<std::size_t>(rank)]);
    const PreciseVector own = matrix.row(rank).transpose() / matrix(rank, rank);
    matrix.row(rank) = own.transpose();
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      if (i == rank || matrix(i, rank).is_zero()) continue;
      const Precise factor = matrix(i, rank);
      for (Eigen::Index j = rank; j < q; ++j) matrix(i, j) -= factor * own(j);
    }
  }
  result.columns = PreciseMatrix::Zero(q, q - rank);
  for (Eigen::Index free = rank; free < q; ++free) {
    result.columns(order[static_cast<std::size_t>(free)], free - rank) = 1.0;
    for (Eigen::Index i = 0; i < rank; ++i)
      result.columns(order[static_cast<std::size_t>(i)], free - rank) = -matrix(i, free);
  }
  return result;
}

/// Combines columns such that the given rows are in echelon form.
/// @return the number of columns with entries in these rows, which come last, and the least pivot;
///         nothing if numerically undecided
std::optional<std::pair<Eigen::Index, double>> echelon(PreciseMatrix& columns,
                                                       Eigen::Index first_row, Eigen::Index rows) {
  Eigen::Index left = columns.cols();  // columns [left, end) are done
  double minimum = 1;
  while (left > 0) {
    const PreciseMatrix part = columns.block(first_row, 0, rows, left);
    const auto [row, column] = first_large(part);
    const double pivot = std::abs(numbers::rounded(part(row, column)));
    const auto more = continues(pivot);
    if (!more) return {};
    if (!*more) break;
    minimum = std::min(minimum, pivot);
    --left;
    columns.col(column).swap(columns.col(left));
    const PreciseVector own = columns.col(left) / columns(first_row + row, left);
    columns.col(left) = own;
    for (Eigen::Index j = 0; j < columns.cols(); ++j) {
      if (j == left) continue;
      const Precise factor = columns(first_row + row, j);
      if (!factor.is_zero()) columns.col(j) -= factor * own;
    }
  }
  // The eliminated entries are zero.
  columns.block(first_row, 0, rows, left).setConstant(Precise(0.0));
  const PreciseMatrix done = columns.rightCols(columns.cols() - left);
  columns.rightCols(done.cols()) = done.rowwise().reverse();  // the first pivot first
  return std::pair(done.cols(), minimum);
}

/// Nodes of a connected component and its supports.
class SupportedBody {
 public:
  SupportedBody(const Structure& structure, const std::set<int>& nodes);

  [[nodiscard]] UnconstrainedBody body() &&;

 private:
  void set_conditions(const std::set<int>& nodes);
  void require_ties_in_place(const PreciseMatrix& motions) const;
  [[nodiscard]] PreciseMatrix support_rows() const;
  [[noreturn]] void refuse() const;

  const Structure& structure_;
  std::vector<std::pair<int, int>> supported_;  // node and axis
  // Conditions of inclined supports, of multi-point constraints with the ground and within the
  // component: rows of q entries.
  std::vector<PreciseMatrix> conditions_;
  std::vector<std::pair<int, PreciseMatrix>> ties_;  // number of the constraint
  UnconstrainedBody body_;
};

SupportedBody::SupportedBody(const Structure& structure, const std::set<int>& nodes)
    : structure_(structure) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(structure.dimension);
  for (const int node : nodes) {
    sum += structure.coordinates.col(node);
    if (!is_ground(structure, node)) body_.nodes.push_back(node);
    for (int axis = 0; axis < structure.dimension; ++axis) {
      if (structure.fixed[static_cast<std::size_t>(node)][static_cast<std::size_t>(axis)])
        supported_.emplace_back(node, axis);
    }
  }
  for (const Spring& spring : structure.springs) {
    if (nodes.contains(spring.node)) supported_.emplace_back(spring.node, spring.axis);
  }
  body_.centre = sum / static_cast<double>(nodes.size());
  double farthest = 0;
  for (const int node : nodes) {
    farthest =
        std::max(farthest, (structure.coordinates.col(node) - body_.centre).cwiseAbs().maxCoeff());
  }
  if (farthest > 0) body_.size = std::exp2(std::ceil(std::log2(farthest)));
  set_conditions(nodes);
}

// Conditions of inclined supports and multi-point constraints on rigid-body modes. A constraint
// within the component imposes none if its node is at the place of its masters.
void SupportedBody::set_conditions(const std::set<int>& nodes) {
  const auto lever_at = [&](int node) {
    return lever(body_.centre, body_.size, structure_.coordinates.col(node));
  };
  for (const auto& [node, direction] : structure_.inclined) {
    if (!nodes.contains(node)) continue;
    const PreciseVector along = direction.cast<Precise>();
    conditions_.emplace_back(along.transpose() / along.norm() * lever_at(node));
  }
  for (int i = 0; i < std::ssize(structure_.ties); ++i) {
    const auto& [tied, to] = structure_.ties[static_cast<std::size_t>(i)];
    if (!nodes.contains(tied)) continue;
    PreciseMatrix rows = lever_at(tied);
    bool within = false;
    for (const auto& [node, weight] : to) {
      if (is_ground(structure_, node)) continue;
      rows -= Precise(weight) * lever_at(node);
      within = true;
    }
    if (within) {
      ties_.emplace_back(i, std::move(rows));
    } else {
      conditions_.push_back(std::move(rows));
    }
  }
}

// A node of a multi-point constraint must move as the place of its masters. If it is at a distance
// from that place, by a gap or by rounding of the weights, a rotation causes strain although the
// body is almost unconstrained; such a structure is refused.
void SupportedBody::require_ties_in_place(const PreciseMatrix& motions) const {
  for (const auto& [tie, rows] : ties_) {
    const PreciseMatrix apart = rows * motions;
    if (apart.cast<double>().cwiseAbs().maxCoeff() <= largest_zero_pivot) continue;
    const int node = structure_.ties[static_cast<std::size_t>(tie)].node;
    throw structure_error(
        structure_, position_of(structure_.sources.ties, tie),
        fmt::format(
            "node {} is tied to a place that differs from its own, in an unconstrained body; "
            "expected coincident nodes, weights that give the place exactly, or supports of the "
            "body",
            quoted_name(structure_, node)));
  }
}

PreciseMatrix SupportedBody::support_rows() const {
  auto count = static_cast<Eigen::Index>(supported_.size());
  for (const auto& condition : conditions_) count += condition.rows();
  PreciseMatrix rows(count, structure_.dimension == 2 ? 3 : 6);
  Eigen::Index row = 0;
  for (const auto& [node, axis] : supported_) {
    rows.row(row++) = lever(body_.centre, body_.size, structure_.coordinates.col(node)).row(axis);
  }
  for (const auto& condition : conditions_) {
    rows.middleRows(row, condition.rows()) = condition;
    row += condition.rows();
  }
  return rows;
}

void SupportedBody::refuse() const {
  const int node = supported_.empty() ? body_.nodes.front() : supported_.front().first;
  throw structure_error(
      structure_, position_of(structure_.sources.nodes, node),
      fmt::format("it is numerically undecided whether the supports of the body of node {} prevent "
                  "all its rigid-body modes; expected supports that leave a mode free exactly, or "
                  "clearly prevent it",
                  quoted_name(structure_, node)));
}

// A single bar may rotate about its axis without displacement of a node; this is not counted as a
// mode.
UnconstrainedBody SupportedBody::body() && {
  auto [columns, pivot] = null_space(support_rows());
  if (pivot == 0) refuse();
  const Eigen::Index d = structure_.dimension;
  const Eigen::Index q = columns.rows();
  if (columns.cols() > 0) {
    require_ties_in_place(columns);
    PreciseMatrix seen(d * static_cast<Eigen::Index>(body_.nodes.size()), columns.cols());
    for (std::size_t k = 0; k < body_.nodes.size(); ++k) {
      seen.middleRows(d * static_cast<Eigen::Index>(k), d) =
          lever(body_.centre, body_.size, structure_.coordinates.col(body_.nodes[k])) * columns;
    }
    const auto still = null_space(std::move(seen));
    if (still.min_pivot == 0) refuse();
    if (still.columns.cols() > 0) {
      // The modes orthogonal to those without displacements.
      const auto across = null_space(PreciseMatrix(still.columns.transpose()));
      columns = columns * across.columns;
    }
  }
  const auto turning = echelon(columns, d, q - d);
  if (!turning) refuse();
  PreciseMatrix shifts = columns.leftCols(columns.cols() - turning->first);
  const auto shifting = echelon(shifts, 0, d);
  if (!shifting) refuse();
  columns.leftCols(shifts.cols()) = shifts;
  body_.motions = columns;
  body_.error = elimination_roundings * numbers::unit_roundoff<Precise> /
                (pivot * turning->second * shifting->second);
  return std::move(body_);
}

/// "x", or "(0.6, 0.8)" for a direction that is not an axis.
std::string direction_name(const Eigen::VectorXd& direction) {
  Eigen::Index axis = 0;
  const double size = direction.cwiseAbs().maxCoeff(&axis);
  if (direction.size() == 1) return "";
  const auto parts = (direction.cwiseAbs().array() > visible_part * size).count();
  if (parts == 1) return std::string(axis_name(static_cast<int>(axis)));
  const Eigen::VectorXd unit = direction / direction.norm();
  std::string text;
  for (const double part : unit)
    text +=
        fmt::format("{}{:.4g}", text.empty() ? "" : ", ", std::abs(part) > visible_part ? part : 0);
  return "(" + text + ")";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) {
    text += k == 0 ? "" : k + 1 == words.size() ? " and " : ", ";
    text += words[k];
  }
  return text;
}

}  // namespace

Eigen::Index UnconstrainedBody::translations() const {
  const Eigen::MatrixXd turning = motions.bottomRows(motions.rows() - centre.size()).cast<double>();
  Eigen::Index count = 0;
  while (count < motions.cols() && turning.col(count).isZero(0.0)) ++count;
  return count;
}

PreciseMatrix displacements(const UnconstrainedBody& body, const Eigen::VectorXd& place) {
  return lever(body.centre, body.size, place) * body.motions;
}

std::vector<UnconstrainedBody> unconstrained_bodies(const Structure& structure) {
  std::vector<UnconstrainedBody> bodies;
  std::set<int> of_superelements;
  for (const Superelement& each : structure.superelements) {
    const auto nodes = nodes_of(each);
    of_superelements.insert(nodes.begin(), nodes.end());
  }
  for (const auto& nodes : connected_bodies(structure)) {
    // Stiffness matrices of other programs have rigid-body modes only up to rounding: the bodies
    // are taken as constrained, and superelement_check examines K.
    if (std::ranges::any_of(nodes, [&](int node) { return of_superelements.contains(node); }))
      continue;
    auto body = SupportedBody(structure, nodes).body();
    if (body.count() > 0) bodies.push_back(std::move(body));
  }
  return bodies;
}

std::string described(const UnconstrainedBody& body) {
  const Eigen::MatrixXd motions = body.motions.cast<double>();
  const Eigen::Index d = body.centre.size();
  const Eigen::Index shifts = body.translations();
  std::vector<std::string> along;
  std::vector<std::string> about;
  for (Eigen::Index k = 0; k < shifts; ++k) along.push_back(direction_name(motions.col(k).head(d)));
  for (Eigen::Index k = shifts; k < motions.cols(); ++k)
    about.push_back(direction_name(motions.col(k).tail(motions.rows() - d)));
  std::string text = "can";
  if (!along.empty()) text += " move along " + joined(along);
  if (about.empty()) return text;
  if (!along.empty()) text += " and";
  text += " turn";
  if (d == 3) text += " about " + joined(about);
  return text;
}

}  // namespace kusabi::problems
