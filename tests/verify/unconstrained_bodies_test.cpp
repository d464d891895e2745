// Certificates of unconstrained bodies: by hand, written by a search, and falsified.
#include <array>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/search.hpp"
#include "nodes/evidence/verified_structure.hpp"
#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/evidence/certificate_file.hpp"
#include "searched.hpp"
#include "support/thorough.hpp"
#include "verify/arithmetic/elimination.hpp"
#include "verify/structure/contact_motions.hpp"
#include "verify/structure/enclosed_problem.hpp"
#include "verify/wedged/certificate.hpp"
#include "verify/wedged/consistency.hpp"
#include "verify/wedged/proof.hpp"

namespace kusabi::verify {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A bar from (-1, 0) to (1, 0), EA = 2, between walls with normals (c, s) and (-c, s).
struct BarBetweenWalls {
  double c;
  double s;

  [[nodiscard]] Structure structure() const {
    Structure bar;
    bar.dimension = 2;
    bar.names = {"a", "b"};
    bar.coordinates = {{-1, 0, 0}, {1, 0, 0}};
    bar.fixed.resize(2);
    bar.bars = {{0, 1, 2, 0, 0}};
    bar.contact.resize(2);
    bar.contact[0].normal = {c, s, 0};
    bar.contact[1] = bar.contact[0];
    bar.contact[1].node = 1;
    bar.contact[1].normal = {-c, s, 0};
    return bar;
  }

