// A structure as a VTK grid: bars, elements and outlines; at the nodes supports, candidates and
// loads.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pictures/contact_state.hpp"
#include "pictures/vtu/unstructured_grid.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::pictures {

/// Points are the nodes. Cells are the members, then the elements, then the outlines of
/// superelements, and last a vertex for each node without any of these. Point data: `fixed` (a flag
/// per axis), `node_tag` (the number of a node in its mesh file, -1 for others), `candidate` (a
/// flag) and, if present, `normal` (of the obstacle, unit vector, zero elsewhere),
/// `inclined_support` (its direction, unit vector), `spring` (stiffness per axis) and `tied` (a
/// flag).
UnstructuredGrid structure_grid(const problems::Structure& structure);

/// As structure_grid, with input data: `friction`, `dead_load`, `reference_load` and
/// `uncertain_load` (range of each component for alpha = 1); cell data `axial_stiffness`,
/// `yield_tension`, `yield_compression`, `modulus`. Data that the structure lacks are omitted.
UnstructuredGrid unsolved_grid(const problems::Structure& structure);

/// Vectors of the nodes as point data, with a third component of zero in the plane.
/// @param vectors d x nodes
Field node_vectors(std::string name, const Eigen::MatrixXd& vectors);

/// States of the candidates as point data, `state`. @param states one per candidate
Field contact_states(const problems::Structure& structure, std::span<const ContactState> states);

/// One number per candidate as point data, the largest of a node's; zero at other nodes.
Field candidate_numbers(const problems::Structure& structure, std::string name,
                        std::span<const double> numbers);

/// A number of the whole grid.
Field whole_number(std::string name, double number, std::string unit = {});

/// One number per member as cell data of `structure_grid`; NaN at other cells.
Field member_numbers(const UnstructuredGrid& grid, std::string name,
                     std::span<const double> numbers);

/// Numbers of the elements as cell data of `structure_grid`; NaN at other cells, including
/// outlines. @param numbers components x elements
Field element_numbers(const UnstructuredGrid& grid, const problems::Structure& structure,
                      std::string name, const Eigen::MatrixXd& numbers);

}  // namespace kusabi::pictures
