// Proofs of the records of a search; falsified records are refused with the right reason.
#include "verify/wedged/proof.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "searched.hpp"
#include "tests/nodes/wedged/random_problem.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::verify {
namespace {

using testing::AnyOf;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using wedged::random_problem;

const Draft& truss() {
  static const Draft draft = searched(example("space-truss.toml"), 0.65);
  return draft;
}

std::size_t first_of(const Draft& draft, const std::string& start) {
  const auto found = std::find_if(draft.nodes.begin(), draft.nodes.end(),
                                  [&](const auto& line) { return line.starts_with(start); });
  EXPECT_NE(found, draft.nodes.end()) << start;
  return static_cast<std::size_t>(found - draft.nodes.begin());
}

// The words of a line, without its end.
std::vector<std::string> words(const std::string& line) {
  std::vector<std::string> list;
  std::size_t start = 0;
  for (std::size_t end = 0; end != std::string::npos; start = end + 1) {
    end = line.find_first_of(" \n", start);
    if (end != std::string::npos) list.push_back(line.substr(start, end - start));
  }
  return list;
}

std::string line(const std::vector<std::string>& words) {
  return fmt::format("{}\n", fmt::join(words, " "));
}

std::string turned(const std::string& number) {
  return number.starts_with('-') ? number.substr(1) : "-" + number;
}

TEST(Proof, AcceptsTheSpaceTruss) {
  for (const auto& [mu, patterns] : {std::pair(0.55, 1U), {0.65, 27U}, {1.0, 251U}}) {
    const auto said = verdict(searched(example("space-truss.toml"), mu).text());
    EXPECT_THAT(said.refusals, IsEmpty());
    EXPECT_EQ(said.feasible.size(), patterns);
    EXPECT_EQ(said.marginal, 0U);
  }
}

TEST(Proof, AcceptsThePlaneTrussAndTheTwoBars) {
  for (const double mu : {0.2, 0.5, 1.0, 1.999, 2.001, 3.0}) {
    for (const auto* name : {"plane-truss.toml", "two-bars.toml"}) {
      EXPECT_THAT(verdict(searched(example(name), mu).text()).refusals, IsEmpty()) << name << mu;
    }
  }
}

TEST(Proof, AcceptsRandomProblems) {
  std::size_t feasible = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const int dimension = seed % 2 == 0 ? 2 : 3;
    const int candidates = 1 + static_cast<int>(seed % 7);
    const double mu = seed % 3 == 0 ? 0.3 : seed % 3 == 1 ? 1.0 : 4.0;
    const auto said = verdict(searched(random_problem(dimension, candidates, seed), mu).text());
    EXPECT_THAT(said.refusals, IsEmpty()) << "seed " << seed;
    EXPECT_EQ(said.marginal, 0U);
    feasible += said.feasible.size();
  }
  EXPECT_GT(feasible, 100U);
}

TEST(Proof, DoesNotDependOnTheUnits) {
  for (const double factor : {1e-150, 1e-9, 1e9, 1e150}) {
    auto problem = example("space-truss.toml");
    problem.compliance.stiffness *= factor;
    problem.compliance.matrix /= factor;
    EXPECT_THAT(verdict(searched(problem, 0.65).text()).refusals, IsEmpty()) << factor;
  }
}

// Displacements whose stiffness differs by a factor of ten thousand: approximate solutions need
// more than double precision.
TEST(Proof, AcceptsBadlyScaledProblems) {
  std::size_t feasible = 0;
  std::size_t infeasible = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    auto problem = random_problem(seed % 2 == 0 ? 2 : 3, 5, seed);
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> exponent(-2, 2);
    for (Eigen::Index i = 0; i < problem.compliance.stiffness.rows(); ++i) {
      const double factor = std::pow(10.0, exponent(generator));
      problem.compliance.stiffness.row(i) *= factor;
      problem.compliance.stiffness.col(i) *= factor;
      problem.compliance.matrix.row(i) /= factor;
      problem.compliance.matrix.col(i) /= factor;
    }
    const Eigen::MatrixXd lower =
        problem.compliance.stiffness.triangularView<Eigen::StrictlyLower>();
    const Eigen::MatrixXd diagonal = problem.compliance.stiffness.diagonal().asDiagonal();
    problem.compliance.stiffness = lower + diagonal + lower.transpose();
    const auto said = verdict(searched(problem, 2.0).text());
    EXPECT_THAT(said.refusals, IsEmpty()) << "seed " << seed;
    feasible += said.feasible.size();
    infeasible += said.infeasible;
  }
  EXPECT_GT(feasible, 20U);
  EXPECT_GT(infeasible, 20U);
}

