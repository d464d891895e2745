// A structure as a grid of VTK: its bars, elements and outlines, and at its nodes what holds them,
// where they may touch and what pulls at them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pictures/contact_state.hpp"
#include "pictures/vtu/unstructured_grid.hpp"
#include "problems/structure/structure.hpp"

namespace kusabi::pictures {

/// The points are the nodes; cells are the members, then the elements, then the outlines of bodies
/// whose stiffness another program has computed, and at last a vertex for each node that has none
/// of these. Point data: `fixed` (a flag an axis), `candidate` (a flag) and, if there are any,
/// `normal` (of the obstacle, unit, zero elsewhere), `inclined_support` (its direction, unit),
/// `spring` (stiffness an axis) and `tied` (a flag).
UnstructuredGrid structure_grid(const problems::Structure& structure);

/// The same, before anything is solved: with `friction`, `dead_load`, `reference_load` and
/// `uncertain_load` (how far each component goes for alpha = 1); at the cells `axial_stiffness`,
/// `yield_tension`, `yield_compression`, `modulus`. Those that the structure has nothing of are
/// left out.
UnstructuredGrid unsolved_grid(const problems::Structure& structure);

/// Vectors of the nodes as point data: a third component of zero in the plane.
/// @param vectors d x nodes
Field node_vectors(std::string name, const Eigen::MatrixXd& vectors);

/// States of the candidates as point data, `state`. @param states one a candidate
Field contact_states(const problems::Structure& structure, std::span<const ContactState> states);

/// A number a member as cell data of `structure_grid`; NaN at other cells.
Field member_numbers(const UnstructuredGrid& grid, std::string name,
                     std::span<const double> numbers);

/// Numbers of the elements as cell data of `structure_grid`; NaN at other cells, outlines among
/// them. @param numbers components x elements
Field element_numbers(const UnstructuredGrid& grid, const problems::Structure& structure,
                      std::string name, const Eigen::MatrixXd& numbers);

}  // namespace kusabi::pictures
