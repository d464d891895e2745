// IndexSet tests against std::set, on both sides of word boundaries.
#include "support/index_set.hpp"

#include <algorithm>
#include <random>
#include <set>
#include <sstream>
#include <vector>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/vector.hpp>
#include <gtest/gtest.h>

namespace kusabi::support {
namespace {

using Numbers = std::set<int>;

// Few numbers, so that sets intersect and shrink; most of them next to a boundary of words.
constexpr int borders[] = {0, 1, 62, 63, 64, 65, 126, 127, 128, 129, 191, 192, 200};

class Dice {
 public:
  int number() { return borders[generator_() % std::size(borders)]; }
  Numbers numbers() {
    Numbers numbers;
    for (auto left = generator_() % 6; left > 0; --left) numbers.insert(number());
    return numbers;
  }

 private:
  std::mt19937_64 generator_{7};
};

IndexSet made(const Numbers& numbers) {
  IndexSet set;
  for (const int number : numbers) set.insert(number);
  return set;
}

Numbers listed(const IndexSet& set) {
  const std::vector<int> list(set.begin(), set.end());
  EXPECT_TRUE(std::ranges::is_sorted(list));
  const Numbers numbers(list.begin(), list.end());
  EXPECT_EQ(numbers.size(), list.size()) << "one of them twice";
  return numbers;
}

template <class Algorithm>
Numbers combined(Algorithm algorithm, const Numbers& a, const Numbers& b) {
  Numbers result;
  algorithm(a.begin(), a.end(), b.begin(), b.end(), std::inserter(result, result.end()));
  return result;
}

TEST(IndexSet, AgreesWithStdSet) {
  Dice dice;
  for (int round = 0; round < 20000; ++round) {
    const Numbers a = dice.numbers(), b = dice.numbers();
    const IndexSet x = made(a), y = made(b);
    ASSERT_EQ(listed(x), a);
    EXPECT_EQ(x.size(), static_cast<int>(a.size()));
    EXPECT_EQ(x.empty(), a.empty());
    if (!a.empty()) {
      EXPECT_EQ(x.lowest(), *a.begin());
    }
    const int number = dice.number();
    EXPECT_EQ(x.contains(number), a.contains(number));
    const auto together = combined([](auto... all) { return std::set_union(all...); }, a, b);
    const auto common = combined([](auto... all) { return std::set_intersection(all...); }, a, b);
    const auto rest = combined([](auto... all) { return std::set_difference(all...); }, a, b);
    EXPECT_EQ(listed(x | y), together);
    EXPECT_EQ(listed(x & y), common);
    EXPECT_EQ(listed(x - y), rest);
    EXPECT_EQ(x.meets(y), !common.empty());
    EXPECT_EQ(x.includes(y), std::ranges::includes(a, b));
    EXPECT_EQ(x == y, a == b);
    // A set reduced from a larger one equals the set constructed directly.
    EXPECT_EQ(x - y, made(rest));
    EXPECT_EQ(x & y, made(common));
    EXPECT_EQ((x | y) - y, made(rest));
  }
}

TEST(IndexSet, HasAStrictOrder) {
  Dice dice;
  for (int round = 0; round < 5000; ++round) {
    const auto a = made(dice.numbers()), b = made(dice.numbers()), c = made(dice.numbers());
    EXPECT_EQ((a < b) + (b < a) + (a == b), 1);
    if (a < b && b < c) {
      EXPECT_LT(a, c);
    }
  }
}

// Order of single-word sets, as in earlier versions.
TEST(IndexSet, OfOneWordHasTheOrderOfItsNumber) {
  for (IndexSet::Word a = 0; a < 16; ++a) {
    for (IndexSet::Word b = 0; b < 16; ++b) EXPECT_EQ(IndexSet(a) < IndexSet(b), a < b);
  }
}

TEST(IndexSet, BelowContainsAllSmallerNumbers) {
  for (const int count : {0, 1, 63, 64, 65, 127, 128, 129, 200}) {
    const auto set = IndexSet::below(count);
    EXPECT_EQ(set.size(), count);
    for (int i = 0; i < 260; ++i) EXPECT_EQ(set.contains(i), i < count) << i << ' ' << count;
    IndexSet one_by_one;
    for (int i = 0; i < count; ++i) one_by_one.insert(i);
    EXPECT_EQ(set, one_by_one);
  }
}

TEST(IndexSet, SingleContainsItsNumber) {
  for (const int number : borders) EXPECT_EQ(listed(IndexSet::single(number)), Numbers{number});
}

TEST(IndexSet, IsAHexadecimalNumber) {
  EXPECT_EQ(hexadecimal({}), "0");
  EXPECT_EQ(hexadecimal(0b101), "5");
  EXPECT_EQ(hexadecimal(IndexSet::single(63)), "8000000000000000");
  EXPECT_EQ(hexadecimal(IndexSet::single(64)), "10000000000000000");
  EXPECT_EQ(hexadecimal(IndexSet::below(70)), "3fffffffffffffffff");
  EXPECT_EQ(hexadecimal(IndexSet::single(128) | 0xabU), "1000000000000000000000000000000ab");
}

TEST(IndexSet, IsMadeOfWordsInAnyOrderWithoutEmptyOnes) {
  IndexSet set;
  set.set_word(2, 1);
  set.set_word(0, 2);
  EXPECT_EQ(listed(set), (Numbers{1, 128}));
  EXPECT_EQ(set.words(), 3U);
  set.set_word(2, 0);
  EXPECT_EQ(set, IndexSet(2));
  set.set_word(1000, 0);
  EXPECT_EQ(set.words(), 1U);
  EXPECT_EQ(set.word(5), 0U);
}

TEST(IndexSet, IsUnchangedBySerialisation) {
  Dice dice;
  for (int round = 0; round < 200; ++round) {
    const auto sent = made(dice.numbers());
    std::stringstream stream;
    boost::archive::binary_oarchive(stream) << sent;
    IndexSet received = IndexSet::below(100);
    boost::archive::binary_iarchive(stream) >> received;
    EXPECT_EQ(received, sent);
  }
}

}  // namespace
}  // namespace kusabi::support
