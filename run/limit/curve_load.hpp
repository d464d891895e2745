// Load of --curve-load: a file of loads, or the critical part of an earlier result.
#pragma once

#include <string>

#include <Eigen/Core>

#include "problems/limit/limit_problem.hpp"

namespace kusabi::run {

/// g, n^d, force, without the part on supports.
/// @param text a TOML file (problems/files/sections/node_forces.hpp) or a result of `kusabi limit
///        --alpha`
/// @param file its name, for messages
/// @throws support::InputError; also if the load is zero on all free displacements
Eigen::VectorXd curve_load(const std::string& text, const std::string& file,
                           const problems::Structure& truss, const problems::LimitProblem& problem);

}  // namespace kusabi::run
