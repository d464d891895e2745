// Ray and cone tests against stored references, brute force, lrs, Bron-Kerbosch, and the
// definition.
#include <algorithm>
#include <array>
#include <bit>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "problems/families/plane_truss.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/wedged/precise_compliance.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "ray_oracles.hpp"
#include "solvers/rays/bit_pattern_tree.hpp"
#include "solvers/rays/double_description.hpp"
#include "solvers/rays/maximal_cones.hpp"
#include "sorted_rays.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::rays {
namespace {

using problems::plane_truss;

nlohmann::json reference(const std::string& name) {
  std::ifstream stream(problems::test::source_path("tests/reference/" + name));
  return nlohmann::json::parse(stream);
}

ReactionCone cone_of(const problems::Structure& structure, double mu) {
  const std::vector<double> friction(structure.contact.size(), mu);
  return {problems::precise_compliance(problems::wedged_problem(checked(structure))), friction};
}

test::Reactions reactions(const ReactionCone& cone, const std::vector<ZeroSet>& zeros) {
  test::Reactions list;
  Health health;
  for (const ZeroSet& zero : zeros) list.push_back(cone.ray(zero, health).reaction);
  EXPECT_TRUE(health.sound());
  return list;
}

struct Row {
  int rows;
  std::string mu;
};

class PlaneTrussTable : public testing::TestWithParam<Row> {};

TEST_P(PlaneTrussTable, HasTheRaysAndConesOfTheReference) {
  const auto& [rows, mu] = GetParam();
  const auto known = reference("plane-truss.json")["table"][std::to_string(rows)][mu];
  const auto cone = cone_of(plane_truss({.rows = rows}), std::stod(mu));
  const auto found = complementary_rays(cone);
  EXPECT_TRUE(found.health.sound());
  EXPECT_EQ(found.rays.size(), known["rays"].get<std::size_t>());
  EXPECT_EQ(maximal_cones(found.rays, cone.all()).size(), known["cones"].get<std::size_t>());
}

// Numbers of rays and cones printed in the wedged paper, except the cones of N = 15, for which it
// prints 30.
TEST(PaperPlaneTruss, HasTheRaysAndConesOfThePaper) {
  const auto table = reference("paper-plane-truss.json")["rays"];
  for (const auto& [mu, by_rows] : table.items()) {
    for (const auto& [rows, counts] : by_rows.items()) {
      const auto cone = cone_of(problems::paper_plane_truss(std::stoi(rows)), std::stod(mu));
      const auto found = complementary_rays(cone);
      EXPECT_TRUE(found.health.sound());
      EXPECT_EQ(found.rays.size(), counts[0].get<std::size_t>()) << rows << ' ' << mu;
      EXPECT_EQ(maximal_cones(found.rays, cone.all()).size(), counts[1].get<std::size_t>());
    }
  }
}

TEST(DoubleDescription, StopsAtTooManyRaysOrOnRequest) {
  const auto cone = cone_of(problems::paper_plane_truss(9), 0.65);
  const auto whole = complementary_rays(cone);
  const auto peak = whole.cost.peak_rays;
  const auto ends = [&](const EnumerationOptions& options) {
    return !complementary_rays(cone, options);
  };
  EXPECT_EQ(complementary_rays(cone, {.max_rays = peak})->rays, whole.rays);
  EXPECT_TRUE(ends({.max_rays = peak - 1}));
  EXPECT_TRUE(ends({.stop = [] { return true; }}));
  EXPECT_FALSE(ends({.stop = [] { return false; }}));
  // The result agreed by all ranks counts, for any result of the own `stop`.
  EXPECT_TRUE(ends({.agree = [](bool) { return true; }}));
  EXPECT_FALSE(ends({.stop = [] { return true; }, .agree = [](bool) { return false; }}));
  EXPECT_LT(bytes_for(1000, 10), bytes_for(1000, 20));
}

// A part of a list, resumed separately, ends with exactly those rays that lie on its face.
TEST(DoubleDescription, ResumesAPartOfTheListOnItsFace) {
  const auto cone = cone_of(plane_truss({.rows = 8}), 0.8);
  const auto whole = complementary_rays(cone);
  auto list = first_list(cone);
  EXPECT_FALSE(divided(list).has_value());  // there was no cut yet
  resume(list, cone, {.max_rays = 100});
  ASSERT_FALSE(has_ended(list, cone));
  auto parts = divided(list);
  ASSERT_TRUE(parts.has_value());
  for (RayList& part : *parts) {
    EXPECT_LT(part.zeros.size(), list.zeros.size());
    ASSERT_EQ(std::popcount(part.contact | part.separated), 1);
    resume(part, cone, {});
    EXPECT_TRUE(has_ended(part, cone));
    std::vector<ZeroSet> on_face;
    for (const ZeroSet& zero : whole.rays) {
      const Supports supports(zero, cone.all());
      if ((supports.separated() & part.contact) == 0 && (supports.reaction() & part.separated) == 0)
        on_face.push_back(zero);
    }
    EXPECT_GT(on_face.size(), 0U);
    EXPECT_LT(on_face.size(), whole.rays.size());
    EXPECT_EQ(test::sorted(part.zeros), test::sorted(on_face));
  }
}

// Pieces computed separately in any order give the list of the unshared step, in its order.
TEST(DoubleDescription, HasTheSameListIfItsStepsAreShared) {
  const auto cone = cone_of(problems::paper_plane_truss(21), 0.65);
  const auto whole = complementary_rays(cone);
  std::uint64_t pieces = 0;
  const auto backwards = [&](std::uint64_t count, const auto& piece) {
    std::vector<NewRays> results(count);
    for (std::uint64_t at = count; at-- > 0;) results[at] = piece(at);
    pieces += count;
    return results;
  };
  const auto shared = complementary_rays(cone, {.share = backwards});
  EXPECT_GT(pieces, 100U);
  EXPECT_EQ(shared->rays, whole.rays);
  EXPECT_EQ(shared->cost.peak_rays, whole.cost.peak_rays);
  EXPECT_EQ(shared->cost.pairs, whole.cost.pairs);
  EXPECT_EQ(shared->cost.adjacent, whole.cost.adjacent);
  EXPECT_EQ(shared->health.smallest_nonzero, whole.health.smallest_nonzero);
  EXPECT_FALSE(complementary_rays(cone, {.share = [&](std::uint64_t count, const auto& piece) {
                                    auto results = backwards(count, piece);
                                    results.front().stopped = true;
                                    return results;
                                  }}));
}

std::vector<Row> table_rows() {
  std::vector<Row> list;
  const auto table = reference("plane-truss.json")["table"];
  for (const auto& [rows, by_friction] : table.items()) {
    for (const auto& [mu, counts] : by_friction.items()) list.push_back({std::stoi(rows), mu});
  }
  return list;
}

INSTANTIATE_TEST_SUITE_P(AllSizesAndFrictions, PlaneTrussTable, testing::ValuesIn(table_rows()));

TEST(Rays, OfTheFiveRowTrussAreThoseOfTheReference) {
  const auto five = reference("plane-truss.json")["five"];
  test::Reactions known;
  for (const auto& numbers : five["rays_at_0_65"]) {
    const auto list = numbers.get<std::vector<double>>();
    Eigen::VectorXd ray = Eigen::Map<const Eigen::VectorXd>(list.data(), 10);
    double normal_sum = 0;
    for (int i = 0; i < 10; i += 2) normal_sum += ray(i);
    known.push_back(ray / normal_sum);
  }
  const auto cone = cone_of(plane_truss({}), 0.65);
  const auto own = reactions(cone, complementary_rays(cone).rays);
  ASSERT_EQ(own.size(), known.size());
  for (const auto& ray : own) {
    const auto distance = [&](const auto& other) { return (ray - other).cwiseAbs().maxCoeff(); };
    const auto nearest =
        std::min_element(known.begin(), known.end(),
                         [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    EXPECT_LT(distance(*nearest), 2e-9);  // the reference has ten digits
  }
}

// W (10): as friction grows through the critical coefficient of a pattern, its cone appears.
TEST(Rays, OfAPatternAppearAtItsCriticalFriction) {
  const auto known = reference("plane-truss.json")["five"]["critical_at_1"];
  for (const auto& entry : known) {
    const double critical = entry[0];
    Candidates contact = 0;
    for (const int i : entry[1]) contact |= bit(i);
    const auto truss = plane_truss({});
    const auto inner = [&](double mu) {
      const auto cone = cone_of(truss, mu);
      const auto cones = maximal_cones(rays_of_pattern(cone, contact).rays, cone.all());
      return std::count(cones.begin(), cones.end(), Cone{contact, cone.all() & ~contact});
    };
    EXPECT_EQ(inner(critical + 1e-6), 1) << critical;
    EXPECT_EQ(inner(critical - 1e-6), 0) << critical;
  }
}

TEST(Rays, OfThePapersElasticBodyAreAsPrinted) {
  const auto printed = reference("paper-elastic-body.json");
  const auto cone = cone_of(
      problems::load_structure(problems::test::source_path("examples/paper/elastic-body.toml")),
      printed["friction"]);
  const auto rays = complementary_rays(cone).rays;
  EXPECT_EQ(rays.size(), 5U);
  const auto cones = maximal_cones(rays, cone.all());
  EXPECT_EQ(cones.size(), printed["rays_of_cones"].size());
  for (const auto& [count, candidates] : printed["rays_of_cones"].items()) {
    Candidates contact = 0;
    for (const int i : candidates) contact |= bit(i);
    EXPECT_EQ(std::count(cones.begin(), cones.end(), Cone{contact, cone.all() & ~contact}), 1);
    EXPECT_EQ(std::to_string(rays_of_pattern(cone, contact).rays.size()), count);
  }
}

TEST(Rays, OfTheElasticBodyAreThoseOfAnIndependentProgram) {
  const auto body =
      problems::load_structure(problems::test::source_path("examples/elastic-body.toml"));
  const auto cone = cone_of(body, 1.5);
  const auto rays = complementary_rays(cone).rays;
  EXPECT_EQ(rays.size(), 5U);
  std::set<Candidates> contact;
  for (const Cone& each : maximal_cones(rays, cone.all())) contact.insert(each.reaction);
  EXPECT_EQ(contact, (std::set<Candidates>{bit(0), bit(10) | bit(11), bit(9) | bit(10) | bit(11)}));
  // tests/reference: the critical friction of the first is that of its only ray, |r_t| / r_n.
  Health health;
  const auto alone = std::find_if(rays.begin(), rays.end(), [&](const ZeroSet& zero) {
    return Supports(zero, cone.all()).reaction() == bit(0);
  });
  EXPECT_NEAR(cone.ray(*alone, health).reaction(1), 1.4482182919, 1e-9);
}

TEST(Rays, AreThoseOfBruteForceOnSmallTrusses) {
  for (const int rows : {2, 3, 4, 5, 6}) {
    for (const int bays : {1, 2, 3}) {
      const auto truss = plane_truss({.rows = rows, .bays = bays});
      const auto problem = problems::wedged_problem(checked(truss));
      for (const double mu : {0.4, 0.65, 1.0, 2.0}) {
        const std::vector<double> friction(problem.friction.size(), mu);
        const auto cone = cone_of(truss, mu);
        EXPECT_TRUE(test::same_rays(reactions(cone, complementary_rays(cone).rays),
                                    test::rays_by_brute_force(problem.compliance.matrix, friction)))
            << rows << " rows, " << bays << " bays, mu = " << mu;
      }
    }
  }
}

TEST(Rays, AreThoseOfBruteForceOnRandomProblemsWithAFrictionForEachCandidate) {
  std::mt19937 bits(7);
  std::uniform_real_distribution<double> coefficient(0.2, 4.0);
  std::size_t all = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const int m = 1 + trial % 5;
    const Eigen::MatrixXd compliance = test::random_compliance(m, bits);
    std::vector<double> friction;
    for (int i = 0; i < m; ++i) friction.push_back(coefficient(bits));
    const ReactionCone cone(compliance.cast<long double>(), friction);
    const auto own = reactions(cone, complementary_rays(cone).rays);
    EXPECT_TRUE(test::same_rays(own, test::rays_by_brute_force(compliance, friction))) << trial;
    all += own.size();
  }
  EXPECT_GT(all, 100U);
}

TEST(Rays, AreThoseOfLrsOnIntegerData) {
  for (const auto& known : reference("lrs_rays.json")) {
    const auto rows = known["compliance"].get<std::vector<std::vector<long double>>>();
    const auto size = static_cast<Eigen::Index>(rows.size());
    LongMatrix compliance(size, size);
    for (Eigen::Index i = 0; i < size; ++i) {
      for (Eigen::Index j = 0; j < size; ++j) {
        compliance(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      }
    }
    const std::vector<double> friction(rows.size() / 2, known["friction"].get<double>());
    const ReactionCone cone(compliance, friction);
    test::Reactions theirs;
    for (const auto& ray : known["rays"]) {
      const auto numbers = ray.get<std::vector<double>>();
      theirs.emplace_back(Eigen::Map<const Eigen::VectorXd>(numbers.data(), size));
    }
    EXPECT_TRUE(test::same_rays(reactions(cone, complementary_rays(cone).rays), theirs));
  }
}

ConesOfRays cones_of(const std::vector<ZeroSet>& rays, Candidates all) {
  ConesOfRays cones;
  for (const ZeroSet& zero : rays) cones.add(rays::cone_of(Supports(zero, all)));
  return cones;
}

TEST(Rays, OfAPatternAndConesStopOnRequest) {
  const auto cone = cone_of(plane_truss({.rows = 9}), 1.0);
  const auto rays = complementary_rays(cone).rays;
  std::size_t questions = 0;
  const auto go_on = [&questions] { return ++questions == 0; };
  ASSERT_TRUE(rays_of_pattern(cone, cone.all(), go_on));
  EXPECT_GT(questions, 5U);
  questions = 0;
  EXPECT_EQ(maximal_cones(cones_of(rays, cone.all()), cone.all(), go_on),
            maximal_cones(rays, cone.all()));
  EXPECT_GT(questions, 5U);
  const auto stop = [] { return true; };
  EXPECT_FALSE(rays_of_pattern(cone, cone.all(), stop));
  EXPECT_FALSE(maximal_cones(cones_of(rays, cone.all()), cone.all(), stop));
}

// Property used by the tree of sign patterns: among the small cones of all leaves, each ray is
// reported by exactly one, with equal bits.
TEST(Rays, OfAllPatternsTogetherAreTheComplementaryRays) {
  for (const double mu : {0.65, 1.0}) {
    const auto cone = cone_of(plane_truss({.rows = 7}), mu);
    std::vector<ZeroSet> together;
    for (Candidates contact = 1; contact <= cone.all(); ++contact) {
      for (const ZeroSet& zero : rays_of_pattern(cone, contact).rays) {
        if (Supports(zero, cone.all()).reaction() == contact) together.push_back(zero);
      }
    }
    EXPECT_EQ(test::sorted(together), test::sorted(complementary_rays(cone).rays)) << mu;
  }
}

TEST(Rays, SolveTheWedgedProblemExactlyWhereTheyAreZero) {
  const auto truss = plane_truss({.rows = 8});
  const auto problem = problems::wedged_problem(checked(truss));
  const double mu = 0.8;
  const auto cone = cone_of(truss, mu);
  Health health;
  for (const ZeroSet& zero : complementary_rays(cone).rays) {
    const Ray ray = cone.ray(zero, health);
    const double size = ray.displacement.cwiseAbs().maxCoeff();
    EXPECT_LT((problem.compliance.matrix * ray.reaction - ray.displacement).cwiseAbs().maxCoeff(),
              1e-12 * size);
    const Supports supports(zero, cone.all());
    double normal_sum = 0;
    for (int i = 0; i < 8; ++i) {
      const double normal = ray.reaction(2 * i);
      const double tangential = ray.reaction(2 * i + 1);
      const double gap = ray.displacement(2 * i);
      normal_sum += normal;
      EXPECT_EQ(normal * gap, 0);
      EXPECT_EQ(normal > 0, (supports.reaction() & bit(i)) != 0);
      EXPECT_EQ(gap > 0, (supports.separated() & bit(i)) != 0);
      const double slack = mu * normal - std::abs(tangential);
      if ((supports.sticking() & bit(i)) != 0) {
        EXPECT_GT(slack, 0);
      } else {
        EXPECT_NEAR(slack, 0, 1e-15);
      }
    }
    EXPECT_NEAR(normal_sum, 1, 1e-14);
  }
  EXPECT_TRUE(health.sound());
}

// One candidate that wedges with r_t = -r_n, and a second one that it displaces by `relative` of
// the terms that cancel.
ReactionCone almost_idle(double relative) {
  LongMatrix compliance = LongMatrix::Identity(4, 4);
  compliance(0, 1) = compliance(1, 0) = 1;
  compliance(1, 1) = 2;
  compliance(2, 0) = compliance(0, 2) = 0.1L;
  compliance(2, 1) = compliance(1, 2) = 0.1L * (1 - 2 * static_cast<long double>(relative));
  return {compliance, std::vector<double>{1.5, 1.5}};
}

TEST(ReactionCone, CountsNumbersThatAreUndecidedNearZero) {
  for (const double relative : {1e-3, 1e-8}) {
    const auto found = complementary_rays(almost_idle(relative));
    EXPECT_TRUE(found.health.sound());
    // p = 2.5 and q = 0.5 for r_n = 1; 0.2 times `relative` is left of |A_p| p + |A_q| q = 1 / 12.
    EXPECT_NEAR(found.health.smallest_nonzero, 2.4 * relative, 0.01 * relative);
  }
  EXPECT_FALSE(complementary_rays(almost_idle(zero_tolerance)).health.sound());
  EXPECT_FALSE(complementary_rays(almost_idle(2 * zero_tolerance)).health.sound());
  EXPECT_TRUE(complementary_rays(almost_idle(0)).health.sound());
}

TEST(ReactionCone, DetectsARayThatContradictsItsZeroSet) {
  const auto cone = almost_idle(1e-3);
  Health health;
  cone.ray({.p = bit(1), .q = bit(1), .u = bit(0)}, health);  // separates at the second candidate
  EXPECT_TRUE(health.sound());
  // the second candidate has no contact there
  cone.ray({.p = bit(1), .q = bit(1), .u = bit(0) | bit(1)}, health);
  EXPECT_FALSE(health.sound());
}

TEST(ReactionCone, RefusesInvalidProblems) {
  const std::vector<double> friction{1.0};
  EXPECT_THROW(ReactionCone(LongMatrix::Identity(4, 4), friction), std::invalid_argument);
  EXPECT_THROW(ReactionCone(LongMatrix::Identity(2, 2), std::vector<double>{-1.0}),
               std::invalid_argument);
  EXPECT_THROW(ReactionCone(LongMatrix(0, 0), std::vector<double>{}), std::invalid_argument);
}

// Cones as sets of ray numbers.
std::set<std::set<int>> families(const std::vector<ZeroSet>& rays, Candidates all) {
  std::set<std::set<int>> list;
  for (const Cone& cone : maximal_cones(rays, all)) {
    std::set<int> family;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (belongs({rays[i], all}, cone)) family.insert(static_cast<int>(i));
    }
    EXPECT_TRUE(list.insert(family).second);
  }
  return list;
}

bool cross_complementary(const Supports& a, const Supports& b) {
  return (a.reaction() & b.separated()) == 0 && (a.separated() & b.reaction()) == 0;
}

std::set<std::set<int>> cliques(const std::vector<ZeroSet>& rays, Candidates all) {
  std::vector<std::set<int>> neighbours(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    for (std::size_t j = 0; j < rays.size(); ++j) {
      if (i != j && cross_complementary({rays[i], all}, {rays[j], all})) {
        neighbours[i].insert(static_cast<int>(j));
      }
    }
  }
  return test::maximal_cliques(neighbours);
}

TEST(MaximalCones, AreTheMaximalCliquesOfTheCrossComplementarityGraph) {
  for (const int rows : {5, 6, 7}) {
    for (const double mu : {0.7, 1.0}) {
      const auto cone = cone_of(plane_truss({.rows = rows}), mu);
      const auto rays = complementary_rays(cone).rays;
      EXPECT_EQ(families(rays, cone.all()), cliques(rays, cone.all())) << rows << ' ' << mu;
    }
  }
}

TEST(MaximalCones, AreTheMaximalCliquesOfAnySupports) {
  std::mt19937 bits(11);
  for (int trial = 0; trial < 400; ++trial) {
    const int m = 1 + trial % 7;
    const Candidates all = first_candidates(m);
    std::vector<ZeroSet> rays;
    const auto count = bits() % 12;
    while (rays.size() < count) {
      const Candidates reaction = bits() & all;
      const Candidates separated = bits() & bits() & all & ~reaction;
      rays.push_back({.p = all & ~reaction, .q = all & ~reaction, .u = all & ~separated});
    }
    EXPECT_EQ(families(rays, all), cliques(rays, all)) << trial;
  }
}

TEST(BitPatternTree, FindsASupersetIfThereIsOne) {
  std::mt19937_64 bits(3);
  std::vector<ZeroSet> sets;
  std::vector<int> members;
  for (int i = 0; i < 500; ++i) {
    sets.push_back({.p = bits() | bits(), .q = bits() | bits(), .u = bits() | bits()});
    members.push_back(i);
  }
  const BitPatternTree tree(sets, members);
  for (int trial = 0; trial < 500; ++trial) {
    ZeroSet smaller{.p = bits(), .q = bits(), .u = bits()};
    for (auto* word : {&smaller.p, &smaller.q, &smaller.u}) {
      for (int more = trial % 7; more > 0; --more) *word &= bits();
    }
    const std::array<int, 2> except{trial, trial / 2};
    const auto fits = [&](int member) {
      return member != except[0] && member != except[1] &&
             contains(sets[static_cast<std::size_t>(member)], smaller);
    };
    const auto found = tree.superset(smaller, except);
    EXPECT_EQ(found.has_value(), std::any_of(members.begin(), members.end(), fits));
    EXPECT_TRUE(!found || fits(*found));
  }
}

TEST(ZeroSet, HasAsManyEqualitiesAsBits) {
  std::mt19937_64 bits(7);
  EXPECT_EQ(size({}), 0);
  EXPECT_EQ(size({.p = ~0UL, .q = ~0UL, .u = ~0UL}), 192);
  for (int trial = 0; trial < 1000; ++trial) {
    const ZeroSet zero{.p = bits(), .q = bits() | bits(), .u = bits() & bits()};
    EXPECT_EQ(size(zero), std::popcount(zero.p) + std::popcount(zero.q) + std::popcount(zero.u));
  }
}

TEST(ZeroSet, HasATotalOrder) {
  std::mt19937 bits(5);
  for (int trial = 0; trial < 1000; ++trial) {
    const ZeroSet a{.p = bits() % 4, .q = bits() % 4, .u = bits() % 4};
    const ZeroSet b{.p = bits() % 4, .q = bits() % 4, .u = bits() % 4};
    EXPECT_EQ(comes_before(a, b) + comes_before(b, a), a == b ? 0 : 1);
  }
}

}  // namespace
}  // namespace kusabi::rays
