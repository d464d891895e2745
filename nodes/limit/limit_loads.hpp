// The load factor at which a truss collapses, (5) of the limit paper, the least one that an
// uncertain dead load can bring about, (13), and the factors that are carried under every
// admissible load, proved: the question that `kusabi limit` asks.
#pragma once

#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/limit/model/limit_question.hpp"
#include "nodes/limit/root/limit_answer.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/structure.hpp"
#include "verify/limit/limit_certificate.hpp"

namespace kusabi::limit {

struct LimitFindings {
  LimitAnswer answer;  ///< on every rank, but for what only rank 0 is told: counts
  /// The claims that are proved, with their evidence, as a certificate wants them; on rank 0. None
  /// of the least factors without one of the largest.
  std::vector<verify::LimitStatement> statements;
};

/// Every rank makes the same call.
/// @param truss what the ends are proved of
/// @param problem of `truss`
/// @throws BigMTooSmall on every rank alike
LimitFindings limit_loads(engine::Analysis& analysis, const problems::Structure& truss,
                          const problems::LimitProblem& problem, const LimitQuestion& question);

}  // namespace kusabi::limit
