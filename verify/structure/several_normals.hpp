// Nodes with several contact normals: the displacement u_a of such a node is a function of q_i =
// n_i.(u_a - p_i) along its normals n_i, where p_i is the displacement of the place opposite to
// candidate i. The displacement of a candidate along a tangent t is an additional degree of
// freedom, connected by a spring to t.(u_a - p_i). The spring makes K definite and does not change
// any answer (docs/theory/wedged.md, "Corners").
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "verify/structure/freedom.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// By candidate at a node with several normals: the numbers of its displacements n, t1[, t2].
using CandidateNumbers = std::map<std::size_t, std::vector<std::size_t>>;

/// Transforms the stiffness: the displacements of each node with several normals become those along
/// its normals and, in space, along the third vector of two normals. Tangential displacements are
/// appended. Entries are not finite where normals are dependent.
CandidateNumbers use_normal_coordinates(const Structure& structure, Freedom& freedom,
                                        SparseEnclosure& stiffness);

}  // namespace kusabi::verify
