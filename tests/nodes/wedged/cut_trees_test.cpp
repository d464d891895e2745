// Trees of sign patterns with cuts: results, sizes, and exact tests of their evidence.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/transport/single_process.hpp"
#include "nodes/evidence/verified_structure.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "nodes/wedged/tree/candidate_friction.hpp"
#include "nodes/wedged/tree/evidence_check.hpp"
#include "problems/families/plane_truss.hpp"
#include "problems/families/space_truss.hpp"
#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/wedged/problem_block.hpp"
#include "random_structure.hpp"
#include "support/input_error.hpp"
#include "support/thorough.hpp"
#include "verify/wedged/proof.hpp"

namespace kusabi::wedged {
namespace {

PatternFindings searched(const problems::WedgedProblem& problem, double mu, Tightening tightening,
                         const EvidenceRecorder& recorder = {}, bool thorough = false,
                         int probes = 0) {
  const std::vector<double> friction(problem.contact_names.size(), mu);
  engine::SingleProcess alone;
  engine::Analysis analysis(alone);
  PatternParameters parameters;
  parameters.tree.tightening = tightening;
  parameters.tree.thorough = thorough;
  parameters.tree.probes = probes;
  parameters.recorder = recorder;
  return find_patterns(analysis, problem, friction, parameters);
}

/// The same patterns in the same states; solid cones are bitwise equal, too, since a leaf's program
/// has no cuts.
void expect_same(const PatternFindings& with, const PatternFindings& without,
                 const std::string& where) {
  ASSERT_TRUE(with.whole() && without.whole());
  EXPECT_EQ(with.count(), without.count()) << where;
  ASSERT_EQ(with.leaves.size(), without.leaves.size()) << where;
  for (std::size_t i = 0; i < with.leaves.size(); ++i) {
    const auto& one = with.leaves[i];
    const auto& other = without.leaves[i];
    EXPECT_EQ(one.block, other.block) << where;
    EXPECT_EQ(one.pattern, other.pattern) << where;
    EXPECT_EQ(one.state, other.state) << where;
    if (one.state != LeafState::feasible || other.state != LeafState::feasible) continue;
    EXPECT_EQ(one.lower, other.lower) << where;
    EXPECT_EQ(one.upper, other.upper) << where;
    EXPECT_EQ(one.reaction, other.reaction) << where;
  }
}

bool is_open(const Configuration& leaf) {
  return leaf.state == LeafState::marginal || leaf.state == LeafState::undecided;
}

/// Number of compared leaves by kind.
struct Leaves {
  std::size_t all = 0, flat = 0, in_blocks = 0, cut_short = 0, bounds = 0;

