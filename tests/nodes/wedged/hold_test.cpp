// States under load compared with linear programs of all sign patterns, and with closed forms.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "engine/transport/single_process.hpp"
#include "nodes/wedged/hold/half_planes.hpp"
#include "nodes/wedged/hold/hold_search.hpp"
#include "nodes/wedged/hold/statics.hpp"
#include "problems/files/structure_file.hpp"
#include "random_structure.hpp"
#include "solvers/linear/linear_program.hpp"
#include "solvers/linear/simplex.hpp"
#include "support/input_error.hpp"
#include "tests/support/thorough.hpp"

namespace kusabi::wedged {
namespace {

constexpr double unlimited = linear::infinity;

/// Edges of a friction cone in space, inside of that of mu and outside of that of mu times the
/// cosine of half the angle between two.
constexpr int edges_in_space = 16;

using Interval = std::pair<double, double>;

/// The program of one pattern: reactions as sums along edges of the friction cones, the motion
/// alpha, lambda; tau = 1. In space the edges span a part of each cone.
class PatternProgram {
 public:
  PatternProgram(const LoadedProblem& loaded, double mu, unsigned contact)
      : loaded_(loaded), contact_(contact) {
    const auto m = static_cast<int>(loaded.clearance.size());
    const int d = loaded.problem.dimension;
    const int edges = d == 2 ? 2 : edges_in_space;
    for (int i = 0; i < m; ++i)
      for (int edge = 0; edge < edges; ++edge) {
        const double slope = mu * loaded.problem.friction[static_cast<std::size_t>(i)];
        const double angle = 2 * std::numbers::pi * edge / edges;
        Eigen::VectorXd load = Eigen::VectorXd::Zero(d * m);
        load[d * i] = 1;
        load[d * i + 1] = slope * std::cos(angle);
        if (d == 3) load[d * i + 2] = slope * std::sin(angle);
        forces_.push_back(load);
        program_.add_column({.lower = 0, .upper = touches(i) ? unlimited : 0});
      }
    for (Eigen::Index l = 0; l < loaded.problem.modes.matrix.cols(); ++l)
      program_.add_column({.lower = -unlimited});
    lambda_ = program_.add_column({.lower = -unlimited});
    add_rows();
  }

  /// The factors of the pattern's states; nothing if there are none.
  std::optional<Interval> factors() {
    Interval result;
    for (const int sign : {1, -1}) {
      program_.columns[static_cast<std::size_t>(lambda_)].cost = sign;
      linear::Simplex simplex(program_);
      simplex.use_slack_basis();
      const auto status = simplex.solve_robustly();
      if (status == linear::LinearStatus::infeasible) return {};
      const double value =
          status == linear::LinearStatus::optimal ? sign * simplex.objective() : -sign * unlimited;
      (sign > 0 ? result.first : result.second) = value;
    }
    return result;
  }

 private:
  [[nodiscard]] bool touches(int candidate) const { return ((contact_ >> candidate) & 1U) != 0; }

  void add_rows() {
    const auto& problem = loaded_.problem;
    const Eigen::MatrixXd w = loaded_.loads.displacements.cast<double>();
    const Eigen::MatrixXd b = loaded_.loads.motions.cast<double>();
    const auto p = problem.modes.matrix.cols();
    const int d = problem.dimension;
    for (int j = 0; j < static_cast<int>(loaded_.clearance.size()); ++j) {
      std::vector<linear::LinearTerm> terms;
      for (std::size_t k = 0; k < forces_.size(); ++k)
        terms.push_back(
            {static_cast<int>(k), problem.compliance.matrix.row(d * j).dot(forces_[k])});
      for (Eigen::Index l = 0; l < p; ++l)
        terms.push_back({static_cast<int>(forces_.size()) + static_cast<int>(l),
                         problem.modes.matrix(d * j, l)});
      terms.push_back({lambda_, w(d * j, 1)});
      const double fixed = -w(d * j, 0) - loaded_.clearance[j];
      program_.add_row({.lower = fixed, .upper = touches(j) ? fixed : unlimited}, terms);
    }
    for (Eigen::Index l = 0; l < p; ++l) {
      std::vector<linear::LinearTerm> terms;
      for (std::size_t k = 0; k < forces_.size(); ++k)
        terms.push_back({static_cast<int>(k), forces_[k].dot(problem.modes.matrix.col(l))});
      terms.push_back({lambda_, b(1, l)});
      program_.add_row({.lower = -b(0, l), .upper = -b(0, l)}, terms);
    }
  }

