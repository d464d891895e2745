// Covers by trees and other sets of nodes, without mechanics.
#include "verify/wedged/cover.hpp"

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kusabi::verify {
namespace {

using testing::HasSubstr;

Certificate of(std::size_t candidates) {
  Certificate certificate;
  for (std::size_t i = 0; i < candidates; ++i) {
    certificate.names.push_back(std::string(1, static_cast<char>('a' + i)));
  }
  certificate.blocks = {certificate.all_candidates()};
  certificate.theorems.resize(1);
  return certificate;
}

void add(Certificate& certificate, std::uint64_t contact, std::uint64_t separated) {
  certificate.nodes.push_back({.line = certificate.nodes.size() + 1,
                               .claim = Claim::infeasible,
                               .contact = contact,
                               .separated = separated});
}

std::string flaw(const Certificate& certificate) {
  return flaw_of_cover(certificate, 0).value_or("");
}

TEST(Cover, IsCompleteWithTheRootAlone) {
  auto certificate = of(3);
  EXPECT_THAT(flaw(certificate), HasSubstr("no node covers contact {} separated {}"));
  add(certificate, 0, 0);
  EXPECT_EQ(flaw(certificate), "");
}

TEST(Cover, ReportsAMissingPattern) {
  auto certificate = of(3);
  add(certificate, 0b001, 0b000);
  add(certificate, 0b010, 0b001);
  EXPECT_THAT(flaw(certificate), HasSubstr("no node covers contact {} separated {a b}"));
  add(certificate, 0b000, 0b011);
  EXPECT_EQ(flaw(certificate), "");
}

TEST(Cover, ReportsAPatternCoveredTwice) {
  auto certificate = of(2);
  add(certificate, 0b01, 0);
  add(certificate, 0, 0b01);
  add(certificate, 0b11, 0);
  EXPECT_THAT(flaw(certificate), HasSubstr("line 1 and line 3 both cover patterns below"));
}

TEST(Cover, ReportsContradictoryClaims) {
  auto certificate = of(1);
  add(certificate, 1, 0);
  add(certificate, 0, 1);
  certificate.states.push_back({.line = 3, .separated = 1});
  EXPECT_THAT(flaw(certificate), HasSubstr("line 2 says infeasible and line 3 says wedged of"));
  // A state under load says nothing about wedged configurations, and is none of another block.
  certificate.states.front().share = LoadShare{1, 0};
  EXPECT_EQ(flaw(certificate), "");
  certificate.states.front() = {.line = 3, .block = 1, .separated = 1};
  EXPECT_EQ(flaw(certificate), "");
}

// Three nodes that cover six of eight patterns, two by two, without a common candidate for the
// root.
TEST(Cover, RefusesNodesThatFormNoTree) {
  auto certificate = of(3);
  add(certificate, 0b001, 0b010);
  add(certificate, 0b010, 0b100);
  add(certificate, 0b100, 0b001);
  EXPECT_THAT(flaw(certificate), HasSubstr("do not form a tree"));
}

// Random trees over 64 candidates: complete, with a node missing, repeated or with exchanged sides.
TEST(Cover, AcceptsRandomTreesAndRefusesAlteredOnes) {
  std::mt19937_64 generator(7);
  for (int round = 0; round < 200; ++round) {
    auto certificate = of(64);
    std::vector<std::pair<std::uint64_t, std::uint64_t>> open{{0, 0}};
    while (!open.empty()) {
      const auto [contact, separated] = open.back();
      open.pop_back();
      const auto split = std::uint64_t{1} << (generator() % 64);
      if (((contact | separated) & split) != 0 || generator() % 100 < 49) {
        add(certificate, contact, separated);
        continue;
      }
      open.emplace_back(contact | split, separated);
      open.emplace_back(contact, separated | split);
    }
    std::shuffle(certificate.nodes.begin(), certificate.nodes.end(), generator);
    ASSERT_EQ(flaw(certificate), "");
    const auto which = generator() % certificate.nodes.size();
    auto spoilt = certificate;
    spoilt.nodes.push_back(spoilt.nodes[which]);
    EXPECT_NE(flaw(spoilt), "");
    spoilt = certificate;
    spoilt.nodes.erase(spoilt.nodes.begin() + static_cast<std::ptrdiff_t>(which));
    EXPECT_NE(flaw(spoilt), "");
    if (certificate.nodes.size() == 1) continue;
    spoilt = certificate;
    std::swap(spoilt.nodes[which].contact, spoilt.nodes[which].separated);
    EXPECT_NE(flaw(spoilt), "");
  }
}

}  // namespace
}  // namespace kusabi::verify
