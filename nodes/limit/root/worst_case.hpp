// Worst-case load factor at the root: static cuts give lower bounds, alternating linear programs
// upper bounds, round by round until they meet. Otherwise nodes/limit/search/sign_tree continues.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "nodes/limit/model/limit_parameters.hpp"
#include "nodes/limit/model/load_factor.hpp"
#include "nodes/limit/model/static_cut.hpp"
#include "nodes/limit/root/master.hpp"

namespace kusabi::limit {

/// Gap of the scaled factor, which is of the order of one, at which the bounds meet: the simplex
/// method has rounding errors of about 1e-12, and engineering needs fewer than ten digits.
inline constexpr double closed_gap = 1e-8;

/// Columns of T in one block of pricing programs: each block starts from the same basis, so that
/// its results do not depend on its rank.
inline constexpr std::size_t pricing_block = 32;

/// Makes the best cuts for some columns of T at z, in their order. Some may be missing after a
/// stop.
using Pricer =
    std::function<std::vector<StaticCut>(const Eigen::VectorXd& z, std::span<const int> columns)>;

/// The cuts of one block. @pre pricing.set_point() was called for the round
std::vector<StaticCut> price_block(StaticPricing& pricing, std::span<const int> columns);

/// All blocks on this rank, one after another.
std::vector<StaticCut> price_alone(StaticPricing& pricing, const Eigen::VectorXd& z,
                                   std::span<const int> columns);

struct WorstCaseCounts {
  std::uint64_t load_factors = 0;  ///< programs (5)
  std::uint64_t relaxations = 0;   ///< programs of master.hpp
  std::uint64_t pricings = 0;      ///< cut-generating programs
  std::uint64_t rounds = 0;
};

/// Result of the root.
enum class RootStatus {
  closed,       ///< the bounds meet
  open,         ///< no further cut, and a gap: continue with the tree
  not_carried,  ///< an admissible dead load has no factor: the worst case is -infinity
  unbounded,    ///< the cuts give no finite bound, and no such load was found
  stopped,      ///< stopped; its results so far are valid
  failed,       ///< the simplex method failed; likewise
  enough,       ///< by splitting: a load with a factor below RootControl::enough, no lower bound
};

struct RootResult {
  RootStatus status = RootStatus::failed;
  std::optional<Worst> worst;           ///< the upper bound
  Eigen::VectorXd overpowering_load;    ///< of not_carried: zeta
  Eigen::VectorXd overpowering_motion;  ///< its proof; may be empty
  /// By the simplex method, scaled; minus infinity: none yet. See `proof`.
  double lower = -linear::infinity;
  std::vector<StaticCut> cuts;
  StaticProof proof;            ///< of the lower bound; no forces: none
  linear::Basis basis;          ///< of the last relaxation
  linear::Basis nominal_basis;  ///< of (5) under the nominal load
  /// Nodes of the tree of signs with at most this many undecided signs are divided into their
  /// corners.
  int enumerated = 0;
  WorstCaseCounts counts;
};

/// Descends from the worst load of a motion; `worst` is replaced by a worse result or by a load
/// without factor. @return false if a load has no factor
bool descend_from(const problems::LimitModel& model, double alpha, LoadFactor& load_factor,
                  const Eigen::VectorXd& motion, RootResult& result);

/// Called after each round with the bounds so far, scaled.
using RoundWatcher = std::function<void(std::uint64_t round, double lower, double upper)>;

/// Callbacks of the rounds. Ranks that work together must get the same answers.
struct RootControl {
  support::Stop stop = {};
  RoundWatcher watcher = {};
  /// Factor below which only the upper bound matters, scaled.
  double enough = -linear::infinity;
  Corners corners = Corners::never;  ///< in place of rounds
};

/// @param alpha scaled, >= 0
/// @param nominal the collapse without uncertainty, which `load_factor` has solved
RootResult solve_root(const problems::LimitModel& model, double alpha, const Collapse& nominal,
                      LoadFactor& load_factor, const Pricer& pricer,
                      const RootControl& control = {});

/// A proof of the bound at a node with these signs and cuts, for yield forces reduced by `share`,
/// if the first one has too small a margin. Nothing if the simplex method fails.
/// @param for_all also for members whose force seems to be determined by equilibrium
std::optional<StaticProof> proof_with_room(const problems::LimitModel& model, double alpha,
                                           std::span<const StaticCut> cuts, const Signs& signs,
                                           double share, bool for_all);

/// Reduction of the yield forces for a first proof: enough for the rounding errors of the simplex
/// method.
inline constexpr double first_room = 1e-11;

/// Difference of gamma_j and |d_j'u| at the point, for each column of T, times its weight.
Eigen::VectorXd violations_at(const problems::LimitModel& model, const Relaxed& point);

/// Weights of the pricing programs: z plus `share` of its mean, so that the forces of members
/// that do not move are determined in the cuts.
Eigen::VectorXd pricing_aim(const Eigen::VectorXd& z, double share);

}  // namespace kusabi::limit