  // By hand: the bar's elongation is -c u_na - s u_ta - c u_nb + s u_tb, EA/L = 1; the modes are
  // translations along x and y, and the rotation about the middle.
  [[nodiscard]] Draft draft(double mu, const std::vector<std::string>& nodes) const {
    const std::array stretch{-c, -s, -c, s};
    Draft draft;
    draft.header = {"kusabi certificate 5 contact\n",
                    "dimension 2\n",
                    "candidates 2\n",
                    "name a\n",
                    "name b\n",
                    fmt::format("friction {0:a} {0:a}\n", mu),
                    "blocks 1\n",
                    "block 3\n",
                    "stiffness\n"};
    for (std::size_t i = 0; i < 4; ++i) {
      std::vector<std::string> row;
      for (std::size_t j = 0; j <= i; ++j)
        row.push_back(fmt::format("{:a}", stretch[i] * stretch[j]));
      draft.header.push_back(fmt::format("{}\n", fmt::join(row, " ")));
    }
    draft.header.emplace_back("motions 3\n");
    for (const auto& row : {std::array{c, s, -s}, {s, -c, c}, {-c, s, s}, {s, c, c}})
      draft.header.push_back(fmt::format("{:a} {:a} {:a}\n", row[0], row[1], row[2]));
    draft.nodes = nodes;
    return draft;
  }
};

std::string node(const std::string& start, const std::vector<double>& numbers) {
  std::string line = start;
  for (const double number : numbers) line += fmt::format(" {:a}", number);
  return line + '\n';
}

constexpr BarBetweenWalls groove{0.6, 0.8};  // wedges from mu = 4/3

// The reaction of a single candidate is not in equilibrium: a displacement along its normal proves
// it.
std::vector<std::string> wedged_nodes() {
  return {node("wedged 1 3 0", {0.8, -0.8, 0, 0, 0}),
          node("infeasible 1 0 1", {0, 0, 0.6, -0.8, 0}),
          node("infeasible 1 1 2", {0, 0, -0.6, -0.8, 0})};
}

void expect_proved(const Draft& draft, const Structure& structure, std::size_t feasible) {
  for (const auto* given : {static_cast<const Structure*>(nullptr), &structure}) {
    const auto said = verdict(draft.text(), given);
    EXPECT_THAT(said.refusals, IsEmpty());
    EXPECT_EQ(said.feasible.size(), feasible);
    EXPECT_EQ(said.marginal, 0U);
  }
}

void expect_refused(const Draft& draft, const Structure& structure, const std::string& why) {
  for (const auto* given : {static_cast<const Structure*>(nullptr), &structure})
    EXPECT_THAT(verdict(draft.text(), given).refusals, Contains(HasSubstr(why)));
}

TEST(UnconstrainedBar, WedgesInAGrooveAboveTheTangentOfItsHalfAngle) {
  expect_proved(groove.draft(1.334, wedged_nodes()), groove.structure(), 1);
  expect_refused(groove.draft(1.333, wedged_nodes()), groove.structure(), "slips");
}

TEST(UnconstrainedBar, DoesNotWedgeInAGrooveBelowTheTangentOfItsHalfAngle) {
  const auto up = std::vector{node("infeasible 1 0 0", {0, 0, 0, -1, 0})};
  expect_proved(groove.draft(1.333, up), groove.structure(), 0);
  expect_refused(groove.draft(1.334, up), groove.structure(), "do not rule out");
  const auto down = std::vector{node("infeasible 1 0 0", {0, 0, 0, 1, 0})};
  expect_refused(groove.draft(1.333, down), groove.structure(), "do not rule out");
}

// The directions given in a file have irrational lengths; sliding modes are exact all the same.
TEST(UnconstrainedBar, IsProvedForNormalsOfIrrationalLength) {
  for (const auto& [c, s] : {std::pair(1.0, 0.3), {3.0, 4.0}, {0.1, 0.7}}) {
    const double length = std::hypot(c, s);
    const BarBetweenWalls bar{c / length, s / length};
    auto structure = bar.structure();
    structure.contact[0].normal = {c, s, 0};
    structure.contact[1].normal = {-c, s, 0};
    auto nodes = wedged_nodes();
    nodes[0] = node("wedged 1 3 0", {bar.s, -bar.s, 0, 0, 0});
    nodes[1] = node("infeasible 1 0 1", {0, 0, bar.c, -bar.s, 0});
    nodes[2] = node("infeasible 1 1 2", {0, 0, -bar.c, -bar.s, 0});
    EXPECT_THAT(verdict(bar.draft(s / c * 1.001, nodes).text(), &structure).refusals, IsEmpty());
    EXPECT_THAT(verdict(bar.draft(s / c * 0.999, nodes).text(), &structure).refusals,
                Contains(HasSubstr("slips")));
  }
}

// Between parallel walls nothing can be squeezed: pulled at both ends the bar moves away from both.
TEST(UnconstrainedBar, BetweenParallelWallsNeedsMultipliersInEquilibrium) {
  const BarBetweenWalls walls{1, 0};
  const auto nodes = [](double first, double second) {
    return std::vector{node("infeasible 1 3 0", {first, second, 0, 0, 0}),
                       node("infeasible 1 0 1", {0, 0, 1, 0, 0}),
                       node("infeasible 1 1 2", {0, 0, -1, 0, 0})};
  };
  expect_proved(walls.draft(5, nodes(-1, -1)), walls.structure(), 0);
  // The nearest multipliers in equilibrium push, or are zero.
  expect_refused(walls.draft(5, nodes(-1, 2)), walls.structure(), "do not rule out");
  expect_refused(walls.draft(5, nodes(-1, 1)), walls.structure(), "do not rule out");
  expect_refused(walls.draft(5, nodes(0, 0)), walls.structure(), "do not rule out");
  // Multipliers outside U must not be negative.
  auto inner = nodes(-1, -1);
  inner[0] = node("infeasible 1 1 0", {-1, -1, 0, 0, 0});
  expect_refused(walls.draft(5, inner), walls.structure(), "do not rule out");
}

// Between walls that are parallel up to 1e-9 the bar is wedged only in configurations that slide a
// billion times farther than it strains. Up to 1e-5 it need not move that far.
TEST(UnconstrainedBar, BetweenNearlyParallelWallsIsInfeasibleExceptForLargeDisplacements) {
  const auto said = [](double lean, const std::string& first) {
    const auto structure = BarBetweenWalls{1, lean}.structure();
    const std::vector nodes{first, node("infeasible 1 0 1", {0, 0, 1, 0, 0}),
                            node("infeasible 1 1 2", {0, 0, -1, 0, 0})};
    return verdict(BarBetweenWalls{1, lean}.draft(5, nodes).text(), &structure);
  };
  const auto squeezed = node("infeasible 1 3 0", {-1, -1, 0, 0, 0});
  EXPECT_THAT(said(1e-9, squeezed).refusals, IsEmpty());
  EXPECT_EQ(said(1e-9, squeezed).except_large_displacements, 1U);
  EXPECT_THAT(said(1e-5, squeezed).refusals, Contains(HasSubstr("do not rule out")));
  EXPECT_THAT(said(1e-5, node("wedged 1 3 0", {1e-5, -1e-5, 0, 0, 0})).refusals, IsEmpty());
}

TEST(UnconstrainedBar, IsNotProvedByAlteredForcesOrModes) {
  const auto structure = groove.structure();
  auto pulled = wedged_nodes();
  pulled[0] = node("wedged 1 3 0", {0.8, 0.8, 0, 0, 0});
  expect_refused(groove.draft(2, pulled), structure, "not pressed");
  auto altered = groove.draft(1.4, wedged_nodes());
  auto& row = altered.header.back();
  row = node(fmt::format("{:a} {:a}", groove.s, groove.c), {groove.c + 1e-3});
  EXPECT_THAT(verdict(altered.text(), &structure).refusals,
              ElementsAre(HasSubstr("motion 3 is not a rigid-body mode of the structure")));
  auto fewer = groove.draft(1.4, {});
  fewer.header.erase(fewer.header.end() - 5, fewer.header.end());
  fewer.header.emplace_back("motions 0\n");
  EXPECT_THAT(
      verdict(fewer.text(), &structure).refusals,
      ElementsAre(HasSubstr("0 rigid-body modes of unconstrained bodies, the structure has 3")));
  EXPECT_THAT(verdict(fewer.text()).refusals, ElementsAre("K"));
}

TEST(UnconstrainedBar, RequiresTheRightNumberOfModes) {
  EXPECT_THROW(verdict(groove.draft(1, {node("infeasible 1 0 0", {0, 0, 0, -1})}).text()),
               CertificateError);
  EXPECT_THROW(verdict(groove.draft(1, {node("wedged 1 3 0", {0, 0})}).text()), CertificateError);
}

problems::Structure read(const std::string& text) {
  return problems::read_structure("units = { length = \"mm\", force = \"N\" }\n" + text, "test");
}

Verdict proved(const problems::Structure& structure, double mu, bool of_structure = true) {
  const auto text = written(problems::wedged_problem(checked(structure)), mu);
  const auto own = evidence::verified_structure(structure);
  return verdict(text, of_structure ? &own : nullptr);
}

// A block in a groove of half angle 15 degrees, as a mesh.
problems::Structure block(int columns, int rows) {
  return read(fmt::format(R"(
name = "block"
dimension = 2
[[mesh]]
name = "b"
corners = [[9, 5], [11, 5], [11.535898384862246, 7], [8.464101615137754, 7]]
divisions = [{}, {}]
E = 200
nu = 0.3
thickness = 1
plane = "strain"
[[contact]]
nodes = ["b.left"]
normal = [0.9659258262890683, 0.25881904510252074]
[[contact]]
nodes = ["b.right"]
normal = [-0.9659258262890683, 0.25881904510252074]
)",
                          columns, rows));
}

