// Reader of certificates: messages about faulty files; no altered file proves a false claim.
#include "verify/wedged/certificate.hpp"

#include <algorithm>
#include <random>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "searched.hpp"
#include "tests/nodes/wedged/random_problem.hpp"

namespace kusabi::verify {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using wedged::random_problem;

// A small problem with infeasible nodes and feasible leaves.
const Draft& small() {
  static const Draft draft = searched(random_problem(2, 4, 5), 4.0);
  return draft;
}

// The message on a text; empty if it is a valid certificate.
std::string complaint(const std::string& text) {
  try {
    read_certificate(text, "cert");
    return {};
  } catch (const CertificateError& error) {
    return error.what();
  }
}

TEST(Certificate, IsReadAsItWasWritten) {
  const auto certificate = read_certificate(small().text(), "cert");
  const auto problem = random_problem(2, 4, 5);
  EXPECT_EQ(certificate.dimension, 2U);
  EXPECT_EQ(certificate.names, problem.contact_names);
  EXPECT_EQ(certificate.friction, std::vector<double>(4, 4.0));
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) {
      EXPECT_EQ(certificate.stiffness[static_cast<std::size_t>(8 * i + j)],
                problem.compliance.stiffness(i, j));
    }
  }
  EXPECT_EQ(certificate.nodes.size() + certificate.states.size(), small().nodes.size());
  EXPECT_EQ(std::min(certificate.nodes.front().line, certificate.states.front().line),
            small().lines_before_nodes() + 1);
  EXPECT_EQ(certificate.names_of(0b1010), "{c1 c3}");
  EXPECT_EQ(certificate.names_of(0), "{}");
}

TEST(Certificate, NamesMayContainAnyCharacter) {
  auto problem = random_problem(2, 2, 1);
  problem.contact_names = {"a b  c", "line\nbreak"};
  const auto certificate = read_certificate(searched(problem, 1.0).text(), "cert");
  EXPECT_EQ(certificate.names, (std::vector<std::string>{"a b  c", "line\\x0abreak"}));
}

TEST(Certificate, EveryAlteredByteIsNoticed) {
  const auto text = searched(example("space-truss.toml"), 0.65).text();
  std::mt19937_64 generator(1);
  for (int trial = 0; trial < 300; ++trial) {
    auto altered = text;
    altered[generator() % text.size()] ^= static_cast<char>(1 + generator() % 255);
    EXPECT_THAT(
        complaint(altered),
        testing::AnyOf(HasSubstr("cert: was altered: digest '"), HasSubstr("cert: is not complete"),
                       HasSubstr("expected 'kusabi certificate 5 contact'")));
  }
}

TEST(Certificate, EveryTruncationIsNoticed) {
  const auto text = small().text();
  for (std::size_t length = 0; length < text.size(); ++length) {
    EXPECT_NE(complaint(text.substr(0, length)), "") << length;
    // The same with a valid digest.
    EXPECT_THAT(complaint(sealed(text.substr(0, std::min(length, text.rfind("digest") - 1)))),
                AllOf(HasSubstr("cert"), HasSubstr("expected")));
  }
}

struct Wrong {
  const char* what;  // text in the file
  const char* with;  // its replacement
  const char* said;
};

