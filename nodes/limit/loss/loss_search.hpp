// Worst loss of members: the least load factor over all losses of up to K members, with both bounds
// proved, or whether a factor remains after each of them (docs/theory/limit.md).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/limit/loss/loss_answer.hpp"
#include "nodes/limit/loss/loss_programs.hpp"
#include "nodes/limit/loss/loss_proof.hpp"
#include "nodes/limit/loss/loss_tree.hpp"
#include "nodes/limit/model/limit_question.hpp"
#include "problems/limit/limit_problem.hpp"
#include "support/index_set.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::limit {

class LossSearch {
 public:
  /// @param model in which the nominal load collapses @param truss for the proofs
  /// @pre all outlive this object. Every rank makes the same calls.
  LossSearch(engine::Analysis& analysis, const verify::Structure& truss,
             const problems::LimitProblem& problem, const problems::LimitModel& model,
             const LossQuestion& question);

  LossAnswer solve();

 private:
  // A loss and what remains after it.
  struct Known {
    support::IndexSet lost;
    LoadStatus status = LoadStatus::undetermined;
    Collapse collapse;
  };

  [[nodiscard]] double value_of(const Known& known) const;
  Known after(const support::IndexSet& lost);
  std::vector<SingleLoss> after_one_more(const Known& known);
  void start();
  void search_below();
  bool take(const LossTree::Solution& solution);
  void drop_useless();
  void conclude();
  void settle_target();

  engine::Analysis& analysis_;
  const problems::LimitModel& model_;
  const LossQuestion& question_;
  support::IndexSet eligible_;
  LossProof proof_;
  RemainingFactor remaining_;
  Known worst_;
  double target_ = 0;  // in the unit of the load factor
  std::vector<support::IndexSet> pool_;
  std::optional<double> lower_;  // proved
  LossAnswer answer_;
};

}  // namespace kusabi::limit
