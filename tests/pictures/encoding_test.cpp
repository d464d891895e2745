// Base64 tests by the examples of RFC 4648.
#include "pictures/vtu/encoding.hpp"

#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace {

using kusabi::pictures::base64;

TEST(Base64, WritesTheExamplesOfRfc4648) {
  for (const auto& [plain, coded] : {std::pair<std::string, std::string>{"", ""},
                                     {"f", "Zg=="},
                                     {"fo", "Zm8="},
                                     {"foo", "Zm9v"},
                                     {"foob", "Zm9vYg=="},
                                     {"fooba", "Zm9vYmE="},
                                     {"foobar", "Zm9vYmFy"}}) {
    EXPECT_EQ(base64(plain), coded);
  }
}

TEST(Base64, EncodesBytesOfAllValues) {
  EXPECT_EQ(base64(std::string("\xFF\xFE\xFD", 3)), "//79");
  EXPECT_EQ(base64(std::string("\0\x80", 2)), "AIA=");
}

}  // namespace
