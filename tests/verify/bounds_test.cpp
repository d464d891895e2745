// Bounds of candidates and the cuts that follow, for problems solved by hand.
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "searched.hpp"
#include "two_candidates.hpp"
#include "verify/wedged/certificate.hpp"
#include "verify/wedged/proof.hpp"

namespace kusabi::verify {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

// One candidate, K = [2 1; 1 2]: u_n = (2 r_n - r_t)/3 is positive for mu < 2. No multipliers of
// displacements alone prove the undecided node infeasible; the cut u_n + r_n <= r_n does.
Draft one(double mu) {
  Draft draft;
  draft.header = {"kusabi certificate 5 contact\n",
                  "dimension 2\n",
                  "candidates 1\n",
                  "name a\n",
                  "friction" + numbers({mu}),
                  "blocks 1\n",
                  "block 1\n",
                  "stiffness\n",
                  "0x1p+1\n",
                  "0x1p+0 0x1p+1\n",
                  "motions 0\n"};
  draft.bounds = {"bound 1 0 separated" + numbers({1, 1, 0, 1})};
  draft.nodes = {"cut 1 0 0" + numbers({-1, 1})};
  return draft;
}

TEST(Bounds, ProveTheListOfTwoCandidates) {
  for (const int dimension : {2, 3}) {
    for (const double mu : {1.25, 2.0, 8.0}) {
      const auto said = verdict(two_candidates(mu, dimension).text());
      EXPECT_THAT(said.refusals, IsEmpty()) << mu;
      EXPECT_EQ(said.feasible, std::set<support::IndexSet>{0b10});
      EXPECT_EQ(said.bounds, 3U);
      EXPECT_EQ(said.infeasible, 2U);
    }
  }
}

TEST(Bounds, ProveThatOneCandidateDoesNotWedge) {
  EXPECT_THAT(verdict(one(1).text()).refusals, IsEmpty());
  EXPECT_EQ(verdict(one(1).text()).infeasible, 1U);
  EXPECT_THAT(verdict(one(1.999).text()).refusals, IsEmpty());
  EXPECT_THAT(verdict(one(2.001).text()).refusals,
              testing::ElementsAre(HasSubstr("do not rule out a reaction at a")));
  auto without = one(1);
  without.bounds.clear();
  EXPECT_THAT(verdict(without.text()).refusals, testing::SizeIs(1));
}

// K is known up to a radius only: coefficients too close to the critical one are not proved.
TEST(Bounds, AreValidForEveryStiffnessWithinTheRadius) {
  const auto refused = [](double mu, double radius) {
    const auto certificate = read_certificate(one(mu).text(), "cert");
    auto stiffness = recorded_stiffness(certificate);
    stiffness.radius = Dyadic(radius);
    Proof proof(certificate, stiffness);
    EXPECT_EQ(proof.add_bound(certificate.bounds[0]), std::nullopt);
    return proof.proof_result(certificate.nodes[0]).refusal.has_value();
  };
  for (const double near : {1e-3, 1e-9}) {
    EXPECT_FALSE(refused(2 - near, 0));
    EXPECT_FALSE(refused(2 - near, near / 100));
    EXPECT_TRUE(refused(2 - near, near));
    EXPECT_TRUE(refused(2 + near, 0));
  }
}

TEST(Bounds, LimitReactionsToTheOptimumOfTheRelaxation) {
  // Without cuts: r_na = r_tb <= mu r_nb, so r_na <= s mu/(1 + mu), which is 2/3 and 1/2.
  const auto refused = [](double mu, double maximum, double y) {
    auto draft = two_candidates(mu);
    draft.bounds = {"bound 1 0 contact" + numbers({maximum, y, 0, 0, 0, 1})};
    draft.nodes = {"marginal 1 0 0\n"};
    return !verdict(draft.text()).refusals.empty();
  };
  EXPECT_FALSE(refused(2, 0.75, -0.3));
  EXPECT_FALSE(refused(1, 0.55, -0.475));
  for (int k = -20; k <= 20; ++k) {
    EXPECT_TRUE(refused(2, 0.66, 0.05 * k));
    EXPECT_TRUE(refused(1, 0.49, 0.05 * k));
  }
}

TEST(Bounds, AreRequiredToProveANodeByCuts) {
  auto draft = two_candidates(2);
  for (int a = -8; a <= 8; ++a) {
    for (int b = -8; b <= 8; ++b) {
      draft.nodes[0] = "infeasible 1 1 0" + numbers({1.0 * a, 1.0 * b});
      EXPECT_THAT(verdict(draft.text()).refusals, testing::SizeIs(1));
    }
  }
}

// Excluded sides hold at every node; a candidate without sides makes a node infeasible.
TEST(Bounds, ExcludeSidesAtEveryNode) {
  auto draft = two_candidates(2);
  draft.nodes[0] = "cut 1 1 0" + numbers({0, 0, 0, 0});
  EXPECT_THAT(verdict(draft.text()).refusals, IsEmpty());
  draft.bounds[1] = "bound 1 0 contact" + numbers({0.75, -0.3, 0, 0, 0, 1});
  EXPECT_THAT(verdict(draft.text()).refusals, Contains(HasSubstr("rule out a reaction at")));
}

TEST(Bounds, ReplaceLargerOnesOfTheSameSide) {
  auto draft = two_candidates(2);
  // u_nb <= s/2 gives 2 u_nb + r_nb <= s: with eta = 1, y_b = -4 exceeds its coefficient.
  const auto loose = "bound 1 1 separated" + numbers({0.5, 0, 1, 0, 0, 1});
  draft.bounds.insert(draft.bounds.begin() + 1, loose);
  EXPECT_THAT(verdict(draft.text()).refusals, IsEmpty());
  draft.bounds.erase(draft.bounds.begin());
  EXPECT_FALSE(verdict(draft.text()).proved());
}

TEST(Bounds, AreRefusedWithAlteredEvidence) {
  const auto refused = [](std::size_t which, const std::string& with) {
    auto draft = two_candidates(2);
    draft.bounds[which] = with;
    draft.nodes = {"marginal 1 0 0\n"};
    return !verdict(draft.text()).refusals.empty();
  };
  EXPECT_FALSE(refused(2, two_candidates(2).bounds[2]));
  // u_na = s in the pattern of b: smaller bounds are wrong, for all multipliers.
  for (const double y : {0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 2.0})
    EXPECT_TRUE(refused(2, "bound 1 0 separated" + numbers({0.75, 1, y, 0, 0, 1}))) << y;
  // The other side, the other candidate, too large a share of the cut, too small a share of the
  // opposite.
  EXPECT_TRUE(refused(1, "never 1 0 separated" + numbers({-4, -4, 0, 1})));
  EXPECT_TRUE(refused(1, "never 1 1 contact" + numbers({-4, -4, 0, 1})));
  EXPECT_TRUE(refused(1, "never 1 0 contact" + numbers({-4, -4, 1, 0})));
  EXPECT_TRUE(refused(1, "never 1 0 contact" + numbers({-4, -4, 0, 5})));
  EXPECT_TRUE(refused(2, "bound 1 0 separated" + numbers({1.25, 1, 1, 0, 0, 0x1p-20})));
  EXPECT_TRUE(refused(2, "bound 1 0 separated" + numbers({1.25, -1, -1, 0, 0, 1})));
}

TEST(Bounds, DependOnEarlierBounds) {
  auto draft = two_candidates(2);
  std::swap(draft.bounds[0], draft.bounds[1]);
  const auto said = verdict(draft.text());
  EXPECT_FALSE(said.proved());
  EXPECT_EQ(said.bounds, 2U);
  // Bounds that depend on a refused one are refused, too; so are nodes.
  draft = two_candidates(2);
  draft.bounds[0] = "bound 1 1 separated" + numbers({0.25, 0, -1, 0, 0, 0x1p-20});
  draft.bounds.erase(draft.bounds.begin());
  EXPECT_EQ(verdict(draft.text()).bounds, 1U);
  EXPECT_THAT(verdict(draft.text()).refusals, testing::SizeIs(2));
}

// A bar in a groove, as in unconstrained_bodies_test.cpp: the walls' normals are (0.6, 0.8) and
// (-0.6, 0.8), and it is wedged from mu = 4/3 on, by two equal reactions. Rigid-body modes alone
// give all proofs.
Draft unconstrained_bar(double mu) {
  Draft draft;
  draft.header = {
      "kusabi certificate 5 contact\n", "dimension 2\n", "candidates 2\n", "name a\n",   "name b\n",
      "friction" + numbers({mu, mu}),   "blocks 1\n",    "block 3\n",      "stiffness\n"};
  const std::vector<double> stretch{-0.6, -0.8, -0.6, 0.8};
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<double> row;
    for (std::size_t j = 0; j <= i; ++j) row.push_back(stretch[i] * stretch[j]);
    draft.header.push_back(numbers(row).substr(1));
  }
  draft.header.emplace_back("motions 3\n");
  for (const auto& row : std::vector<std::vector<double>>{
           {0.6, 0.8, -0.8}, {0.8, -0.6, 0.6}, {-0.6, 0.8, 0.8}, {0.8, 0.6, 0.6}})
    draft.header.push_back(numbers(row).substr(1));
  // The normal components of w are -1/2 at one end and 1/2 at the other; all others are zero.
  draft.bounds = {"bound 1 0 contact" + numbers({0.6, 0, 0, -0.3, 0, 0.4, 0, 0, 1}),
                  "bound 1 1 contact" + numbers({0.6, 0, 0, 0.3, 0, -0.4, 0, 0, 1}),
                  "never 1 1 separated" + numbers({0, 0, -0.6, -0.8, 0, 0, 0})};
  draft.nodes = {"wedged 1 3 0" + numbers({0.8, -0.8, 0, 0, 0}),
                 "infeasible 1 0 1" + numbers({0, 0, 0.6, -0.8, 0}),
                 "cut 1 1 2" + numbers({0, 0, 0, 0, 0, 0, 0})};
  return draft;
}

