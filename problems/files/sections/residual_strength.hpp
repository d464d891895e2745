// Residual compression strengths of struts: the key `residual` of [[members]]
// (docs/problem-files.md). They are no part of the structure, since no other analysis uses them.
#pragma once

#include <string>
#include <string_view>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// The compression strength of each member of a truss after buckling; empty if the file has no
/// struts. Members that are no struts keep their strength.
/// @param structure of the same text @throws support::InputError
Eigen::VectorXd residual_strengths(std::string_view toml_text, const std::string& file_name,
                                   const Structure& structure);

}  // namespace kusabi::problems
