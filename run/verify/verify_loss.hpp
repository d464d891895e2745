// Proof of a certificate of the loss of members, and its claims in words.
#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "problems/structure/checks/checked_structure.hpp"
#include "run/command/command_run.hpp"
#include "run/verify/verify.hpp"

namespace kusabi::run {

/// @param structure of the problem file to prove the claims for, if any
/// @param residual compression strengths of the problem file after buckling, by member; empty: none
/// @throws WrongInput for a wrong certificate, on every rank; support::InputError if limit analysis
///         does not apply to the structure
VerifyFindings verify_loss(CommandRun& run, const VerifyOptions& options,
                           const std::optional<problems::CheckedStructure>& structure,
                           const Eigen::VectorXd& residual, const std::string& text);

}  // namespace kusabi::run
