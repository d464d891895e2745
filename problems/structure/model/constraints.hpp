// Dependent displacements: u = H q, where q are the free ones and H is sparse.
//
//   a multi-point constraint     u_a = sum_k w_k u_bk
//   a candidate on another body  u_a = u_rel + sum_k w_k u_bk, with u_rel, its displacement
//                                relative to that body, replacing u_a among the free ones;
//                                u_a is kept if the node has several contact normals
//                                (problems/structure/model/several_normals.hpp)
//   an inclined support          u_i = -sum_j (d_j / d_i) u_j, i the axis of the largest |d_i|
//
// Strains are functions of q: K = H' K^0 H. A reaction on u_rel acts on a and, with weights and
// opposite sign, on the b_k (docs/theory/wedged.md, "Two bodies").
#pragma once

#include <set>
#include <utility>

#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"

namespace kusabi::problems {

/// The displacements, as (node, axis), without a free displacement of their own: those of nodes
/// with multi-point constraints, and one of each node with an inclined support.
std::set<std::pair<int, int>> dependent_displacements(const Structure& structure);

/// Sets the master degrees of freedom of numbered displacements.
/// @param degrees with their numbers and nodes of several normals
void set_master_degrees(const Structure& structure, FreeDegrees& degrees);

/// The axis of the largest component, the first of equal ones.
int largest_component_axis(const Eigen::VectorXd& direction);

/// True if any displacement is dependent; limit analysis does not support such structures.
bool has_constraints(const Structure& structure);

}  // namespace kusabi::problems
