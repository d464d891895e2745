// Worst case by the 0-1 program (29) of the limit paper: Algorithms 4.2 and 5.1 as printed, and
// accelerated variants, for comparison with static cuts.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "engine/analysis/analysis.hpp"
#include "nodes/limit/model/limit_parameters.hpp"
#include "nodes/limit/root/limit_answer.hpp"
#include "nodes/limit/root/worst_case.hpp"
#include "problems/limit/limit_analysis.hpp"
#include "problems/limit/limit_problem.hpp"

namespace kusabi::limit {

/// A collapse that bounds (29) from above before the tree: that of a sampled load (remark 4.5).
struct ZeroOneStart {
  double factor = 0;       ///< v^U, in the unit of the load factor
  Eigen::VectorXd motion;  ///< u, n^d, f_R^T u = 1 in the units of the problem
};

/// Result, the same on every rank except counts.
struct ZeroOneWorst {
  LimitZeroOne found;
  /// Motion of the best point, n^d: the signs of t_j'u are the critical load. In the units of the
  /// problem by printed_worst(), in those of the model by zero_one_worst(). Empty: no point was
  /// found.
  Eigen::VectorXd motion;
  engine::Status status = engine::Status::solved;  ///< reason of the end of the search
};

/// Algorithm 4.2, after Algorithm 5.1 if requested, as printed: (27) in the units of the problem
/// with the given M, u and gamma free, and no other information but `start`. docs/theory/limit.md
/// lists the differences.
/// @pre parameters.as_printed()
ZeroOneWorst printed_worst(engine::Analysis& analysis, const LimitParameters& parameters,
                           const problems::LimitProblem& problem,
                           const std::optional<ZeroOneStart>& start);

/// (29) with M derived from static cuts, unless given, and bounds of its columns likewise; with
/// static cuts as rows and a tightened M if the method has them.
/// @param alpha scaled
/// @param root result of static cuts: a safe M and a collapse
/// @return nothing if no safe M is found
/// @throws BigMTooSmall on every rank if the given M leaves no point
std::optional<ZeroOneWorst> zero_one_worst(engine::Analysis& analysis,
                                           const LimitParameters& parameters,
                                           const problems::LimitModel& model, double alpha,
                                           const RootResult& root,
                                           const std::optional<ZeroOneStart>& start);

}  // namespace kusabi::limit
