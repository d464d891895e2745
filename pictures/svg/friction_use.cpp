// Reactions are vectors in global axes; the normal part is that along the candidate's normal.
#include "pictures/svg/friction_use.hpp"

namespace kusabi::pictures {

double friction_use(const DrawnCandidate& candidate) {
  const double normal = candidate.reaction.dot(candidate.normal);
  const double cone = candidate.friction * normal;
  if (!(cone > 0)) return 0;
  return (candidate.reaction - normal * candidate.normal).norm() / cone;
}

bool is_loaded(const DrawnCandidate& candidate, const Scales& scales) {
  constexpr double min_share = 0.01;
  return candidate.state == ContactState::contact &&
         (scales.largest_reaction == 0 ||
          candidate.reaction.norm() > min_share * scales.largest_reaction);
}

int use_shade(double use) {
  int shade = 0;
  while (shade + 1 < use_shades && use >= use_steps[shade + 1]) ++shade;
  return shade;
}

}  // namespace kusabi::pictures
