// Successive linearisation of complementarity at one friction coefficient. A point of the
// relaxation is a wedged configuration exactly if the concave function sum_i min(u_ni / c_i, r_ni)
// is zero there. From an estimate of the candidates in contact a few programs of the size of a root
// lead to a local minimum; each may change the states of all candidates (docs/theory/wedged.md,
// "Primal heuristic").
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "problems/wedged/wedged_problem.hpp"
#include "solvers/conic/weighted_relaxation.hpp"
#include "support/index_set.hpp"
#include "support/stop.hpp"

namespace kusabi::wedged {

/// Result of the iteration, without proof: likely a feasible pattern if `excess` is near zero.
struct LinearisedPattern {
  support::IndexSet contact;
  double excess = 0;  ///< sum_i min(u_ni / c_i, r_ni), of 1
};

/// Linearisation of one block. Results depend on the arguments only; each rank has its own.
class Linearisation {
 public:
  explicit Linearisation(const problems::WedgedProblem& block);

  /// from() throws support::Stopped soon after this stop request.
  void end_when(const support::Stop& stop);

  /// @param contact the first estimate  @param factor of the candidates' own friction coefficients
  /// @param share of the row sums of F_nn in c, the rest is the candidates' own compliance: 0 to 1
  std::optional<LinearisedPattern> from(const support::IndexSet& contact, double factor,
                                        double share);

  [[nodiscard]] std::uint64_t programs() const { return programs_; }

 private:
  using Vector = Eigen::VectorXd;

  std::optional<conic::RelaxedPoint> minimise(const support::IndexSet& contact,
                                              const Vector& scale);

  std::variant<conic::WeightedRelaxation<2>, conic::WeightedRelaxation<3>> relaxation_;
  std::vector<double> own_friction_, friction_;
  Vector normal_, tangential_, row_sums_;  // of scaled F: F_nn,ii, |F_nt,ii|, sums of F_nn
  std::uint64_t programs_ = 0;
};

}  // namespace kusabi::wedged