TEST(BoundsOfAnUnconstrainedBar, ProveItsListOfPatterns) {
  const auto said = verdict(unconstrained_bar(2).text());
  EXPECT_THAT(said.refusals, IsEmpty());
  EXPECT_EQ(said.bounds, 3U);
  EXPECT_EQ(said.feasible.size(), 1U);
  EXPECT_EQ(said.infeasible, 2U);
  EXPECT_EQ(said.except_large_displacements, 0U);
  auto without = unconstrained_bar(2);
  without.bounds.clear();
  EXPECT_THAT(verdict(without.text()).refusals, testing::SizeIs(1));
}

TEST(BoundsOfAnUnconstrainedBar, AreRefusedBelowHalfOfTheReactions) {
  const auto refused = [](const std::string& bound) {
    auto draft = unconstrained_bar(2);
    draft.bounds = {bound};
    draft.nodes = {"marginal 1 0 0\n"};
    return !verdict(draft.text()).refusals.empty();
  };
  const auto bound = [](double maximum, double x, double turn, double y = 0) {
    return "bound 1 0 contact" + numbers({maximum, y, y, x, 0, turn, 0, 0, 1});
  };
  EXPECT_FALSE(refused(bound(0.51, -0.3, 0.4)));
  for (const double maximum : {0.4999, 0.3})
    for (int k = -10; k <= 10; ++k)
      for (const double y : {-1.0, 0.0, 1.0})
        EXPECT_TRUE(refused(bound(maximum, -0.06 * k, 0.08 * k, y))) << k;
  EXPECT_TRUE(refused(bound(0.6, 0.3, -0.4)));
  EXPECT_TRUE(refused("never 1 0 contact" + numbers({0, 0, -0.3, 0, 0.4, 0, 0})));
}

