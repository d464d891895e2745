// Proved limit load factor of a truss, (5) of the limit paper, its minimum over uncertain dead
// loads, (13), and the factors carried under every admissible load: the analysis of `kusabi limit`.
#pragma once

#include <optional>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/limit/loss/loss_answer.hpp"
#include "nodes/limit/model/limit_parameters.hpp"
#include "nodes/limit/root/limit_answer.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/structure.hpp"
#include "verify/limit/truss_certificate.hpp"

namespace kusabi::limit {

struct LimitFindings {
  LimitAnswer answer;  ///< on every rank, except counts, which are on rank 0
  /// The proved theorems with their evidence for a certificate, on rank 0. None on least factors
  /// without one on the largest.
  std::vector<verify::TrussTheorem> theorems;
  /// The same analysis with all struts at their residual strength; nothing: there are no struts, or
  /// no result at their strength. Its claims are among `theorems`.
  std::optional<LimitAnswer> residual;
  /// Answer of `--lose`; nothing: not requested, or no nominal factor was found.
  std::optional<LossAnswer> loss;
  std::optional<LossAnswer> residual_loss;  ///< the same with all struts at residual strength

  /// As LimitAnswer, with struts and the loss of members.
  [[nodiscard]] engine::Status ended() const;
  [[nodiscard]] bool whole() const;
};

/// Every rank makes the same call.
/// @param truss for the proofs
/// @param problem of `truss`
/// @throws BigMTooSmall on every rank alike
LimitFindings limit_loads(engine::Analysis& analysis, const problems::Structure& truss,
                          const problems::LimitProblem& problem, const LimitParameters& parameters);

}  // namespace kusabi::limit
