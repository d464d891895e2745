// Bounds of candidates and the cuts that follow, of problems that are solved by hand.
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "searched.hpp"
#include "verify/certificate.hpp"
#include "verify/proof.hpp"

namespace kusabi::verify {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

std::string numbers(const std::vector<double>& list) {
  std::string text;
  for (const double number : list) text += fmt::format(" {:a}", number);
  return text + "\n";
}

// A certificate of version 4 that can be taken apart.
struct Parts {
  std::vector<std::string> header;  // up to the motions
  std::vector<std::string> bounds;
  std::vector<std::string> nodes;

  [[nodiscard]] std::string text() const {
    Draft draft;
    draft.header = header;
    draft.header.push_back(fmt::format("bounds {}\n", bounds.size()));
    draft.header.insert(draft.header.end(), bounds.begin(), bounds.end());
    draft.header.emplace_back("nodes\n");
    draft.nodes = nodes;
    return draft.text();
  }
};

// Two candidates a and b with
//
//   u_na = r_na - r_tb,   u_nb = r_nb + r_tb,   u_tb = r_nb - r_na + 3 r_tb,
//
// all other tangents being springs of stiffness 1. In contact a has r_na = r_tb, so u_nb >= r_nb;
// one of them is zero, and so all is. b in contact has r_tb = -r_nb, and lifts a by r_nb: a pattern
// if mu > 1.
Parts two(double mu, int dimension = 2) {
  const std::vector<std::vector<double>> plane = {
      {2, 0, -1, 1}, {0, 1, 0, 0}, {-1, 0, 2, -1}, {1, 0, -1, 1}};
  Parts parts;
  parts.header = {"kusabi certificate 4\n",
                  fmt::format("dimension {}\n", dimension),
                  "candidates 2\n",
                  "name a\n",
                  "name b\n",
                  "friction" + numbers({mu, mu}),
                  "blocks 1\n",
                  "block 3\n",
                  "stiffness\n"};
  for (int i = 0; i < 2 * dimension; ++i) {
    std::vector<double> row;
    for (int j = 0; j <= i; ++j) {
      const bool in_plane = i % dimension < 2 && j % dimension < 2;
      const auto at = [&](int k) {
        return static_cast<std::size_t>(2 * (k / dimension) + k % dimension);
      };
      row.push_back(in_plane ? plane[at(i)][at(j)] : i == j ? 1 : 0);
    }
    parts.header.push_back(numbers(row).substr(1));
  }
  parts.header.emplace_back("motions 0\n");
  // Without b: u_nb = 0. With 4 u_nb + r_nb <= r_na + r_nb, a in contact has 4 r_nb + 3 r_na <= 0.
  parts.bounds = {"bound 1 1 separated" + numbers({0.25, 0, 1, 0, 0, 1}),
                  "never 1 0 contact" + numbers({-4, -4, 0, 1}),
                  "bound 1 0 separated" + numbers({1.25, 1, 1, 0, 0, 1})};
  const std::vector<double> sliding(static_cast<std::size_t>(dimension - 1), 0);
  auto reactions = sliding;
  reactions[0] = -1;
  parts.nodes = {"cut 1 1 0" + numbers({-4, -4, 0, 1}), "alive 1 2 1" + numbers(reactions),
                 "dead 1 0 3" + numbers({0, 0})};
  return parts;
}

// One candidate, K = [2 1; 1 2]: u_n = (2 r_n - r_t)/3 is above zero for mu < 2. No multipliers of
// displacements alone show that it does not wedge, undecided as it is; the cut u_n + r_n <= r_n
// does.
Parts one(double mu) {
  Parts parts;
  parts.header = {"kusabi certificate 4\n",
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
  parts.bounds = {"bound 1 0 separated" + numbers({1, 1, 0, 1})};
  parts.nodes = {"cut 1 0 0" + numbers({-1, 1})};
  return parts;
}

TEST(Bounds, ProveTheListOfTwoCandidates) {
  for (const int dimension : {2, 3}) {
    for (const double mu : {1.25, 2.0, 8.0}) {
      const auto said = verdict(two(mu, dimension).text());
      EXPECT_THAT(said.refusals, IsEmpty()) << mu;
      EXPECT_EQ(said.alive, std::set<support::IndexSet>{0b10});
      EXPECT_EQ(said.bounds, 3U);
      EXPECT_EQ(said.dead, 2U);
    }
  }
}

TEST(Bounds, ProveThatOneCandidateDoesNotWedge) {
  EXPECT_THAT(verdict(one(1).text()).refusals, IsEmpty());
  EXPECT_EQ(verdict(one(1).text()).dead, 1U);
  EXPECT_THAT(verdict(one(1.999).text()).refusals, IsEmpty());
  EXPECT_THAT(verdict(one(2.001).text()).refusals,
              testing::ElementsAre(HasSubstr("do not rule out a reaction at a")));
  auto without = one(1);
  without.bounds.clear();
  EXPECT_THAT(verdict(without.text()).refusals, testing::SizeIs(1));
}

TEST(Bounds, ReactionsAreBoundedAsFarAsTheRelaxationGoes) {
  // Without cuts: r_na = r_tb <= mu r_nb, so r_na <= s mu/(1 + mu), which is 2/3 and 1/2.
  const auto refused = [](double mu, double most, double y) {
    auto parts = two(mu);
    parts.bounds = {"bound 1 0 contact" + numbers({most, y, 0, 0, 0, 1})};
    parts.nodes = {"marginal 1 0 0\n"};
    return !verdict(parts.text()).refusals.empty();
  };
  EXPECT_FALSE(refused(2, 0.75, -0.3));
  EXPECT_FALSE(refused(1, 0.55, -0.475));
  for (int k = -20; k <= 20; ++k) {
    EXPECT_TRUE(refused(2, 0.66, 0.05 * k));
    EXPECT_TRUE(refused(1, 0.49, 0.05 * k));
  }
}

TEST(Bounds, WithoutTheCutNothingProvesTheNode) {
  auto parts = two(2);
  for (int a = -8; a <= 8; ++a) {
    for (int b = -8; b <= 8; ++b) {
      parts.nodes[0] = "dead 1 1 0" + numbers({1.0 * a, 1.0 * b});
      EXPECT_THAT(verdict(parts.text()).refusals, testing::SizeIs(1));
    }
  }
}

// What has been shown of a side is known of every node; and of what is on neither nothing is left.
TEST(Bounds, SidesThatAreExcludedAreKnown) {
  auto parts = two(2);
  parts.nodes[0] = "cut 1 1 0" + numbers({0, 0, 0, 0});
  EXPECT_THAT(verdict(parts.text()).refusals, IsEmpty());
  parts.bounds[1] = "bound 1 0 contact" + numbers({0.75, -0.3, 0, 0, 0, 1});
  EXPECT_THAT(verdict(parts.text()).refusals, Contains(HasSubstr("rule out a reaction at")));
}

TEST(Bounds, OfASmallerBoundThanBeforeTheLargerIsForgotten) {
  auto parts = two(2);
  // u_nb <= s/2 gives 2 u_nb + r_nb <= s: with eta = 1, y_b = -4 is beyond what it gives.
  const auto loose = "bound 1 1 separated" + numbers({0.5, 0, 1, 0, 0, 1});
  parts.bounds.insert(parts.bounds.begin() + 1, loose);
  EXPECT_THAT(verdict(parts.text()).refusals, IsEmpty());
  parts.bounds.erase(parts.bounds.begin());
  EXPECT_FALSE(verdict(parts.text()).proved());
}

TEST(Bounds, RefusesWhatIsSpoilt) {
  const auto refused = [](std::size_t which, const std::string& with) {
    auto parts = two(2);
    parts.bounds[which] = with;
    parts.nodes = {"marginal 1 0 0\n"};
    return !verdict(parts.text()).refusals.empty();
  };
  EXPECT_FALSE(refused(2, two(2).bounds[2]));
  // u_na = s in the pattern of b: less is wrong, whatever the multipliers.
  for (const double y : {0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 2.0})
    EXPECT_TRUE(refused(2, "bound 1 0 separated" + numbers({0.75, 1, y, 0, 0, 1}))) << y;
  // The other side, the other candidate, too much of the cut, too little of the opposite.
  EXPECT_TRUE(refused(1, "never 1 0 separated" + numbers({-4, -4, 0, 1})));
  EXPECT_TRUE(refused(1, "never 1 1 contact" + numbers({-4, -4, 0, 1})));
  EXPECT_TRUE(refused(1, "never 1 0 contact" + numbers({-4, -4, 1, 0})));
  EXPECT_TRUE(refused(1, "never 1 0 contact" + numbers({-4, -4, 0, 5})));
  EXPECT_TRUE(refused(2, "bound 1 0 separated" + numbers({1.25, 1, 1, 0, 0, 0x1p-20})));
  EXPECT_TRUE(refused(2, "bound 1 0 separated" + numbers({1.25, -1, -1, 0, 0, 1})));
}

TEST(Bounds, RestOnThoseBeforeThem) {
  auto parts = two(2);
  std::swap(parts.bounds[0], parts.bounds[1]);
  const auto said = verdict(parts.text());
  EXPECT_FALSE(said.proved());
  EXPECT_EQ(said.bounds, 2U);
  // And fall with them; so do nodes.
  parts = two(2);
  parts.bounds[0] = "bound 1 1 separated" + numbers({0.25, 0, -1, 0, 0, 0x1p-20});
  parts.bounds.erase(parts.bounds.begin());
  EXPECT_EQ(verdict(parts.text()).bounds, 1U);
  EXPECT_THAT(verdict(parts.text()).refusals, testing::SizeIs(2));
}

// The search may ask without a file; what the reader would refuse is refused.
TEST(Bounds, AreCheckedWithoutAReaderToo) {
  const auto certificate = read_certificate(two(2).text(), "cert");
  const auto refusal = [&](const auto& change) {
    Proof proof(certificate);
    auto bound = certificate.bounds[0];
    change(bound);
    return proof.take_up(bound).value_or("");
  };
  EXPECT_EQ(refusal([](Bound&) {}), "");
  EXPECT_THAT(refusal([](Bound& bound) { bound.candidate = 2; }),
              HasSubstr("not one of its block"));
  EXPECT_THAT(refusal([](Bound& bound) { bound.most = 0; }), HasSubstr("above zero"));
  EXPECT_THAT(refusal([](Bound& bound) { bound.most = -1; }), HasSubstr("above zero"));
  EXPECT_THAT(refusal([](Bound& bound) { bound.numbers.back() = 0; }), HasSubstr("above zero"));
  EXPECT_THAT(refusal([](Bound& bound) { bound.numbers[2] = -1; }), HasSubstr("negative"));
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (std::size_t k = 0; k < 5; ++k)
      EXPECT_NE(refusal([&](Bound& bound) { bound.numbers[k] = bad; }), "") << bad << k;
    EXPECT_NE(refusal([&](Bound& bound) { bound.most = bad; }), "");
  }
}

TEST(Bounds, AnyNumbersAreJudged) {
  for (const auto* number : {"0x1.fffffffffffffp+1023", "0x0.0000000000001p-1022", "0x1p-900"}) {
    for (int which = 0; which < 6; ++which) {
      auto parts = two(2);
      std::string line = "bound 1 0 separated";
      for (int k = 0; k < 6; ++k) line += k == which ? fmt::format(" {}", number) : " 0x1p+0";
      parts.bounds[2] = line + "\n";
      verdict(parts.text());
    }
    auto parts = two(2);
    parts.bounds[0] =
        fmt::format("bound 1 1 separated {} 0x0p+0 {} 0x0p+0 0x0p+0 {}\n", number, number, number);
    verdict(parts.text());
  }
}

std::string complaint(const std::string& text) {
  try {
    read_certificate(text, "cert");
    return {};
  } catch (const CertificateError& error) {
    return error.what();
  }
}

TEST(BoundLines, AreReadAsTheyWereWritten) {
  const auto certificate = read_certificate(two(2).text(), "cert");
  ASSERT_EQ(certificate.bounds.size(), 3U);
  const auto& [line, block, candidate, side, most, multipliers] = certificate.bounds[0];
  EXPECT_EQ(line, 16U);
  EXPECT_EQ(block, 0U);
  EXPECT_EQ(candidate, 1);
  EXPECT_EQ(side, Side::separated);
  EXPECT_EQ(most, 0.25);
  EXPECT_EQ(multipliers, (std::vector<double>{0, 1, 0, 0, 1}));
  EXPECT_EQ(certificate.bounds[1].side, Side::contact);
  EXPECT_EQ(certificate.bounds[1].most, std::nullopt);
  EXPECT_EQ(certificate.records[0].claim, Claim::cut);
  EXPECT_EQ(certificate.records[0].numbers, (std::vector<double>{-4, -4, 0, 1}));
}

struct Wrong {
  const char* what;  // in the file
  const char* with;  // instead
  const char* said;
};

TEST(BoundLines, SaysWhatIsWrongAndWhatWasExpected) {
  auto parts = two(2);
  parts.bounds = {"bound 1 1 separated 0x1p-2 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x1p+0\n",
                  "never 1 0 contact -0x1p+2 -0x1p+2 0x0p+0 0x1p+0\n"};
  parts.nodes = {"cut 1 1 0 -0x1p+2 -0x1p+2 0x0p+0 0x1p+0\n", "marginal 1 0 1\n"};
  const auto text = parts.text();
  ASSERT_EQ(complaint(text), "");
  const Wrong table[] = {
      {"kusabi certificate 4", "kusabi certificate 3", "cert:15: 'bounds 2', expected 'nodes'"},
      {"bounds 2", "bounds", "cert:15: 'bounds', expected 'bounds' and how many"},
      {"bounds 2", "bounds -1", "expected 'bounds' and how many there are"},
      {"bounds 2", "bounds 2 ", "expected 'bounds' and how many there are"},
      {"bounds 2", "bounds 1", "cert:17: 'never 1 0 contact"},
      {"bounds 2", "bounds 3", "cert:18: 'nodes', expected 'bound' or 'never'"},
      {"bounds 2", "bounds 18446744073709551615", "expected 'bound' or 'never'"},
      {"bounds 2\n", "", "expected 'bounds' and how many"},
      {"bound 1 1", "bond 1 1", "cert:16: 'bond 1 1"},
      {"bound 1 1", "bound 0 1", "expected the number of a block, from 1 to 1"},
      {"bound 1 1", "bound 2 1", "expected the number of a block, from 1 to 1"},
      {"bound 1 1", "bound 1 2", "expected a contact candidate of the block, counted from 0"},
      {"bound 1 1", "bound 1 -1", "expected a contact candidate of the block"},
      {"bound 1 1", "bound 1 99999999999", "expected a contact candidate of the block"},
      {"separated", "apart", "expected 'contact' or 'separated'"},
      {"0x1p-2", "0x0p+0", "expected a bound above zero"},
      {"0x1p-2", "-0x1p-2", "expected a bound above zero"},
      {"0x1p-2", "1", "expected a bound above zero, like 0x1.8p+3"},
      {"0x0p+0 0x0p+0 0x1p+0\n", "-0x1p+0 0x0p+0 0x1p+0\n",
       "expected multipliers of cuts that are not negative"},
      {"0x0p+0 0x0p+0 0x1p+0\n", "0x0p+0 0x0p+0 0x0p+0\n", "the last one, above zero"},
      {"0x0p+0 0x0p+0 0x1p+0\n", "0x0p+0 0x0p+0 -0x1p+0\n", "the last one, above zero"},
      {"0x0p+0 0x0p+0 0x1p+0\n", "0x0p+0 0x0p+0\n", "expected 5 multipliers, each like"},
      {"never 1 0", "never 1", "cert:17: "},
      {"contact -0x1p+2", "contact 0x1p-2 -0x1p+2", "expected 4 multipliers, each like"},
      {"cut 1 1 0 -0x1p+2", "cut 1 1 0 -0x1p+2 0x1p+0", "expected 4 multipliers, each like"},
      {"cut 1 1 0 -0x1p+2", "cut 1 1 1 -0x1p+2", "expected two disjoint sets of candidates"},
      {"cut 1 1 0 -0x1p+2 -0x1p+2 0x0p+0", "cut 1 1 0 -0x1p+2 -0x1p+2 -0x1p+0",
       "cert:19: 'cut 1 1 0 -0x1p+2 -0x1p+2 -0x1p+0 0x1p+0', expected multipliers of cuts"},
      {"cut 1 1", "shut 1 1", "expected 'dead', 'cut', 'alive', 'marginal' or 'end'"},
  };
  for (const auto& [what, with, said] : table) {
    auto wrong = text;
    ASSERT_NE(wrong.find(what), std::string::npos) << what;
    wrong.replace(wrong.find(what), std::string(what).size(), with);
    const auto complained = complaint(sealed(wrong));
    EXPECT_THAT(complained, HasSubstr(said)) << with;
    EXPECT_EQ(complained.find('\n'), std::string::npos);
  }
}

// Bodies that nothing holds have no bounds, and what is not of the block neither.
TEST(BoundLines, AreOfTheirOwnBlock) {
  const std::vector<std::string> header = {"kusabi certificate 4\n",
                                           "dimension 2\n",
                                           "candidates 2\n",
                                           "name a\n",
                                           "name b\n",
                                           "friction" + numbers({1, 1}),
                                           "blocks 2\n",
                                           "block 1\n",
                                           "block 2\n",
                                           "stiffness\n",
                                           "0x1p+0\n",
                                           "0x0p+0 0x0p+0\n",
                                           "0x0p+0 0x0p+0 0x1p+0\n",
                                           "0x0p+0 0x0p+0 0x0p+0 0x1p+0\n",
                                           "motions 1\n",
                                           "0x0p+0\n",
                                           "0x1p+0\n",
                                           "0x0p+0\n",
                                           "0x0p+0\n"};
  const auto with = [&](const std::string& bound, const std::string& node) {
    return complaint(Parts{header, {bound}, {node}}.text());
  };
  const auto good = "bound 2 1 contact" + numbers({2, 0, 0, 1});
  EXPECT_EQ(with(good, "cut 2 0 0" + numbers({0, 0})), "");
  EXPECT_THAT(with("bound 1 0 contact" + numbers({2, 0, 0, 1}), "marginal 1 0 0\n"),
              HasSubstr("expected a bound of a block without motions"));
  EXPECT_THAT(with("bound 2 0 contact" + numbers({2, 0, 0, 1}), "marginal 1 0 0\n"),
              HasSubstr("expected a contact candidate of the block"));
  EXPECT_THAT(with(good, "cut 1 0 0" + numbers({0, 0})),
              HasSubstr("expected a node with cuts of a block without motions"));
}

TEST(BoundLines, DeadIsDeadWithCutsOrWithout) {
  auto parts = two(2);
  parts.nodes.push_back("cut 1 0 3" + numbers({0, 0, 0, 0}));
  EXPECT_THAT(verdict(parts.text()).refusals, IsEmpty());
  parts.nodes.push_back("cut 1 2 1" + numbers({0, 0, 0, 0}));
  EXPECT_THAT(verdict(parts.text()).refusals, Contains(HasSubstr("one says alive, the other cut")));
}

}  // namespace
}  // namespace kusabi::verify
