// Linear programs on a truss without some of its members: its load factor, (5) of the limit paper,
// and a stress state of few members that carries a factor not below a target.
#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "nodes/limit/model/load_factor.hpp"
#include "problems/limit/limit_analysis.hpp"
#include "solvers/linear/basis.hpp"
#include "solvers/linear/simplex.hpp"
#include "support/index_set.hpp"
#include "support/stop.hpp"

namespace kusabi::limit {

/// Member forces in equilibrium with the dead load and a factor times the reference load.
struct CarryingState {
  double factor = 0;       ///< scaled
  Eigen::VectorXd forces;  ///< scaled, n^m; exactly zero in members without stress
};

/// Reductions of the yield forces of a carrying stress state, relative: the margin of its proof.
/// The second one is used if a proof with the first one fails; the simplex method may violate
/// bounds by 1e-9.
inline constexpr double yield_margins[] = {1e-10, 4e-9};

/// Load factor after a loss. Its results depend on the loss alone.
class RemainingFactor {
 public:
  /// @pre the model outlives this object
  explicit RemainingFactor(const problems::LimitModel& model, support::Stop stop = {});

  /// Solves (5) without these members.
  LoadStatus solve(const support::IndexSet& lost);

  /// @pre the result of the last solve was `collapses`
  [[nodiscard]] Collapse collapse() const;
  /// As LoadFactor::overpowering_motion().
  [[nodiscard]] Eigen::VectorXd overpowering_motion();

  [[nodiscard]] std::uint64_t solves() const { return simplex_.solves(); }

 private:
  const problems::LimitModel& model_;
  support::Stop stop_;
  linear::Simplex simplex_;
  linear::Basis first_;     // of the intact truss
  support::IndexSet lost_;  // in the last solve
};

/// Carrying stress states of small weighted sum of forces: minimise sum_i w_i |q_i| subject to
/// B q = f_D + lambda f_R, lambda >= target, and the yield forces.
class StateProgram {
 public:
  /// Result of a solve.
  enum class Result { found, none, undetermined };

  /// @param target scaled @pre the model outlives this object
  StateProgram(const problems::LimitModel& model, double target, support::Stop stop = {});

  /// Makes the next result independent of earlier ones.
  void restart();

  /// @param lost without stress @param avoided members with a large weight
  /// @param free members with a small weight @param margin relative reduction of the yield forces
  Result solve(const support::IndexSet& lost, const support::IndexSet& avoided,
               const support::IndexSet& free, double margin);

  /// @pre the result of the last solve was `found`
  [[nodiscard]] CarryingState state() const;

  [[nodiscard]] std::uint64_t solves() const { return simplex_.solves(); }

 private:
  const problems::LimitModel& model_;
  support::Stop stop_;
  linear::Simplex simplex_;
  linear::Basis first_;
};

}  // namespace kusabi::limit
