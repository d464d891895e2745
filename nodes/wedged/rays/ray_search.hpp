// All extremal rays and maximal cones of wedged configurations in the plane, by the faster of two
// methods (Algorithms 4.1 to 4.3 of the wedged paper): the analysis of `kusabi rays`.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/rays/ray_tree.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "solvers/rays/double_description.hpp"
#include "solvers/rays/maximal_cones.hpp"
#include "solvers/rays/reaction_cone.hpp"

namespace kusabi::wedged {

/// Method of finding rays. Both methods have the same result.
enum class RayMethod {
  automatic,  ///< Algorithm 4.2, unless sampling or a long list shows the tree to be faster
  double_description,  ///< Algorithm 4.2: every rank has all rays, large steps are distributed
  tree,                ///< for each pattern, on all ranks
};

/// True if these limits may stop a search early.
bool limited(const engine::Limits& limits);

/// Statistics of the tree of sign patterns or of lists.
struct RayTreeReport {
  SignPatternTally patterns;
  std::uint64_t opened = 0;
  std::uint64_t open = 0;
  std::uint64_t fingerprint = 0;
  std::vector<engine::RankReport<RayTree>> ranks;
};

/// Result and method, on rank 0.
struct RayFindings {
  engine::Status status = engine::Status::solved;
  std::vector<rays::ZeroSet> rays;  ///< in the order of all answers; without recorded ones
  std::uint64_t kept = 0;           ///< number of rays that a recorder has taken
  /// Rigid-body modes of unconstrained bodies that move away without reactions. Every configuration
  /// is a combination of these and the rays; modes alone are not wedged.
  std::vector<rays::ZeroSet> motions;
  std::vector<rays::Cone> cones;                     ///< maximal; none if the search stopped early
  rays::Health health;                               ///< of the search
  RayMethod method = RayMethod::double_description;  ///< the chosen method
  std::optional<RayTreeReport> tree;                 ///< of a tree of either kind; nothing: no tree
  rays::Cost cost;                                   ///< of double description without a tree
  double seconds = 0;  ///< duration of double description without a tree

  /// Number of rays.
  [[nodiscard]] std::uint64_t count() const { return rays.size() + kept; }
};

/// The cone of reactions of a problem in the plane, including unconstrained bodies.
/// @param friction of each candidate
/// @throws std::invalid_argument if there are more than 64 candidates
rays::ReactionCone reaction_cone(const problems::WedgedProblem& problem,
                                 std::span<const double> friction);

/// Every rank makes the same call.
/// @throws std::invalid_argument if the cone lacks the unconstrained bodies of the problem
/// @param problem in the plane  @param friction of each candidate
/// @param cone of the same problem and friction, which computes rays of zero sets
/// @param method double description ignores limits
/// @param recorder takes the rays of a tree of either kind; the findings then have no cones, which
///   find_cones() adds. Empty: the findings have all rays and cones
RayFindings find_rays(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                      std::span<const double> friction, const rays::ReactionCone& cone,
                      RayMethod method, const RayRecorder& recorder = {});

/// Adds the maximal cones to the findings of a complete search, on rank 0.
/// @param of_rays the cones of all rays @param all candidates
void find_cones(RayFindings& found, rays::ConesOfRays of_rays, rays::Candidates all,
                const engine::Budget& budget);

}  // namespace kusabi::wedged
