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
#include "verify/limit/limit_proof.hpp"
#include "verify/limit/limit_truss.hpp"
#include "verify/limit/stress_state.hpp"
#include "verify/limit/truss_certificate.hpp"
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
  /// @param truss with exact directions, and strengths that are not yet divided by `sudden`
  /// @param alpha in the unit of force; zero: the dead load as given
  /// @pre the problem outlives this object
  LossProof(const verify::Structure& truss, const problems::LimitProblem& problem, double alpha,
            double sudden);
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
  /// @param zeta m, of which the signs count; empty: the dead load as given
  /// @param motion n^d, in units
  [[nodiscard]] std::optional<double> upper(const support::IndexSet& lost,
                                            const Eigen::VectorXd& zeta,
                                            const Eigen::VectorXd& motion) const;

  /// True if the motion proves that no load factor remains.
  [[nodiscard]] bool shows_no_factor(const support::IndexSet& lost, const Eigen::VectorXd& zeta,
                                     const Eigen::VectorXd& motion) const;

  /// The load and the motion after a loss, as recorded; nothing: no proof is possible.
  [[nodiscard]] std::optional<verify::CollapseMotion> collapse(const support::IndexSet& lost,
                                                               const Eigen::VectorXd& zeta,
                                                               const Eigen::VectorXd& motion) const;

  /// The truss with its loads. @pre a proof is possible
  [[nodiscard]] const verify::Structure& truss() const { return *loaded_; }

 private:
  const problems::LimitProblem& problem_;
  double alpha_;
  std::optional<verify::Structure> loaded_;
  verify::ExactTruss exact_;
  std::optional<verify::LimitTruss> truss_;  // nothing: no proof is possible
  std::optional<verify::LimitProof> proof_;
};

}  // namespace kusabi::limit