TEST(UnconstrainedBlock, IsProvedToWedgeFromTheTangentOfTheHalfAngle) {
  const double critical = 0.2679491924311227;
  for (const int rows : {1, 2, 4}) {
    for (const bool of_structure : {true, false}) {
      const auto below = proved(block(2, rows), critical * (1 - 1e-6), of_structure);
      EXPECT_THAT(below.refusals, IsEmpty());
      EXPECT_THAT(below.feasible, IsEmpty());
      EXPECT_EQ(below.marginal, 0U);
      const auto above = proved(block(2, rows), critical * 1.2, of_structure);
      EXPECT_THAT(above.refusals, IsEmpty());
      EXPECT_FALSE(above.feasible.empty());
      EXPECT_EQ(above.marginal, 0U);
    }
  }
}

// Random unconstrained trusses, some on a roller: all results are proved.
problems::Structure random_truss(int dimension, int nodes, std::mt19937& bits) {
  std::uniform_real_distribution<double> place(-1, 1);
  std::string text = fmt::format("name = \"t\"\ndimension = {}\n[nodes]\n", dimension);
  std::vector<std::vector<double>> places;
  for (int i = 0; i < nodes; ++i) {
    auto& own = places.emplace_back();
    for (int k = 0; k < dimension; ++k) own.push_back(place(bits));
    text += fmt::format("n{} = [{}]\n", i, fmt::join(own, ", "));
  }
  text += "[[members]]\nEA = 3\nbetween = [";
  for (int i = 0; i < nodes; ++i) {
    for (int j = 0; j < i; ++j) text += fmt::format("[\"n{}\", \"n{}\"],", i, j);
  }
  text += "]\n";
  for (int i = 0; i + 1 < nodes; ++i) {  // walls around it, such that it may be wedged
    std::vector<double> normal;
    for (const double x : places[static_cast<std::size_t>(i)])
      normal.push_back(-x + 0.5 * place(bits));
    text +=
        fmt::format("[[contact]]\nnodes = [\"n{}\"]\nnormal = [{}]\n", i, fmt::join(normal, ", "));
  }
  if (bits() % 3 == 0)
    text += fmt::format("[[supports]]\nnodes = [\"n{}\"]\nfixed = [\"x\"]\n", nodes - 1);
  return read(text);
}

