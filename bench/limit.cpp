// Worst-case limit loads of random trusses with a gap after static cuts, so that the tree of signs
// is measured. (bench/limit.py: grids.)
//
//   bench_limit [TRUSSES]    random trusses with 6 nodes at integer coordinates, yield force 1
#include <array>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <random>
#include <span>
#include <string>

#include <fmt/format.h>

#include "engine/search.hpp"
#include "nodes/limit/search/sign_tree.hpp"
#include "problems/limit/limit_problem.hpp"
#include "support/input_error.hpp"

namespace {

using namespace kusabi;
using namespace kusabi::limit;

struct Solved {
  RootResult root;
  double minimum = 0;  // scaled
  std::uint64_t nodes = 1;
};

std::optional<Solved> solve(const problems::LimitModel& model, double alpha) {
  LoadFactor load_factor(model);
  StaticPricing pricing(model);
  if (load_factor.solve(model.dead) != LoadStatus::collapses) return {};
  Solved solved;
  solved.root = solve_root(model, alpha, load_factor.collapse(), load_factor,
                           [&](const Eigen::VectorXd& z, std::span<const int> columns) {
                             return price_alone(pricing, z, columns);
                           });
  if (!solved.root.worst) return solved;
  solved.minimum = solved.root.worst->collapse.factor;
  if (solved.root.status != RootStatus::open) return solved;
  SignTree tree(model, alpha, solved.root, false);
  engine::Options options;
  options.goal = engine::Goal::best;
  const auto outcome = engine::search(tree, options);
  solved.nodes = outcome.opened();
  if (!outcome.solutions.empty()) solved.minimum = outcome.solutions.front().solution.factor;
  return solved;
}

problems::Structure random_truss(std::mt19937& bits) {
  constexpr int nodes = 6;
  problems::Structure truss;
  truss.name = "random";
  truss.dimension = 2;
  truss.units = {"m", "kN"};
  truss.coordinates.resize(2, nodes);
  for (int node = 0; node < nodes; ++node) {
    truss.coordinates.col(node) << static_cast<double>(bits() % 4), static_cast<double>(bits() % 4);
    truss.node_names.push_back(fmt::format("{}", node));
    truss.fixed.push_back(node < 2 ? std::array{true, true, false} : std::array<bool, 3>{});
  }
  for (int first = 0; first < nodes; ++first) {
    for (int second = first + 1; second < nodes; ++second) {
      if (bits() % 8 == 0) continue;
      truss.members.push_back(
          {.first = first, .second = second, .yield = problems::YieldForces{1, 1}});
    }
  }
  const Eigen::Vector2d force = bits() % 2 == 0 ? Eigen::Vector2d(1, 0) : Eigen::Vector2d(0, 1);
  truss.loads.push_back({problems::Load::Kind::reference, nodes - 1, force});
  return truss;
}

void gaps(std::uint32_t count) {
  int solved_count = 0;
  int gap_count = 0;
  std::uint64_t nodes = 0;
  for (std::uint32_t seed = 0; seed < count; ++seed) {
    std::mt19937 bits(seed);
    const auto truss = random_truss(bits);
    const double alpha = 0.05 * static_cast<double>(1 + bits() % 10);
    try {
      const auto model = limit_model(limit_problem(checked(truss)));
      const auto solved = solve(model, alpha / model.force_unit);
      if (!solved || !solved->root.worst) continue;
      ++solved_count;
      const double gap = solved->minimum - solved->root.lower;
      constexpr double visible = 1e-6;
      if (solved->root.status != RootStatus::open || gap < visible) continue;
      ++gap_count;
      nodes += solved->nodes;
      fmt::print("seed {}: alpha {}, bound {:.6f}, least factor {:.6f}, {} nodes\n", seed, alpha,
                 solved->root.lower * model.factor_unit, solved->minimum * model.factor_unit,
                 solved->nodes);
    } catch (const support::InputError&) {
      continue;  // two nodes at one point, or a mechanism
    }
  }
  fmt::print("{} of {} trusses with a gap; {} nodes in their trees\n", gap_count, solved_count,
             nodes);
}

}  // namespace

int main(int argc, char** argv) {
  const std::span<char*> arguments(argv, static_cast<std::size_t>(argc));
  constexpr std::uint32_t usual = 20000;
  gaps(arguments.size() > 1 ? static_cast<std::uint32_t>(std::stoul(arguments[1])) : usual);
}
