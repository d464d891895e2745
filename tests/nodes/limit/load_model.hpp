// What the tests of the load model share: a truss from end to end, on one rank.
#pragma once

#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "engine/transport/single_process.hpp"
#include "nodes/limit/limit_loads.hpp"
#include "support/input_error.hpp"
#include "tests/nodes/limit/correlated_trusses.hpp"
#include "tests/nodes/limit/plain_truss.hpp"

namespace kusabi::limit::test {

/// The corners are solved by a simplex method with a tolerance of 1e-7 of its own.
inline constexpr double near = 1e-6;

inline LimitFindings findings(const problems::Structure& truss, const LimitQuestion& question) {
  engine::SingleProcess alone;
  engine::Campaign campaign(alone);
  return limit_loads(campaign, truss, limit_problem(truss), question);
}

/// The problem of the truss; nothing if it is a mechanism or has a node without a member.
inline std::optional<problems::LimitProblem> problem_of(const problems::Structure& truss) {
  try {
    return limit_problem(truss);
  } catch (const support::InputError& error) {
    const std::string why = error.what();
    EXPECT_TRUE(why.ends_with("every node") || why.ends_with("or no such node")) << why;
    return {};
  }
}

}  // namespace kusabi::limit::test
