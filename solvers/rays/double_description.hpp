// Double description method for cones of reactions: Algorithm 4.2 of the wedged paper, which keeps
// the complementary rays only, and the plain method in the cone D(Y) of one sign pattern.
//
// The cone {x >= 0} of some candidates' p and q is intersected with one half-space u_ni >= 0 after
// another. Each step keeps the rays with u_ni >= 0 and adds, for each adjacent pair of rays on
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

/// Cost of an enumeration.
struct Cost {
  std::uint64_t peak_rays = 0;  ///< maximum number of rays
  std::uint64_t pairs = 0;      ///< pairs of rays tested individually
  std::uint64_t adjacent = 0;   ///< adjacent pairs, each of which gave a new ray

  Cost& operator+=(const Cost& other);

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& peak_rays& pairs& adjacent;
  }
};

/// Zero sets of extremal rays, in no particular order.
struct Enumeration {
  std::vector<ZeroSet> rays;
  Cost cost;
  Health health;
};

/// Rays added by a step, and the cost of finding them.
struct NewRays {
  std::vector<ZeroSet> zeros;
  std::vector<double> coordinates;  ///< one ray after another
  Cost cost;
  bool stopped = false;  ///< before all were found

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& zeros& coordinates& cost& stopped;
  }
};

/// Limits, stop requests and parallelism of an enumeration.
struct EnumerationOptions {
  /// Maximum number of rays: above it the enumeration ends, if the list can be divided.
  std::uint64_t max_rays = std::numeric_limits<std::uint64_t>::max();

  /// Called now and then; true ends the enumeration. With sharing it may differ between the ranks:
  /// it then ends shared pieces, and `agree` combines it after each step. Empty: never.
  std::function<bool()> stop = {};

  /// Computes the pieces of work 0, ..., count - 1 by one function and returns all results in
  /// order; empty: no sharing. All ranks make the same enumeration, and large steps are shared. The
  /// result does not depend on it.
  std::function<std::vector<NewRays>(std::uint64_t count,
                                     const std::function<NewRays(std::uint64_t)>& piece)>
      share = {};
  /// With sharing: combines the results of `stop` on all ranks into one.
  std::function<bool(bool)> agree = {};

  /// Called after each step, with the cost so far, the same on all ranks; true ends the enumeration
  /// as `stop` does. Empty: never.
  std::function<bool(const Cost& cost)> give_up = {};
};

/// State of Algorithm 4.2: the processed candidates and the rays that are complementary there; or
/// those of them on the face {u_n = 0 on `contact`, r = 0 on `separated`}, a part of the list that
/// can be processed separately (docs/theory/rays.md).
struct RayList {
  ReactionCone::Stage done;
  Candidates contact = 0;  ///< processed candidates, as `separated`
  Candidates separated = 0;
  std::vector<ZeroSet> zeros;
  std::vector<double> coordinates;  ///< one ray after another

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& done.gaps& done.balanced& contact& separated& zeros& coordinates;
  }
};

/// Initial list: the cone x >= 0.
RayList first_list(const ReactionCone& cone);

/// Cost and numerical health of some steps.
struct StepsResult {
  Cost cost;
  Health health;
  bool stopped = false;  ///< by `stop` or `give_up`; the list is then invalid
};

/// Resumes a list until all steps are done, or until a limit of `options`.
StepsResult resume(RayList& list, const ReactionCone& cone, const EnumerationOptions& options);

/// True if all steps are done: the list is then that of its face.
bool has_ended(const RayList& list, const ReactionCone& cone);

/// The parts of a list on the two faces u_ni = 0 and r_i = 0 of a processed candidate i, in this
/// order, such that both are short; the rays inactive at i are in both. Nothing if at no candidate
/// some rays have a reaction and others a gap.
std::optional<std::array<RayList, 2>> divided(const RayList& list);

/// All extremal rays of C_r that satisfy u_n^T r_n = 0 (Algorithm 4.2), including those of modes
/// alone (r = 0); nothing if `options` ended it.
std::optional<Enumeration> complementary_rays(const ReactionCone& cone,
                                              const EnumerationOptions& options);
Enumeration complementary_rays(const ReactionCone& cone);

/// Approximate memory, in bytes, for this number of rays.
std::uint64_t bytes_for(std::uint64_t rays, int candidates);

/// All extremal rays of D(Y) = {r in C_r: u_n = 0 on `contact`, r = 0 elsewhere}. They are extremal
/// rays of C_r, since D(Y) is one of its faces.
Enumeration rays_of_pattern(const ReactionCone& cone, Candidates contact);

/// The same; nothing if `stop`, which is called now and then, returned true.
std::optional<Enumeration> rays_of_pattern(const ReactionCone& cone, Candidates contact,
                                           std::function<bool()> stop);

/// As rays_of_pattern, in resumable turns of limited cost.
class PatternRaysByTurns {
 public:
  /// @param cone outlives this object
  /// @param stop called now and then; after it returned true, resume returns false and the object
  ///   is of no use. Empty: never
  PatternRaysByTurns(const ReactionCone& cone, Candidates contact, std::function<bool()> stop = {});
  PatternRaysByTurns(PatternRaysByTurns&&) noexcept;
  PatternRaysByTurns& operator=(PatternRaysByTurns&&) noexcept;
  ~PatternRaysByTurns();

  /// Resumes until more than `max_pairs` pairs were tested, over all turns, or all rays are found.
  /// Only `stop` interrupts a step. @return true if all rays are found
  bool resume(std::uint64_t max_pairs);

  /// @pre resume has returned true
  Enumeration result() &&;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace kusabi::rays
