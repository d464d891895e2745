// Unconstrained bodies of a structure and their rigid-body modes in rational numbers
// (docs/theory/proofs.md, "Unconstrained bodies").
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "verify/arithmetic/elimination.hpp"
#include "verify/arithmetic/exact.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// Rigid-body modes of all unconstrained bodies, side by side.
/// @pre the structure outlives this object
class UnconstrainedBodies {
 public:
  explicit UnconstrainedBodies(const Structure& structure);

  [[nodiscard]] const std::vector<Rationals>& motions() const { return motions_; }

  /// Displacements of a node along an axis.
  [[nodiscard]] Rationals at(std::size_t node, std::size_t axis) const;

  /// Displacements of a candidate along an axis, relative to the opposite place.
  [[nodiscard]] Rationals at(const ContactPoint& point, std::size_t axis) const;

  /// Grounding springs for modes that displace no candidate, each where the first remaining mode is
  /// largest.
  [[nodiscard]] std::vector<GroundSpring> grounding_springs(Elimination unseen) const;

 private:
  struct Placed {
    Vector centre;
    std::size_t first;  // of its modes among all
  };

  const Structure& structure_;
  std::size_t size_;  // number of parameters of a rigid-body mode
  std::vector<Placed> bodies_;
  std::map<std::size_t, std::size_t> body_of_;  // by node
  std::map<std::size_t, Rationals> placed_;  // exact places of displaced nodes (placed_nodes.hpp)
  std::vector<Rationals> motions_;
};

}  // namespace kusabi::verify