  const LoadedProblem& loaded_;
  unsigned contact_;
  linear::LinearProgram program_;
  std::vector<Eigen::VectorXd> forces_;
  int lambda_ = 0;
};

// Factors of all patterns, one by one.
std::vector<Interval> by_all_patterns(const LoadedProblem& loaded, double mu) {
  std::vector<Interval> all;
  const unsigned count = 1U << static_cast<unsigned>(loaded.clearance.size());
  for (unsigned contact = 0; contact < count; ++contact) {
    // Without friction both edges of a cone are one, and a cone without width has no states inside.
    if (const auto own = PatternProgram(loaded, mu, contact).factors()) all.push_back(*own);
  }
  std::ranges::sort(all);
  std::vector<Interval> joined;
  for (const auto& each : all) {
    const double slack = joined.empty() ? 0 : 1e-7 * std::max(1.0, std::abs(joined.back().second));
    if (joined.empty() || each.first > joined.back().second + slack)
      joined.push_back(each);
    else
      joined.back().second = std::max(joined.back().second, each.second);
  }
  return joined;
}

bool near(double a, double b) {
  return a == b || std::abs(a - b) <= 1e-6 * std::max({1.0, std::abs(a), std::abs(b)});
}

/// A random unconstrained body of bars, moved off the integers, with two loads and clearances.
/// Nothing: the seed gives a mechanism, a constrained body, or too few or many contacts.
std::optional<LoadedProblem> loaded_body(std::uint64_t seed, int dimension = 2) {
  auto structure = random_unconstrained_structure(dimension, seed);
  std::mt19937_64 generator(seed + 77);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto any = [&] { return uniform(generator); };
  structure.coordinates +=
      0.2 * Eigen::MatrixXd::NullaryExpr(dimension, structure.coordinates.cols(), any);
  if (structure.contact.size() < 2 || structure.contact.size() > 6) return {};
  const bool gaps = generator() % 2 == 0;
  for (auto& candidate : structure.contact) {
    candidate.normal =
        (candidate.normal + 0.2 * Eigen::VectorXd::NullaryExpr(dimension, any)).normalized();
    if (gaps) candidate.clearance = 0.3 * uniform(generator);
  }
  for (const auto kind : {problems::Load::Kind::dead, problems::Load::Kind::reference})
    for (int node = 0; node < static_cast<int>(structure.coordinates.cols()); ++node)
      structure.loads.push_back({kind, node, Eigen::VectorXd::NullaryExpr(dimension, any)});
  try {
    auto loaded = loaded_problem(checked(structure));
    const bool of_interest =
        loaded.problem.modes.matrix.cols() > 0 && loaded.has_reference && loaded.has_dead;
    return of_interest ? std::optional(std::move(loaded)) : std::nullopt;
  } catch (const support::InputError&) {  // a mechanism
    return {};
  }
}

// Automatically no body of this size has bounds of its candidates.
constexpr std::array with_and_without_bounds{Tightening::automatic, Tightening::always};

TEST(HeldFactors, AreThoseOfAllPatterns) {
  int compared = 0, bounded = 0, empty = 0, several = 0, proved = 0;
  for (std::uint64_t seed = 1; seed <= 160; ++seed) {
    const auto loaded = loaded_body(seed);
    if (!loaded) continue;
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    const double mu = 0.1 + 0.15 * static_cast<double>(seed % 7);
    const auto wanted = by_all_patterns(*loaded, mu);
    for (const auto tightening : with_and_without_bounds) {
      engine::SingleProcess alone;
      engine::Analysis analysis(alone);
      const auto found = held_factors(analysis, *loaded, mu, {.tightening = tightening});
      EXPECT_FALSE(found.unresolved);
      proved += is_proved(found.outside) ? 1 : 0;
      ASSERT_EQ(found.intervals.size(), wanted.size());
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_PRED2(near, found.intervals[i].low, wanted[i].first);
        EXPECT_PRED2(near, found.intervals[i].high, wanted[i].second);
      }
    }
    ++compared;
    empty += wanted.empty() ? 1 : 0;
    several += wanted.size() > 1 ? 1 : 0;
    for (const auto& [low, high] : wanted)
      bounded += std::isfinite(low) || std::isfinite(high) ? 1 : 0;
  }
  RecordProperty("compared", compared);
  EXPECT_GT(compared, 60);
  EXPECT_GT(bounded, 10);
  EXPECT_GE(proved, 2 * (compared - compared / 10));
  fmt::print("{} compared, {} proved, {} with an end, {} empty, {} with several\n", compared,
             proved, bounded, empty, several);
}

/// True if each interval is within one of the others.
bool within(const std::vector<Interval>& inner, const std::vector<Interval>& outer) {
  return std::ranges::all_of(inner, [&](const Interval& each) {
    return std::ranges::any_of(outer, [&](const Interval& other) {
      return (other.first <= each.first || near(other.first, each.first)) &&
             (each.second <= other.second || near(each.second, other.second));
    });
  });
}

TEST(HeldFactors, InSpaceAreBetweenThoseOfConesInsideAndAround) {
  int compared = 0, bounded = 0, proved = 0;
  for (std::uint64_t seed = 1; seed <= (test::thorough ? 2000 : 30); ++seed) {
    const auto loaded = loaded_body(seed, 3);
    if (!loaded) continue;
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    const double mu = 0.1 + 0.15 * static_cast<double>(seed % 7);
    const auto inner = by_all_patterns(*loaded, mu);
    const auto outer = by_all_patterns(*loaded, mu / std::cos(std::numbers::pi / edges_in_space));
    for (const auto tightening : with_and_without_bounds) {
      engine::SingleProcess alone;
      engine::Analysis analysis(alone);
      const auto found = held_factors(analysis, *loaded, mu, {.tightening = tightening});
      std::vector<Interval> held;
      for (const auto& each : found.intervals) held.emplace_back(each.low, each.high);
      EXPECT_TRUE(within(held, outer)) << fmt::format("{} not within {}", held, outer);
      proved += is_proved(found.outside) && !found.unresolved ? 1 : 0;
      if (found.unresolved) continue;
      EXPECT_TRUE(within(inner, held)) << fmt::format("{} not within {}", inner, held);
    }
    ++compared;
    for (const auto& [low, high] : inner)
      bounded += std::isfinite(low) || std::isfinite(high) ? 1 : 0;
  }
  fmt::print("{} compared, {} proved, {} with an end\n", compared, proved, bounded);
  EXPECT_GT(compared, 10);
  EXPECT_GT(bounded, 2);
  EXPECT_GE(proved, 2 * (compared - compared / 10));
}

TEST(HoldingFriction, IsTheLeastAtWhichSomePatternHoldsTheDeadLoad) {
  int compared = 0, inside = 0;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    const auto loaded = loaded_body(seed);
    if (!loaded) continue;
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    engine::SingleProcess alone;
    engine::Analysis analysis(alone);
    const auto found = holding_friction(
        analysis, *loaded, {.maximum = 100, .tightening = with_and_without_bounds.at(seed % 2)});
    const auto holds = [&](double mu) {
      return std::ranges::any_of(by_all_patterns(*loaded, mu), [](const Interval& each) {
        return each.first <= 0 && each.second >= 0;
      });
    };
    ++compared;
    if (!found.bracket.upper) {
      EXPECT_FALSE(holds(99));
      continue;
    }
    EXPECT_TRUE(holds(found.bracket.at_most() * (1 + 1e-5) + 1e-9));
    if (!found.bracket.lower) continue;
    EXPECT_FALSE(holds(found.bracket.at_least() * (1 - 1e-5)));
    EXPECT_LE(found.bracket.at_most() - found.bracket.at_least(),
              1e-6 * std::max(found.bracket.at_most(), 1e-6) + 1e-6);
    inside += found.bracket.at_least() > 0 ? 1 : 0;
  }
  EXPECT_GT(compared, 30);
  EXPECT_GT(inside, 10);
}