  void compare(const problems::WedgedProblem& problem, double mu, const std::string& where) {
    const auto without = searched(problem, mu, Tightening::never);
    const auto with = searched(problem, mu, Tightening::always);
    EXPECT_TRUE(problem.modes.matrix.cols() > 0 || !with.bounds.empty()) << where;
    expect_same(with, without, where);
    const auto probed = searched(problem, mu, Tightening::always, {}, false, 3);
    expect_same(probed, without, where + ", probed");
    expect_same(searched(problem, mu, Tightening::never, {}, false, 3), without,
                where + ", probed without cuts");
    bounds += with.bounds.size();
    EXPECT_TRUE(without.bounds.empty()) << where;
    all += without.leaves.size();
    flat += without.flat;
    if (without.blocks.size() > 1) in_blocks += without.leaves.size();
    cut_short += with.outcome.opened() < without.outcome.opened() ? 1 : 0;
  }
};

class CutTreesIn : public ::testing::TestWithParam<int> {};

TEST_P(CutTreesIn, FindTheSamePatternsWithDegenerateNodesAndBlocks) {
  constexpr std::uint64_t seeds = test::thorough ? 300 : 80;
  Leaves compared;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    problems::WedgedProblem problem;
    try {
      problem = problems::wedged_problem(checked(random_structure(GetParam(), seed)));
    } catch (const support::InputError&) {  // a mechanism
      continue;
    }
    if (problem.modes.matrix.cols() > 0) continue;
    for (const double mu : {0.3, 0.7, 1.0, 3.0})
      compared.compare(problem, mu, fmt::format("seed {}, mu {}", seed, mu));
  }
  EXPECT_GT(compared.all, seeds / 3);
  EXPECT_GT(compared.flat, seeds / 15);
  EXPECT_GT(compared.in_blocks, seeds / 6);
  EXPECT_GT(compared.cut_short, seeds / 15);
}

/// The problems of random unconstrained bodies.
std::vector<problems::Structure> unconstrained_bodies(int dimension, std::size_t count) {
  std::vector<problems::Structure> bodies;
  for (std::uint64_t seed = 1; bodies.size() < count; ++seed) {
    auto structure = random_unconstrained_structure(dimension, seed);
    if (structure.contact.size() < 3) continue;
    try {
      if (problems::wedged_problem(checked(structure)).modes.matrix.cols() > 0)
        bodies.push_back(std::move(structure));
    } catch (const support::InputError&) {  // a mechanism
    }
  }
  return bodies;
}

TEST_P(CutTreesIn, FindTheSamePatternsOfUnconstrainedBodies) {
  Leaves compared;
  int number = 0;
  for (const auto& body : unconstrained_bodies(GetParam(), 40)) {
    const auto problem = problems::wedged_problem(checked(body));
    for (const double mu : {0.4, 1.0, 2.5})
      compared.compare(problem, mu, fmt::format("body {}, mu {}", number, mu));
    ++number;
  }
  EXPECT_GT(compared.all, 50U);
  EXPECT_GT(compared.flat, 5U);
  EXPECT_GT(compared.bounds, 100U);
  EXPECT_GT(compared.cut_short, 10U);
}

/// The largest |u_n| of a candidate in contact, as a share of the largest displacement.
double missed_contact(const Configuration& leaf, int dimension) {
  double largest = 0, missed = 0;
  for (const double u : leaf.displacement) largest = std::max(largest, std::abs(u));
  for (const int i : leaf.pattern.contact)
    missed = std::max(missed, std::abs(leaf.displacement[static_cast<std::size_t>(dimension * i)]));
  return largest == 0 ? 0 : missed / largest;
}

// Coefficients at which forces along lines through candidates lie on the boundary of their cones,
// and one so large that these are almost half-spaces.
TEST_P(CutTreesIn, DecideAllLeavesOfUnconstrainedBodies) {
  std::size_t flat = 0;
  int number = 0;
  for (const auto& body : unconstrained_bodies(GetParam(), 60)) {
    const auto problem = problems::wedged_problem(checked(body));
    for (const double mu : {0.01, 0.5, std::sqrt(0.5), 1.0, std::sqrt(2), 3.0, 100.0}) {
      const auto findings = searched(problem, mu, Tightening::never);
      for (const auto& leaf : findings.leaves) {
        EXPECT_FALSE(is_open(leaf)) << "body " << number << ", mu " << mu;
        EXPECT_LT(missed_contact(leaf, GetParam()), 1e-9) << "body " << number << ", mu " << mu;
      }
      flat += findings.flat;
    }
    ++number;
  }
  EXPECT_GT(flat, 20U);
}

INSTANTIATE_TEST_SUITE_P(Dimension, CutTreesIn, ::testing::Values(2, 3));

/// Square cells of bars with both diagonals, supported below, in contact above with normals that
/// lean to both sides symmetrically: each pattern has its mirror image.
problems::Structure symmetric_grid(int columns, int rows, double lean) {
  StructureBuilder builder(2);
  std::vector<std::vector<int>> nodes;
  for (int j = 0; j <= rows; ++j) {
    nodes.emplace_back();
    for (int i = 0; i < columns; ++i)
      nodes.back().push_back(builder.node(Eigen::Vector2d(i, j), j == 0));
  }
  const auto at = [&](int i, int j) {
    return nodes[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)];
  };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      builder.bar(at(i, j), at(i, j + 1));
      if (i + 1 == columns) continue;
      builder.bar(at(i, j + 1), at(i + 1, j + 1));
      builder.bar(at(i, j), at(i + 1, j + 1));
      builder.bar(at(i + 1, j), at(i, j + 1));
    }
  for (int i = 0; i < columns; ++i) {
    const double side = i - (columns - 1) / 2.0;
    builder.candidate(at(i, rows), Eigen::Vector2d(lean * side, -1));
  }
  return builder.structure();
}

