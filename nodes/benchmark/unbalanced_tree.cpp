// Number of children of a node. The expressions are evaluated as published, operation by operation,
// since a different rounding would give another tree.
#include "nodes/benchmark/unbalanced_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/search.hpp"

namespace kusabi::benchmark {
namespace {

constexpr std::uint32_t max_children = 100;

// Uniform in [0, 1): the lower 31 bits of the state.
double random_number(const UnbalancedTree::Node& node) {
  constexpr double range = 2147483648.0;  // 2^31
  return (node.state[4] & 0x7FFFFFFFU) / range;
}

double mean_children(const TreeParameters& tree, std::uint32_t depth) {
  const double b = tree.branching;
  const double h = depth;
  const double d = tree.depth;
  if (depth == 0) return b;
  switch (tree.shape) {
    case TreeShape::linear:
      return b * (1.0 - h / d);
    case TreeShape::exponential:
      return b * std::pow(h, -std::log(b) / std::log(d));
    case TreeShape::cyclic:
      return h > 5 * d ? 0.0 : std::pow(b, std::sin(2.0 * std::numbers::pi * h / d));
    case TreeShape::fixed:
      return depth < tree.depth ? b : 0.0;
  }
  return 0;
}

// Inverse of the geometric distribution function of the given mean.
std::uint32_t geometric_children(double mean, double random) {
  if (mean <= 0) return 0;
  const double p = 1.0 / (1.0 + mean);
  const double children = std::floor(std::log(1.0 - random) / std::log(1.0 - p));
  return static_cast<std::uint32_t>(std::min<double>(children, max_children));
}

}  // namespace

std::uint32_t UnbalancedTree::children(const Node& node) const {
  const auto& tree = parameters_;
  if (tree.type == TreeType::binomial && node.depth == 0) {
    return static_cast<std::uint32_t>(tree.branching);
  }
  const double random = random_number(node);
  const bool geometric = tree.type == TreeType::geometric ||
                         (tree.type == TreeType::hybrid && node.depth < 0.5 * tree.depth);
  if (geometric) return geometric_children(mean_children(tree, node.depth), random);
  return random < tree.probability ? std::min(tree.binomial_children, max_children) : 0;
}

}  // namespace kusabi::benchmark

template kusabi::engine::OutcomeOf<kusabi::benchmark::UnbalancedTree> kusabi::engine::search(
    kusabi::benchmark::UnbalancedTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
