// Rigid-body modes restricted to contact degrees of freedom, orthogonalised column by column.
#include "problems/wedged/contact_motions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "problems/structure/assembly/contact_frame.hpp"
#include "problems/structure/bodies/null_space.hpp"
#include "problems/structure/model/constraints.hpp"

namespace kusabi::problems {
namespace {

using numbers::Precise;
using numbers::PreciseMatrix;
using numbers::PreciseVector;

/// Bound of the rounding errors of a frame, a displacement and two projections.
constexpr double motion_roundings = 512;

/// A node whose distance from its opposite place is at most this share of the largest coordinate is
/// moved there exactly.
constexpr double rounded_place = 0x1p-48;

/// By node, its body; and the first mode of each body.
struct Numbering {
  std::map<int, std::size_t> body;
  std::vector<Eigen::Index> first;
  Eigen::Index count = 0;

  explicit Numbering(std::span<const UnconstrainedBody> bodies) {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      for (const int node : bodies[b].nodes) body.emplace(node, b);
      first.push_back(count);
      count += bodies[b].count();
    }
  }
};

// Adds the components of a node's modes, times a weight, along the axes of a frame.
void add_motions(const Structure& structure, std::span<const UnconstrainedBody> bodies,
                 const Numbering& numbering, const WeightedNode& share, const PreciseMatrix& frame,
                 Eigen::Index row, PreciseMatrix& restricted) {
  const auto found = numbering.body.find(share.node);
  if (found == numbering.body.end()) return;
  const UnconstrainedBody& body = bodies[found->second];
  restricted.block(row, numbering.first[found->second], frame.cols(), body.count()) +=
      Precise(share.weight) *
      (frame.transpose() * displacements(body, structure.coordinates.col(share.node)));
}

/// Vector from the node of a candidate to its opposite place, if it is due to rounding of
/// coordinates; otherwise, and for a rigid obstacle, zero.
Eigen::VectorXd rounding_of_place(const Structure& structure, const ContactCandidate& candidate) {
  const auto node = structure.coordinates.col(candidate.node);
  PreciseVector away = -node.cast<Precise>();
  double largest = node.cwiseAbs().maxCoeff();
  for (const auto& [other, weight] : candidate.against) {
    const auto place = structure.coordinates.col(other);
    away += Precise(weight) * place.cast<Precise>();
    largest = std::max(largest, place.cwiseAbs().maxCoeff());
  }
  Eigen::VectorXd rounded = away.cast<double>();
  const bool is_rounding = rounded.cwiseAbs().maxCoeff() <= rounded_place * largest;
  if (candidate.against.empty() || !is_rounding) rounded.setZero();
  return rounded;
}

/// Adds the change of the node's modes if it is moved to its exact place.
void add_placing(const Structure& structure, std::span<const UnconstrainedBody> bodies,
                 const Numbering& numbering, const ContactCandidate& candidate,
                 const PreciseMatrix& frame, Eigen::Index row, PreciseMatrix& restricted) {
  const auto found = numbering.body.find(candidate.node);
  const Eigen::VectorXd away = rounding_of_place(structure, candidate);
  if (found == numbering.body.end() || away.isZero(0)) return;
  UnconstrainedBody about_origin = bodies[found->second];
  about_origin.centre.setZero();
  const PreciseMatrix more = displacements(about_origin, away) -
                             displacements(about_origin, Eigen::VectorXd::Zero(away.size()));
  restricted.block(row, numbering.first[found->second], frame.cols(), about_origin.count()) +=
      frame.transpose() * more;
}

// An unconstrained body without contact candidates has no influence on answers and is most likely
// an input error.
void refuse_untouched(const Structure& structure, std::span<const UnconstrainedBody> bodies,
                      const Numbering& numbering) {
  std::vector<bool> touched(bodies.size(), false);
  const auto touch = [&](int node) {
    const auto found = numbering.body.find(node);
    if (found != numbering.body.end()) touched[found->second] = true;
  };
  for (const ContactCandidate& candidate : structure.contact) {
    touch(candidate.node);
    for (const WeightedNode& share : candidate.against) touch(share.node);
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (touched[b]) continue;
    const int node = bodies[b].nodes.front();
    throw structure_error(
        structure, position_of(structure.sources.nodes, node),
        fmt::format("the body of node {} is unconstrained, {}, and has no contact candidate; "
                    "expected supports, or a contact candidate on it",
                    quoted_name(structure, node), described(bodies[b])));
  }
}

[[noreturn]] void refuse_line(const Structure& structure) {
  throw structure_error(
      structure, position_of(structure.sources.contact, 0),
      "the contact candidates of an unconstrained body lie almost on one line, and whether it can "
      "turn "
      "about that line is numerically undecided; expected candidates exactly on a line, or clearly "
      "off it");
}

[[noreturn]] void refuse_gap(const Structure& structure) {
  throw structure_error(
      structure, position_of(structure.sources.contact, 0),
      "unconstrained bodies touch at places that almost coincide, or almost lie on one line, and "
      "whether they can turn together is numerically undecided; expected pairs of nodes that "
      "coincide, or candidates on a rigid obstacle");
}

// The work of each load on each mode of each body, loads x sum of p.
PreciseMatrix work_of(const Structure& structure, std::span<const UnconstrainedBody> bodies,
                      const Eigen::MatrixXd& forces) {
  const Numbering numbering(bodies);
  const Eigen::Index d = structure.dimension;
  PreciseMatrix work = PreciseMatrix::Zero(forces.cols(), numbering.count);
  for (std::size_t b = 0; forces.cols() > 0 && b < bodies.size(); ++b) {
    for (const int node : bodies[b].nodes) {
      const PreciseMatrix own = forces.middleRows(d * node, d).transpose().cast<Precise>();
      if (own.isZero(0)) continue;
      work.middleCols(numbering.first[b], bodies[b].count()) +=
          own * displacements(bodies[b], structure.coordinates.col(node));
    }
  }
  return work;
}

double min_sine(const Structure& structure) {
  double minimum = 1;
  for (const ContactCandidate& candidate : structure.contact) {
    if (candidate.tangent)
      minimum = std::min(minimum, tangent_sine(candidate.normal, *candidate.tangent) / 2);
  }
  return minimum;
}

}  // namespace

