// Proofs on a truss without some of its members, in exact arithmetic by the verifier.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "problems/limit/limit_analysis.hpp"
#include "problems/limit/limit_problem.hpp"
#include "support/index_set.hpp"
#include "verify/limit/exact_truss.hpp"
#include "verify/limit/limit_certificate.hpp"
#include "verify/limit/limit_proof.hpp"
#include "verify/limit/loss_certificate.hpp"
#include "verify/limit/stress_state.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::limit {

/// A state that is proved to carry the target, and its members.
struct ProvedState {
  support::IndexSet support;
  verify::StressState state;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& support& state;
  }
};

class LossProof {
 public:
  /// @param alpha in the unit of force; zero: the dead load as given
  /// @pre problem and model outlive this object @param truss with exact directions
  LossProof(const verify::Structure& truss, const problems::LimitProblem& problem,
            const problems::LimitModel& model, double alpha);

  /// The state, if its members or, for the rounding errors of equilibrium, further members without
  /// the lost ones are proved to carry at least the target under every admissible load.
  /// @param target in the unit of the load factor
  [[nodiscard]] std::optional<ProvedState> proved(verify::StressState state, double target,
                                                  const support::IndexSet& lost) const;

  /// Proved upper bound of the load factor without these members; nothing if there is none.
  /// @param zeta shares of the half-widths, m; empty: the dead load as given
  /// @param motion n^d, in units
  std::optional<double> upper(const support::IndexSet& lost, const Eigen::VectorXd& zeta,
                              const Eigen::VectorXd& motion);

  /// True if the motion proves that no load factor remains.
  bool shows_no_factor(const support::IndexSet& lost, const Eigen::VectorXd& zeta,
                       const Eigen::VectorXd& motion);

  /// Uncertain loads, and the load of the last proof. @param uncertain false: none
  void write_loads(bool uncertain, verify::LossStatement& statement) const;

 private:
  bool set(const support::IndexSet& lost, const Eigen::VectorXd& zeta,
           const Eigen::VectorXd& motion);

  const problems::LimitProblem& problem_;
  verify::ExactTruss exact_;
  verify::LimitCertificate certificate_;
  // Of certificate_, with its present yield forces; nothing: no proof is possible.
  std::optional<verify::LimitProof> proof_;
};

}  // namespace kusabi::limit
