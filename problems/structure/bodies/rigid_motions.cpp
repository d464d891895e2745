// Rigid-body modes as the null space of support and spring conditions, by elimination.
#include "problems/structure/bodies/rigid_motions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "problems/structure/bodies/connected_bodies.hpp"
#include "problems/structure/bodies/null_space.hpp"
#include "problems/structure/model/superelement.hpp"

namespace kusabi::problems {
namespace {

using numbers::Precise;
using numbers::PreciseMatrix;
using numbers::PreciseVector;

/// Bound of the rounding errors of an elimination with at most six steps.
constexpr double elimination_roundings = 256;

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

}  // namespace kusabi::problems
