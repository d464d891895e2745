// Loads in the node program: each is a last candidate without friction that has a reaction, its
// amount tau >= 0, and no row (docs/theory/loads.md, "The node program").
//
// A state of a block under a dead load f_0 with clearances g, and lambda times a reference load
// f_1:
//
//   u = F r + w_0 tau + w_1 lambda + G alpha,   G'r + b_0 tau + b_1 lambda = 0,
//   u_n + g tau >= 0,   r_n >= 0,   complementary,   ||r_t|| <= mu r_n,   tau = 1.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "problems/structure/checks/checked_structure.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "solvers/conic/answer.hpp"
#include "support/index_set.hpp"

namespace kusabi::wedged {

/// As CriticalFriction::tolerances: t* near a limit is a small multiple of the distance from it.
inline constexpr conic::Tolerances hold_tolerances{
    .sign = 1e-14, .value = 1e-15, .iterations = 100};

/// A combination of the loads: `dead` times the dead load and the clearances, plus `reference`
/// times the reference load, plus `second` times that of a second case.
struct LoadShare {
  double dead = 0;
  double reference = 0;
  double second = 0;
};

/// Restriction to states whose normal reactions add up to a given sum in units of the dead load.
struct GripRestriction {
  enum class Kind { above, below, equal };  ///< at least, at most, exactly
  Kind kind = Kind::equal;
  double total = 0;  ///< force
};

/// A wedged problem with its loads.
struct LoadedProblem {
  problems::WedgedProblem problem;
  problems::LoadColumns loads;  ///< of the loads that are there: dead, reference, second
  bool has_dead = false;        ///< a dead load that acts not on supports alone
  bool has_reference = false;
  bool has_second = false;    ///< a reference load of a second case
  Eigen::VectorXd clearance;  ///< g, m, length

  /// True if a dead load or a clearance is not zero.
  [[nodiscard]] bool has_dead_part() const { return has_dead || !clearance.isZero(0); }
};

/// The dead and the reference load of a structure without load cases, and its clearances,
/// condensed.
/// @throws as problems::wedged_problem
LoadedProblem loaded_problem(const problems::CheckedStructure& structure,
                             const support::LongWork& work = {});

/// The same with the reference loads of two load cases, which are then `reference` and `second`.
/// Dead loads are those common to all cases.
LoadedProblem loaded_problem(const problems::CheckedStructure& structure,
                             const std::array<std::string, 2>& cases,
                             const support::LongWork& work = {});

/// Forces on the candidates, dm each, that are equivalent to the loads: K u = r + p for every state.
/// With S = F^-1, which includes the grounding springs, and the work b of a load on the modes G,
///
///   p = S w + S G (G'S G)^-1 (b - G'S w).
///
/// Zero for a load that is not there.
struct EquivalentForces {
  Eigen::VectorXd dead, reference;
};
EquivalentForces equivalent_forces(const LoadedProblem& loaded);

/// The part of a decoupled block. @param candidates of the block
LoadedProblem loaded_block(const LoadedProblem& whole, const support::IndexSet& candidates);

/// True if a load acts on the block. @param load its number among those that are there
bool acts(const LoadedProblem& block, Eigen::Index load);

/// True if supports constrain every body on which a load acts.
bool is_constrained(const LoadedProblem& loaded);

/// True if the dead load or a clearance acts on the block.
bool is_under_dead(const LoadedProblem& block);

/// True if a load or a clearance acts on the block.
bool is_loaded(const LoadedProblem& block);

/// Work of a load on the modes that displace no candidate, relative to its size: the largest
/// magnitude. Above `negligible_work` the load is not in equilibrium with any reactions.
double work_on_other_modes(const LoadedProblem& loaded, LoadShare share);

/// Share of a load below which its work on a mode is the rounding of directions and positions,
/// which the file writes with sixteen digits.
inline constexpr double negligible_work = 1e-12;

/// The problem with one more candidate for each share, for a ContactSolver with as many loads.
/// F_jj is an upper bound that makes the error bound of F valid for the load's column, and the load
/// is scaled such that it equals the mean of F_nn.
problems::WedgedProblem with_loads(const LoadedProblem& loaded, std::span<const LoadShare> shares);

/// The same with one more equation, sum r_n = total times the amount of the dead shares, which is a
/// last column of the modes; `above` and `below` have one more load, the difference. The equation
/// is divided by `grip_scale`.
problems::WedgedProblem with_grip(const LoadedProblem& loaded, std::span<const LoadShare> shares,
                                  const GripRestriction& grip);

double grip_scale(const LoadedProblem& loaded, std::span<const LoadShare> shares,
                  const GripRestriction& grip);

/// Factor by which `with_loads` divides the load.
double scale_of(const LoadedProblem& loaded, LoadShare share);

/// mu of each candidate, then zero for each load.
std::vector<double> friction_with_loads(const problems::WedgedProblem& problem, double mu,
                                        std::size_t loads);

}  // namespace kusabi::wedged