TEST(UnconstrainedTrusses, HaveSearchResultsThatAreProved) {
  std::mt19937 bits(7);
  std::size_t feasible = 0;
  std::size_t infeasible = 0;
  std::size_t marginal = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const int dimension = trial % 2 == 0 ? 2 : 3;
    const auto truss = random_truss(dimension, 4 + trial % 3, bits);
    const double mu = trial % 4 < 2 ? 0.4 : 1.0;
    const auto check = [&](bool of_structure) {
      const auto said = proved(truss, mu, of_structure);
      EXPECT_THAT(said.refusals, IsEmpty()) << trial;
      feasible += said.feasible.size();
      infeasible += said.infeasible;
      marginal += said.marginal;
    };
    check(true);
    // In space two contacts are in equilibrium only along the line between them: a G of doubles has
    // no such line, so that without the structure no reactions are in equilibrium.
    if (dimension == 2) check(false);
  }
  EXPECT_GT(feasible, 20U);
  EXPECT_GT(infeasible, 100U);
  EXPECT_LE(marginal, feasible / 10);  // undecided in the search
}

// No evidence proves a node infeasible that contains a configuration, be it a leaf or an inner
// node.
TEST(UnconstrainedTrusses, AreNotProvedInfeasibleWhereTheyWedge) {
  std::mt19937 bits(11);
  std::size_t tried = 0;
  for (int trial = 0; trial < (test::thorough ? 16 : 6); ++trial) {
    const auto truss = random_truss(trial % 2 == 0 ? 2 : 3, 5, bits);
    const auto text = written(problems::wedged_problem(checked(truss)), 1.0);
    const auto certificate = read_certificate(text, "test");
    const auto agreed = std::get<ConsistentStructure>(
        consistency(certificate, evidence::verified_structure(truss)));
    const Proof proof(certificate, agreed.stiffness, agreed.motions);
    for (const auto& leaf : certificate.states) {
      for (auto node : certificate.nodes) {
        if (node.claim != Claim::infeasible) continue;
        node.contact = leaf.contact;
        node.separated = leaf.separated;
        for (const int candidate : certificate.all_candidates()) {
          EXPECT_TRUE(proof.proof_result(node).refusal.has_value());
          ++tried;
          const auto one = support::IndexSet::single(candidate);
          node.contact -= one;
          node.separated -= one;
        }
      }
    }
  }
  EXPECT_GT(tried, test::thorough ? 500U : 200U);
}

// Two ends of a bar in a groove, and a third point on the floor, whose reaction must be zero: only
// friction could direct it to the line between the two.
TEST(UnconstrainedTrusses, HaveContactsThatAreUnloadedByEquilibrium) {
  const auto body = read(R"(
name = "tripod"
dimension = 3
[nodes]
a = [-1, 0, 0]
b = [1, 0, 0]
k = [0, 1, 0]
top = [0, 0.3, 1]
[[members]]
EA = 3
between = [["a", "b"], ["a", "k"], ["b", "k"], ["a", "top"], ["b", "top"], ["k", "top"]]
[[contact]]
nodes = ["a"]
normal = [0.9659258262890683, 0, 0.25881904510252074]
[[contact]]
nodes = ["b"]
normal = [-0.9659258262890683, 0, 0.25881904510252074]
[[contact]]
nodes = ["k"]
normal = [0, 0, 1]
)");
  const auto said = proved(body, 0.5);
  EXPECT_THAT(said.refusals, IsEmpty());
  EXPECT_EQ(said.feasible.size(), 1U);
  EXPECT_GT(said.marginal, 0U);
  EXPECT_EQ(said.unloaded, said.marginal);
  // At a feasible node no contact is without reaction.
  auto certificate =
      read_certificate(written(problems::wedged_problem(checked(body)), 0.5), "test");
  const auto agreed =
      std::get<ConsistentStructure>(consistency(certificate, evidence::verified_structure(body)));
  const Proof proof(certificate, agreed.stiffness, agreed.motions);
  for (const auto& state : certificate.states) {
    Node node{.contact = state.contact, .separated = state.separated};
    EXPECT_FALSE(proof.proof_result(node).unloaded);
    node.separated = {};  // the third has no reaction, but it is not in U
    EXPECT_FALSE(proof.proof_result(node).unloaded);
  }
}

