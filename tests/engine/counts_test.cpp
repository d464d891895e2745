// Tests of Counts: sums, serialisation and reports from one list of counts.
#include "engine/counts.hpp"

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "engine/wire.hpp"

namespace {

using namespace kusabi::engine;

struct Tally : Counts<Tally> {
  std::uint64_t opened = 0;
  std::uint64_t closed = 0;
  Least bound;

  static constexpr auto fields() {
    return std::tuple{field("opened", &Tally::opened), field("shut", &Tally::closed),
                      field("bound", &Tally::bound)};
  }
};

Tally tally(std::uint64_t opened, std::uint64_t closed, double bound) {
  Tally made;
  made.opened = opened;
  made.closed = closed;
  made.bound = {bound};
  return made;
}

TEST(Counts, AddUpAndKeepTheLeastBound) {
  Tally sum;
  EXPECT_EQ(sum.bound.value, std::numeric_limits<double>::infinity());
  sum += tally(1, 10, 3.5);
  sum += tally(2, 20, -1);
  sum += tally(3, 30, 7);
  EXPECT_EQ(sum.opened, 6U);
  EXPECT_EQ(sum.closed, 60U);
  EXPECT_EQ(sum.bound.value, -1);
}

TEST(Counts, AreUnchangedBySerialisation) {
  const auto bytes = pack(tally(4, 5, 0.25));
  const auto arrived = unpack<Tally>(std::span<const char>(bytes.data(), bytes.size()));
  EXPECT_EQ(arrived.opened, 4U);
  EXPECT_EQ(arrived.closed, 5U);
  EXPECT_EQ(arrived.bound.value, 0.25);
}

TEST(Counts, AreNamedInTheOrderOfTheirList) {
  std::vector<std::string> names;
  tally(1, 2, 3).each([&](const char* name, const auto& /*value*/) { names.emplace_back(name); });
  EXPECT_EQ(names, (std::vector<std::string>{"opened", "shut", "bound"}));
}

}  // namespace
