// The worst-case load factor at the root: static cuts from below, alternating linear programs from
// above, round by round until they meet. Where they do not, nodes/limit/sign_tree goes on.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "nodes/limit/model/load_factor.hpp"
#include "nodes/limit/model/static_cut.hpp"
#include "nodes/limit/root/master.hpp"

namespace kusabi::limit {

/// Upper and lower end meet if they differ by no more than this, in the scaled factor, which is of
/// the order of one: the simplex method leaves rounding of 1e-12 or so, and no answer of
/// engineering needs ten digits.
inline constexpr double closed_gap = 1e-8;

/// Columns of T in one block of pricing programs: each block starts from the same basis, so that
/// what it finds does not depend on which rank it is solved on.
inline constexpr std::size_t pricing_block = 32;

/// Makes the best cuts for some columns of T at z, in their order. Some may be missing once the
/// pricer was asked to end.
using Pricer =
    std::function<std::vector<StaticCut>(const Eigen::VectorXd& z, std::span<const int> columns)>;

/// The cuts of one block. @pre pricing.aim() was called for the round
std::vector<StaticCut> price_block(StaticPricing& pricing, std::span<const int> columns);

/// All blocks here, one after another.
std::vector<StaticCut> price_alone(StaticPricing& pricing, const Eigen::VectorXd& z,
                                   std::span<const int> columns);

struct WorstCaseCounts {
  std::uint64_t load_factors = 0;  ///< programs (5)
  std::uint64_t relaxations = 0;   ///< programs of master.hpp
  std::uint64_t pricings = 0;      ///< cut-generating programs
  std::uint64_t rounds = 0;
};

/// How the root ended.
enum class RootStatus {
  closed,       ///< the ends meet
  open,         ///< no further cut, and a gap: the tree has to go on
  not_carried,  ///< an admissible dead load is carried at no factor: the worst case is -infinity
  unbounded,    ///< the cuts give no finite bound, and no such load was found
  stopped,      ///< it was asked to end; what it has found so far holds
  failed,       ///< the simplex method failed; likewise
};

struct RootResult {
  RootStatus status = RootStatus::failed;
  std::optional<Worst> worst;           ///< the upper end
  Eigen::VectorXd overpowering_load;    ///< of not_carried: zeta
  Eigen::VectorXd overpowering_motion;  ///< what shows it; may be empty
  /// By the simplex method, scaled; minus infinity: none yet. See `proof`.
  double lower = -linear::infinity;
  std::vector<StaticCut> cuts;
  StaticProof proof;    ///< of the lower end; no forces: none
  linear::Basis basis;  ///< of the last relaxation
  WorstCaseCounts counts;
};

/// Descends from the worst load of a motion; `worst` becomes what is found if that is worse, or
/// what is overpowering. @return false if a load on the way is carried at no factor
bool descend_from(const problems::LimitModel& model, double alpha, LoadFactor& load_factor,
                  const Eigen::VectorXd& motion, RootResult& result);

/// Told after each round: the ends so far, scaled.
using RoundWatcher = std::function<void(std::uint64_t round, double lower, double upper)>;

/// What goes on around the rounds. Ranks that work together must be given the same answers.
struct RootControl {
  support::Stop stop = {};
  RoundWatcher watcher = {};
};

/// @param alpha scaled, >= 0
/// @param nominal the collapse without uncertainty, which `load_factor` has solved
RootResult solve_root(const problems::LimitModel& model, double alpha, const Collapse& nominal,
                      LoadFactor& load_factor, const Pricer& pricer,
                      const RootControl& control = {});

/// A proof of the bound at a node with these signs and cuts, for yield forces smaller by `share`:
/// where the first one has too little room. Nothing if the simplex method fails.
/// @param for_all also for members that seem to have no choice
std::optional<StaticProof> proof_with_room(const problems::LimitModel& model, double alpha,
                                           std::span<const StaticCut> cuts, const Signs& signs,
                                           double share, bool for_all);

/// The share of the yield forces that a first proof leaves: enough where the simplex method leaves
/// no more than rounding.
inline constexpr double first_room = 1e-11;

/// How much the point leaves |d_j'u| and gamma_j apart, for each column of T, times its weight.
Eigen::VectorXd looseness(const problems::LimitModel& model, const Relaxed& point);

/// The weights of the pricing programs: z plus `share` of its mean, so that the forces of members
/// that do not move are determined in the cuts.
Eigen::VectorXd pricing_aim(const Eigen::VectorXd& z, double share);

}  // namespace kusabi::limit