// One candidate, K = [2 1; 1 2]; without friction it cannot wedge.
Draft frictionless() {
  Draft draft;
  draft.header = {"kusabi certificate 5 contact\n",
                  "dimension 2\n",
                  "candidates 1\n",
                  "name a\n",
                  "friction 0x0p+0\n",
                  "blocks 1\n",
                  "block 1\n",
                  "stiffness\n",
                  "0x1p+1\n",
                  "0x1p+0 0x1p+1\n",
                  "motions 0\n"};
  // Contact: u_n = 0, and r_t = 2 u_t = 0 implies r_n = u_t = 0. With multiplier -1, w = (-2, 1)/3.
  draft.nodes = {"infeasible 1 1 0 -0x1p+0\n", "infeasible 1 0 1 0x0p+0\n"};
  return draft;
}

TEST(Proof, AcceptsZeroFriction) {
  EXPECT_THAT(verdict(frictionless().text()).refusals, IsEmpty());
  EXPECT_EQ(verdict(frictionless().text()).infeasible, 2U);
  auto turned = frictionless();
  turned.nodes[0] = "infeasible 1 1 0 0x1p+0\n";
  EXPECT_THAT(verdict(turned.text()).refusals,
              testing::ElementsAre(HasSubstr("do not rule out a reaction at a")));
  auto slipping = frictionless();
  slipping.nodes[0] = "wedged 1 1 0 0x1p+0\n";
  EXPECT_THAT(verdict(slipping.text()).refusals,
              testing::ElementsAre(HasSubstr("a has no friction, but a tangential reaction")));
  auto still = frictionless();
  still.nodes[0] = "wedged 1 1 0 0x0p+0\n";
  EXPECT_THAT(verdict(still.text()).refusals,
              testing::ElementsAre(HasSubstr("a is not pressed against the obstacle")));
}

// K = [2 1; 1 2], in contact r_t = 2 r_n: the critical friction is between 2 and its neighbours.
// With K known up to a radius only, coefficients too close to it are not proved.
TEST(Proof, IsValidForEveryStiffnessWithinTheRadius) {
  const auto refused = [](double mu, const std::string& claim, double radius) {
    auto draft = frictionless();
    draft.header[4] = fmt::format("friction {:a}\n", mu);
    draft.nodes[0] = claim;
    const auto certificate = read_certificate(draft.text(), "cert");
    auto stiffness = recorded_stiffness(certificate);
    stiffness.radius = Dyadic(radius);
    const Proof proof(certificate, stiffness);
    EXPECT_TRUE(proof.min_eigenvalue());
    EXPECT_LE(proof.min_eigenvalue()->nearest(), 1 - radius);
    if (!certificate.states.empty()) return proof.refusal(certificate.states[0]).has_value();
    return proof.proof_result(certificate.nodes[0]).refusal.has_value();
  };
  const std::string feasible = "wedged 1 1 0 0x1p+1\n";
  const std::string infeasible = "infeasible 1 1 0 -0x1p+0\n";
  for (const double near : {1e-3, 1e-9}) {
    EXPECT_FALSE(refused(2 + near, feasible, 0));
    EXPECT_FALSE(refused(2 + near, feasible, near / 100));
    EXPECT_TRUE(refused(2 + near, feasible, near));
    EXPECT_TRUE(refused(2 - near, feasible, 0));
    EXPECT_FALSE(refused(2 - near, infeasible, 0));
    EXPECT_FALSE(refused(2 - near, infeasible, near / 100));
    EXPECT_TRUE(refused(2 - near, infeasible, near));
    EXPECT_TRUE(refused(2 + near, infeasible, 0));
  }
}

TEST(Proof, CountsARepeatedNodeOnce) {
  auto draft = truss();
  const auto expected = verdict(draft.text());
  const std::vector<std::string> again(draft.nodes.begin(), draft.nodes.begin() + 50);
  draft.nodes.insert(draft.nodes.end(), again.begin(), again.end());
  const auto said = verdict(draft.text());
  EXPECT_TRUE(said.proved());
  EXPECT_EQ(said.infeasible, expected.infeasible);
  std::reverse(draft.nodes.begin(), draft.nodes.end());
  EXPECT_TRUE(verdict(draft.text()).proved());
}

