// Load factor for a known dead load, (5) of the limit paper, by the simplex method with a warm
// start from the previous load; and alternating linear programs for critical loads.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include <Eigen/Core>

#include "problems/limit/limit_analysis.hpp"
#include "solvers/linear/checked_simplex.hpp"

namespace kusabi::limit {

/// A collapse under a dead load, in the scaled units of the model.
struct Collapse {
  double factor = 0;       ///< lambda*
  Eigen::VectorXd forces;  ///< q, n^m, without the model's shift
  Eigen::VectorXd motion;  ///< u, n^d, f_R^T u = 1
};

/// Result of (5).
enum class LoadStatus {
  collapses,     ///< at a finite factor, which is negative if the dead load alone is too large
  not_carried,   ///< no factor of either sign admits equilibrium within the yield forces
  undetermined,  ///< no answer of the simplex method has passed its check, or it was stopped
};

/// Result of (5) for one dead load.
struct LoadResult {
  LoadStatus status = LoadStatus::undetermined;
  Collapse collapse{};       ///< of `collapses`
  Eigen::VectorXd motion{};  ///< of `not_carried`: overpowering; empty if none was found
};

class LoadFactor {
 public:
  /// @param stop ends a long solve, which is then undetermined
  explicit LoadFactor(const problems::LimitModel& model, support::Stop stop = {});

  /// Solves (5). The result depends on the load and on the basis, see `restart`.
  LoadStatus solve(const Eigen::VectorXd& dead);

  /// Makes the next solve start from the basis of the first one, so that its result depends on
  /// its load alone. @pre the first load has collapsed
  void restart();

  /// Basis of the first collapse; empty: there is none.
  [[nodiscard]] linear::Basis first_basis() const { return first_.value_or(linear::Basis()); }
  /// Iterations of the first solve.
  [[nodiscard]] std::uint64_t first_iterations() const { return first_iterations_; }
  /// Takes the place of a first solve. @param first of the same program
  void start_from(const linear::Basis& first) { first_ = first; }

  /// The collapse of the load under the opposite reference load, whose factor is minus the least
  /// factor of the load. Nothing if it is not determined. @pre the first load has collapsed
  std::optional<Collapse> opposite_collapse(const Eigen::VectorXd& dead);

  /// Basis of the last solve.
  [[nodiscard]] linear::Basis basis() const { return simplex_.basis(); }

  /// @pre the result of the last solve was `collapses`
  [[nodiscard]] Collapse collapse() const;

  /// After `not_carried`: a motion u with f_R^T u = 0 on which the work of the load exceeds the
  /// largest dissipation. Empty if none was found.
  [[nodiscard]] Eigen::VectorXd overpowering_motion() const;

  [[nodiscard]] std::uint64_t solves() const { return simplex_.solves(); }
  [[nodiscard]] std::uint64_t iterations() const { return simplex_.iterations(); }

 private:
  const problems::LimitModel& model_;
  support::Stop stop_;
  linear::CheckedSimplex simplex_;
  std::optional<linear::Basis> first_;
  std::uint64_t first_iterations_ = 0;
};

/// A worst case found so far.
struct Worst {
  Eigen::VectorXd zeta;  ///< m, scaled, each of size alpha
  Collapse collapse;
};

/// Result of a descent.
struct Descent {
  /// undetermined: the simplex method failed on the first load.
  /// not_carried: some load has no factor.
  LoadStatus status = LoadStatus::undetermined;
  Worst worst;                          ///< of `collapses`
  Eigen::VectorXd overpowering_load;    ///< of `not_carried`: zeta
  Eigen::VectorXd overpowering_motion;  ///< and a motion that proves it; empty if none was found
};

/// Alternates zeta = alpha sign(T^T u) and (5) while the factor decreases.
/// @param zeta initial value: m, scaled  @param solve (5) for a dead load
Descent descend(const problems::LimitModel& model, double alpha, Eigen::VectorXd zeta,
                const std::function<LoadResult(const Eigen::VectorXd& dead)>& solve);
Descent descend(const problems::LimitModel& model, LoadFactor& load_factor, double alpha,
                Eigen::VectorXd zeta);

/// alpha sign(t_j^T u) for each j; where t_j^T u is zero the sign of `otherwise`, or plus.
Eigen::VectorXd worst_for(const problems::LimitModel& model, double alpha,
                          const Eigen::VectorXd& motion, const Eigen::VectorXd& otherwise);

}  // namespace kusabi::limit
