// The load factor under a known dead load, (5) of the limit paper, by the simplex method warm from
// the load before; and the alternating linear programs that find good critical loads.
#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "problems/limit/limit_analysis.hpp"
#include "solvers/linear/simplex.hpp"

namespace kusabi::nodes::limit {

/// A collapse under a dead load, in the scaled units of the model.
struct Collapse {
  double factor = 0;       ///< lambda*
  Eigen::VectorXd forces;  ///< q, n^m, without the model's shift
  Eigen::VectorXd motion;  ///< u, n^d, f_R^T u = 1
};

/// What (5) can come to.
enum class LoadStatus {
  collapses,     ///< at a finite factor, which is negative if the dead load alone is too much
  not_carried,   ///< at no factor, of either sign, is there equilibrium within the yield forces
  undetermined,  ///< the simplex method failed
};

class LoadFactor {
 public:
  explicit LoadFactor(const problems::LimitModel& model);

  /// Solves (5). The result hangs on the load and on the basis, see `restart`.
  LoadStatus solve(const Eigen::VectorXd& dead);

  /// The next solve starts from the basis of the first one, so that what it finds hangs on its load
  /// alone. @pre the first load has collapsed
  void restart();

  /// @pre the last solve said `collapses`
  [[nodiscard]] Collapse collapse() const;

  /// After `not_carried`: a motion u with f_R^T u = 0 on which the load does more work than the
  /// members can take. Empty if none was found.
  [[nodiscard]] Eigen::VectorXd overpowering_motion();

  [[nodiscard]] const linear::Simplex& simplex() const { return simplex_; }
  [[nodiscard]] std::uint64_t solves() const { return simplex_.solves(); }

 private:
  const problems::LimitModel& model_;
  linear::Simplex simplex_;
  std::optional<linear::Basis> first_;
};

/// A worst case found so far.
struct Worst {
  Eigen::VectorXd zeta;  ///< m, scaled, each of size alpha
  Collapse collapse;
};

/// Fixes zeta at alpha sign(T^T u), solves (5), and so on while the factor falls.
/// @param zeta where to start: m, scaled
/// @return nothing if a load on the way is not carried; then `zeta` is that load
std::optional<Worst> descend(const problems::LimitModel& model, LoadFactor& load_factor,
                             double alpha, Eigen::VectorXd& zeta);

/// alpha sign(t_j^T u) for each j; where t_j^T u is zero the sign of `otherwise`, or plus.
Eigen::VectorXd worst_for(const problems::LimitModel& model, double alpha,
                          const Eigen::VectorXd& motion, const Eigen::VectorXd& otherwise);

}  // namespace kusabi::nodes::limit