// No end is ever separated, so every bound on that side is true.
TEST(BoundsOfAnUnconstrainedBar, NoAlterationProvesAFalseBound) {
  const auto text = unconstrained_bar(2).text();
  const auto begin = text.find("bounds 3\n");
  const auto size = text.rfind("digest ") - begin;
  std::mt19937_64 generator(8);
  int added = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const auto wrong = misspelt(text, begin, size, generator);
    try {
      const auto certificate = read_certificate(wrong, "cert");
      Proof proof(certificate);
      for (const auto& bound : certificate.bounds) {
        if (proof.add_bound(bound)) continue;
        ++added;
        EXPECT_TRUE(bound.side == Side::separated || (bound.maximum && *bound.maximum >= 0.5));
      }
      const auto said = verdict(wrong);
      EXPECT_TRUE(!said.proved() || said.feasible.size() + said.marginal >= 1) << wrong;
    } catch (const CertificateError&) {
    }
  }
  EXPECT_GT(added, 100);
}

// The search checks bounds without a file; faults that the reader would refuse are refused.
TEST(Bounds, AreCheckedWithoutAReader) {
  const auto certificate = read_certificate(two_candidates(2).text(), "cert");
  const auto refusal = [&](const auto& change) {
    Proof proof(certificate);
    auto bound = certificate.bounds[0];
    change(bound);
    return proof.add_bound(bound).value_or("");
  };
  EXPECT_EQ(refusal([](CandidateBound&) {}), "");
  EXPECT_THAT(refusal([](CandidateBound& bound) { bound.candidate = 2; }),
              HasSubstr("not in its block"));
  EXPECT_THAT(refusal([](CandidateBound& bound) { bound.maximum = 0; }), HasSubstr("above zero"));
  EXPECT_THAT(refusal([](CandidateBound& bound) { bound.maximum = -1; }), HasSubstr("above zero"));
  EXPECT_THAT(refusal([](CandidateBound& bound) { bound.numbers.back() = 0; }),
              HasSubstr("above zero"));
  EXPECT_THAT(refusal([](CandidateBound& bound) { bound.numbers[2] = -1; }), HasSubstr("negative"));
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (std::size_t k = 0; k < 5; ++k)
      EXPECT_NE(refusal([&](CandidateBound& bound) { bound.numbers[k] = bad; }), "") << bad << k;
    EXPECT_NE(refusal([&](CandidateBound& bound) { bound.maximum = bad; }), "");
  }
}