TEST(HalfPlanes, IntersectInAPolygonOrACone) {
  const auto planes_of = [](const std::vector<Eigen::Vector2d>& normals) {
    std::vector<HalfPlane> planes;
    for (const auto& normal : normals) planes.push_back({normal.normalized(), 1});
    return planes;
  };
  const auto square = intersection(planes_of({{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}}));
  ASSERT_EQ(square.vertices.size(), 4U);
  for (const auto& vertex : square.vertices) EXPECT_NEAR(vertex.cwiseAbs().minCoeff(), 1, 1e-14);
  EXPECT_TRUE(square.rays.empty());
  const auto corner = intersection(planes_of({{-1, 0}, {0, -1}}));
  ASSERT_EQ(corner.vertices.size(), 1U);
  EXPECT_NEAR((corner.vertices.front() + Eigen::Vector2d(1, 1)).norm(), 0, 1e-14);
  ASSERT_EQ(corner.rays.size(), 2U);
  EXPECT_NEAR((corner.rays[0] + corner.rays[1] - Eigen::Vector2d(1, 1)).norm(), 0, 1e-14);
  const auto strip = intersection(planes_of({{0, 1}, {0, -1}}));
  EXPECT_TRUE(strip.vertices.empty());
  EXPECT_EQ(strip.rays.size(), 2U);
}

