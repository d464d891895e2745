// Maximal families of cross-complementary rays: section 4.3 and equation (11) of the wedged paper.
//
// Two rays are cross-complementary if at no candidate one has a reaction and the other a gap. The
// paper computes the maximal cliques of that graph. A clique leaves to each candidate either no
// reaction or no gap, so it lies within a sign pattern: processing the candidates one by one finds
// all cliques without the graph (docs/theory/rays.md).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "solvers/rays/zero_set.hpp"

namespace kusabi::rays {

/// One maximal cone. Its rays have no reaction on `separated` and no gap on `reaction`; some ray
/// has a gap at each candidate of `separated`, some ray a reaction at each of `reaction`.
struct Cone {
  Candidates reaction = 0;
  Candidates separated = 0;

  friend bool operator==(const Cone&, const Cone&) = default;
};

/// True if a ray belongs to a cone.
inline bool belongs(const Supports& ray, const Cone& cone) {
  return (ray.reaction() & cone.separated) == 0 && (ray.separated() & cone.reaction) == 0;
}

/// The cone of a single ray.
Cone cone_of(const Supports& ray);

/// The cones of many rays, each once: most rays differ from others in their sliding only.
class ConesOfRays {
 public:
  void add(const Cone& ray);

  /// The cones so far, sorted by bits.
  const std::vector<Cone>& sorted();

 private:
  std::vector<Cone> cones_;
  std::size_t sorted_ = 0;  // number of different cones when they were last sorted
};

/// All maximal cones, in the order of their reactions.
std::vector<Cone> maximal_cones(std::span<const ZeroSet> rays, Candidates all);

/// The same; nothing if `stop`, which is called now and then, returned true.
/// @param rays the cones of all rays
std::optional<std::vector<Cone>> maximal_cones(ConesOfRays rays, Candidates all,
                                               const std::function<bool()>& stop);

}  // namespace kusabi::rays
