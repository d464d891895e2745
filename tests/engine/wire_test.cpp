// Wire format tests: round trips, and detection of a truncated message.
#include "engine/wire.hpp"

#include <bit>
#include <string>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>
#include <gtest/gtest.h>

#include "engine/detail/nodes/frontier.hpp"

namespace kusabi::engine {
namespace {

TEST(Wire, UnpacksPackedValues) {
  const std::vector<std::string> words{"", "kusabi", std::string(100'000, 'x')};
  EXPECT_EQ(unpack<std::vector<std::string>>(pack(words)), words);
}

TEST(Wire, KeepsEveryBitOfADouble) {
  const std::vector<double> values{-0.0, 1.0 / 3.0, 5e-324, 1.7976931348623157e308};
  const auto copy = unpack<std::vector<double>>(pack(values));
  ASSERT_EQ(copy.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(copy[i]), std::bit_cast<std::uint64_t>(values[i]));
  }
}

TEST(Wire, RefusesBytesThatEndTooEarly) {
  auto bytes = pack(std::vector<std::uint64_t>(10, 7));
  bytes.resize(bytes.size() - 1);
  EXPECT_THROW(unpack<std::vector<std::uint64_t>>(bytes), boost::archive::archive_exception);
}

TEST(Wire, CarriesATransfer) {
  const Transfer<int> transfer{{{TrailStep{0, 2, 7, 0.5}}, {{42, 1, 0}, {43, 1, 1}}},
                               {{}, {{44, 0, 0}}}};
  const auto copy = unpack<Transfer<int>>(pack(transfer));
  ASSERT_EQ(copy.size(), 2U);
  ASSERT_EQ(copy[0].trail.size(), 1U);
  EXPECT_EQ(copy[0].trail[0].hash, 7U);
  ASSERT_EQ(copy[0].nodes.size(), 2U);
  EXPECT_EQ(copy[0].nodes[1].node, 43);
  EXPECT_EQ(copy[0].nodes[1].branch, 1U);
  EXPECT_EQ(copy[1].nodes[0].node, 44);
}

}  // namespace
}  // namespace kusabi::engine
