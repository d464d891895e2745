// Certificates with more candidates than bits in a word.
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dense.hpp"
#include "searched.hpp"
#include "tests/nodes/wedged/random_problem.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::verify {
namespace {

using testing::HasSubstr;
using wedged::random_problem;

// The message on a text; empty if it is a valid certificate.
std::string complaint(const std::string& text) {
  try {
    read_certificate(text, "cert");
    return {};
  } catch (const CertificateError& error) {
    return error.what();
  }
}

struct Wrong {
  const char* what;  // text in the file
  const char* with;  // its replacement
  const char* said;
};

// Candidates of which each opens all others: one in contact leaves no reaction to any other, and
// the tree has one infeasible node more than there are candidates.
problems::WedgedProblem lifting_each_other(int candidates) {
  auto problem = random_problem(2, candidates, 5);
  problem.compliance.stiffness.setIdentity();
  for (int i = 0; i < candidates; ++i)
    for (int k = 0; k < candidates; ++k)
      problem.compliance.stiffness(2 * i, 2 * k) -= 1.0 / (2 * candidates);
  const Eigen::MatrixXd inverse = dense::inverse(problem.compliance.stiffness);
  problem.compliance.matrix = (inverse + inverse.transpose()) / 2;
  return problem;
}

// Candidates c0, ..., c59 that are infeasible at once, and ten whose sets begin in the first word
// of a set and end in the second.
const Draft& seventy() {
  static const Draft draft =
      in_blocks(searched(lifting_each_other(60), 0.5), searched(random_problem(2, 10, 5), 4.0));
  return draft;
}

TEST(CertificateOfManyCandidates, IsProvedBlockByBlock) {
  const auto certificate = read_certificate(seventy().text(), "cert");
  ASSERT_EQ(certificate.names.size(), 70U);
  EXPECT_EQ(certificate.blocks[1], support::IndexSet::below(70) - support::IndexSet::below(60));
  const auto said = verdict(seventy().text());
  EXPECT_TRUE(said.proved()) << said.refusals.front();
  std::set<support::IndexSet> expected;
  for (const auto& contact : verdict(searched(random_problem(2, 10, 5), 4.0).text()).feasible) {
    support::IndexSet moved;
    for (const int i : contact) moved.insert(60 + i);
    expected.insert(moved);
  }
  EXPECT_GT(expected.size(), 1U);
  EXPECT_EQ(said.feasible, expected);
}

TEST(CertificateOfManyCandidates, ReportsAnInvalidSet) {
  const auto text = seventy().text();
  const auto* const first = "block fffffffffffffff\n";
  const auto* const second = "block 3ff000000000000000\n";
  const Wrong table[] = {
      {second, "block 3ff00000000000000g\n", "in hexadecimal digits"},
      {second, "block g3ff000000000000000\n", "in hexadecimal digits"},
      {second, "block 3ff0000000-0000000\n", "in hexadecimal digits"},
      {second, "block 7ff000000000000000\n", "expected contact candidates that no other"},
      {second, "block 1000000000000000000000000000000003ff000000000000000\n",
       "expected contact candidates that no other"},
      {second, "block 1ff000000000000000\n", "in the blocks, but {b-c9} are"},
      {second, "block 3ef000000000000000\n", "in the blocks, but {b-c4} are"},
      {first, "block 1fffffffffffffff\n", "block 3ff000000000000000"},
      {"evidence\n", "evidence\nmarginal 2 400000000000000000 0\n", "expected two disjoint sets"},
      {"evidence\n", "evidence\nmarginal 2 200000000000000000 200000000000000000\n",
       "expected two disjoint sets"},
      {"evidence\n", "evidence\nmarginal 1 0 200000000000000000\n", "expected two disjoint sets"},
  };
  for (const auto& [what, with, said] : table) {
    auto wrong = text;
    ASSERT_NE(wrong.find(what), std::string::npos) << what;
    wrong.replace(wrong.find(what), std::string(what).size(), with);
    EXPECT_THAT(complaint(sealed(wrong)), HasSubstr(said)) << with;
  }
}

}  // namespace
}  // namespace kusabi::verify
