// Proofs on a truss without some of its members, by the verifier: by enclosures, and in exact
// arithmetic where these do not suffice.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "problems/limit/limit_analysis.hpp"
#include "problems/limit/limit_problem.hpp"
#include "support/index_set.hpp"
#include "support/stop.hpp"
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
  LossProof(const LossProof&) = delete;
  LossProof& operator=(const LossProof&) = delete;
  ~LossProof() = default;

  /// The state, if its members or, for the rounding errors of equilibrium, further members without
  /// the lost ones are proved to carry at least the target under every admissible load. Nothing
  /// also if an end is requested.
  /// @param basic members that are tried first as further ones
  /// @param target in the unit of the load factor
  /// @param last true: no other state is tried, so that an elimination may take long
  [[nodiscard]] std::optional<ProvedState> proved(verify::StressState state,
                                                  const support::IndexSet& basic, double target,
                                                  const support::IndexSet& lost, bool last,
                                                  const support::Stop& stop) const;

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
  verify::LimitCertificate intact_;           // without a loss
  std::optional<verify::LimitProof> states_;  // of intact_; nothing: no proof is possible
  verify::LimitCertificate certificate_;      // after the loss of the last proof
  std::optional<verify::LimitProof> proof_;   // of certificate_, with its present yield forces
};

}  // namespace kusabi::limit
