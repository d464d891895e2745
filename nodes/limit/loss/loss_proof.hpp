// Proofs on a truss without some of its members, in exact arithmetic by the verifier: the yield
// forces of members that are lost, or that a proof must not use, are zero.
//
// One more "member" stands for the factor: its column is f_R, and its force a change of the factor.
// Its yield forces are the excess of the factor over the target, so that corrections of equilibrium
// may change the factor down to the target. Where the truss without its lost members is a mechanism
// on which f_R does work, equilibrium determines the factor, which may be no double.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <gmpxx.h>

#include "problems/limit/limit_analysis.hpp"
#include "problems/limit/limit_problem.hpp"
#include "support/index_set.hpp"
#include "verify/limit/limit_certificate.hpp"
#include "verify/limit/limit_proof.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::limit {

class LossProof {
 public:
  /// @pre problem and model outlive this object @param truss with exact directions
  LossProof(const verify::Structure& truss, const problems::LimitProblem& problem,
            const problems::LimitModel& model);

  /// True if members of `present` alone carry the dead load and some factor of at least `target`.
  /// The nominal dead load is meant, without its uncertain part.
  /// @param target in the unit of the load factor, like `factor`
  /// @param forces scaled, n^m, about in equilibrium with `factor`; zero outside of `present`
  bool carries(const support::IndexSet& present, double target, double factor,
               const Eigen::VectorXd& forces);

  /// Proved upper bound of the load factor without these members; nothing if there is none.
  /// @param motion scaled, n^d
  std::optional<double> upper(const support::IndexSet& lost, const Eigen::VectorXd& motion);

  /// True if the motion proves that no load factor remains. @param motion scaled, n^d
  bool shows_no_factor(const support::IndexSet& lost, const Eigen::VectorXd& motion);

 private:
  void remove(const support::IndexSet& lost, double excess);
  void set_motion(const Eigen::VectorXd& motion);

  const problems::LimitProblem& problem_;
  const problems::LimitModel& model_;
  verify::LimitCertificate certificate_;
  std::optional<verify::LimitProof> proof_;  // of certificate_, with its present yield forces
};

}  // namespace kusabi::limit
