// Consistency of certificates with problem files: genuine ones are proved for the structure, all
// others refused.
#include "verify/wedged/consistency.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nodes/evidence/verified_structure.hpp"
#include "problems/files/structure_file.hpp"
#include "searched.hpp"

namespace kusabi::verify {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Structure structure_of(const std::string& name) {
  return evidence::verified_structure(example_structure(name));
}

TEST(Consistency, GenuineCertificatesAreProvedForTheirStructures) {
  for (const auto* name :
       {"two-bars.toml", "plane-truss.toml", "space-truss.toml", "elastic-body.toml"}) {
    const auto structure = structure_of(name);
    for (const double mu : {0.3, 0.65, 1.0}) {
      const auto text = searched(example(name), mu).text();
      const auto own = verdict(text);
      const auto said = verdict(text, &structure);
      EXPECT_THAT(said.refusals, IsEmpty()) << name << ' ' << mu;
      EXPECT_EQ(said.feasible, own.feasible) << name << ' ' << mu;
      EXPECT_EQ(said.infeasible, own.infeasible) << name << ' ' << mu;
    }
  }
}

TEST(Consistency, TheCertificateOfAnotherProblemIsRefused) {
  const auto text = searched(example("plane-truss.toml"), 1.0).text();
  const auto structure = structure_of("plane-truss.toml");
  ASSERT_TRUE(verdict(text, &structure).proved());
  const auto refusal = [&](const auto& change) {
    auto other = structure;
    change(other);
    const auto said = verdict(text, &other);
    return said.proved() ? std::string() : said.refusals.front();
  };
  EXPECT_THAT(refusal([](Structure& s) { s.bars[3].axial_stiffness *= 1.001; }),
              HasSubstr("K of the certificate is not that of the structure"));
  EXPECT_THAT(refusal([](Structure& s) { s.coordinates[s.contact[1].node][0] += 1e-3; }),
              HasSubstr("K of the certificate is not that of the structure"));
  EXPECT_THAT(refusal([](Structure& s) { s.contact[2].normal[1] += 1e-3; }),
              HasSubstr("K of the certificate is not that of the structure"));
  EXPECT_THAT(refusal([](Structure& s) { std::swap(s.contact[0], s.contact[1]); }),
              HasSubstr("contact candidate 1 of the certificate is r1, that of the structure r2"));
  EXPECT_THAT(refusal([](Structure& s) { s.names[s.contact[4].node] = "x"; }),
              HasSubstr("contact candidate 5 of the certificate is r5, that of the structure x"));
  EXPECT_THAT(refusal([](Structure& s) { s.contact.pop_back(); }),
              HasSubstr("the certificate has 5 contact candidates, the structure has 4"));
  EXPECT_THAT(refusal([](Structure& s) { s.contact[1].friction = 2; }),
              HasSubstr("the friction at r2 is 1"));
  EXPECT_THAT(refusal([](Structure& s) { s.dimension = 3; }), HasSubstr("dimension"));
  EXPECT_THAT(
      refusal([](Structure& s) { s.bars.clear(); }),
      HasSubstr(
          "the certificate has 0 rigid-body modes of unconstrained bodies, the structure has 10"));
}

// Differences below the tolerance of the comparison do not lead to a proof for the wrong structure
// either, since the proof uses the structure's K alone.
TEST(Consistency, ProofsUseTheKOfTheStructure) {
  const auto structure = structure_of("plane-truss.toml");
  const auto certificate = read_certificate(searched(example("plane-truss.toml"), 1.0).text(), "c");
  auto other = structure;
  for (auto& bar : other.bars) bar.axial_stiffness *= 1 + 1e-9;
  const auto one = std::get<ConsistentStructure>(consistency(certificate, structure));
  const auto two = std::get<ConsistentStructure>(consistency(certificate, other));
  const double ratio =
      two.stiffness.middle.entries[0].nearest() / one.stiffness.middle.entries[0].nearest();
  EXPECT_NEAR(ratio - 1, 1e-9, 1e-15);
  EXPECT_EQ(one.friction, 1.0);
}

// The certificate `draft` with mu times the given relative frictions.
Certificate with_frictions(Draft draft, double mu, const std::vector<double>& relative) {
  for (auto& line : draft.header) {
    if (!line.starts_with("friction")) continue;
    line = "friction";
    for (const double factor : relative) {
      char number[64];
      std::snprintf(number, sizeof number, " %a", mu * factor);
      line += number;
    }
    line += "\n";
  }
  return read_certificate(draft.text(), "c");
}

TEST(Consistency, FrictionsAreThoseOfTheFileTimesOneCoefficient) {
  auto structure = structure_of("plane-truss.toml");
  const auto draft = searched(example("plane-truss.toml"), 1.0);
  const std::vector<double> relative{1, 0.1, 3, 0.7, 0};
  for (std::size_t i = 0; i < relative.size(); ++i) structure.contact[i].friction = relative[i];
  const auto certificate = with_frictions(draft, 0.3, relative);
  const auto found = consistency(certificate, structure);
  ASSERT_TRUE(std::holds_alternative<ConsistentStructure>(found)) << std::get<std::string>(found);
  EXPECT_EQ(std::get<ConsistentStructure>(found).friction, 0.3);
  structure.contact[4].friction = 1e-3;
  EXPECT_THAT(std::get<std::string>(consistency(certificate, structure)),
              HasSubstr("the friction at r5 is 0"));
}

TEST(Consistency, FirstCandidatesWithoutFrictionFixTheCoefficientAtZero) {
  const auto structure = structure_of("plane-truss.toml");
  const auto draft = searched(example("plane-truss.toml"), 1.0);
  EXPECT_THAT(
      std::get<std::string>(consistency(with_frictions(draft, 0.5, {0, 1, 1, 1, 1}), structure)),
      HasSubstr("the friction at r2 is 0.5"));
  EXPECT_THAT(
      std::get<std::string>(consistency(with_frictions(draft, 0.5, {0, 0, 0, 0, 1}), structure)),
      HasSubstr("the friction at r5 is 0.5"));
}

// Two disconnected towers may be two blocks or one; connected ones may not be two.
TEST(Consistency, BlocksMustBeUnconnectedInTheStructure) {
  auto structure = structure_of("two-bars.toml");
  const auto single = searched(example("two-bars.toml"), 3.0);
  const auto nodes = structure.names.size();
  for (std::size_t node = 0; node < nodes; ++node) {
    structure.coordinates.push_back(structure.coordinates[node]);
    structure.fixed.push_back(structure.fixed[node]);
    structure.names.push_back("b-" + structure.names[node]);
    structure.names[node] = "a-" + structure.names[node];
  }
  for (std::size_t bar = 0; bar < 2; ++bar) {
    auto copy = structure.bars[bar];
    copy.first += nodes;
    copy.second += nodes;
    structure.bars.push_back(copy);
  }
  structure.contact.push_back(structure.contact[0]);
  structure.contact[1].node += nodes;
  const auto text = in_blocks(single, single).text();
  const auto said = verdict(text, &structure);
  EXPECT_THAT(said.refusals, IsEmpty());
  EXPECT_THAT(said.feasible, ElementsAre(1U, 2U));
  // A bar between the two, of any stiffness.
  Bar weak;
  weak.first = structure.contact[0].node;
  weak.second = structure.contact[1].node;
  weak.axial_stiffness = 1e-40;
  structure.coordinates[weak.second][0] += 0x1p-40;
  structure.bars.push_back(weak);
  EXPECT_THAT(verdict(text, &structure).refusals,
              ElementsAre(HasSubstr("in different blocks, but the structure connects them")));
}

// Stiffnesses from 1 to 1e9: K in double precision has few correct digits, and t* = 0 is near.
TEST(Consistency, IsShownForStiffnessesNineOrdersApart) {
  const auto file = problems::read_structure(R"(
name = "contrast"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
a = [0.0, 0.0]
b = [1.0, 0.3]
c = [-0.98, 1.53]
tip = [1.13, 2.66]
[[members]]
EA = 1.0
between = [["a","c"], ["b","c"], ["b","tip"]]
[[members]]
EA = 1000000000.0
between = [["c","tip"]]
[[supports]]
nodes = ["a", "b"]
[[contact]]
nodes = ["tip"]
normal = [0.99, -0.1]
)",
                                             "contrast.toml");
  const auto structure = evidence::verified_structure(file);
  const auto problem = problems::wedged_problem(file);
  for (const double mu : {100.0, 107.0, 108.5, 120.0}) {
    const auto said = verdict(searched(problem, mu).text(), &structure);
    EXPECT_THAT(said.refusals, IsEmpty()) << mu;
    EXPECT_EQ(said.feasible.size(), mu > 107.78064 ? 1U : 0U) << mu;
  }
}

}  // namespace
}  // namespace kusabi::verify