TEST(Certificate, ReportsFaultAndExpectation) {
  const auto text = small().text();
  const Wrong table[] = {
      {"kusabi certificate 5", "kusabi certificate 6",
       "cert:1: 'kusabi certificate 6 contact', exp"},
      {"kusabi certificate 5 contact", "kusabi certificate 4",
       "cert:1: 'kusabi certificate 4', exp"},
      {"loads 0", "loads 1", "expected 'loads 0' or 'loads 2'"},
      {"loads 0", "loads 2", "expected 'case' and the name of a load case"},
      {"theorems 1", "theorems 2", "expected 'none' with its block, loads and sum"},
      {"none 1 0", "none 2 0", "expected the number of a block, from 1 to 1"},
      {"none 1 0", "none 1 1 0x1p+0 0x0p+0", "expected no loads, since the certificate has none"},
      {"none 1 0", "none 1 0 above 0x1p+0", "expected no sum without loads"},
      {"dimension 2", "dimension 4", "cert:2: 'dimension 4', expected 'dimension 2' or"},
      {"dimension 2", "dimension", "cert:2: 'dimension', expected"},
      {"candidates 4", "candidates 0", "cert:3: 'candidates 0', expected"},
      {"candidates 4", "candidates 4097", "cert:3: 'candidates 4097', expected"},
      {"candidates 4", "candidates 5", "cert:8: 'friction 0x1p+2"},
      {"candidates 4", "candidates 3", "cert:7: 'name c3', expected 'friction'"},
      {"friction 0x1p+2", "friction -0x1p+1",
       "expected friction coefficients that are not negative"},
      {"name c1", "name ", "cert:5: 'name ', expected a name that is not empty"},
      {"name c1", "name", "cert:5: 'name', expected a name that is not empty"},
      {"name c3", "name c1", "cert:7: 'name c1', expected a name other than that of line 5"},
      {"friction 0x1p+2", "friction 2", "expected 4 friction coefficients, each like 0x1.8p+3"},
      {"friction 0x1p+2", "friction 0xinf", "expected 4 friction coefficients"},
      {"friction 0x1p+2", "friction 0x1.00000000000001p+2", "expected 4 friction coefficients"},
      {"friction 0x1p+2", "friction 0x20000000000001p+2", "expected 4 friction coefficients"},
      {"friction 0x1p+2", "friction 0x1.8p-1074", "expected 4 friction coefficients"},
      {"friction 0x1p+2", "friction 0x1p+9999", "expected 4 friction coefficients"},
      {"friction 0x1p+2", "friction  0x1p+1", "expected 4 friction coefficients"},
      {"friction 0x1p+2", "friction 0x1p+2 0x1p+1", "expected 4 friction coefficients"},
      {"stiffness\n", "stiffness\n\n", "cert:12: '', expected 1 entries of row 1"},
      {"evidence\n", "evidence\ndead 1 0 0\n",
       "expected 'infeasible', 'cut', 'form', 'marginal', 'wedged', 'held' or 'end'"},
      {"evidence\n", "evidence\ninfeasible 2 1 2\n",
       "expected the number of a theorem, from 1 to 1"},
      {"evidence\n", "evidence\nheld 1 f 0\n",
       "expected 'wedged', since the certificate has no loads"},
      {"evidence\n", "evidence\ninfeasible 1 1 1 0x0p+0\n", "expected two disjoint sets"},
      {"evidence\n", "evidence\ninfeasible 1 10 1 0x0p+0\n", "expected two disjoint sets"},
      {"evidence\n", "evidence\ninfeasible 1 -1 1 0x0p+0\n", "expected two disjoint sets"},
      {"evidence\n", "evidence\ninfeasible 1 1\n", "expected two disjoint sets"},
      {"evidence\n", "evidence\ninfeasible 1 1 2\n", "expected 4 multipliers"},
      {"evidence\n", "evidence\nwedged 1 1 2 0x1p+0\n", "expected a leaf"},
      {"evidence\n", "evidence\nmarginal 1 f 0 \n", "expected 0 numbers"},
      {"evidence\n", "evidence\nwedged 1 f 0 0x1p+0\n", "expected 4 tangential reactions"},
      {"evidence\n", "evidence\nmarginal 1 f 0\n", "the number of nodes above"},
      {"end ", "end 1", "the number of nodes above"},
      {"end ", "end -", "the number of nodes above"},
      {"digest ", "more\ndigest ", "expected the line 'digest …', the last one"},
  };
  for (const auto& [what, with, said] : table) {
    auto wrong = text;
    wrong.replace(wrong.find(what), std::string(what).size(), with);
    const auto complained = complaint(sealed(wrong));
    EXPECT_THAT(complained, HasSubstr(said)) << with;
    EXPECT_EQ(complained.find('\n'), std::string::npos);
  }
  EXPECT_EQ(complaint(""), "cert:1: the file ends here, expected 'kusabi certificate 5 contact'");
  EXPECT_EQ(complaint("name = 1\n"), "cert:1: 'name = 1', expected 'kusabi certificate 5 contact'");
  EXPECT_THAT(complaint("kusabi certificate 5 contact\n"), HasSubstr("cert: is not complete"));
  EXPECT_THAT(complaint(text + "\n"), HasSubstr("cert: is not complete"));
  EXPECT_THAT(complaint(sealed("")), HasSubstr("cert"));
}