PreciseMatrix restricted_modes(const Structure& structure,
                               std::span<const UnconstrainedBody> bodies) {
  const Numbering numbering(bodies);
  const Eigen::Index d = structure.dimension;
  PreciseMatrix restricted =
      PreciseMatrix::Zero(d * static_cast<Eigen::Index>(structure.contact.size()), numbering.count);
  Eigen::Index row = 0;
  for (const ContactCandidate& candidate : structure.contact) {
    const auto frame = precise_contact_frame(candidate);
    add_motions(structure, bodies, numbering, {candidate.node, 1}, frame, row, restricted);
    for (const auto& [node, weight] : candidate.against)
      add_motions(structure, bodies, numbering, {node, -weight}, frame, row, restricted);
    add_placing(structure, bodies, numbering, candidate, frame, row, restricted);
    row += d;
  }
  return restricted;
}

ContactMotions contact_motions(const Structure& structure,
                               std::span<const UnconstrainedBody> bodies,
                               const Eigen::MatrixXd& forces) {
  refuse_untouched(structure, bodies, Numbering(bodies));
  const auto restricted = restricted_modes(structure, bodies);
  const PreciseMatrix work = work_of(structure, bodies, forces);
  ContactMotions result{PreciseMatrix(restricted.rows(), 0), 0};
  // Modes restricted to contact, each with the work of the loads on it; both are combined alike.
  std::vector<std::pair<PreciseVector, PreciseVector>> columns;
  std::vector<PreciseVector> unseen;
  double min_left = 1;
  for (Eigen::Index k = 0; k < restricted.cols(); ++k) {
    PreciseVector column = restricted.col(k);
    PreciseVector own = work.col(k);
    for (int pass = 0; pass < 2; ++pass) {
      for (const auto& [other, others] : columns) {
        const Precise part = other.dot(column) / other.squaredNorm();
        if (part.is_zero()) continue;
        column -= part * other;
        own -= part * others;
      }
    }
    const double size = numbers::rounded(Precise(column.cwiseAbs().maxCoeff()));
    if (size <= largest_zero_pivot) {
      unseen.push_back(own);
      continue;
    }
    if (size < smallest_nonzero_pivot && has_constraints(structure)) refuse_gap(structure);
    if (size < smallest_nonzero_pivot) refuse_line(structure);
    min_left = std::min(min_left, size);
    const Precise unit(std::exp2(-std::ceil(std::log2(size))));
    columns.emplace_back(column * unit, own * unit);
  }
  result.matrix.resize(restricted.rows(), static_cast<Eigen::Index>(columns.size()));
  result.work.resize(work.rows(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) {
    result.matrix.col(static_cast<Eigen::Index>(k)) = columns[k].first;
    result.work.col(static_cast<Eigen::Index>(k)) = columns[k].second;
  }
  result.work_on_other_modes.resize(work.rows(), static_cast<Eigen::Index>(unseen.size()));
  for (std::size_t k = 0; k < unseen.size(); ++k)
    result.work_on_other_modes.col(static_cast<Eigen::Index>(k)) = unseen[k];
  double error = 0;
  for (const UnconstrainedBody& body : bodies) error = std::max(error, body.error);
  error += motion_roundings * numbers::unit_roundoff<Precise> / min_sine(structure);
  result.error = bodies.empty() ? 0 : error / min_left;
  return result;
}

}  // namespace kusabi::problems
