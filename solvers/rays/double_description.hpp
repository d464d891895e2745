// The double description method for cones of reactions: the paper's Algorithm 4.2, which keeps the
// complementary rays only, and the plain method in the cone D(Y) of one sign pattern.
//
// The cone {x >= 0} of some candidates' p and q is intersected with one half-space u_ni >= 0 after
// another. Each such step keeps the rays with u_ni >= 0 and adds, for each adjacent pair of rays on
// different sides, the one between them. Algorithm 4.2 is corrected in two places, and the rank
// test of Remark 4.6 is replaced by a comparison of bits; docs/theory/rays.md proves both.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "solvers/rays/health.hpp"
#include "solvers/rays/reaction_cone.hpp"
#include "solvers/rays/zero_set.hpp"

namespace kusabi::rays {

/// What an enumeration cost.
struct Effort {
  std::uint64_t peak_rays = 0;  ///< most rays at one time
  std::uint64_t pairs = 0;      ///< pairs of rays that were looked at one by one
  std::uint64_t adjacent = 0;   ///< of these were adjacent, and gave a new ray

  Effort& operator+=(const Effort& other);

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& peak_rays& pairs& adjacent;
  }
};

/// Zero sets of extremal rays, in no particular order.
struct Enumeration {
  std::vector<ZeroSet> rays;
  Effort effort;
  Health health;
};

/// All extremal rays of C_r that satisfy u_n^T r_n = 0 (Algorithm 4.2).
/// @param most_rays at one time: with more, nothing is returned
/// @param stop asked now and then whether to end: then nothing is returned, too; empty: never
std::optional<Enumeration> complementary_rays(const ReactionCone& cone, std::uint64_t most_rays,
                                              const std::function<bool()>& stop = {});
Enumeration complementary_rays(const ReactionCone& cone);

/// How many rays at one time fit into so many bytes.
std::uint64_t rays_that_fit(std::uint64_t bytes, int candidates);

/// All extremal rays of D(Y) = {r in C_r: u_n = 0 on `contact`, r = 0 elsewhere}. They are extremal
/// rays of C_r, since D(Y) is one of its faces.
Enumeration rays_of_pattern(const ReactionCone& cone, Candidates contact);

}  // namespace kusabi::rays
