// Enclosed stiffness of a structure over its free displacements, K^0 of equation (2) of the wedged
// paper, and the frames of its contact candidates.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "verify/arithmetic/enclosure.hpp"
#include "verify/structure/freedom.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// H' K^0 H over the free displacements. Entries are not finite if a bar has length zero or an
/// element area zero.
SparseEnclosure enclosed_stiffness(const Structure& structure, const Freedom& freedom);

/// Unit direction vector and length of a bar.
struct Direction {
  std::vector<Enclosure> cosines;  ///< d
  Enclosure length;
};
Direction direction(const Structure& structure, const Bar& bar);

/// Unit vectors n, t1 and, in space, t2 = n x t1, as columns with d components each.
using Frame = std::vector<std::vector<Enclosure>>;

/// t1 is the given tangent minus its component along n. Without a given tangent it is n turned
/// clockwise by 90 degrees in the plane, the projection of an axis in space.
Frame frame(const ContactPoint& point, std::size_t dimension);

/// For each candidate the connected component of the structure that contains it, as the number of a
/// candidate in that component. Displacements are connected if a bar strains by both (the
/// difference of coordinates is not zero), or if they belong to one element, one spring, one entry
/// of a given stiffness or one candidate.
std::vector<std::size_t> pieces(const Structure& structure, const Freedom& freedom);

/// By candidate: true if a load acts on the connected component that contains it.
std::vector<bool> touched(const Structure& structure, const Freedom& freedom,
                          const std::vector<Force>& load);

}  // namespace kusabi::verify