TEST(CutTrees, FindTheSamePatternsOnSymmetricGrids) {
  Leaves compared;
  for (const int columns : {4, 5, 7, 8})
    for (const double lean : {-1.0, -0.5, 0.0, 0.5, 1.0})
      for (const double mu : {0.3, 0.8, 1.5, 3.0})
        compared.compare(problems::wedged_problem(checked(symmetric_grid(columns, 2, lean))), mu,
                         fmt::format("{} columns, lean {}, mu {}", columns, lean, mu));
  EXPECT_GT(compared.all, 30U);
}

TEST(CutTrees, FindTheSamePatternsInSpace) {
  Leaves compared;
  for (const int rows : {3, 5})
    for (const double mu : {0.3, 0.55, 0.8, 3.0})
      compared.compare(problems::wedged_problem(checked(problems::space_truss({.rows = rows}))), mu,
                       fmt::format("{} rows, mu {}", rows, mu));
  EXPECT_GT(compared.all, 200U);
}

// Thirty candidates, with a tree so large that bounds pay.
TEST(CutTrees, OpenAnEighthOfTheNodesOfATreeWithoutCuts) {
  const auto problem = problems::wedged_problem(checked(problems::space_truss({.rows = 15})));
  const auto without = searched(problem, 0.5, Tightening::never);
  const auto with = searched(problem, 0.5, Tightening::always);
  expect_same(with, without, "15 rows");
  EXPECT_LE(8 * with.outcome.opened(), without.outcome.opened());
  EXPECT_EQ(with.count(), 72U);
  const auto automatic = searched(problem, 0.5, Tightening::automatic);
  EXPECT_EQ(automatic.outcome.opened(), with.outcome.opened());
}

TEST(CutTrees, OpenFewerNodesIfChildrenAreProbed) {
  const auto problem =
      problems::wedged_problem(checked(problems::space_truss({.rows = 6, .depth = 5})));
  const auto plain = searched(problem, 0.5, Tightening::always);
  const auto probed = searched(problem, 0.5, Tightening::always, {}, false, 8);
  expect_same(probed, plain, "6 x 5");
  EXPECT_LE(3 * probed.outcome.opened(), 2 * plain.outcome.opened());
  EXPECT_EQ(plain.outcome.tally().probed, 0U);
  EXPECT_GT(probed.outcome.tally().probed, probed.outcome.tally().branched);
}

/// Copy of evidence that outlives its node.
struct KeptEvidence {
  Evidence evidence;
  std::vector<double> numbers;

  [[nodiscard]] bool holds(const EvidenceCheck& check) const {
    Evidence whole = evidence;
    whole.numbers = numbers;
    return check.holds(whole);
  }
};

/// A search with cuts of a structure, and the verifier's enclosure of K.
struct Searched {
  problems::WedgedProblem problem;
  std::vector<double> friction;
  verify::EnclosedProblem enclosed;
  std::vector<KeptEvidence> evidence{};
  PatternFindings findings{};
  mutable verify::Certificate certificate{};  // input of a proof

  Searched(const problems::Structure& structure, double mu, int probes = 0)
      : problem(problems::wedged_problem(checked(structure))),
        friction(problem.contact_names.size(), mu),
        enclosed(std::get<verify::EnclosedProblem>(enclosed_stiffness(structure))) {
    findings = searched(
        problem, mu, Tightening::always,
        [this](const Evidence& one) {
          evidence.push_back({one, {one.numbers.begin(), one.numbers.end()}});
        },
        true, probes);
  }

