// Sentences of `kusabi limit` about members and loads, and the verdict.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include "answer/verdict.hpp"
#include "nodes/limit/root/limit_answer.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/structure.hpp"
#include "run/limit/limit.hpp"
#include "run/limit/limit_cases.hpp"

namespace kusabi::run {

/// Unit of alpha; nothing where alpha multiplies the uncertain loads.
std::optional<std::string_view> unit_of_alpha(const problems::LimitProblem& problem);

/// Members with the highest utilisation besides those that yield, in descending order.
std::string utilisation_text(const problems::LimitProblem& problem,
                             const limit::LimitCollapse& collapse);

/// The uncertain loads by direction and value, or the factors of the actions of a combination; empty
/// if zeta is.
/// @param truss of the load case  @param zeta m, in multiples of the uncertain loads
std::string critical_load_text(const problems::Structure& truss,
                               const problems::LimitProblem& problem, const Eigen::VectorXd& zeta);

/// "1.35 self, 1.05 crane, -0.9 wind; 1.5 snow times the load factor"; empty if the load case is no
/// combination of actions, or zeta is empty.
std::string combination_text(const problems::Structure& truss,
                             const problems::LimitProblem& problem, const Eigen::VectorXd& zeta);

/// Load factors that are carried, and the members that yield at their ends.
answer::Verdict limit_verdict(const LimitOptions& options, std::span<const LimitCase> cases);

}  // namespace kusabi::run
