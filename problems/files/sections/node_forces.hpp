// Forces at the nodes of a structure, in a file of their own: a load along which the limit load
// factor is followed (docs/problem-files.md).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace kusabi::problems {

/// Reads [[loads]] groups of `nodes` and `force`; what several put on one node adds up.
/// @param node_names of the structure
/// @return d x nodes, force
/// @throws InputError at the first fault
Eigen::MatrixXd read_node_forces(std::string_view toml_text, const std::string& file_name,
                                 const std::vector<std::string>& node_names, int dimension);

}  // namespace kusabi::problems