  /// Without bounds.
  [[nodiscard]] verify::Proof proof() const {
    certificate.dimension = static_cast<std::size_t>(problem.dimension);
    certificate.names = problem.contact_names;
    certificate.friction = friction;
    certificate.blocks = problems::blocks_of(problem);
    certificate.theorems.clear();
    for (std::size_t block = 0; block < certificate.blocks.size(); ++block)
      certificate.theorems.push_back({.block = block});
    certificate.motions = static_cast<std::size_t>(problem.modes.matrix.cols());
    certificate.motion_values.clear();
    for (const auto& row : problem.modes.matrix.rowwise())
      certificate.motion_values.insert(certificate.motion_values.end(), row.begin(), row.end());
    return {certificate, enclosed.stiffness, enclosed.motions};
  }

  [[nodiscard]] std::size_t of_kind(Evidence::Kind kind) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        evidence, [&](const KeptEvidence& one) { return one.evidence.kind == kind; }));
  }
};

/// Structures with trees that are not trivial, in space and in the plane.
std::vector<std::pair<problems::Structure, double>> structures() {
  return {{problems::space_truss({.rows = 5}), 0.65}, {problems::plane_truss({.rows = 8}), 0.8}};
}

TEST(CutTrees, HaveEvidenceThatTheVerifierAccepts) {
  for (const auto& [structure, mu] : structures())
    for (const int probes : {0, 4}) {
      const Searched own(structure, mu, probes);
      const EvidenceCheck check(own.problem, own.enclosed, own.friction, own.findings.bounds);
      for (const auto& one : own.evidence) {
        if (one.evidence.kind == Evidence::Kind::no_claim) continue;
        EXPECT_TRUE(one.holds(check));
      }
      EXPECT_GT(own.of_kind(Evidence::Kind::cut), 10U);
      EXPECT_GT(own.of_kind(Evidence::Kind::feasible), 5U) << structure.name;
      EXPECT_EQ(own.of_kind(Evidence::Kind::no_claim), 0U) << structure.name;
    }
}

// Bounds that the exact test refuses are not used, and do not enter a certificate.
TEST(CutTrees, HaveNoBoundsThatTheVerifierRefuses) {
  const std::string path = KUSABI_SOURCE_DIR "/tests/nodes/wedged/cases/long_lever.toml";
  const auto structure = problems::read_structure(problems::problem_text(path), path);
  const auto problem = problems::wedged_problem(structure);
  const auto friction = candidate_friction(problem, 0.988566);
  const auto enclosed = std::get<verify::EnclosedProblem>(enclosed_stiffness(structure));
  std::vector<KeptEvidence> evidence;
  PatternParameters parameters;
  parameters.tree.tightening = Tightening::always;
  parameters.structure = &structure;
  parameters.recorder = [&](const Evidence& one) {
    evidence.push_back({one, {one.numbers.begin(), one.numbers.end()}});
  };
  engine::SingleProcess alone;
  engine::Analysis analysis(alone, {});
  const auto findings = find_patterns(analysis, problem, friction, parameters);
  EXPECT_EQ(findings.count(), 5U);
  const EvidenceCheck check(problem, enclosed, friction, findings.bounds);
  EXPECT_TRUE(check.proves_bounds());
  EXPECT_FALSE(evidence.empty());
  for (const auto& one : evidence) EXPECT_TRUE(one.holds(check));
}

/// The largest reaction or gap of a candidate over all configurations found on its side.
double largest(const Searched& own, const ProvedBound& bound) {
  double maximum = 0;
  const auto d = static_cast<std::size_t>(own.problem.dimension);
  const auto at = d * static_cast<std::size_t>(bound.candidate);  // a single block
  const bool touches = bound.side == Side::contact;
  for (const auto& leaf : own.findings.leaves) {
    const auto& side = touches ? leaf.pattern.contact : leaf.pattern.separated;
    if (!is_open(leaf) && side.contains(bound.candidate))
      maximum = std::max(maximum, touches ? leaf.reaction[at] : leaf.displacement[at]);
  }
  return maximum;
}

verify::CandidateBound as_written(const ProvedBound& bound) {
  return {.line = 0,
          .theorem = bound.theorem,
          .candidate = bound.candidate,
          .side = bound.side == Side::contact ? verify::Side::contact : verify::Side::separated,
          .maximum = bound.excludes_side() ? std::nullopt : std::optional(bound.maximum),
          .numbers = bound.numbers};
}

