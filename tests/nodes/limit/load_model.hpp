// Common functions of the tests of the load model: a complete analysis of a truss on one rank.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include <gtest/gtest.h>

#include "engine/transport/single_process.hpp"
#include "nodes/evidence/verified_structure.hpp"
#include "nodes/limit/limit_loads.hpp"
#include "support/input_error.hpp"
#include "tests/nodes/limit/correlated_trusses.hpp"
#include "tests/nodes/limit/plain_truss.hpp"
#include "verify/limit/truss_consistency.hpp"
#include "verify/limit/truss_proof.hpp"

namespace kusabi::limit::test {

/// The vertices are solved by a simplex method with a tolerance of 1e-7.
inline constexpr double near = 1e-6;

inline LimitFindings findings(const problems::Structure& truss, const LimitParameters& parameters) {
  engine::SingleProcess alone;
  engine::Analysis analysis(alone);
  return limit_loads(analysis, truss, limit_problem(checked(truss)), parameters);
}

/// The problem of the truss; nothing if it is a mechanism or has a node without a member.
inline std::optional<problems::LimitProblem> problem_of(const problems::Structure& truss) {
  try {
    return limit_problem(checked(truss));
  } catch (const support::InputError& error) {
    const std::string why = error.what();
    EXPECT_TRUE(why.ends_with("that prevent this") || why.ends_with("or no such node")) << why;
    return {};
  }
}

// Proved bounds of a theorem for the truss; an empty interval: none.
struct Shown {
  double lower = std::numeric_limits<double>::infinity();
  double upper = -std::numeric_limits<double>::infinity();
  std::string why;
};

/// @param truss of a problem file; nothing: that of the theorem
inline Shown shown(const verify::TrussTheorem& theorem,
                   const std::optional<verify::Structure>& truss) {
  if (truss) {
    if (auto why = verify::truss_difference(theorem, *truss)) return {.why = *why};
  }
  const verify::TrussProof proof(theorem);
  Shown result;
  if (const auto refusals = proof.refusals(result.upper); !refusals.empty())
    return {.why = refusals.front()};
  for (std::size_t piece = 0; piece < proof.pieces(); ++piece) {
    const auto lower = proof.lower(piece);
    if (const auto* why = std::get_if<std::string>(&lower)) return {.why = *why};
    result.lower = std::min(result.lower, std::get<double>(lower));
  }
  return result;
}

inline Shown shown(const verify::TrussTheorem& theorem, const problems::Structure& truss) {
  return shown(theorem, evidence::verified_structure(truss));
}

}  // namespace kusabi::limit::test
