// The load that --curve-load names: a file of loads, or the critical part of an earlier result.
#pragma once

#include <string>

#include <Eigen/Core>

#include "problems/limit/limit_problem.hpp"

namespace kusabi::run {

/// g, n^d, force. What is on supports goes straight to the ground.
/// @param text a TOML file (problems/files/sections/node_forces.hpp) or a result of `kusabi limit
/// --alpha`
/// @param file how errors name it
/// @throws support::InputError; also if nothing is left of the load on the free displacements
Eigen::VectorXd curve_load(const std::string& text, const std::string& file,
                           const problems::LimitProblem& problem);

}  // namespace kusabi::run
