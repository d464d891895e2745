// All extremal rays and maximal cones of wedged configurations in the plane:
//   rays plane-truss.toml 0.8
#include <cstdio>
#include <cstdlib>

#include "engine/transport/single_process.hpp"
#include "nodes/wedged/rays/ray_search.hpp"
#include "nodes/wedged/tree/candidate_friction.hpp"
#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/wedged/wedged_problem.hpp"

using namespace kusabi;

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto structure = problems::read_structure(problems::problem_text(argv[1]), argv[1]);
  const auto problem = problems::wedged_problem(structure);
  const auto friction = wedged::candidate_friction(problem, std::atof(argv[2]));
  const auto cone = wedged::reaction_cone(problem, friction);

  engine::SingleProcess alone;
  engine::Analysis analysis(alone);
  auto found = wedged::find_rays(analysis, problem, friction, cone, wedged::RayMethod::automatic);
  for (const auto& zero_set : found.rays) {
    const auto ray = cone.ray(zero_set, found.health);
    std::printf("r_n:");
    for (int i = 0; i < cone.candidates(); ++i) std::printf(" %.4g", ray.reaction(2 * i));
    std::printf("\n");
  }
  std::printf("%zu extremal rays in %zu maximal cones\n", found.rays.size(), found.cones.size());
  return found.health.sound() ? 0 : 1;
}
