// `kusabi verify` for certificates of worst-case limit loads.
#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "problems/structure/checks/checked_structure.hpp"
#include "run/command/command_run.hpp"
#include "run/verify/verify.hpp"

namespace kusabi::run {

/// Proves both bounds on all ranks, in pieces of one node.
/// @param structure of the problem file to prove it for, if any
/// @param residual compression strengths of the problem file after buckling, by member; empty: none
/// @param text of the file, the same on all ranks
/// @throws WrongInput on every rank; support::InputError if limit analysis does not apply to the
/// structure
VerifyFindings verify_limit(CommandRun& run, const VerifyOptions& options,
                            const std::optional<problems::CheckedStructure>& structure,
                            const Eigen::VectorXd& residual, const std::string& text);

}  // namespace kusabi::run
