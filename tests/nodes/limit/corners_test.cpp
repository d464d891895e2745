// Corners in place of static cuts: factors and certificates of random trusses compared with all
// vertices, which are solved independently; forged certificates; searches that are stopped; the
// choice between both methods.
#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "nodes/limit/guaranteed_interval.hpp"
#include "nodes/limit/root/corner_choice.hpp"
#include "problems/families/grid_truss.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/limit/half_widths.hpp"
#include "tests/nodes/limit/load_model.hpp"
#include "tests/nodes/limit/two_bars.hpp"

namespace kusabi::limit {
namespace {

using problems::Load;
using problems::Structure;
using test::findings;
using test::near;
using test::PlainTruss;
using test::problem_of;
using test::shown;

constexpr unsigned max_loads = 5;

Structure with_opposite_reference(Structure truss) {
  for (auto& load : truss.loads) {
    if (load.kind == Load::Kind::reference) load.force = -load.force;
  }
  return truss;
}

// Expects one proved node for each corner, and bounds that meet at `minimum`.
void expect_all_corners(const verify::TrussTheorem& theorem, const Structure& truss,
                        double minimum) {
  EXPECT_TRUE(theorem.cuts.empty());
  EXPECT_EQ(theorem.nodes.size(), std::size_t{1} << theorem.truss.uncertain->size());
  const auto claim = shown(theorem, truss);
  EXPECT_EQ(claim.why, "");
  EXPECT_NEAR(claim.lower, minimum, near);
  EXPECT_NEAR(claim.upper, minimum, near);
  EXPECT_LE(claim.lower, claim.upper);
}

TEST(Corners, HaveTheFactorsOfAllVertices) {
  unsigned compared = 0;
  unsigned not_carried = 0;
  for (unsigned seed = 1; seed <= 120; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto [truss, alpha] = test::correlated_truss(seed);
    const auto problem = problem_of(truss);
    if (!problem || truss.uncertain->size() > max_loads) continue;
    const PlainTruss plain(truss);
    if (!plain.factor(Eigen::VectorXd::Zero(plain.uncertain.cols()))) continue;
    const auto found = findings(truss, {.alpha = alpha, .corners = Corners::always});
    EXPECT_TRUE(found.answer.whole());
    const auto& worst = *found.answer.worst;
    EXPECT_EQ(worst.cuts, 0U);
    const auto minimum = plain.min_over_corners(alpha);
    if (!minimum) {
      EXPECT_EQ(worst.status, RootStatus::not_carried);
      EXPECT_EQ(found.theorems.at(0).claim, verify::LimitClaim::none);
      ++not_carried;
      continue;
    }
    EXPECT_EQ(worst.corners, 1U << truss.uncertain->size());
    EXPECT_NEAR(worst.ends.at_most(), *minimum, near);
    EXPECT_NEAR(worst.ends.at_least(), *minimum, near);
    const auto opposite = with_opposite_reference(truss);
    const auto least = PlainTruss(opposite).min_over_corners(alpha).value();
    const auto interval = guaranteed_interval(found.answer);
    EXPECT_NEAR(interval.minimum.at_least(), -least, near);
    EXPECT_NEAR(interval.minimum.at_most(), -least, near);
    ASSERT_EQ(found.theorems.size(), 2U);
    expect_all_corners(found.theorems[0], truss, *minimum);
    expect_all_corners(found.theorems[1], truss, least);
    ++compared;
  }
  EXPECT_GE(compared, 40U);
  EXPECT_GE(not_carried, 2U);
}

// Columns that do not change the load have no sign of their own: 2 corners for 2 loads.
TEST(Corners, LeaveOutLoadsOfNoWidth) {
  unsigned compared = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    auto [truss, alpha] = test::correlated_truss(seed);
    const auto problem = problem_of(truss);
    if (!problem) continue;
    truss.uncertain->resize(2);
    truss.uncertain->back().group = "of no width";
    auto one = truss;
    one.uncertain->resize(1);
    const auto minimum = PlainTruss(one).min_over_corners(alpha);
    if (!minimum) continue;
    auto half = limit_problem(checked(truss));
    for (auto& column : half.uncertain) column.half_width = column.group.empty() ? alpha : 0;
    engine::SingleProcess alone;
    engine::Analysis analysis(alone);
    const auto found = limit_loads(analysis, truss, half, {.alpha = 1, .corners = Corners::always});
    EXPECT_EQ(found.answer.worst->corners, 2U);
    EXPECT_NEAR(found.answer.worst->ends.at_least(), *minimum, near);
    EXPECT_NEAR(found.answer.worst->ends.at_most(), *minimum, near);
    EXPECT_TRUE(found.answer.whole());
    ++compared;
  }
  EXPECT_GE(compared, 5U);
}

// Two bars of equal strength under loads across the reference load: q = lambda +- zeta.
TEST(Corners, OfEqualFactorsAreProved) {
  Structure truss = problems::read_structure(
      two_bars("[[uncertainty]]\nname = \"across\"\nforces = [{ nodes = [\"tip\"], force = [1, "
               "-1] }]\n[[uncertainty]]\nname = \"again\"\nforces = [{ nodes = [\"tip\"], force = "
               "[1, -1] }]\n"),
      "two-bars.toml");
  for (auto& member : truss.members) member.yield = problems::YieldForces{3, 3};
  const auto found = findings(truss, {.alpha = 0.5, .corners = Corners::always});
  EXPECT_NEAR(found.answer.worst->ends.at_most(), 2, 1e-9);
  EXPECT_TRUE(found.answer.whole());
  expect_all_corners(found.theorems.at(0), truss, 2);
}

TEST(Corners, AreNotProvedByAForgedCertificate) {
  const auto truss = problems::load_structure(KUSABI_SOURCE_DIR "/examples/gust.toml");
  const auto found = findings(truss, {.alpha = 0.5, .corners = Corners::always});
  const auto& honest = found.theorems.at(0);
  ASSERT_EQ(shown(honest, truss).why, "");
  for (std::size_t missing = 0; missing < honest.nodes.size(); ++missing) {
    auto forged = honest;
    forged.nodes.erase(forged.nodes.begin() + static_cast<std::ptrdiff_t>(missing));
    EXPECT_EQ(shown(forged, truss).why, "no node covers some combination of signs");
  }
  for (std::size_t k = 1; k < honest.nodes.size(); ++k) {
    auto forged = honest;  // the state of another load
    forged.nodes[k].forces = honest.nodes[k - 1].forces;
    forged.nodes[k].factor = honest.nodes[k - 1].factor;
    EXPECT_NE(shown(forged, truss).why, "");
  }
}

// A search that was stopped has the least factor so far as its upper bound, and static cuts or
// nothing as its lower one.
TEST(Corners, BoundTheWorstCaseWhereTheSearchWasStopped) {
  unsigned compared = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto [truss, alpha] = test::correlated_truss(seed);
    const auto problem = problem_of(truss);
    if (!problem || truss.uncertain->size() < 3) continue;
    const auto minimum = PlainTruss(truss).min_over_corners(alpha);
    if (!minimum) continue;
    for (const std::uint64_t nodes : {1U, 6U}) {
      engine::SingleProcess alone;
      engine::Analysis analysis(alone, {.limits = {.nodes = nodes}});
      const auto found =
          limit_loads(analysis, truss, *problem, {.alpha = alpha, .corners = Corners::always});
      const auto& worst = *found.answer.worst;
      EXPECT_EQ(worst.search, engine::Status::node_limit);
      EXPECT_LT(worst.corners, 1U << truss.uncertain->size());
      EXPECT_TRUE(is_proved(worst.ends.upper));
      EXPECT_GE(worst.ends.at_most(), *minimum - near);
      EXPECT_LE(worst.ends.at_least(), *minimum + near);
      EXPECT_FALSE(found.answer.whole());
      for (const auto& theorem : found.theorems) {
        if (theorem.claim != verify::LimitClaim::largest) continue;
        const auto claim = shown(theorem, truss);
        EXPECT_LE(claim.lower, *minimum + near);
        EXPECT_GE(claim.upper, *minimum - near);
      }
      ++compared;
    }
  }
  EXPECT_GE(compared, 20U);
}

