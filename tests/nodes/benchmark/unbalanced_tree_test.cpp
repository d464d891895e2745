// Unbalanced Tree Search tests: the hash, the published counts, and the same counts on many
// simulated ranks.
#include "nodes/benchmark/unbalanced_tree.hpp"

#include <algorithm>
#include <array>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "engine/simulation.hpp"
#include "nodes/benchmark/standard_trees.hpp"
#include "support/sha1.hpp"

namespace kusabi::benchmark {

// Printed by a failing test.
std::ostream& operator<<(std::ostream& out, const TreeCounts& counts) {
  return out << counts.nodes << " nodes, " << counts.leaves << " leaves, depth " << counts.depth;
}

namespace {

// Examples of FIPS 180, and the digest of the empty message.
TEST(Sha1, GivesTheDigestsOfTheStandard) {
  EXPECT_EQ(support::sha1(""),
            (support::Sha1Digest{0xDA39A3EE, 0x5E6B4B0D, 0x3255BFEF, 0x95601890, 0xAFD80709}));
  EXPECT_EQ(support::sha1("abc"),
            (support::Sha1Digest{0xA9993E36, 0x4706816A, 0xBA3E2571, 0x7850C26C, 0x9CD0D89D}));
  EXPECT_EQ(support::sha1("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            (support::Sha1Digest{0x84983E44, 0x1C3BD26E, 0xBAAE4AA1, 0xF95129E5, 0xE54670F1}));
  EXPECT_EQ(support::sha1(std::string(1'000'000, 'a')),
            (support::Sha1Digest{0x34AA973C, 0xD4C4DAA4, 0xF61EEB2B, 0xDBAD2731, 0x6534016F}));
}

TEST(Sha1, PiecesHaveTheDigestOfTheWhole) {
  std::string message;
  for (int i = 0; i < 300; ++i) message += static_cast<char>('a' + i % 23);
  for (std::size_t first = 0; first <= 130; ++first) {
    for (const std::size_t second : {0, 1, 63, 64, 65, 129}) {
      support::Sha1Stream stream;
      stream.add(std::string_view(message).substr(0, first));
      stream.add(std::string_view(message).substr(first, second));
      stream.add(std::string_view(message).substr(first + second));
      EXPECT_EQ(stream.digest(), support::sha1(message)) << first << " " << second;
    }
  }
  EXPECT_EQ(support::hexadecimal(support::sha1("abc")), "a9993e364706816aba3e25717850c26c9cd0d89d");
}

TEST(Sha1, WordsAreHashedInBigEndianOrder) {
  EXPECT_EQ(support::sha1(std::array<std::uint32_t, 2>{0x61626364, 0x65666768}),
            support::sha1("abcdefgh"));
  EXPECT_EQ(support::sha1(std::array<std::uint32_t, 0>{}), support::sha1(""));
}

class PublishedTree : public testing::TestWithParam<const char*> {};

TEST_P(PublishedTree, HasItsPublishedCounts) {
  const auto& standard = standard_tree(GetParam());
  UnbalancedTree tree(standard.parameters);
  const auto outcome = engine::search(tree);
  EXPECT_EQ(outcome.tally(), standard.counts);
  EXPECT_EQ(outcome.opened(), standard.counts.nodes);
}

INSTANTIATE_TEST_SUITE_P(Uts, PublishedTree,
                         testing::Values("T1-4", "T1-6", "T1-7", "T1", "T2", "T3", "T4", "T5"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(StandardTrees, AnUnknownNameIsRefused) {
  EXPECT_THROW(standard_tree("T9"), std::out_of_range);
}

TEST(UnbalancedTree, HasTheSameCountsWithMoreWorkPerNode) {
  const auto& standard = standard_tree("T1-4");
  UnbalancedTree tree(standard.parameters, 3);
  EXPECT_EQ(engine::search(tree).tally(), standard.counts);
}

TEST(UnbalancedTree, HasTheSameCountsOnAnyNumberOfRanks) {
  const auto& standard = standard_tree("T1-6");
  const UnbalancedTree tree(standard.parameters);
  for (const int ranks : {1, 2, 4, 7, 32}) {
    const auto seed = static_cast<std::uint64_t>(ranks);
    const auto together = engine::simulate(tree, ranks, seed, {.stall_probability = 0.001});
    EXPECT_EQ(together.outcome.tally(), standard.counts) << ranks << " ranks";
    EXPECT_EQ(together.left_behind, 0U) << ranks << " ranks";
  }
}

}  // namespace
}  // namespace kusabi::benchmark
