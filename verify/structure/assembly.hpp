// The stiffness of a structure over its free displacements, K^0 of equation (2) of the wedged
// paper, every entry enclosed; and the frames of its contact candidates.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "verify/arithmetic/enclosure.hpp"
#include "verify/structure/freedom.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// H' K^0 H over the free displacements. Not all finite if a bar has no length or an element no
/// area.
SparseEnclosure enclosed_stiffness(const Structure& structure, const Freedom& freedom);

/// The direction of a bar, a unit vector; its length.
struct Direction {
  std::vector<Enclosure> cosines;  ///< d
  Enclosure length;
};
Direction direction(const Structure& structure, const Bar& bar);

/// Unit vectors n, t1 and, in space, t2 = n x t1: by columns, of which each has d components.
using Frame = std::vector<std::vector<Enclosure>>;

/// t1 is the wished tangent less its part along n; without a wish n turned clockwise by a quarter
/// in the plane, the projection of an axis in space.
Frame frame(const ContactPoint& point, std::size_t dimension);

/// For each candidate, which piece of the structure it belongs to: the number of another candidate
/// or its own. Displacements belong together if a bar strains by both (which takes a difference of
/// coordinates that is not zero), if they are of one element, of one spring, of one entry of a
/// given stiffness, or of one candidate.
std::vector<std::size_t> pieces(const Structure& structure, const Freedom& freedom);

}  // namespace kusabi::verify