/// A point with a distance of at least `slack` from the boundary of a hull: the edges are those of
/// all pairs of points, with rays as far points.
bool is_within(const Polygon& hull, const Eigen::Vector2d& point, double slack) {
  std::vector<Eigen::Vector2d> points = hull.vertices;
  for (const auto& ray : hull.rays)
    for (const auto& vertex : hull.vertices) points.emplace_back(vertex + 1e6 * ray);
  for (const auto& a : points) {
    for (const auto& b : points) {
      const Eigen::Vector2d normal = Eigen::Vector2d(a.y() - b.y(), b.x() - a.x());
      if (normal.norm() < 1e-9) continue;
      const bool edge = std::ranges::all_of(points, [&](const auto& each) {
        return normal.dot(each - a) <= 1e-9 * normal.norm() * (each - a).norm();
      });
      if (edge && normal.dot(point - a) > -slack * normal.norm()) return false;
    }
  }
  return true;
}

TEST(HalfPlanes, IntersectionOfTwoHullsHasThePointsOfBoth) {
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto random_point = [&] { return Eigen::Vector2d(uniform(generator), uniform(generator)); };
  // Bounded hulls, those with one direction, wedges, strips and half-planes, of any two kinds;
  // some with parallel edges.
  const auto random_hull = [&](int kind, const Eigen::Vector2d& along) {
    Polygon hull;
    const Eigen::Vector2d centre = random_point();
    for (int k = 0; k < 3; ++k) hull.vertices.emplace_back(centre + 0.7 * random_point());
    if (kind > 0) hull.rays = {along};
    if (kind == 2) hull.rays.emplace_back(Eigen::Rotation2Dd(2 * uniform(generator)) * along);
    if (kind > 2) hull.rays.emplace_back(-along);
    if (kind == 4) hull.rays.emplace_back(-along.y(), along.x());
    return hull;
  };
  int empty = 0, bounded = 0, endless = 0, lines = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Vector2d along = random_point().normalized();
    const Eigen::Vector2d other =
        trial < 25 ? Eigen::Vector2d((trial % 2 - 0.5) * 2 * along) : random_point().normalized();
    const std::array hulls{random_hull(trial % 5, along), random_hull(trial / 5 % 5, other)};
    const auto part = common_part(hulls[0], hulls[1]);
    (!part                                ? empty
     : part->rays.empty()                 ? bounded
     : trial % 5 > 2 && trial / 5 % 5 > 2 ? lines
                                          : endless) += 1;
    for (int k = 0; k < 40; ++k) {
      const Eigen::Vector2d point = 3 * random_point();
      const auto in_both = [&](double slack) {
        return is_within(hulls[0], point, slack) && is_within(hulls[1], point, slack);
      };
      if (in_both(1e-5) != in_both(-1e-5)) continue;
      EXPECT_EQ(part && is_within(*part, point, 0), in_both(0)) << trial;
    }
  }
  EXPECT_GT(std::min({empty, bounded, endless, lines}), 4);
}

TEST(HalfPlanes, PointsOnEdgesAreNoVertices) {
  const Polygon square{{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, -1 + 1e-6}}, {}};
  EXPECT_EQ(with_corners_only(square, {0.1, 0.2}, 1e-4, 1e-5).vertices.size(), 4U);
  // A vertex before the last one lies on the ray of that one.
  const Polygon cone{{{0, 0}, {1, 0}, {3, 0}, {0, 2}}, {{1, 0}, {0, 1}}};
  const auto only = with_corners_only(cone, {1, 1}, 1e-4, 1e-5);
  ASSERT_EQ(only.vertices.size(), 1U);
  EXPECT_EQ(only.vertices.front().norm(), 0);
  const Polygon bent{{{0, 0}, {2, -1e-3}, {0, 2}}, {{1, 0}, {0, 1}}};
  EXPECT_EQ(with_corners_only(bent, {1, 1}, 1e-4, 1e-5).vertices.size(), 2U);
}

