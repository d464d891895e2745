// Worst loss of members: the least load factor over all losses of up to K members and, on request,
// over all admissible loads, with both bounds proved, or whether a factor remains after each of
// them (docs/theory/limit.md).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/limit/loss/loss_answer.hpp"
#include "nodes/limit/loss/loss_opening.hpp"
#include "nodes/limit/loss/loss_programs.hpp"
#include "nodes/limit/loss/loss_proof.hpp"
#include "nodes/limit/model/limit_parameters.hpp"
#include "problems/limit/limit_problem.hpp"
#include "support/index_set.hpp"
#include "verify/limit/loss_cover.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::limit {

class LossSearch {
 public:
  /// @param model in which the nominal load collapses @param truss for the proofs
  /// @param alpha in the unit of force; zero: the dead load as given
  /// @pre all outlive this object. Every rank makes the same calls.
  LossSearch(engine::Analysis& analysis, const verify::Structure& truss,
             const problems::LimitProblem& problem, const problems::LimitModel& model,
             const LossParameters& parameters, double alpha);

  LossAnswer solve();

 private:
  // A loss and what remains after it, in units.
  struct Known {
    support::IndexSet lost;
    LoadStatus status = LoadStatus::undetermined;
    Eigen::VectorXd zeta;
    LimitCollapse collapse;
  };

  Known after(const support::IndexSet& lost, const support::Stop& stop = {});
  Known worst_after(const support::IndexSet& lost);
  std::vector<SingleLoss> after_one_more(const Known& known);
  void start();
  void search();
  void search_below();
  std::vector<LossPiece> open_round(const std::vector<LossNode>& batch);
  void judge(const support::IndexSet& suspect);
  void drop_useless();
  void use_no_load();
  void conclude();
  void settle_target();
  void record();
  [[nodiscard]] verify::LossCover cover() const;

  engine::Analysis& analysis_;
  const verify::Structure& truss_;
  const problems::LimitProblem& problem_;
  const problems::LimitModel& model_;
  const LossParameters& parameters_;
  double alpha_;
  support::IndexSet eligible_;
  LossProof proof_;
  RemainingFactor remaining_;
  std::optional<StateProgram> program_;
  Known worst_;
  LossKnowledge known_;
  std::vector<ProvedState> states_;
  bool missed_ = false;          // a loss below the given target is known
  std::optional<double> lower_;  // proved
  LossAnswer answer_;
};

}  // namespace kusabi::limit
