// All extremal rays and maximal cones of wedged configurations in the plane, by whichever way is
// faster (Algorithms 4.1 to 4.3 of the wedged paper): the question that `kusabi rays` asks.
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

/// How rays are found. Both ways find the same.
enum class RayMethod {
  automatic,  ///< Algorithm 4.2, its list divided when it is long, unless a trial shows the tree to
              ///< be faster
  double_description,  ///< Algorithm 4.2: every rank has all rays, large steps are shared
  tree,                ///< pattern by pattern, on all ranks
};

/// Whether a search by these limits may stop early.
bool limited(const engine::Limits& limits);

/// What the tree was like, of sign patterns or of lists.
struct RayTreeReport {
  SignPatternTally patterns;
  std::uint64_t opened = 0;
  std::uint64_t open = 0;
  std::uint64_t fingerprint = 0;
  std::vector<engine::RankReport<RayTree>> ranks;
};

/// What has been found, and how; on rank 0.
struct RayFindings {
  engine::Status status = engine::Status::solved;
  std::vector<rays::ZeroSet> rays;  ///< in the order of every answer
  /// Of bodies that nothing holds: the ways to move off without any reaction. With these and the
  /// rays every configuration is a sum; by themselves they are not wedged.
  std::vector<rays::ZeroSet> motions;
  std::vector<rays::Cone> cones;                     ///< maximal; none if the search stopped early
  rays::Health health;                               ///< of the search
  RayMethod method = RayMethod::double_description;  ///< which was taken
  std::optional<RayTreeReport> tree;                 ///< if there was one, of either kind
  rays::Effort effort;                               ///< otherwise, and
  double seconds = 0;                                ///< the time
};

/// The cone of reactions of a structure in the plane, loose bodies included.
/// @param problem of the structure  @param friction of each candidate
/// @throws std::invalid_argument if there are more than 64 candidates
rays::ReactionCone reaction_cone(const problems::Structure& structure,
                                 const problems::WedgedProblem& problem,
                                 std::span<const double> friction);

/// Every rank makes the same call.
/// @throws std::invalid_argument if the cone knows nothing of the loose bodies of the problem
/// @param problem in the plane  @param friction of each candidate
/// @param cone of the same problem and friction, which makes rays of zero sets
/// @param method double description heeds no limits
RayFindings find_rays(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                      std::span<const double> friction, const rays::ReactionCone& cone,
                      RayMethod method);

}  // namespace kusabi::wedged
