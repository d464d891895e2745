// The search behind `kusabi limit`, on all ranks: the nominal load factor, the worst case at the
// root and in the tree of signs, its proof, samples and curves.
#pragma once

#include <optional>

#include "problems/limit/limit_problem.hpp"
#include "run/limit/limit.hpp"
#include "run/limit/limit_answer.hpp"
#include "run/session/session.hpp"
#include "verify/limit_certificate.hpp"

namespace kusabi::run {

struct LimitFindings {
  LimitAnswer answer;  ///< on every rank, but for what only rank 0 is told: the ends and counts
  /// The evidence of both ends, if both are proved; on rank 0.
  std::optional<verify::LimitCertificate> certificate;
};

/// Every rank makes the same call.
/// @param problem of `truss`
/// @throws WrongInput on every rank alike, if a method cannot be used
LimitFindings limit_search(Session& session, const LimitOptions& options,
                           const problems::Structure& truss, const problems::LimitProblem& problem);

}  // namespace kusabi::run
