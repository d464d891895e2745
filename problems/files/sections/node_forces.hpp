// Nodal forces in a separate file: the load direction for curves of the limit load factor
// (docs/problem-files.md).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace kusabi::problems {

/// Reads [[loads]] groups of `nodes` and `force`; forces on the same node are added.
/// @param node_names of the structure
/// @return d x nodes, force
/// @throws InputError at the first fault
Eigen::MatrixXd read_node_forces(std::string_view toml_text, const std::string& file_name,
                                 const std::vector<std::string>& node_names, int dimension);

}  // namespace kusabi::problems
