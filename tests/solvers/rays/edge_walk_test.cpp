// The walk along edges against double description, on trusses and on random problems.
#include "solvers/rays/edge_walk.hpp"

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "problems/families/plane_truss.hpp"
#include "problems/wedged/precise_compliance.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "ray_oracles.hpp"
#include "solvers/rays/double_description.hpp"
#include "solvers/rays/maximal_cones.hpp"
#include "sorted_rays.hpp"

namespace kusabi::rays {
namespace {

/// A sum of the rays of a cone: with all of them, a point inside.
LongVector sum_of(const ReactionCone& cone, const std::vector<ZeroSet>& rays) {
  LongVector sum = LongVector::Zero(cone.unknowns());
  for (const ZeroSet& zero : rays) sum += cone.coordinates(zero);
  return sum;
}

bool has_only_simple_rays(const ReactionCone& cone, const std::vector<ZeroSet>& rays) {
  return std::ranges::all_of(
      rays, [&](const ZeroSet& zero) { return size(zero) == cone.unknowns() - 1; });
}

/// True if no candidate is inactive, or slides one way, at all rays.
bool is_solid(const ReactionCone& cone, Candidates contact, const std::vector<ZeroSet>& rays) {
  ZeroSet always{~Candidates{0}, ~Candidates{0}, ~Candidates{0}};
  for (const ZeroSet& zero : rays)
    always = {always.p & zero.p, always.q & zero.q, always.u & zero.u};
  Candidates one_way = always.p | always.q;
  for (int i = 0; i < cone.candidates(); ++i) {
    if (cone.slips(i)) one_way = (one_way & ~bit(i)) | (always.p & bit(i));
  }
  return (one_way & contact) == 0 && (always.u & cone.all() & ~contact) == 0;
}

struct Compared {
  std::size_t walks = 0;
  std::size_t not_simple = 0;
};

// Compares all solid cones D(Y) of patterns with at least one candidate in contact.
Compared compare(const ReactionCone& cone) {
  Compared compared;
  for (Candidates contact = 1; contact <= cone.all(); ++contact) {
    const auto rays = rays_of_pattern(cone, contact).rays;
    if (rays.empty() || !is_solid(cone, contact, rays)) continue;
    const auto walk = walk_along_edges(cone, contact, sum_of(cone, rays), {});
    if (has_only_simple_rays(cone, rays)) {
      EXPECT_EQ(walk.end, WalkEnd::complete) << contact;
      EXPECT_EQ(test::sorted(walk.rays), test::sorted(rays)) << contact;
      ++compared.walks;
    } else {
      EXPECT_EQ(walk.end, WalkEnd::not_simple) << contact;
      ++compared.not_simple;
    }
  }
  return compared;
}

ReactionCone truss_of(int rows, double mu) {
  const auto truss = problems::plane_truss({.rows = rows});
  return {problems::precise_compliance(problems::wedged_problem(checked(truss))),
          std::vector<double>(static_cast<std::size_t>(rows), mu)};
}

TEST(EdgeWalk, FindsTheRaysOfDoubleDescriptionOnTrusses) {
  for (const double mu : {0.65, 0.8, 1.0}) {
    // tests/reference/plane-truss.json: 6, 82 and 103 patterns
    const auto compared = compare(truss_of(8, mu));
    EXPECT_EQ(compared.walks, mu < 0.7 ? 6U : mu < 0.9 ? 82U : 103U) << mu;
    EXPECT_EQ(compared.not_simple, 0U);
  }
}

TEST(EdgeWalk, FindsTheRaysOfRandomProblemsWithAFrictionForEachCandidate) {
  std::mt19937 bits(7);
  std::size_t walks = 0;
  for (int round = 0; round < 60; ++round) {
    constexpr int m = 5;
    std::vector<double> friction{0.3, 2, 0, 5, 1};
    std::shuffle(friction.begin(), friction.end(), bits);
    const ReactionCone cone(test::random_compliance(m, bits).cast<long double>(), friction);
    walks += compare(cone).walks;
  }
  EXPECT_GT(walks, 100U);
}

// Two candidates that have the same gap whatever the reactions of others: where one has none, nor
// has the other.
TEST(EdgeWalk, DoesNotEndWithRaysThatAreNotSimple) {
  std::mt19937 bits(3);
  Compared all;
  for (int round = 0; round < 60; ++round) {
    constexpr int m = 5;
    Eigen::MatrixXd compliance = test::random_compliance(m, bits);
    constexpr int first = 2 * (m - 2);
    constexpr int second = 2 * (m - 1);
    for (int k = 0; k < first; ++k)
      compliance(second, k) = compliance(k, second) = compliance(first, k);
    const ReactionCone cone(compliance.cast<long double>(), std::vector<double>(m, 2.0));
    const auto compared = compare(cone);
    all.not_simple += compared.not_simple;
  }
  EXPECT_GT(all.not_simple, 10U);
}

TEST(EdgeWalk, EndsOnRequest) {
  const auto cone = truss_of(8, 0.65);
  const auto rays = complementary_rays(cone).rays;
  const auto cones = maximal_cones(rays, cone.all());
  const auto& largest = *std::ranges::max_element(cones, {}, [&](const Cone& each) {
    return std::ranges::count_if(rays, [&](const ZeroSet& zero) {
      return belongs({zero, cone.all()}, each);
    });
  });
  std::vector<ZeroSet> own;
  for (const ZeroSet& zero : rays) {
    if (belongs({zero, cone.all()}, largest)) own.push_back(zero);
  }
  const auto inside = sum_of(cone, own);
  EXPECT_EQ(walk_along_edges(cone, largest.reaction, inside, [] { return false; }).rays.size(),
            own.size());
  EXPECT_EQ(walk_along_edges(cone, largest.reaction, inside, [] { return true; }).end,
            WalkEnd::stopped);
  EXPECT_EQ(walk_along_edges(cone, largest.reaction, -inside, {}).end, WalkEnd::not_simple);
}

}  // namespace
}  // namespace kusabi::rays
