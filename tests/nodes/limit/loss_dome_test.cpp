// Loss of members of ring domes, whose loads balance by symmetry: compared with all losses by
// independent code, also where coordinates are rounded or have noise; ends before the answer;
// claims that differ from proved ones in the last digits.
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/transport/single_process.hpp"
#include "nodes/evidence/verified_structure.hpp"
#include "nodes/limit/limit_loads.hpp"
#include "tests/nodes/limit/load_model.hpp"
#include "tests/nodes/limit/plain_truss.hpp"
#include "verify/limit/stress_state.hpp"
#include "verify/limit/truss_certificate.hpp"
#include "verify/limit/truss_proof.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::limit {
namespace {

using problems::Structure;

/// Coordinates of a dome.
struct DomeShape {
  int sectors = 6;
  int rings = 2;      ///< the last one is supported
  double grid = 0;    ///< coordinates are rounded to multiples of it; 0: not at all
  double noise = 0;   ///< instead of zero
  double turned = 0;  ///< about the axis
};

/// A node at the apex, rings, meridians, and diagonals to the next sector; a load on each node.
Structure ring_dome(const DomeShape& shape) {
  Structure truss;
  truss.name = "ring dome";
  truss.dimension = 3;
  truss.units = {"m", "kN"};
  const int nodes = 1 + shape.sectors * shape.rings;
  const auto node = [&](int ring, int sector) {
    return 1 + ring * shape.sectors + sector % shape.sectors;
  };
  const auto coordinate = [&](double exact) {
    const double rounded = shape.grid == 0 ? exact : shape.grid * std::round(exact / shape.grid);
    return std::abs(rounded) < 1e-12 ? shape.noise : rounded;
  };
  truss.coordinates.setZero(3, nodes);
  truss.coordinates(2, 0) = 6.7;
  for (int ring = 0; ring < shape.rings; ++ring) {
    const double radius = 2.7 + 2.2 * ring;
    const double largest = 2.7 + 2.2 * (shape.rings - 1);
    for (int sector = 0; sector < shape.sectors; ++sector) {
      const double angle = shape.turned + 2 * std::numbers::pi * sector / shape.sectors;
      truss.coordinates.col(node(ring, sector)) << coordinate(radius * std::cos(angle)),
          coordinate(radius * std::sin(angle)),
          coordinate(6.7 - 2.3 * radius * radius / (largest * largest));
    }
  }
  for (int k = 0; k < nodes; ++k) {
    const bool supported = k >= node(shape.rings - 1, 0);
    truss.node_names.push_back(std::to_string(k));
    truss.fixed.push_back({supported, supported, supported});
    if (!supported)
      truss.loads.push_back({problems::Load::Kind::reference, k, Eigen::Vector3d(0, 0, -1)});
  }
  const auto join = [&](int first, int second) {
    truss.members.push_back(
        {.first = first, .second = second, .yield = problems::YieldForces{10, 5}});
  };
  for (int sector = 0; sector < shape.sectors; ++sector) {
    join(0, node(0, sector));
    for (int ring = 0; ring + 1 < shape.rings; ++ring) {
      join(node(ring, sector), node(ring, sector + 1));
      join(node(ring, sector), node(ring + 1, sector));
      join(node(ring, sector), node(ring + 1, sector + 1));
    }
  }
  truss.uncertain.emplace();
  return truss;
}

LossAnswer answer_for(const Structure& truss, const LossParameters& parameters,
                      std::optional<double> alpha = {}, engine::AnalysisOptions options = {}) {
  engine::SingleProcess alone;
  engine::Analysis analysis(alone, std::move(options));
  const auto problem = problems::limit_problem(checked(truss));
  const auto found = limit_loads(analysis, truss, problem, {.alpha = alpha, .loss = parameters});
  return found.loss.value_or(LossAnswer{});
}

/// The least factor over all losses of up to `left` members from `from` on.
double least_of_all(test::PlainTruss& truss, int from, int left, double alpha) {
  double least = truss.min_over_corners(alpha).value_or(-std::numeric_limits<double>::infinity());
  if (left == 0) return least;
  for (int i = from; i < truss.tension.size(); ++i) {
    const double tension = std::exchange(truss.tension(i), 0);
    const double compression = std::exchange(truss.compression(i), 0);
    least = std::min(least, least_of_all(truss, i + 1, left - 1, alpha));
    truss.tension(i) = tension;
    truss.compression(i) = compression;
  }
  return least;
}

/// The independent program without entries that are noise.
test::PlainTruss plain(const Structure& truss) {
  test::PlainTruss without_noise(truss);
  auto& entries = without_noise.equilibrium;
  entries = (entries.array().abs() < 1e-14).select(0, entries);
  return without_noise;
}

void expect_least_of_all(const Structure& truss, int maximum, double alpha = 0) {
  auto independent = plain(truss);
  const double expected = least_of_all(independent, 0, maximum, alpha);
  const auto found = answer_for(truss, {.maximum = maximum}, alpha);
  EXPECT_TRUE(found.proved());
  EXPECT_EQ(found.undecided, 0U);
  EXPECT_NEAR(found.ends.at_most(), expected, 1e-6);
  EXPECT_NEAR(found.ends.at_least(), expected, 1e-6);
  ASSERT_TRUE(found.theorem);
  EXPECT_EQ(test::shown(*found.theorem, truss).why, "");
}

TEST(LossOfDomes, IsTheWorstOfAllLosses) {
  const std::array shapes{DomeShape{8, 3}, DomeShape{8, 3, 0.1}, DomeShape{8, 3, 0.1, 1e-16},
                          DomeShape{8, 3, 0, 1e-16}, DomeShape{8, 3, 0, 0, 0.3}};
  for (const auto& shape : shapes) {
    SCOPED_TRACE(testing::Message() << shape.grid << ' ' << shape.noise << ' ' << shape.turned);
    expect_least_of_all(ring_dome(shape), 1);
  }
}

TEST(LossOfDomes, IsTheWorstOfAllPairs) {
  for (const double grid : {0.0, 0.1}) expect_least_of_all(ring_dome({6, 2, grid}), 2);
}

TEST(LossOfDomes, IsTheWorstUnderUncertainLoads) {
  auto truss = ring_dome({6, 2});
  truss.uncertain->push_back({.name = "wind", .components = {{0, 0, 0.4}, {1, 0, 0.2}}});
  truss.uncertain->push_back({.name = "snow", .components = {{2, 2, -0.3}, {3, 2, -0.3}}});
  expect_least_of_all(truss, 1, 0.5);
}

// The loads of a dome without dead load: zero times the reference load is carried always.
TEST(LossOfDomes, KeepsWhatIsKnownAtAnEarlyEnd) {
  const auto truss = ring_dome({6, 3});
  const auto complete = answer_for(truss, {.maximum = 1});
  ASSERT_TRUE(complete.proved());
  int early = 0;
  int with_a_loss = 0;
  for (int calls = 1;; calls += 1 + calls / 4) {
    int left = calls;
    const auto found =
        answer_for(truss, {.maximum = 1}, {}, {.interrupt = [&left] {
                     return --left < 0 ? engine::Interrupt::stop : engine::Interrupt::none;
                   }});
    if (found.maximum == 0) continue;  // before the nominal load is known
    if (found.proved()) break;
    ++early;
    EXPECT_NE(found.search, engine::Status::solved);
    EXPECT_TRUE(is_proved(found.ends.lower));
    EXPECT_EQ(found.ends.at_least(), 0);
    EXPECT_TRUE(is_proved(found.ends.upper));
    EXPECT_GE(found.ends.at_most(), complete.ends.at_least());
    if (!found.lost.empty()) ++with_a_loss;
    ASSERT_TRUE(found.theorem);
    EXPECT_EQ(test::shown(*found.theorem, truss).why, "");
  }
  EXPECT_GT(early, 5);
  EXPECT_GT(with_a_loss, 3);
}

/// A node on a strut and a tie, and a bar that is not stressed.
Structure hanging_node() {
  Structure truss;
  truss.name = "hanging node";
  truss.dimension = 2;
  truss.coordinates.resize(2, 4);
  truss.coordinates << 0, 0, 3, -2,  //
      0, 1, 0, 0;
  for (const char* const name : {"a", "b", "c", "d"}) truss.node_names.emplace_back(name);
  truss.fixed = {{}, {true, true, true}, {true, true, true}, {true, true, true}};
  for (int end = 1; end < 4; ++end)
    truss.members.push_back({.first = 0, .second = end, .yield = problems::YieldForces{1, 1}});
  truss.loads.push_back({problems::Load::Kind::reference, 0, Eigen::Vector2d(0, -1)});
  truss.uncertain.emplace();
  return truss;
}

// Only the bar a-b carries the load: without it the factor is zero.
TEST(LossWithoutDeadLoad, LeavesTheFactorZeroExactly) {
  const auto truss = hanging_node();
  const auto found = answer_for(truss, {.maximum = 1});
  EXPECT_TRUE(found.proved());
  EXPECT_EQ(found.ends.at_least(), 0);
  EXPECT_LT(found.ends.at_most(), 1e-90);
  EXPECT_THAT(found.lost, testing::ElementsAre(0));
  ASSERT_TRUE(found.theorem);
  EXPECT_EQ(test::shown(*found.theorem, truss).why, "");
  EXPECT_EQ(answer_for(truss, {.maximum = 1, .at_least = 0.5}).reaches_target, false);
}

TEST(LossCertificate, IsRefusedForTheLastDigits) {
  const auto truss = hanging_node();
  auto theorem = *answer_for(truss, {.maximum = 1, .kept = {0}}).theorem;
  const auto refused = [&](double factor, std::vector<std::size_t> support) {
    theorem.lower = factor;
    theorem.states = {{std::move(support), {{factor, {{0, factor}}}}}};
    return std::holds_alternative<std::string>(verify::TrussProof(theorem).lower(0));
  };
  EXPECT_FALSE(refused(1, {0}));
  EXPECT_TRUE(refused(1 + 1e-12, {0}));
  // The bar with the force is outside the support.
  EXPECT_TRUE(refused(0.5, {1, 2}));
}

TEST(LossCertificate, IsRefusedWithoutAMemberOfAState) {
  const auto truss = ring_dome({8, 3});
  const auto theorem = *answer_for(truss, {.maximum = 1}).theorem;
  ASSERT_EQ(theorem.collapse.lost.size(), 1U);
  std::size_t forged = 0;
  for (const auto& state : theorem.states) {
    // That of the worst loss carries no more than the target.
    if (std::ranges::binary_search(state.support, theorem.collapse.lost.front())) continue;
    for (const auto& [member, force] : state.columns.front().forces) {
      if (std::abs(force) < 4.9) continue;  // far from its yield force
      auto without = theorem;
      without.states = {state};
      std::erase(without.states.front().support, member);
      const auto lower = verify::TrussProof(without).lower(0);
      EXPECT_TRUE(std::holds_alternative<std::string>(lower)) << member;
      ++forged;
    }
  }
  EXPECT_GT(forged, 0U);
}

TEST(LossProofByElimination, EndsAtItsLimits) {
  const auto theorem = *answer_for(ring_dome({}), {.maximum = 1}).theorem;
  ASSERT_FALSE(theorem.states.empty());
  const auto exact = verify::exact_truss(theorem.truss);
  const auto& state = theorem.states.front();
  EXPECT_TRUE(verify::carried_factor(exact, state));
  EXPECT_FALSE(verify::carried_factor(exact, state, {.stop = [] { return true; }}));
  EXPECT_FALSE(verify::carried_factor(exact, state, {.products = 0}));
}

}  // namespace
}  // namespace kusabi::limit
