// Compliances c of both kinds from the diagonal of the stiffness, as in the proofs.
#include "problems/wedged/tangential_springs.hpp"

#include <algorithm>
#include <cstddef>

#include "problems/structure/assembly/contact_frame.hpp"
#include "problems/structure/model/constraints.hpp"

namespace kusabi::problems {
namespace {

using numbers::Precise;

/// Bound of the rounding errors of an entry of a frame, of c and of their products.
constexpr double spring_roundings = 128;

class TangentialSprings {
 public:
  TangentialSprings(const Structure& structure, const FreeDegrees& degrees,
                    const ScaledStiffness& stiffness)
      : structure_(structure), degrees_(degrees), stiffness_(stiffness) {}

  /// Term of a candidate alone at its node, d x d.
  numbers::PreciseMatrix of_rollers(const ContactCandidate& candidate) {
    const Eigen::Index d = structure_.dimension;
    numbers::PreciseMatrix added = numbers::PreciseMatrix::Zero(d, d);
    for (int axis = 0; axis < structure_.dimension; ++axis) {
      if (!structure_
               .fixed[static_cast<std::size_t>(candidate.node)][static_cast<std::size_t>(axis)])
        continue;
      const int nearest = largest_component_axis(candidate.direction.value_or(candidate.normal));
      const Precise soft = 1.0 / along(nearest, candidate.node);
      const numbers::PreciseVector held = precise_contact_frame(candidate).row(axis).transpose();
      added += soft * held * held.transpose();
    }
    return added;
  }

  /// Term of a candidate at a node with several normals: tangents are axes in its frame.
  numbers::PreciseMatrix of_corner(const ContactCandidate& candidate) {
    const Eigen::Index d = structure_.dimension;
    Precise sum = 0.0;
    int count = 0;
    for (int axis = 0; axis < structure_.dimension; ++axis) {
      if (degrees_.number(axis, candidate.node) < 0) continue;
      sum += along(axis, candidate.node);
      ++count;
    }
    numbers::PreciseMatrix added = numbers::PreciseMatrix::Zero(d, d);
    for (Eigen::Index k = 1; k < d; ++k) added(k, k) = Precise(count) / sum;
    return added;
  }

  double error() const { return 2 * error_; }

 private:
  /// The stiffness of a node along an axis with all other displacements fixed.
  Precise along(int axis, int node) {
    const int number = degrees_.number(axis, node);
    const Precise scaled = stiffness_.matrix.coeff(number, number);
    error_ = std::max(error_, stiffness_.error / numbers::rounded(scaled));
    return scaled / (Precise(stiffness_.scale(number)) * stiffness_.scale(number));
  }

  const Structure& structure_;
  const FreeDegrees& degrees_;
  const ScaledStiffness& stiffness_;
  double error_ = spring_roundings * numbers::unit_roundoff<Precise>;
};

}  // namespace

double add_tangential_springs(const Structure& structure, const FreeDegrees& degrees,
                              const ScaledStiffness& stiffness,
                              numbers::PreciseMatrix& compliance) {
  TangentialSprings springs(structure, degrees, stiffness);
  const auto d = static_cast<Eigen::Index>(structure.dimension);
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    const ContactCandidate& candidate = structure.contact[i];
    const auto first = d * static_cast<Eigen::Index>(i);
    compliance.block(first, first, d, d) += degrees.several_normals.contains(candidate.node)
                                                ? springs.of_corner(candidate)
                                                : springs.of_rollers(candidate);
  }
  return springs.error();
}

}  // namespace kusabi::problems
