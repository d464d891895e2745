// Displacements that are made of others: u = H q, where q are the free ones and H is sparse.
//
//   a tie                        u_a = sum_k w_k u_bk
//   a candidate on another body  u_a = u_rel + sum_k w_k u_bk, with u_rel, its displacement
//                                relative to that body, in the place of u_a among the free ones;
//                                not in a corner, where u_a stays
//                                (problems/structure/model/corner.hpp)
//   an inclined support          u_i = -sum_j (d_j / d_i) u_j, i the axis of the largest |d_i|
//
// All that is computed from strains is so computed in the coordinates q: K = H' K^0 H, and a
// reaction on u_rel is one on a and, with weights and reversed, on the b_k
// (docs/theory/wedged.md, "Two bodies").
#pragma once

#include <set>
#include <utility>

#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"

namespace kusabi::problems {

/// The displacements, as (node, axis), that have nothing of their own: those of tied nodes, and one
/// of each node on an inclined support.
std::set<std::pair<int, int>> made_of_others(const Structure& structure);

/// Fills `leaders` of degrees whose numbers are given.
void set_leaders(const Structure& structure, FreeDegrees& degrees);

/// The axis of the largest component, of equals the first.
int steepest_axis(const Eigen::VectorXd& direction);

/// Whether any displacement is made of others: what limit analysis knows nothing of.
bool has_constraints(const Structure& structure);

}  // namespace kusabi::problems