/// A ladder against a wall with slope 4/3, and a climber at a tenth of its length.
LoadedProblem ladder(int climber) {
  return loaded_problem(problems::read_structure(fmt::format(R"(name = "ladder"
dimension = 2
units = {{ length = "m", force = "kN" }}
[[mesh]]
name = "ladder"
corners = [[0, 0], [3, 4], [2.92, 4.06], [-0.08, 0.06]]
divisions = [10, 1]
thickness = 1
plane = "strain"
E = 1000
nu = 0.3
[[contact]]
nodes = ["ladder.0,0"]
normal = [0, 1]
[[contact]]
nodes = ["ladder.10,0"]
normal = [-1, 0]
[[loads]]
kind = "dead"
nodes = ["ladder.{},0"]
force = [0, -1]
)",
                                                             climber),
                                                 "ladder.toml"));
}

TEST(HoldingFriction, OfALadderIsThatOfStatics) {
  for (const int climber : {2, 5, 8}) {
    const double s = climber / 10.0, slope = 4.0 / 3;
    const double wanted = (-slope + std::sqrt(slope * slope + 4 * s * (1 - s))) / (2 * (1 - s));
    const auto loaded = ladder(climber);
    engine::SingleProcess alone;
    engine::Analysis analysis(alone);
    const auto found = holding_friction(analysis, loaded);
    ASSERT_TRUE(found.bracket.upper);
    EXPECT_TRUE(found.bracket.has_proved_ends());
    EXPECT_NEAR(found.bracket.at_least(), wanted, 1e-8);
    EXPECT_NEAR(found.bracket.at_most(), wanted, 1e-8);
    EXPECT_LE(found.bracket.at_least(), wanted + 1e-15);
    EXPECT_GE(found.bracket.at_most(), wanted - 1e-15);
  }
}

// The ladder has two contacts: equilibrium of forces and moments in closed form.
TEST(Statics, NeedTheFrictionOfALadderToTheLastDigits) {
  for (const int climber : {2, 5, 8}) {
    const double s = climber / 10.0, slope = 4.0 / 3;
    const double wanted = (-slope + std::sqrt(slope * slope + 4 * s * (1 - s))) / (2 * (1 - s));
    const auto found = static_friction(ladder(climber), 1e-6, 1000);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found / wanted, 1, 1e-13);
    EXPECT_FALSE(static_friction(ladder(climber), 1.001 * wanted, 1000));  // enough from there on
    EXPECT_FALSE(static_friction(ladder(climber), 1e-6, 0.999 * wanted));
  }
}

// It turns about its lower edge at every coefficient that keeps it from sliding.
TEST(Statics, TurnATallBlockAboutItsEdge) {
  const auto loaded = loaded_problem(problems::load_structure(
      std::string(KUSABI_SOURCE_DIR) + "/examples/statics/tall-block-on-an-incline.toml"));
  for (const double mu : {1.0, 10.0, 1000.0}) {
    const auto amounts =
        static_motion(loaded, loaded.loads.motions.row(0).transpose().cast<double>(), mu);
    ASSERT_TRUE(amounts) << mu;
    const Eigen::VectorXd motion = loaded.problem.modes.matrix * *amounts;
    const double largest = motion.cwiseAbs().maxCoeff();
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(motion[2 * i + 1], 0, 1e-6 * largest) << mu;
      EXPECT_NEAR(motion[2 * i], i * motion[2], 1e-6 * largest) << mu;
    }
    EXPECT_GT(motion[2], 0);
  }
}

// Statics has no fewer reactions than the states, which also satisfy elasticity.
TEST(Statics, BoundTheFactorsOfRandomStructures) {
  int bounded = 0, equal = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const auto loaded = loaded_body(seed);
    if (!loaded) continue;
    constexpr double mu = 0.4;
    const auto range = static_range(*loaded, mu);
    if (!range) continue;
    engine::SingleProcess alone;
    engine::Analysis analysis(alone);
    for (const auto& each : held_factors(analysis, *loaded, mu).intervals) {
      const auto slack = [](double end) {
        return std::isfinite(end) ? 1e-7 * (1 + std::abs(end)) : 0;
      };
      EXPECT_GE(each.low, range->low - slack(range->low)) << seed;
      EXPECT_LE(each.high, range->high + slack(range->high)) << seed;
      bounded += std::isfinite(range->high) ? 1 : 0;
      equal += std::abs(each.high - range->high) <= slack(range->high) ? 1 : 0;
    }
  }
  EXPECT_GT(bounded, 0);
  EXPECT_GT(equal, 0);
}

}  // namespace
}  // namespace kusabi::wedged
