// Nodal forces in a separate file: the load direction for curves of the limit load factor
// (docs/problem-files.md).
#pragma once

#include <string>
#include <string_view>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Reads [[loads]] groups of `nodes` and `force`; forces on the same node are added.
/// @param structure whose nodes may be called by each of their names
/// @return d x nodes, force
/// @throws InputError at the first fault
Eigen::MatrixXd read_node_forces(std::string_view toml_text, const std::string& file_name,
                                 const Structure& structure);

}  // namespace kusabi::problems
