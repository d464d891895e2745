// What the table of `kusabi limit` says of members and loads, and the answer in a sentence.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include "nodes/limit/root/limit_answer.hpp"
#include "problems/limit/limit_problem.hpp"
#include "run/limit/limit.hpp"
#include "run/limit/limit_cases.hpp"
#include "run/verdict/verdict.hpp"

namespace kusabi::run {

/// Nothing where alpha is a number: of times the uncertain loads.
std::optional<std::string_view> unit_of_alpha(const problems::LimitProblem& problem);

/// The members that use most of their strength besides those that yield, the highest first.
std::string utilisation_text(const problems::LimitProblem& problem,
                             const limit::LimitCollapse& collapse);

/// Direction by direction and size by size where the uncertain loads act; empty if zeta is.
/// @param zeta m, in multiples of them
std::string critical_load_text(const problems::LimitProblem& problem, const Eigen::VectorXd& zeta);

/// The factors that are carried, and which members yield where they end.
Verdict limit_verdict(const LimitOptions& options, std::span<const LimitCase> cases);

}  // namespace kusabi::run