TEST(Bounds, AreDecidedForExtremeNumbers) {
  for (const auto* number : {"0x1.fffffffffffffp+1023", "0x0.0000000000001p-1022", "0x1p-900"}) {
    for (int which = 0; which < 6; ++which) {
      auto draft = two_candidates(2);
      std::string line = "bound 1 0 separated";
      for (int k = 0; k < 6; ++k) line += k == which ? fmt::format(" {}", number) : " 0x1p+0";
      draft.bounds[2] = line + "\n";
      EXPECT_NO_THROW(verdict(draft.text()));
    }
    auto draft = two_candidates(2);
    draft.bounds[0] =
        fmt::format("bound 1 1 separated {} 0x0p+0 {} 0x0p+0 0x0p+0 {}\n", number, number, number);
    EXPECT_NO_THROW(verdict(draft.text()));
  }
}

// For the single pattern, b in contact: u_na = s, r_nb = s.
bool is_true(const CandidateBound& bound) {
  const bool has_part =
      bound.candidate == 0 ? bound.side == Side::separated : bound.side == Side::contact;
  return !has_part || (bound.maximum && *bound.maximum >= 1);
}

TEST(Bounds, NoAlterationProvesAFalseBound) {
  const auto text = two_candidates(2).text();
  const auto begin = text.find("bounds 3\n");
  const auto size = text.rfind("digest ") - begin;
  std::mt19937_64 generator(6);
  int added = 0;
  int proved = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const auto wrong = misspelt(text, begin, size, generator);
    try {
      const auto certificate = read_certificate(wrong, "cert");
      Proof proof(certificate);
      for (const auto& bound : certificate.bounds) {
        if (proof.add_bound(bound)) continue;
        ++added;
        EXPECT_TRUE(is_true(bound)) << wrong;
      }
      const auto said = verdict(wrong);
      if (!said.proved()) continue;
      ++proved;
      EXPECT_TRUE(said.feasible.empty() || said.feasible == std::set<support::IndexSet>{0b10});
      EXPECT_GE(said.feasible.size() + said.marginal, 1U) << wrong;
    } catch (const CertificateError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
  EXPECT_GT(added, 1000);
  EXPECT_GT(proved, 100);
}

}  // namespace
}  // namespace kusabi::verify
