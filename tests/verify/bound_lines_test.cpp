// Reader of bounds, and of nodes that require them.
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "searched.hpp"
#include "two_candidates.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::verify {
namespace {

using testing::Contains;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;

std::string complaint(const std::string& text) {
  try {
    read_certificate(text, "cert");
    return {};
  } catch (const CertificateError& error) {
    return error.what();
  }
}

TEST(BoundLines, AreReadAsTheyWereWritten) {
  const auto certificate = read_certificate(two_candidates(2).text(), "cert");
  ASSERT_EQ(certificate.bounds.size(), 3U);
  const auto& [line, block, candidate, side, maximum, multipliers] = certificate.bounds[0];
  EXPECT_EQ(line, 19U);
  EXPECT_EQ(block, 0U);
  EXPECT_EQ(candidate, 1);
  EXPECT_EQ(side, Side::separated);
  EXPECT_EQ(maximum, 0.25);
  EXPECT_EQ(multipliers, (std::vector<double>{0, 1, 0, 0, 1}));
  EXPECT_EQ(certificate.bounds[1].side, Side::contact);
  EXPECT_EQ(certificate.bounds[1].maximum, std::nullopt);
  EXPECT_EQ(certificate.nodes[0].claim, Claim::cut);
  EXPECT_EQ(certificate.nodes[0].numbers, (std::vector<double>{-4, -4, 0, 1}));
}

struct Wrong {
  const char* what;  // text in the file
  const char* with;  // its replacement
  const char* said;
};

TEST(BoundLines, ReportsFaultAndExpectation) {
  auto draft = two_candidates(2);
  draft.bounds = {"bound 1 1 separated 0x1p-2 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x1p+0\n",
                  "never 1 0 contact -0x1p+2 -0x1p+2 0x0p+0 0x1p+0\n"};
  draft.nodes = {"cut 1 1 0 -0x1p+2 -0x1p+2 0x0p+0 0x1p+0\n", "marginal 1 0 1\n"};
  const auto text = draft.text();
  ASSERT_EQ(complaint(text), "");
  const Wrong table[] = {
      {"bounds 2", "bounds", "cert:18: 'bounds', expected 'bounds' and a number"},
      {"bounds 2", "bounds -1", "expected 'bounds' and a number"},
      {"bounds 2", "bounds 2 ", "expected 'bounds' and a number"},
      {"bounds 2", "bounds 1", "cert:20: 'never 1 0 contact"},
      {"bounds 2", "bounds 3", "cert:21: 'evidence', expected 'bound' or 'never'"},
      {"bounds 2", "bounds 18446744073709551615", "a number that the rest of the file holds"},
      {"bounds 2\n", "", "expected 'bounds' and a number"},
      {"bound 1 1", "bond 1 1", "cert:19: 'bond 1 1"},
      {"bound 1 1", "bound 0 1", "expected the number of a theorem, from 1 to 1"},
      {"bound 1 1", "bound 2 1", "expected the number of a theorem, from 1 to 1"},
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
      {"never 1 0", "never 1", "cert:20: "},
      {"contact -0x1p+2", "contact 0x1p-2 -0x1p+2", "expected 4 multipliers, each like"},
      {"cut 1 1 0 -0x1p+2", "cut 1 1 0 -0x1p+2 0x1p+0", "expected 4 multipliers, each like"},
      {"cut 1 1 0 -0x1p+2", "cut 1 1 1 -0x1p+2", "expected two disjoint sets of candidates"},
      {"cut 1 1 0 -0x1p+2 -0x1p+2 0x0p+0", "cut 1 1 0 -0x1p+2 -0x1p+2 -0x1p+0",
       "cert:22: 'cut 1 1 0 -0x1p+2 -0x1p+2 -0x1p+0 0x1p+0', expected multipliers of cuts"},
      {"cut 1 1 0", "form 1 1 0", "expected two empty sets"},
      {"cut 1 1 0", "form 1 0 0", "expected 10 multipliers of products, slips and squares"},
      {"cut 1 1", "shut 1 1",
       "expected 'infeasible', 'cut', 'form', 'marginal', 'wedged', 'held' or 'end'"},
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

// Bounds of an unconstrained body have coefficients of its rigid-body modes, too.
TEST(BoundLines, ReferToTheirOwnBlock) {
  const std::vector<std::string> header = {"kusabi certificate 5 contact\n",
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
    return complaint(Draft{header, {bound}, {node}}.text());
  };
  const auto good = "bound 2 1 contact" + numbers({2, 0, 0, 1});
  EXPECT_EQ(with(good, "cut 2 0 0" + numbers({0, 0})), "");
  EXPECT_EQ(with("bound 1 0 contact" + numbers({2, 0, 0, 0, 1}), "cut 1 0 0" + numbers({0, 0, 0})),
            "");
  EXPECT_THAT(with("bound 1 0 contact" + numbers({2, 0, 0, 1}), "marginal 1 0 0\n"),
              HasSubstr("expected 4 multipliers and parts of motions"));
  EXPECT_THAT(with("bound 1 0 contact" + numbers({2, 0, 0, -1, 1}), "marginal 1 0 0\n"),
              HasSubstr("expected multipliers of cuts that are not negative"));
  EXPECT_THAT(with("bound 2 0 contact" + numbers({2, 0, 0, 1}), "marginal 1 0 0\n"),
              HasSubstr("expected a contact candidate of the block"));
  EXPECT_THAT(with(good, "cut 1 0 0" + numbers({0, 0})),
              HasSubstr("expected 3 multipliers and parts of motions"));
}

TEST(BoundLines, AgreeOnInfeasibilityWithAndWithoutCuts) {
  auto draft = two_candidates(2);
  draft.nodes.push_back("cut 1 0 3" + numbers({0, 0, 0, 0}));
  EXPECT_THAT(verdict(draft.text()).refusals, IsEmpty());
  draft.nodes.push_back("cut 1 2 1" + numbers({0, 0, 0, 0}));
  EXPECT_THAT(verdict(draft.text()).refusals,
              Contains(ContainsRegex("line [0-9]+ says wedged and line [0-9]+ says cut of")));
}

}  // namespace
}  // namespace kusabi::verify
