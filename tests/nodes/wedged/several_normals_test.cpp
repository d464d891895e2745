// Searches with several contact normals at a node: compared with all sign patterns by linear
// programs, with two nodes connected by a stiff matrix, with rays, and with statics.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/search.hpp"
#include "engine/transport/single_process.hpp"
#include "nodes/wedged/critical_search.hpp"
#include "nodes/wedged/rays/ray_search.hpp"
#include "nodes/wedged/tree/maximal_cones.hpp"
#include "nodes/wedged/tree/sign_pattern_tree.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "random_truss.hpp"
#include "solvers/linear/simplex.hpp"
#include "tests/problems/bodies.hpp"

namespace kusabi::wedged {
namespace {

using Contacts = std::set<support::IndexSet>;
/// (S, G): candidates with reactions and with gaps in a cone.
using Cones = std::set<std::pair<support::IndexSet, support::IndexSet>>;

std::vector<double> everywhere(const problems::WedgedProblem& problem, double mu) {
  return std::vector<double>(problem.contact_names.size(), mu);
}

std::vector<Configuration> leaves_of(problems::WedgedProblem problem, double mu) {
  problem.blocks.clear();
  SignPatternTree tree(problem, everywhere(problem, mu));
  std::vector<Configuration> leaves;
  for (auto& found : engine::search(tree).solutions) leaves.push_back(std::move(found.solution));
  return maximal_cones(std::move(leaves));
}

/// @param minimum of t*  @param open counts undecided leaves
Contacts feasible(const problems::WedgedProblem& problem, double mu, double minimum, int& open) {
  Contacts result;
  for (const auto& leaf : leaves_of(problem, mu)) {
    open += leaf.state != LeafState::feasible && leaf.state != LeafState::flat;
    if (leaf.state == LeafState::feasible && leaf.lower > minimum)
      result.insert(leaf.pattern.contact);
  }
  return result;
}

/// A truss in the plane whose first candidates are at nodes with several contact normals.
problems::Structure truss_in_corners(int candidates, int corners, std::mt19937_64& bits) {
  const auto [held, problem] = testing::random_problem(
      {.dimension = 2, .candidates = candidates, .free_nodes = candidates + 2}, bits);
  auto structure = held;
  std::uniform_real_distribution<double> turn(0.5, 2.6);
  for (int i = 0; i < corners; ++i) {
    auto other = structure.contact[static_cast<std::size_t>(i)];
    const double angle = turn(bits);
    other.normal = Eigen::Rotation2Dd(angle) * Eigen::Vector2d(other.normal);
    structure.contact.push_back(other);
  }
  return structure;
}

/// t* of (P) at a leaf, by the simplex method, from an F of independent origin: nothing if no
/// reactions are possible. In the plane.
std::optional<double> margin(const Eigen::MatrixXd& f, const support::IndexSet& contact,
                             double mu) {
  const int m = static_cast<int>(f.rows()) / 2;
  linear::LinearProgram program;
  const double free = linear::infinity;
  const int t = program.add_column({-1, -free, free});
  std::vector<int> columns;  // r_n, r_t of each candidate
  std::vector<linear::LinearTerm> sum;
  for (int i = 0; i < m; ++i) {
    const double maximum = contact.contains(i) ? free : 0;
    columns.push_back(program.add_column({0, 0, maximum}));
    columns.push_back(program.add_column({0, -maximum, maximum}));
    sum.push_back({columns[static_cast<std::size_t>(2 * i)], 1});
  }
  program.add_row({1, 1}, sum);
  for (int i = 0; i < m; ++i) {
    std::vector<linear::LinearTerm> moves;
    for (int k = 0; k < 2 * m; ++k)
      moves.push_back({columns[static_cast<std::size_t>(k)], f(2 * i, k)});
    const int normal = columns[static_cast<std::size_t>(2 * i)];
    const int tangential = columns[static_cast<std::size_t>(2 * i + 1)];
    if (contact.contains(i)) {
      program.add_row({0, 0}, moves);
      for (const double sign : {-1.0, 1.0}) {
        program.add_row({0, free},
                        std::vector<linear::LinearTerm>{{normal, mu}, {tangential, sign}, {t, -1}});
      }
    } else {
      moves.push_back({t, -1});
      program.add_row({0, free}, moves);
    }
  }
  linear::Simplex simplex(program);
  if (simplex.solve_robustly() != linear::LinearStatus::optimal) return std::nullopt;
  return simplex.value(t);
}

TEST(SeveralNormals, HaveThePatternsOfALinearProgramForEachLeaf) {
  constexpr double accuracy = 1e-6;  // accuracy of the simplex method in doubles
  std::mt19937_64 bits(5);
  int open = 0;
  std::size_t patterns = 0;
  std::size_t of_corners = 0;
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE(trial);
    const auto structure = truss_in_corners(3, 1 + trial % 3, bits);
    Eigen::MatrixXd f = problems::test::compliance_by_multipliers(structure);
    f /= f.diagonal().mean();
    // Entries between unconnected candidates are set to zero; the simplex method would scale
    // rounding errors up.
    f = (f.array().abs() < 1e-13).select(Eigen::MatrixXd::Zero(f.rows(), f.cols()), f).eval();
    const int m = static_cast<int>(structure.contact.size());
    for (const double mu : {0.4, 1.2}) {
      const auto found = feasible(problems::wedged_problem(checked(structure)), mu, 0, open);
      for (std::uint64_t ones = 1; ones < std::uint64_t{1} << static_cast<unsigned>(m); ++ones) {
        const support::IndexSet contact = ones;
        const double maximum = margin(f, contact, mu).value_or(-1);
        if (std::abs(maximum) <= accuracy) continue;
        EXPECT_EQ(found.contains(contact), maximum > 0) << mu << ' ' << maximum << ' ' << ones;
        patterns += maximum > 0;
        of_corners += maximum > 0 && contact.contains(0) && contact.contains(3);
      }
    }
  }
  EXPECT_EQ(open, 0);
  EXPECT_GT(patterns, 60U);
  EXPECT_GT(of_corners, 10U);
}

/// The second candidates at nodes of their own, connected by a very stiff matrix.
problems::Structure tied_apart(problems::Structure structure, double stiffness) {
  std::set<int> seen;
  for (auto& candidate : structure.contact) {
    const int node = candidate.node;
    if (seen.insert(node).second) continue;
    const int twin = static_cast<int>(structure.node_names.size());
    structure.node_names.push_back("twin" + std::to_string(twin));
    structure.coordinates.conservativeResize(Eigen::NoChange, twin + 1);
    structure.coordinates.col(twin) = structure.coordinates.col(node);
    structure.fixed.push_back({});
    problems::Superelement tie;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(4, 4);
    for (int axis = 0; axis < 2; ++axis) {
      tie.rows.push_back({node, axis});
      tie.rows.push_back({twin, axis});
      matrix.block(2 * axis, 2 * axis, 2, 2) << stiffness, -stiffness, -stiffness, stiffness;
    }
    tie.stiffness = matrix.sparseView();
    structure.superelements.push_back(std::move(tie));
    candidate.node = twin;
  }
  return structure;
}

// The stiff connection deforms by 1e-8, which lets inactive candidates move by that much. Patterns
// with margins of this size are due to the connection and are not compared.
TEST(SeveralNormals, AreEquivalentToTwoNodesInAStiffConnection) {
  constexpr double of_the_tie = 1e-6;
  int open = 0;
  int open_of_the_tie = 0;
  std::mt19937_64 bits(6);
  std::size_t patterns = 0;
  for (int trial = 0; trial < 40; ++trial) {
    SCOPED_TRACE(trial);
    const auto structure = truss_in_corners(3, 2, bits);
    const auto tied = tied_apart(structure, 1e8);
    for (const double mu : {0.5, 1.5}) {
      const auto own = feasible(problems::wedged_problem(checked(structure)), mu, 0, open);
      EXPECT_EQ(own,
                feasible(problems::wedged_problem(checked(tied)), mu, of_the_tie, open_of_the_tie));
      patterns += own.size();
    }
  }
  EXPECT_EQ(open, 0);
  EXPECT_GT(patterns, 40U);
}

RayFindings rays_of(const problems::Structure& structure, double mu, RayMethod method) {
  const auto problem = problems::wedged_problem(checked(structure));
  const auto friction = everywhere(problem, mu);
  const auto cone = reaction_cone(problem, friction);
  engine::SingleProcess alone;
  engine::Analysis analysis(alone);
  return find_rays(analysis, problem, friction, cone, method);
}

TEST(SeveralNormals, HaveRaysWhoseCliquesAreThePatterns) {
  std::mt19937_64 bits(7);
  std::size_t cones = 0;
  for (int trial = 0; trial < 30; ++trial) {
    SCOPED_TRACE(trial);
    const auto structure = truss_in_corners(3, 1 + trial % 2, bits);
    const auto problem = problems::wedged_problem(checked(structure));
    for (const double mu : {0.5, 1.5}) {
      const auto found = rays_of(structure, mu, RayMethod::double_description);
      EXPECT_TRUE(found.health.sound());
      EXPECT_EQ(found.rays, rays_of(structure, mu, RayMethod::tree).rays);
      Cones cliques;
      for (const auto& each : found.cones) cliques.emplace(each.reaction, each.separated);
      Cones patterns;
      for (const auto& leaf : leaves_of(problem, mu))
        patterns.emplace(leaf.pattern.contact, leaf.pattern.separated);
      EXPECT_EQ(cliques, patterns);
      cones += cliques.size();
    }
  }
  EXPECT_GT(cones, 40U);
}

problems::Structure read(const std::string& text) {
  return problems::read_structure(
      "name = \"g\"\ndimension = 2\nunits = { length = \"m\", force = \"N\" }\n" + text, "g");
}

/// A triangle of bars in a groove whose walls are at `theta` to the vertical, its point at the
/// bottom.
problems::Structure wedge_in_groove(double theta) {
  const double c = std::cos(theta), s = std::sin(theta), w = std::tan(theta);
  return read(fmt::format(
      "[nodes]\npoint = [0, 0]\nleft = [{}, 1]\nright = [{}, 1]\ntop = [0, 1.5]\n"
      "[[members]]\nEA = 1\nbetween = [[\"point\", \"left\"], [\"point\", \"right\"], [\"left\", "
      "\"right\"], [\"left\", \"top\"], [\"right\", \"top\"], [\"point\", \"top\"]]\n"
      "[[contact]]\nname = \"l\"\nnodes = [\"point\", \"left\"]\nnormal = [{}, {}]\n"
      "[[contact]]\nname = \"r\"\nnodes = [\"point\", \"right\"]\nnormal = [{}, {}]\n",
      -w, w, c, s, -c, s));
}

/// A tip on two equal bars at right angles, in the same groove: its displacement is parallel to the
/// force, so neither wall alone can wedge it.
problems::Structure tip_in_groove(double theta) {
  const double c = std::cos(theta), s = std::sin(theta);
  return read(
      fmt::format("[nodes]\ntip = [0, 0]\na = [-1, 1]\nb = [1, 1]\n"
                  "[[members]]\nEA = 1\nbetween = [[\"tip\", \"a\"], [\"tip\", \"b\"]]\n"
                  "[[supports]]\nnodes = [\"a\", \"b\"]\n"
                  "[[contact]]\nnodes = [\"tip\"]\nnormal = [{0}, {1}]\n"
                  "[[contact]]\nnodes = [\"tip\"]\nnormal = [-{0}, {1}]\n",
                  c, s));
}

CriticalFindings critical(const problems::Structure& structure) {
  engine::SingleProcess alone;
  engine::Analysis analysis(alone, {});
  const auto own = checked(structure);
  return find_critical_friction(analysis, own, problems::wedged_problem(own), {.width = 1e-8});
}

TEST(SeveralNormals, OfAGrooveWedgeFromTheTangentOfItsHalfAngle) {
  for (const double degrees : {10.0, 30.0}) {
    const double theta = degrees * std::numbers::pi / 180;
    const auto found = critical(tip_in_groove(theta));
    ASSERT_TRUE(found.bracket.upper);
    EXPECT_LT(found.bracket.at_least(), std::tan(theta) + 1e-12);
    EXPECT_GT(found.bracket.at_most(), std::tan(theta) - 1e-12);
    EXPECT_LE(found.bracket.at_most() - found.bracket.at_least(), 2.5e-8);
    EXPECT_TRUE(is_proved(found.bracket.lower) && is_proved(found.bracket.upper));
  }
}

// The point touches the bottom, so the wedge cannot be squeezed: only its point is wedged, and the
// other candidates are inactive.
TEST(SeveralNormals, AtTheBottomOfAWedgeAreTheOnlyLoadedCandidates) {
  for (const double degrees : {10.0, 30.0}) {
    const double theta = degrees * std::numbers::pi / 180;
    const auto structure = wedge_in_groove(theta);
    const auto problem = problems::wedged_problem(checked(structure));
    EXPECT_EQ(problem.contact_names,
              (std::vector<std::string>{"point@l", "left", "point@r", "right"}));
    EXPECT_TRUE(leaves_of(problem, std::tan(theta) * 0.999).empty());
    const auto above = leaves_of(problem, std::tan(theta) * 1.001);
    ASSERT_EQ(above.size(), 1U);
    EXPECT_EQ(above[0].state, LeafState::flat);
    EXPECT_EQ(above[0].pattern.contact, support::IndexSet(0b0101));
    EXPECT_EQ(above[0].pattern.inactive, support::IndexSet(0b1010));
    const auto found = critical(structure);
    ASSERT_TRUE(found.bracket.upper);
    EXPECT_GT(found.bracket.at_most(), std::tan(theta) - 1e-12);
    EXPECT_LT(found.bracket.at_least(), std::tan(theta) + 1e-12);
    EXPECT_GT(found.bracket.at_least(), std::tan(theta) - 1e-4);
    EXPECT_TRUE(is_proved(found.bracket.lower));
  }
}

// Exchange of left and right exchanges the patterns.
TEST(SeveralNormals, OfASymmetricStructureHaveSymmetricPatterns) {
  const auto structure = read(
      "[nodes]\ntip = [0, 0]\na = [-1, 1]\nb = [1, 1]\nc = [-1, 2]\nd = [1, 2]\n"
      "[[members]]\nEA = 1\nbetween = [[\"tip\", \"a\"], [\"tip\", \"b\"], [\"a\", \"b\"], [\"a\", "
      "\"c\"], [\"b\", \"d\"], [\"a\", \"d\"], [\"b\", \"c\"]]\n"
      "[[supports]]\nnodes = [\"c\", \"d\"]\n"
      "[[contact]]\nnodes = [\"a\"]\nnormal = [4, 1]\n"
      "[[contact]]\nnodes = [\"tip\"]\nnormal = [2, 1]\n"
      "[[contact]]\nnodes = [\"tip\"]\nnormal = [-2, 1]\n"
      "[[contact]]\nnodes = [\"b\"]\nnormal = [-4, 1]\n");
  const auto problem = problems::wedged_problem(checked(structure));
  EXPECT_THAT(problem.contact_names, ::testing::ElementsAre("a", "tip@1", "tip@2", "b"));
  std::size_t found = 0;
  for (const double mu : {0.8, 3.0, 12.0}) {
    Cones cones;
    Cones mirrored;
    const auto mirror = [](const support::IndexSet& set) {
      support::IndexSet result;
      for (const int i : set) result.insert(3 - i);
      return result;
    };
    for (const auto& leaf : leaves_of(problem, mu)) {
      cones.emplace(leaf.pattern.contact, leaf.pattern.separated);
      mirrored.emplace(mirror(leaf.pattern.contact), mirror(leaf.pattern.separated));
    }
    EXPECT_EQ(cones, mirrored) << mu;
    found += cones.size();
  }
  EXPECT_GT(found, 2U);
}

}  // namespace
}  // namespace kusabi::wedged
