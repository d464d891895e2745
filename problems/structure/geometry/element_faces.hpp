// The faces of the elements: which nodes they have, in an order that tells inside from outside.
//
// Faces are numbered as Abaqus and CalculiX number them (S1, S2, ...). In the plane a face is an
// edge.
#pragma once

#include <vector>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// The nodes of each face, by their places in the element: corners, then the node in the middle of
/// each side, if the shape has them: the first between the first two corners, and so on. Seen
/// from outside the corners of a face go round anticlockwise; along an edge the body is on the
/// left. (Of an element whose nodes go round the usual way; of its mirror image it is inside out.)
const std::vector<std::vector<int>>& element_faces(ElementShape shape);

}  // namespace kusabi::problems
