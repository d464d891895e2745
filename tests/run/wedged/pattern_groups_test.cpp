// Groups of random patterns, compared with reachability in a graph.
#include "run/wedged/pattern_groups.hpp"

#include <random>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kusabi::run {
namespace {

using support::IndexSet;
using wedged::Configuration;

Configuration pattern(std::uint32_t block, IndexSet contact, double margin) {
  Configuration one;
  one.block = block;
  one.pattern.contact = std::move(contact);
  one.lower = margin;
  return one;
}

std::vector<Configuration> random_patterns(unsigned seed, int count) {
  std::mt19937 random(seed);
  std::vector<Configuration> list;
  list.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    list.push_back(pattern(random() % 2, IndexSet(random() % 512), double(random() % 1000)));
  return list;
}

// By Warshall's algorithm, on counts of ones.
std::vector<std::vector<bool>> reachable(const std::vector<Configuration>& list,
                                         int max_differences) {
  const auto n = list.size();
  std::vector<std::vector<bool>> joined(n, std::vector<bool>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      int apart = 0;
      for (int c = 0; c < 9; ++c)
        apart += list[i].pattern.contact.contains(c) != list[j].pattern.contact.contains(c);
      joined[i][j] = list[i].block == list[j].block && apart <= max_differences;
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        if (joined[i][k] && joined[k][j]) joined[i][j] = true;
    }
  }
  return joined;
}

TEST(PatternGroups, AreConnectedByStepsOfFewCandidates) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto list = random_patterns(seed, 30);
    const int max_differences = 1 + static_cast<int>(seed % 3);
    const auto joined = reachable(list, max_differences);
    std::set<std::size_t> seen;
    double before = 1e9;
    for (const auto& group : pattern_groups(list, max_differences)) {
      for (std::size_t i = 0; i < list.size(); ++i) {
        const bool within = std::ranges::find(group.members, i) != group.members.end();
        EXPECT_EQ(within, joined[group.members.front()][i]) << seed;
        if (within) {
          EXPECT_TRUE(seen.insert(i).second);
          EXPECT_LE(list[i].lower, list[group.largest_margin].lower);
        }
      }
      for (int c = 0; c < 9; ++c) {
        const auto holds = std::ranges::count_if(
            group.members, [&](auto i) { return list[i].pattern.contact.contains(c); });
        EXPECT_EQ(group.contact.contains(c), holds == std::ssize(group.members));
        EXPECT_EQ(group.varying.contains(c), holds > 0 && holds < std::ssize(group.members));
      }
      EXPECT_LE(list[group.largest_margin].lower, before) << "the largest margin first";
      before = list[group.largest_margin].lower;
    }
    EXPECT_EQ(seen.size(), list.size());
  }
}

int apart(const Configuration& a, const Configuration& b) {
  int count = 0;
  for (int c = 0; c < 9; ++c)
    count += a.pattern.contact.contains(c) != b.pattern.contact.contains(c);
  return count;
}

TEST(PatternGroups, AroundLargestMarginsHaveNearMembersOfSmallerMargin) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto list = random_patterns(seed, 60);
    const int max_differences = 1 + static_cast<int>(seed % 3);
    const auto groups = groups_around_largest_margin(list, max_differences, list.size());
    ASSERT_TRUE(groups);
    std::set<std::size_t> seen;
    for (std::size_t g = 0; g < groups->size(); ++g) {
      const auto& group = (*groups)[g];
      const auto& first = list[group.largest_margin];
      IndexSet all = first.pattern.contact, some;
      for (const auto i : group.members) {
        EXPECT_TRUE(seen.insert(i).second);
        EXPECT_EQ(list[i].block, first.block);
        EXPECT_LE(list[i].lower, first.lower);
        EXPECT_LE(apart(list[i], first), max_differences);
        for (std::size_t before = 0; before < g; ++before) {  // no earlier group could contain it
          const auto& other = list[(*groups)[before].largest_margin];
          EXPECT_TRUE(other.block != list[i].block || apart(list[i], other) > max_differences);
        }
        all &= list[i].pattern.contact;
        some |= list[i].pattern.contact;
      }
      EXPECT_EQ(group.contact, all);
      EXPECT_EQ(group.varying, some - all);
      const auto before = g > 0 ? list[(*groups)[g - 1].largest_margin].lower : first.lower;
      EXPECT_LE(first.lower, before) << "the largest margin first";
    }
    EXPECT_EQ(seen.size(), list.size());
    EXPECT_EQ(groups_around_largest_margin(list, max_differences, groups->size())->size(),
              groups->size());
    EXPECT_FALSE(groups_around_largest_margin(list, max_differences, groups->size() - 1));
  }
}

TEST(PatternGroups, OfAnEmptyListAreNone) {
  EXPECT_TRUE(pattern_groups({}, 1).empty());
  EXPECT_TRUE(groups_around_largest_margin({}, 1, 1)->empty());
}

}  // namespace
}  // namespace kusabi::run
