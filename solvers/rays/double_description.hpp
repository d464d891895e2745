// The double description method for cones of reactions: the paper's Algorithm 4.2, which keeps the
// complementary rays only, and the plain method in the cone D(Y) of one sign pattern.
//
// The cone {x >= 0} of some candidates' p and q is intersected with one half-space u_ni >= 0 after
// another. Each such step keeps the rays with u_ni >= 0 and adds, for each adjacent pair of rays on
// different sides, the one between them. Algorithm 4.2 is corrected in two places, and the rank
// test of Remark 4.6 is replaced by a comparison of bits; docs/theory/rays.md proves both.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
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

/// Rays that a step adds, and what it took to find them.
struct NewRays {
  std::vector<ZeroSet> zeros;
  std::vector<double> coordinates;  ///< one ray after another
  Effort effort;
  bool stopped = false;  ///< before all were found

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& zeros& coordinates& effort& stopped;
  }
};

/// How an enumeration is supervised, and by how many it is done.
struct Conduct {
  /// Rays at one time: with more it ends, if they can be divided.
  std::uint64_t most_rays = std::numeric_limits<std::uint64_t>::max();

  /// Asked now and then whether to end. Empty: never.
  std::function<bool()> stop = {};

  /// Does pieces of work 0, ..., count - 1 by one function and returns all results in order; empty:
  /// there is nobody to share with. All who share make the same enumeration, and large steps are
  /// shared. The answer does not depend on it.
  std::function<std::vector<NewRays>(std::uint64_t count,
                                     const std::function<NewRays(std::uint64_t)>& piece)>
      share = {};
  /// Where work is shared: makes one answer of what each of those who share it was told by `stop`.
  std::function<bool(bool)> agree = {};

  /// Asked after each step, with the effort so far, the same for all who share: whether to end, as
  /// with `stop`. Empty: never.
  std::function<bool(const Effort& effort)> give_up = {};
};

/// Where Algorithm 4.2 is: what the cone has been cut by, and its rays that are complementary
/// there; or those of them that lie on the face {u_n = 0 on `contact`, r = 0 on `separated`}, a
/// part of the list, with which it can be gone on by itself (docs/theory/rays.md).
struct RayList {
  ReactionCone::Stage done;
  Candidates contact = 0;  ///< of the candidates done, as `separated`
  Candidates separated = 0;
  std::vector<ZeroSet> zeros;
  std::vector<double> coordinates;  ///< one ray after another

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& done.gaps& done.balanced& contact& separated& zeros& coordinates;
  }
};

/// Before the first step: the cone x >= 0.
RayList first_list(const ReactionCone& cone);

/// What some steps cost, and saw.
struct Steps {
  Effort effort;
  Health health;
  bool stopped = false;  ///< by `stop` or `give_up`; the list is of no more use
};

/// Goes on with a list until all steps are done, or as `conduct` says.
Steps go_on(RayList& list, const ReactionCone& cone, const Conduct& conduct);

/// Whether all steps are done: the list is that of its face.
bool has_ended(const RayList& list, const ReactionCone& cone);

/// The parts of a list on the two faces u_ni = 0 and r_i = 0 of a candidate i that has been cut by,
/// in this order, such that both are short; the rays idle at i are in both. Nothing if at no
/// candidate some rays have a reaction and others a gap.
std::optional<std::array<RayList, 2>> divided(const RayList& list);

/// All extremal rays of C_r that satisfy u_n^T r_n = 0 (Algorithm 4.2), those of motions alone
/// (r = 0) among them; nothing if `conduct` has ended it.
std::optional<Enumeration> complementary_rays(const ReactionCone& cone, const Conduct& conduct);
Enumeration complementary_rays(const ReactionCone& cone);

/// About how many bytes it takes to have so many rays at one time.
std::uint64_t bytes_for(std::uint64_t rays, int candidates);

/// All extremal rays of D(Y) = {r in C_r: u_n = 0 on `contact`, r = 0 elsewhere}. They are extremal
/// rays of C_r, since D(Y) is one of its faces.
Enumeration rays_of_pattern(const ReactionCone& cone, Candidates contact);

/// The same, with pauses, for whoever does not know whether it is worth its cost.
class PatternRaysByTurns {
 public:
  /// @param cone outlives this object
  PatternRaysByTurns(const ReactionCone& cone, Candidates contact);
  PatternRaysByTurns(PatternRaysByTurns&&) noexcept;
  PatternRaysByTurns& operator=(PatternRaysByTurns&&) noexcept;
  ~PatternRaysByTurns();

  /// Goes on until it has looked at more than so many pairs, all turns together, or has all rays.
  /// A step is not broken off. @return whether it has all rays
  bool go_on(std::uint64_t most_pairs);

  /// @pre go_on has returned true
  Enumeration result() &&;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace kusabi::rays
