// Faces of the elements as lists of nodes, oriented outwards.
//
// Faces are numbered as in Abaqus and CalculiX (S1, S2, ...). In the plane a face is an edge.
#pragma once

#include <vector>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// The nodes of each face, as indices of the element's nodes: vertices, then the midpoint of each
/// side of a quadratic shape, first that between the first two vertices, and so on. Seen from
/// outside the vertices of a face are anticlockwise; along an edge the body is on the left. (For an
/// element with the usual orientation; its mirror image has the opposite one.)
const std::vector<std::vector<int>>& element_faces(ElementShape shape);

}  // namespace kusabi::problems