// Each bound decreased below a known configuration, and an excluded side that contains one.
TEST(CutTrees, HaveBoundsThatTheVerifierRefusesIfTheyAreLowered) {
  for (const auto& [structure, mu] : structures()) {
    const Searched own(structure, mu);
    ASSERT_EQ(own.findings.blocks.size(), 1U);
    verify::Proof proof = own.proof();
    ASSERT_TRUE(proof.min_eigenvalue());
    int refused = 0;
    for (const auto& bound : own.findings.bounds) {
      const double maximum = largest(own, bound);
      if (bound.excludes_side()) {
        EXPECT_EQ(maximum, 0) << bound.candidate;
      } else if (maximum > 1e-9 * bound.maximum) {
        auto low = as_written(bound);
        low.maximum = maximum * (1 - 1e-9);
        EXPECT_TRUE(proof.add_bound(low)) << bound.candidate;
        auto never = as_written(bound);
        never.maximum.reset();
        never.numbers.pop_back();
        EXPECT_TRUE(proof.add_bound(never)) << bound.candidate;
        ++refused;
      }
      EXPECT_FALSE(proof.add_bound(as_written(bound))) << bound.candidate;
    }
    EXPECT_GT(refused, 20);
  }
}

// Unconstrained bodies with many degenerate nodes; undecided leaves have no claim.
TEST_P(CutTreesIn, HaveEvidenceOfUnconstrainedBodiesThatTheVerifierAccepts) {
  std::size_t cut = 0, feasible = 0, bounds = 0, refused = 0;
  for (const auto& body : unconstrained_bodies(GetParam(), 25)) {
    for (const double mu : {0.4, 1.0}) {
      const Searched own(body, mu);
      const EvidenceCheck check(own.problem, own.enclosed, own.friction, own.findings.bounds);
      for (const auto& one : own.evidence)
        EXPECT_TRUE(one.evidence.kind == Evidence::Kind::no_claim || one.holds(check));
      cut += own.of_kind(Evidence::Kind::cut);
      feasible += own.of_kind(Evidence::Kind::feasible);
      if (own.findings.blocks.size() > 1) continue;
      verify::Proof proof = own.proof();
      for (const auto& bound : own.findings.bounds) {
        const double maximum = largest(own, bound);
        if (maximum > 1e-9) {
          ASSERT_FALSE(bound.excludes_side());
          auto low = as_written(bound);
          low.maximum = maximum * (1 - 1e-9);
          EXPECT_TRUE(proof.add_bound(low));
          low.maximum.reset();
          low.numbers.pop_back();
          EXPECT_TRUE(proof.add_bound(low));
          ++refused;
        }
        EXPECT_EQ(proof.add_bound(as_written(bound)), std::nullopt);
        ++bounds;
      }
    }
  }
  EXPECT_GT(cut, 50U);
  EXPECT_GT(feasible, 10U);
  EXPECT_GT(bounds, 50U);
  EXPECT_GT(refused, 5U);  // in space few reactions are in equilibrium, so few bounds exist
}

// Without the first bound that took a program, its consequences and later bounds are not proved.
TEST(CutTrees, HaveEvidenceThatIsRefusedWithoutItsBounds) {
  for (const auto& [structure, mu] : structures()) {
    const Searched own(structure, mu);
    auto bounds = own.findings.bounds;
    const auto low = std::ranges::find_if(
        bounds.begin() + static_cast<std::ptrdiff_t>(own.friction.size()), bounds.end(),
        [&](const ProvedBound& bound) {
          return !bound.excludes_side() && largest(own, bound) > 1e-9 * bound.maximum;
        });
    ASSERT_NE(low, bounds.end());
    low->maximum = largest(own, *low) / 2;
    const EvidenceCheck check(own.problem, own.enclosed, own.friction, bounds);
    std::size_t refused = 0;
    for (const auto& one : own.evidence) {
      const bool stands = one.holds(check);
      EXPECT_TRUE(stands || one.evidence.kind != Evidence::Kind::feasible);
      refused += stands ? 0 : 1;
    }
    EXPECT_GT(refused, 5U);
  }
}

}  // namespace
}  // namespace kusabi::wedged
