// Table of the standard trees, with the counts published in the benchmark's source
// (sample_trees.sh).
#include "nodes/benchmark/standard_trees.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace kusabi::benchmark {
namespace {

constexpr TreeParameters geometric(TreeShape shape, double branching, std::uint32_t depth,
                                   std::uint32_t seed) {
  return {.type = TreeType::geometric,
          .shape = shape,
          .branching = branching,
          .depth = depth,
          .seed = seed};
}

constexpr TreeParameters binomial(double branching, double probability, std::uint32_t children,
                                  std::uint32_t seed) {
  return {.type = TreeType::binomial,
          .branching = branching,
          .probability = probability,
          .binomial_children = children,
          .seed = seed};
}

constexpr TreeParameters hybrid_t4{.type = TreeType::hybrid,
                                   .shape = TreeShape::linear,
                                   .branching = 6,
                                   .depth = 16,
                                   .probability = 0.234375,
                                   .binomial_children = 4,
                                   .seed = 1};

constexpr std::array trees{
    StandardTree{"T1-4", geometric(TreeShape::fixed, 4, 4, 19), {944, 744, 4}},
    StandardTree{"T1-6", geometric(TreeShape::fixed, 4, 6, 19), {16000, 12839, 6}},
    StandardTree{"T1-7", geometric(TreeShape::fixed, 4, 7, 19), {63914, 51124, 7}},
    StandardTree{"T1", geometric(TreeShape::fixed, 4, 10, 19), {4130071, 3305118, 10}},
    StandardTree{"T2", geometric(TreeShape::cyclic, 6, 16, 502), {4117769, 2342762, 81}},
    StandardTree{"T3", binomial(2000, 0.124875, 8, 42), {4112897, 3599034, 1572}},
    StandardTree{"T4", hybrid_t4, {4132453, 3108986, 134}},
    StandardTree{"T5", geometric(TreeShape::linear, 4, 20, 34), {4147582, 2181318, 20}},
    StandardTree{"T1L", geometric(TreeShape::fixed, 4, 13, 29), {102181082, 81746377, 13}},
    StandardTree{"T2L", geometric(TreeShape::cyclic, 7, 23, 220), {96793510, 53791152, 67}},
    StandardTree{"T3L", binomial(2000, 0.200014, 5, 7), {111345631, 89076904, 17844}},
    StandardTree{"T1XL", geometric(TreeShape::fixed, 4, 15, 29), {1635119272, 1308100063, 15}},
};

}  // namespace

std::span<const StandardTree> standard_trees() {
  return trees;
}

const StandardTree& standard_tree(std::string_view name) {
  const auto found = std::find_if(trees.begin(), trees.end(),
                                  [&](const StandardTree& tree) { return tree.name == name; });
  if (found == trees.end()) throw std::out_of_range("no standard tree " + std::string(name));
  return *found;
}

}  // namespace kusabi::benchmark