TEST(Proof, RefusesAMissingNode) {
  for (std::size_t i = 0; i < truss().nodes.size(); ++i) {
    auto draft = truss();
    draft.nodes.erase(draft.nodes.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_THAT(verdict(draft.text()).refusals, Contains(HasSubstr("no node covers")));
  }
}

TEST(Proof, RefusesANodeWithItsSetsExchanged) {
  auto draft = truss();
  int count = 0;
  for (auto& node : draft.nodes) {
    const auto original = node;
    auto parts = words(node);
    if (parts[0] != "infeasible") continue;
    ++count;
    std::swap(parts[2], parts[3]);
    node = line(parts);
    EXPECT_FALSE(verdict(draft.text()).proved()) << original;
    node = original;
  }
  EXPECT_GT(count, 20);
}

TEST(Proof, RefusesAStiffnessThatIsNotDefinite) {
  auto draft = truss();
  const auto rows = std::find(draft.header.begin(), draft.header.end(), "stiffness\n") + 1;
  *rows = "-0x1p+0\n";
  EXPECT_THAT(verdict(draft.text()).refusals, testing::ElementsAre("K"));
  *rows = "0x0p+0\n";
  EXPECT_THAT(verdict(draft.text()).refusals, testing::ElementsAre("K"));
  // [1 1; 1 1] and [1 2; 2 1] as its leading block.
  for (const auto* row : {"0x1p+0 0x1p+0\n", "0x1p+1 0x1p+0\n"}) {
    rows[0] = "0x1p+0\n";
    rows[1] = row;
    EXPECT_THAT(verdict(draft.text()).refusals, testing::ElementsAre("K"));
  }
}

TEST(Proof, RefusesTheEvidenceOfAnotherStiffness) {
  auto draft = truss();
  const auto rows = std::find(draft.header.begin(), draft.header.end(), "stiffness\n") + 1;
  auto entries = words(rows[3]);
  entries[3] = fmt::format("{:a}", 4 * std::strtod(entries[3].c_str(), nullptr));
  rows[3] = line(entries);
  const auto said = verdict(draft.text());
  EXPECT_THAT(said.refusals, Contains(AnyOf(HasSubstr("rule"), HasSubstr("separate"),
                                            HasSubstr("slips"), HasSubstr("pressed"))));
}

TEST(Proof, RefusesTheEvidenceOfAnotherFriction) {
  auto draft = truss();
  auto& friction = *std::find_if(draft.header.begin(), draft.header.end(),
                                 [](const auto& text) { return text.starts_with("friction"); });
  const auto with = [&](double mu) {
    friction = "friction";
    for (int i = 0; i < 10; ++i) friction += fmt::format(" {:a}", mu);
    friction += "\n";
    return verdict(draft.text()).refusals;
  };
  EXPECT_THAT(with(0.65), IsEmpty());
  const auto larger = with(1.5 * 0.65);
  EXPECT_FALSE(larger.empty());
  EXPECT_THAT(larger, Each(HasSubstr("do not rule out a reaction at")));
  const auto smaller = with(0.65 / 1.5);
  EXPECT_FALSE(smaller.empty());
  EXPECT_THAT(smaller, Each(HasSubstr("slips")));
}

TEST(Proof, RefusesAlteredMultipliers) {
  auto draft = truss();
  int count = 0;
  for (auto& node : draft.nodes) {
    auto parts = words(node);
    if (parts[0] != "infeasible" || parts[3] == "3ff") continue;
    ++count;
    const auto original = node;
    for (std::size_t i = 4; i < parts.size(); ++i) parts[i] = turned(parts[i]);
    node = line(parts);
    EXPECT_THAT(verdict(draft.text()).refusals, testing::SizeIs(1)) << original;
    for (std::size_t i = 4; i < parts.size(); ++i) parts[i] = "0x0p+0";
    node = line(parts);
    EXPECT_THAT(verdict(draft.text()).refusals,
                testing::ElementsAre(HasSubstr("do not rule out a reaction at")));
    node = original;
  }
  EXPECT_GT(count, 20);
}

// A multiplier of a displacement that is nonnegative exceeds the coefficient of u_n >= 0.
TEST(Proof, RefusesMultipliersOfTheWrongSign) {
  auto draft = searched(example("two-bars.toml"), 1.0);
  // K = [2 1; 1 2], and without contact only u_n >= 0: no positive multiplier can help.
  draft.nodes = {"infeasible 1 0 0 -0x1p+0\n"};
  EXPECT_THAT(
      verdict(draft.text()).refusals,
      testing::ElementsAre(HasSubstr("margin of its multipliers is within the rounding errors")));
}

TEST(Proof, RefusesAlteredReactions) {
  auto draft = truss();
  int count = 0;
  for (auto& node : draft.nodes) {
    auto parts = words(node);
    if (parts[0] != "wedged") continue;
    ++count;
    const auto original = node;
    for (std::size_t i = 4; i < parts.size(); ++i) parts[i] = turned(parts[i]);
    node = line(parts);
    EXPECT_THAT(verdict(draft.text()).refusals,
                testing::ElementsAre(AnyOf(HasSubstr("is not pressed"), HasSubstr("separate"))));
    for (std::size_t i = 4; i < parts.size(); ++i) parts[i] = "0x0p+0";
    node = line(parts);
    EXPECT_THAT(verdict(draft.text()).refusals,
                testing::ElementsAre(AnyOf(HasSubstr("is not pressed"), HasSubstr("separate"))));
    node = original;
  }
  EXPECT_GT(count, 20);
}

// No tangential reaction makes an infeasible leaf feasible; random ones are tried.
TEST(Proof, RefusesAnInfeasibleLeafClaimedFeasible) {
  std::mt19937_64 generator(3);
  std::normal_distribution<double> normal;
  auto draft = truss();
  int leaves = 0;
  for (auto& node : draft.nodes) {
    const auto parts = words(node);
    const auto contact = std::stoull(parts[2], nullptr, 16);
    const auto separated = std::stoull(parts[3], nullptr, 16);
    if (parts[0] != "infeasible" || (contact | separated) != 1023) continue;
    ++leaves;
    const auto original = node;
    for (int trial = 0; trial < 3; ++trial) {
      node = fmt::format("wedged 1 {} {}", parts[2], parts[3]);
      for (auto rest = contact; rest != 0; rest &= rest - 1) {
        node += fmt::format(" {:a} {:a}", normal(generator), normal(generator));
      }
      node += "\n";
      EXPECT_THAT(verdict(draft.text()).refusals, testing::SizeIs(1)) << original;
    }
    node = original;
  }
  EXPECT_GT(leaves, 10);
}

TEST(Proof, RefusesAFeasibleLeafClaimedInfeasible) {
  std::mt19937_64 generator(4);
  std::normal_distribution<double> normal;
  auto draft = truss();
  int count = 0;
  for (auto& node : draft.nodes) {
    const auto parts = words(node);
    if (parts[0] != "wedged") continue;
    ++count;
    const auto original = node;
    for (int trial = 0; trial < 3; ++trial) {
      node = fmt::format("infeasible 1 {} {}", parts[2], parts[3]);
      for (int i = 0; i < 10; ++i) node += fmt::format(" {:a}", normal(generator));
      node += "\n";
      EXPECT_THAT(verdict(draft.text()).refusals, testing::SizeIs(1)) << original;
    }
    node = original;
  }
  EXPECT_GT(count, 20);
}

TEST(Proof, RefusesTwoClaimsOfOneNode) {
  auto draft = truss();
  const auto parts = words(draft.nodes[first_of(draft, "wedged")]);
  draft.nodes.push_back(fmt::format("marginal 1 {} {}\n", parts[2], parts[3]));
  EXPECT_THAT(verdict(draft.text()).refusals,
              testing::ElementsAre(HasSubstr("says marginal of contact")));
}

TEST(Proof, ReportsAMarginalNodeAsUndecided) {
  auto draft = truss();
  auto& node = draft.nodes[first_of(draft, "wedged")];
  const auto parts = words(node);
  node = fmt::format("marginal 1 {} {}\n", parts[2], parts[3]);
  const auto said = verdict(draft.text());
  EXPECT_TRUE(said.proved());
  EXPECT_EQ(said.marginal, 1U);
  EXPECT_EQ(said.feasible.size(), 26U);
}

TEST(Proof, RefusesNumbersOutOfRange) {
  auto draft = truss();
  const auto spoil = [&](const std::string& claim, const std::string& number) {
    auto& node = draft.nodes[first_of(draft, claim)];
    const auto original = node;
    auto parts = words(node);
    for (std::size_t i = 4; i < parts.size(); ++i) parts[i] = number;
    node = line(parts);
    EXPECT_THAT(verdict(draft.text()).refusals, testing::SizeIs(1)) << claim << number;
    node = original;
  };
  for (const auto* number : {"0x1.fffffffffffffp+1023", "-0x1.fffffffffffffp+1023",
                             "0x0.0000000000001p-1022", "-0x0.0000000000001p-1022"}) {
    spoil("wedged", number);
    spoil("infeasible", number);
  }
}

}  // namespace
}  // namespace kusabi::verify