// The same at many moments, during a program as well.
TEST(Corners, HaveValidBoundsWhereverTheyAreStopped) {
  const auto [truss, alpha] = test::correlated_truss(1807);
  const auto minimum = PlainTruss(truss).min_over_corners(alpha).value();
  std::uint64_t polls = 0;
  const auto stopped_at = [&, &loads = truss, half_width = alpha](std::uint64_t last) {
    engine::SingleProcess alone;
    polls = 0;
    engine::Analysis analysis(alone, {.interrupt = [&] {
                                return ++polls > last ? engine::Interrupt::stop
                                                      : engine::Interrupt::none;
                              }});
    return limit_loads(analysis, loads, limit_problem(checked(loads)),
                       {.alpha = half_width, .corners = Corners::always})
        .answer;
  };
  EXPECT_TRUE(stopped_at(std::numeric_limits<std::uint64_t>::max()).whole());
  const auto all = polls;
  ASSERT_GE(all, 20U);
  for (std::uint64_t part = 0; part < 20; ++part) {
    SCOPED_TRACE(part);
    const auto found = stopped_at(part * all / 20);
    EXPECT_EQ(found.ended(), engine::Status::interrupted);
    EXPECT_FALSE(found.whole());
    if (!found.worst) continue;
    EXPECT_LE(found.worst->ends.at_least(), minimum + near);
    EXPECT_GE(found.worst->ends.at_most(), minimum - near);
  }
}

