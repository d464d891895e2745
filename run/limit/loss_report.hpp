// Loss of members in the results of `kusabi limit --lose`: table, JSON, and the verdict.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "answer/verdict.hpp"
#include "nodes/limit/loss/loss_answer.hpp"
#include "problems/limit/limit_problem.hpp"
#include "run/limit/limit_cases.hpp"

namespace kusabi::run {

/// The word in results for what remains after a loss.
const char* loss_state(limit::LoadStatus status);

/// The worst loss, and the members whose loss alone lowers the factor.
std::string loss_text(const problems::LimitProblem& problem, const problems::Structure& truss,
                      const limit::LossAnswer& loss);

/// The key `member_loss` of a result.
nlohmann::ordered_json loss_json(const problems::LimitProblem& problem,
                                 const problems::Structure& truss, const limit::LossAnswer& loss);

/// Of the load case in which the least factor remains. @param kept members that are not lost
/// @pre every case has an answer
answer::MemberLoss member_loss(std::span<const LimitCase> cases, const std::vector<int>& kept);

}  // namespace kusabi::run