// Two components of a structure, each with infeasible nodes and feasible leaves.
const Draft& pieces() {
  static const Draft draft =
      in_blocks(searched(random_problem(2, 3, 5), 4.0), searched(random_problem(2, 2, 7), 4.0));
  return draft;
}

TEST(CertificateInBlocks, IsReadAsItWasWritten) {
  const auto certificate = read_certificate(pieces().text(), "cert");
  EXPECT_EQ(certificate.blocks, (std::vector<support::IndexSet>{0b00111, 0b11000}));
  EXPECT_EQ(certificate.names, (std::vector<std::string>{"a-c0", "a-c1", "a-c2", "b-c0", "b-c1"}));
  EXPECT_EQ(certificate.nodes.size() + certificate.states.size(), pieces().nodes.size());
  for (const auto& node : certificate.nodes) {
    const auto block = certificate.theorems[node.theorem].block;
    EXPECT_TRUE(certificate.blocks[block].includes(node.contact | node.separated));
    if (node.claim == Claim::infeasible) {
      EXPECT_EQ(node.numbers.size(), block == 0 ? 3U : 2U);
    }
  }
  EXPECT_EQ(certificate.stiffness[10 * 7 + 2], 0);
}

TEST(CertificateInBlocks, ReportsFaultAndExpectation) {
  const auto text = pieces().text();
  const Wrong table[] = {
      {"blocks 2", "blocks 0", "cert:10: 'blocks 0', expected 'blocks' and a number from 1 to"},
      {"blocks 2", "blocks 6", "cert:10: 'blocks 6', expected 'blocks' and a number from 1 to"},
      {"blocks 2", "blocks 1", "expected all contact candidates in the blocks, but {b-c0 b-c1}"},
      {"block 7", "block 0", "cert:11: 'block 0', expected contact candidates that no other"},
      {"block 18", "block 1c", "cert:12: 'block 1c', expected contact candidates that no other"},
      {"block 18", "block 38", "cert:12: 'block 38', expected contact candidates that no other"},
      {"block 18", "block 8", "expected all contact candidates in the blocks, but {b-c1} are"},
      {"block 7", "block 18", "cert:11: 'block 18', expected the block of a-c0, the first"},
      {"0x0p+0", "0x1p-900", "expected 0x0p+0 as entry 1, which couples two blocks"},
      {"evidence\n", "evidence\ninfeasible 0 1 2 0x0p+0\n", "the number of a theorem, from 1 to 2"},
      {"evidence\n", "evidence\ninfeasible 3 1 2 0x0p+0\n", "the number of a theorem, from 1 to 2"},
      {"evidence\n", "evidence\ninfeasible 1 1 8 0x0p+0\n",
       "expected two disjoint sets of candidates of the"},
      {"evidence\n", "evidence\ninfeasible 2 8 10 0x0p+0\n", "expected 2 multipliers"},
      {"evidence\n", "evidence\nwedged 2 8 0 0x0p+0\n", "expected a leaf"},
      {"evidence\n", "evidence\nmarginal 1 3\n", "expected two disjoint sets"},
      {"evidence\n", "evidence\nmarginal 1 3 0\n",
       "the number of nodes above"},  // no leaf, and none required
  };
  for (const auto& [what, with, said] : table) {
    auto wrong = text;
    wrong.replace(wrong.find(what), std::string(what).size(), with);
    EXPECT_THAT(complaint(sealed(wrong)), HasSubstr(said)) << with;
  }
}