// A triangle of bars and a node a million times farther away. A rotation of that node strains the
// triangle so little that, with its contacts fixed, the eigenvalues of K differ by a factor of
// 1e16.
TEST(UnconstrainedTrusses, AreProvedWithAVeryLongLever) {
  const auto lever = read(R"(
name = "lever"
dimension = 2
[nodes]
a = [0.7706521597981201, 0.018297834191031336]
b = [-0.16894052248598754, 0.8377311952464849]
c = [-0.7960570833301549, -0.4142136273628958]
far = [1360103.0763467862, 529428.8620135831]
[[members]]
EA = 0.6261946677920907
between = [["a", "b"]]
[[members]]
EA = 1.904562501691604
between = [["a", "c"]]
[[members]]
EA = 1.8687358362155064
between = [["b", "c"]]
[[members]]
EA = 1911966.2853108642
between = [["far", "c"]]
[[members]]
EA = 1418074.3514599341
between = [["far", "a"]]
[[contact]]
nodes = ["a"]
normal = [-0.9863508342967405, 0.1646573159082948]
[[contact]]
nodes = ["c"]
normal = [0.9057831897196091, 0.4237414461925697]
friction_factor = 0.37017046969364437
[[contact]]
nodes = ["b"]
normal = [0.5672571170074856, -0.8235407477498341]
[[contact]]
nodes = ["far"]
normal = [-1.0097363452536945, 0.1452424204884224]
friction_factor = 1.2632737347327885
)");
  const auto said = proved(lever, 1.55461);
  EXPECT_THAT(said.refusals, IsEmpty());
  EXPECT_EQ(said.feasible.size(), 8U);
  EXPECT_EQ(said.marginal, 0U);
}

TEST(ContactMotions, OfTheStructureAreRigidAndComplete) {
  std::mt19937 bits(3);
  for (const int dimension : {2, 3}) {
    const auto truss = evidence::verified_structure(random_truss(dimension, 5, bits));
    const auto problem = std::get<EnclosedProblem>(enclosed_problem(truss));
    const auto near = problem.motions.nearest();
    const auto p = problem.motions.count;
    EXPECT_GE(p, dimension == 2 ? 2U : 5U);
    const auto n = problem.stiffness.middle.size;
    for (std::size_t k = 0; k < p; ++k) {
      Rationals unit(p);
      unit[k] = 1;
      const auto forces =
          problem.stiffness.middle *
          restricted_to_candidates(problem.motions, unit).values;  // K G, to 46 digits
      for (std::size_t row = 0; row < n; ++row) EXPECT_LE(std::abs(forces[row].nearest()), 1e-40);
    }
    EXPECT_EQ(near.size(), n * p);
  }
}

TEST(Elimination, DetectsLinearDependence) {
  Elimination rest(3);
  EXPECT_TRUE(rest.add_equation({1, 2, 3}));
  EXPECT_FALSE(rest.add_equation({2, 4, 6}));
  EXPECT_TRUE(rest.add_equation({mpq_class(1, 3), 0, 1}));
  ASSERT_EQ(rest.basis().size(), 1U);
  EXPECT_EQ(dot(rest.basis()[0], {1, 2, 3}), 0);
  EXPECT_EQ(dot(rest.basis()[0], {1, 0, 3}), 0);
  EXPECT_EQ(rest.removed().size(), 2U);
  EXPECT_FALSE(solution({{1, 2}, {2, 4}}, {1, 3}).has_value());
  const auto x = *solution({{1, 2}, {2, 4}, {0, 1}}, {1, 2, 5});
  EXPECT_EQ(x, (Rationals{-9, 5}));
  EXPECT_FALSE(inverse_columns({{1, 2}, {2, 4}}).has_value());
  EXPECT_EQ(*inverse_columns({{0, 2}, {1, mpq_class(1, 3)}}),
            (std::vector<Rationals>{{mpq_class(-1, 6), mpq_class(1, 2)}, {1, 0}}));
}

}  // namespace
}  // namespace kusabi::verify
