// Maximal cones: comparison with the definition, pair by pair, on more cones than are compared at a
// time.
#include "nodes/wedged/tree/maximal_cones.hpp"

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace kusabi::wedged {
namespace {

Configuration leaf(std::uint32_t block, LeafState state, std::uint64_t contact,
                   std::uint64_t separated) {
  Configuration made;
  made.block = block;
  made.state = state;
  made.pattern = {.contact = contact, .separated = separated, .inactive = {}};
  return made;
}

// Few candidates, such that many cones contain others; some numbers are above 64.
std::vector<Configuration> random_leaves(std::size_t count, std::mt19937& bits) {
  constexpr std::uint64_t few = 0x1f;
  std::vector<Configuration> leaves;
  for (std::size_t i = 0; i < count; ++i) {
    const auto contact = bits() & bits() & few;
    const auto separated = bits() & few & ~contact;
    const auto state = bits() % 3 == 0   ? LeafState::feasible
                       : bits() % 7 == 0 ? LeafState::marginal
                                         : LeafState::flat;
    leaves.push_back(leaf(bits() % 2, state, contact, separated));
    if (bits() % 2 == 0) leaves.back().pattern.separated.insert(70);
    if (bits() % 2 == 0) leaves.back().pattern.contact.insert(static_cast<int>(6 + bits() % 60));
  }
  return leaves;
}

bool is_cone(const Configuration& each) {
  return each.state == LeafState::feasible || each.state == LeafState::flat;
}

bool is_maximal(const Configuration& flat, const std::vector<Configuration>& leaves) {
  return std::ranges::none_of(leaves, [&](const auto& other) {
    return is_cone(other) && other.block == flat.block && other.pattern != flat.pattern &&
           within(flat.pattern, other.pattern);
  });
}

TEST(MaximalCones, AreThoseOfTheDefinition) {
  std::mt19937 bits(5);
  for (const std::size_t count : {0U, 1U, 50U, 12'000U}) {
    const auto leaves = random_leaves(count, bits);
    const auto kept = maximal_cones(leaves);
    EXPECT_TRUE(count < 50 || kept.size() < count);
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const auto& each = kept[i];
      EXPECT_TRUE(each.state != LeafState::flat || is_maximal(each, leaves)) << i;
    }
    // Every leaf is kept, or is a flat cone contained in one that is kept.
    for (const auto& each : leaves) {
      const bool there = std::ranges::any_of(kept, [&](const auto& other) {
        return other.block == each.block &&
               (each.state == LeafState::flat
                    ? is_cone(other) && within(each.pattern, other.pattern)
                    : other.state == each.state && other.pattern == each.pattern);
      });
      EXPECT_TRUE(there);
    }
    // Of equal flat cones one is kept.
    for (std::size_t i = 1; i < kept.size(); ++i) {
      if (kept[i].state != LeafState::flat || kept[i - 1].state != LeafState::flat) continue;
      EXPECT_FALSE(kept[i].block == kept[i - 1].block && kept[i].pattern == kept[i - 1].pattern);
    }
  }
}

}  // namespace
}  // namespace kusabi::wedged