TEST(CertificateInBlocks, IsProvedBlockByBlock) {
  const auto said = verdict(pieces().text());
  EXPECT_TRUE(said.proved()) << said.refusals.front();
  const auto first = verdict(searched(random_problem(2, 3, 5), 4.0).text());
  const auto second = verdict(searched(random_problem(2, 2, 7), 4.0).text());
  auto expected = first.feasible;
  for (const auto& contact : second.feasible) expected.insert(contact.word(0) << 3U);
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(said.feasible, expected);
  EXPECT_EQ(said.infeasible, first.infeasible + second.infeasible);
}

TEST(CertificateInBlocks, EachBlockMustBeCovered) {
  for (std::size_t which = 0; which < pieces().nodes.size(); ++which) {
    auto draft = pieces();
    const bool first = draft.nodes[which].find(" 1 ") == draft.nodes[which].find(' ');
    draft.nodes.erase(draft.nodes.begin() + static_cast<std::ptrdiff_t>(which));
    EXPECT_THAT(verdict(draft.text()).refusals,
                testing::Contains(
                    HasSubstr(first ? "block 1: no node covers" : "block 2: no node covers")));
  }
}

// Any change of the nodes leads to a message or a verdict; a proved list is correct, since the
// problem is unchanged.
TEST(Certificate, NoChangeOfTheNodesProvesAnotherList) {
  const auto text = small().text();
  const auto nodes = text.find("evidence\n") + 9;
  const auto end = text.rfind("digest ");
  const auto truth = verdict(text);
  ASSERT_TRUE(truth.proved());
  ASSERT_FALSE(truth.feasible.empty());
  ASSERT_GT(truth.infeasible, 0U);
  std::mt19937_64 generator(2);
  const std::string likely = "0123456789abcdef-+xp \n";
  int read = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    auto altered = text;
    for (auto changes = 1 + generator() % 3; changes > 0; --changes) {
      altered[nodes + generator() % (end - nodes)] =
          trial % 4 == 0 ? static_cast<char>(generator()) : likely[generator() % likely.size()];
    }
    altered = sealed(altered);
    try {
      const auto said = verdict(altered);
      ++read;
      if (said.proved()) {
        auto known = said.feasible;
        EXPECT_TRUE(std::includes(truth.feasible.begin(), truth.feasible.end(), known.begin(),
                                  known.end()));
        EXPECT_EQ(known.size() + said.marginal >= truth.feasible.size(), true);
      }
    } catch (const CertificateError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
  EXPECT_GT(read, 1000);
}

TEST(Certificate, NoAlterationProvesAFalseClaim) {
  std::mt19937_64 generator(3);
  const std::string texts[] = {small().text(), pieces().text()};
  // Numbers at the limits of doubles, and beyond.
  const std::string extremes[] = {"0x1p-1060",
                                  "0x0.0000000000001p-1022",
                                  "-0x1p-1074",
                                  "0x1.fffffffffffffp+1023",
                                  "0x1p+99999999999",
                                  "0x1p-99999999999",
                                  "-0x0p+0",
                                  "0x1p+1000",
                                  "0x1p-1000",
                                  "0xnan",
                                  "0xinf",
                                  "0x" + std::string(400, 'f') + "p+0",
                                  "18446744073709551616"};
  const std::string likely = "0123456789abcdef-+xp \n";
  for (int trial = 0; trial < 20000; ++trial) {
    auto altered = texts[trial % 2];
    for (auto changes = 1 + generator() % 5; changes > 0; --changes) {
      const auto place = generator() % altered.size();
      switch (generator() % 5) {
        case 4: {
          const auto start = altered.find(' ', place);
          if (start == std::string::npos) break;
          const auto end = altered.find_first_of(" \n", start + 1);
          altered.replace(start + 1, end - start - 1, extremes[generator() % std::size(extremes)]);
          break;
        }
        case 0:
          altered.erase(place, generator() % 20);
          break;
        case 1:
          altered.insert(place, 1, likely[generator() % likely.size()]);
          break;
        case 2:
          altered[place] = static_cast<char>(generator());
          break;
        default:
          altered[place] = likely[generator() % likely.size()];
          break;
      }
    }
    try {
      verdict(sealed(altered));
    } catch (const CertificateError& error) {
      EXPECT_THAT(error.what(), HasSubstr("cert"));
    }
  }
}

}  // namespace
}  // namespace kusabi::verify