// 4 (20 + 30) = 200 iterations for two loads.
TEST(CornerChoice, ComparesCornersWithARoundOfCuts) {
  EXPECT_FALSE(CornerChoice(2, 100, 30).is_less_than_a_round());
  EXPECT_TRUE(CornerChoice(2, 101, 30).is_less_than_a_round());
  EXPECT_FALSE(CornerChoice(2, 1, 30).is_less_than(200));
  EXPECT_TRUE(CornerChoice(2, 1, 30).is_less_than(201));
  EXPECT_FALSE(CornerChoice(4000, 1e6, 30).is_less_than_a_round());
}

TEST(CornerChoice, DividesNodesWithFewUndecidedSigns) {
  EXPECT_EQ(CornerChoice(5, 1, 30).signs_within(99), 0);
  EXPECT_EQ(CornerChoice(5, 1, 30).signs_within(100), 1);
  EXPECT_EQ(CornerChoice(5, 1, 30).signs_within(799), 3);
  EXPECT_EQ(CornerChoice(5, 1, 30).signs_within(1e9), 5);
}

// Few loads on a large truss are solved one by one, those of a small one by cuts.
TEST(CornerChoice, DependsOnTheSizeOfTheTruss) {
  for (const auto& [bays, corners] : {std::pair(2, 0U), std::pair(7, 4U)}) {
    auto truss = problems::grid_truss(bays);
    const int last = static_cast<int>(truss.node_names.size()) - 1;
    truss.uncertain = {{"one", {{last, 0, 1}, {last - 1, 0, 1}}}, {"two", {{last - 2, 1, 1}}}};
    const auto found = findings(truss, {.alpha = 20});
    EXPECT_EQ(found.answer.worst->corners, corners);
    EXPECT_EQ(found.answer.worst->cuts == 0, corners > 0);
    const auto minimum = PlainTruss(truss).min_over_corners(20).value();
    EXPECT_NEAR(found.answer.worst->ends.at_most(), minimum, near * std::abs(minimum));
    EXPECT_NEAR(found.answer.worst->ends.at_least(), minimum, near * std::abs(minimum));
  }
}

}  // namespace
}  // namespace kusabi::limit
