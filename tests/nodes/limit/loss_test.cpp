// Loss of members compared with all losses of random trusses, by independent code, and with
// published numbers of grid trusses; losses that leave no factor; ranks.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/simulation.hpp"
#include "engine/transport/single_process.hpp"
#include "nodes/evidence/verified_structure.hpp"
#include "nodes/limit/limit_loads.hpp"
#include "nodes/limit/loss/loss_proof.hpp"
#include "nodes/limit/loss/loss_tree.hpp"
#include "problems/families/grid_truss.hpp"
#include "support/input_error.hpp"
#include "tests/nodes/limit/plain_truss.hpp"

namespace kusabi::limit {
namespace {

using problems::Structure;

constexpr double infinity = std::numeric_limits<double>::infinity();

LossAnswer answer_of(const Structure& truss, const LossQuestion& question) {
  engine::SingleProcess alone;
  engine::Analysis analysis(alone);
  const auto problem = problems::limit_problem(checked(truss));
  const auto found = limit_loads(analysis, truss, problem, {.loss = question});
  return found.loss.value_or(LossAnswer{});
}

/// The least factor over all losses of up to `left` further members from `from` on.
double least_of_all(test::PlainTruss& truss, const std::vector<bool>& kept, int from, int left) {
  double least = truss.factor(Eigen::VectorXd::Zero(truss.uncertain.cols())).value_or(-infinity);
  if (left == 0) return least;
  for (int i = from; i < truss.tension.size(); ++i) {
    if (kept[static_cast<std::size_t>(i)]) continue;
    const double tension = std::exchange(truss.tension(i), 0);
    const double compression = std::exchange(truss.compression(i), 0);
    least = std::min(least, least_of_all(truss, kept, i + 1, left - 1));
    truss.tension(i) = tension;
    truss.compression(i) = compression;
  }
  return least;
}

/// Six or seven nodes, most of them joined; cables, rollers and nodes in line at random.
Structure random_truss(std::uint32_t seed) {
  std::mt19937 bits(seed);
  const auto below = [&](unsigned count) { return static_cast<unsigned>(bits() % count); };
  const auto between = [&](double from, double to) {
    return from + (to - from) * (static_cast<double>(bits()) * 0x1p-32);
  };
  Structure truss;
  truss.name = "random " + std::to_string(seed);
  const int d = truss.dimension = below(4) == 0 ? 3 : 2;
  truss.units = {"m", "kN"};
  const int nodes = 6 + static_cast<int>(below(2));
  const bool on_a_grid = below(2) == 0;
  truss.coordinates.resize(d, nodes);
  for (int node = 0; node < nodes; ++node) {
    for (int axis = 0; axis < d; ++axis)
      truss.coordinates(axis, node) = on_a_grid ? below(4) : between(0, 3);
    truss.node_names.push_back(std::to_string(node));
    truss.fixed.push_back(node < d ? std::array{true, true, true} : std::array<bool, 3>{});
  }
  if (below(4) == 0) truss.fixed[static_cast<std::size_t>(d)][below(2)] = true;
  const bool cables = below(3) == 0;
  for (int first = 0; first < nodes; ++first) {
    for (int second = first + 1; second < nodes; ++second) {
      if (below(7) == 0) continue;
      const double tension = between(0.3, 1);
      const double compression = cables && below(3) == 0 ? 0 : tension * between(0.3, 1);
      truss.members.push_back(
          {.first = first, .second = second, .yield = problems::YieldForces{tension, compression}});
    }
  }
  const auto load = [&](problems::Load::Kind kind, int node) {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(d);
    force(below(static_cast<unsigned>(d))) = between(-1, 1);
    truss.loads.push_back({kind, node, force});
  };
  load(problems::Load::Kind::reference, nodes - 1);
  if (below(2) == 0) load(problems::Load::Kind::reference, nodes - 2);
  if (below(3) != 0) {
    load(problems::Load::Kind::dead, nodes - 1 - static_cast<int>(below(3)));
    truss.loads.back().force *= 0.3;
  }
  truss.uncertain.emplace();
  return truss;
}

unsigned from_environment(const char* name, unsigned otherwise) {
  const char* const text = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
  return text == nullptr ? otherwise : static_cast<unsigned>(std::stoul(text));
}

TEST(Loss, ProvesTheWorstOfAllLossesOfRandomTrusses) {
  unsigned compared = 0;
  unsigned fatal = 0;
  unsigned open = 0;
  const unsigned first = from_environment("KUSABI_SEED", 1);
  const unsigned count = from_environment("KUSABI_TRUSSES", 60);
  for (unsigned seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto truss = random_truss(seed);
    std::optional<test::PlainTruss> plain;
    try {
      problems::limit_problem(checked(truss));
      plain.emplace(truss);
    } catch (const support::InputError&) {
      continue;  // a mechanism, or two nodes at one place
    }
    const std::vector<bool> none(truss.members.size());
    for (const int most : {1, 2, 3}) {
      SCOPED_TRACE("K = " + std::to_string(most));
      if (most == 3 && seed % 5 != 0) continue;
      const auto found = answer_of(truss, {.most = most});
      if (found.most == 0) continue;  // the nominal load is not carried
      const double expected = least_of_all(*plain, none, 0, most);
      ++compared;
      if (!found.proved) ++open;
      if (expected == -infinity) {
        ++fatal;
        EXPECT_TRUE(found.is_fatal()) << found.ends.lower << " to " << found.ends.upper;
        continue;
      }
      EXPECT_TRUE(found.proved) << found.ends.lower << " to " << found.ends.upper << ", "
                                << found.undecided << " undecided";
      const double room = 1e-6 * (1 + std::abs(expected));
      EXPECT_NEAR(found.ends.upper, expected, room);
      EXPECT_LE(found.ends.lower, expected + 1e-9);
    }
  }
  RecordProperty("compared", static_cast<int>(compared));
  EXPECT_GT(compared, count);
  EXPECT_GT(fatal, 0U);
  EXPECT_EQ(open, 0U);
}

/// A grid with a quarter of the dead load, and no load at its upper corners.
Structure grid(int bays) {
  auto truss = problems::grid_truss(bays);
  const int corner = (bays + 1) * (bays + 1) - 1;
  std::erase_if(truss.loads, [&](const problems::Load& load) {
    return load.node == corner || load.node == corner - bays;
  });
  for (auto& load : truss.loads) {
    if (load.kind == problems::Load::Kind::dead) load.force /= 4;
  }
  return truss;
}

/// Members at loaded nodes.
std::vector<int> at_loads(const Structure& truss) {
  std::vector<int> members;
  for (std::size_t i = 0; i < truss.members.size(); ++i) {
    const auto& bar = truss.members[i];
    const bool loaded = std::ranges::any_of(truss.loads, [&](const problems::Load& load) {
      return load.node == bar.first || load.node == bar.second;
    });
    if (loaded) members.push_back(static_cast<int>(i));
  }
  return members;
}

void expect_proved(const LossAnswer& found, double factor) {
  EXPECT_TRUE(found.proved);
  EXPECT_EQ(found.undecided, 0U);
  EXPECT_LE(found.ends.lower, factor + 1e-9);
  EXPECT_GE(found.ends.upper, factor - 1e-9);
  EXPECT_LE(found.ends.upper - found.ends.lower, 1e-5);
}

// Numbers of the reference (structures.json, C), computed by HiGHS; those of 4 x 4 also by
// enumeration of all losses.
TEST(Loss, HasTheFactorsOfGrids) {
  const auto small = grid(4);
  EXPECT_NEAR(answer_of(small, {.most = 1}).nominal, 27.611514259139085, 1e-8);
  expect_proved(answer_of(small, {.most = 1}), 17.644995211179335);
  expect_proved(answer_of(small, {.most = 2}), 8.822497605589668);
  const auto kept = at_loads(small);
  EXPECT_EQ(answer_of(small, {.most = 1, .kept = kept}).eligible, 50);
  expect_proved(answer_of(small, {.most = 1, .kept = kept}), 23.2561040487847);
  expect_proved(answer_of(small, {.most = 2, .kept = kept}), 18.900693838430296);
  expect_proved(answer_of(small, {.most = 3, .kept = kept}), 15.356390040961939);
  const auto large = grid(6);
  expect_proved(answer_of(large, {.most = 2}), 8.822497605589668);
  expect_proved(answer_of(large, {.most = 2, .kept = at_loads(large)}), 17.005020946149298);
}

TEST(Loss, ReportsLossesThatLeaveNoFactor) {
  const auto found = answer_of(grid(4), {.most = 3});
  EXPECT_TRUE(found.is_fatal());
  EXPECT_TRUE(found.proved);
  EXPECT_FALSE(found.collapse);
  // Three bars below one loaded node.
  EXPECT_EQ(found.lost.size(), 3U);
}

TEST(Loss, DecidesATarget) {
  const auto truss = grid(4);
  const auto reached = answer_of(truss, {.most = 2, .at_least = 8.8});
  EXPECT_EQ(reached.reaches_target, true);
  EXPECT_TRUE(reached.proved);
  const auto missed = answer_of(truss, {.most = 2, .at_least = 8.9});
  EXPECT_EQ(missed.reaches_target, false);
  EXPECT_TRUE(missed.proved);
  EXPECT_LT(missed.ends.upper, 8.9);
}

TEST(Loss, ListsTheLossOfEachMember) {
  const auto truss = grid(4);
  auto plain = test::PlainTruss([&] {
    auto certain = truss;
    certain.uncertain.emplace();
    return certain;
  }());
  const auto found = answer_of(truss, {.most = 1});
  ASSERT_EQ(found.singles.size(), truss.members.size());
  for (const auto& single : found.singles) {
    const int i = single.member;
    const double tension = std::exchange(plain.tension(i), 0);
    const double compression = std::exchange(plain.compression(i), 0);
    const auto expected = plain.factor(Eigen::VectorXd(0));
    ASSERT_EQ(single.status, LoadStatus::collapses);
    ASSERT_TRUE(expected);
    EXPECT_NEAR(single.factor, *expected, 1e-7) << i;
    plain.tension(i) = tension;
    plain.compression(i) = compression;
  }
}

// The opening of a node depends on the node alone, and the first solution on no number of ranks.
TEST(Loss, DoesNotDependOnTheNumberOfRanks) {
  const auto truss = grid(4);
  const auto problem = problems::limit_problem(checked(truss));
  const auto verified = evidence::verified_structure(truss);
  const auto model = problems::limit_model(problem);
  const std::vector<support::IndexSet> pool;
  auto eligible = support::IndexSet::below(problem.member_count());
  for (const int member : at_loads(truss)) eligible -= support::IndexSet::single(member);
  for (const double factor : {15.35, 15.5}) {
    const LossTarget target{3, factor, eligible};
    std::vector<support::IndexSet> first;
    std::vector<std::uint64_t> marks;
    for (const int ranks : {1, 2, 5}) {
      LossProof proof(verified, problem, model);
      engine::Options options;
      options.goal = engine::Goal::first;
      options.check_expand = 0.05;
      LossTree tree(model, proof, target, pool);
      const auto outcome = engine::simulate(tree, ranks, 7, {}, options);
      ASSERT_EQ(outcome.outcome.status, engine::Status::solved);
      const auto& found = outcome.outcome.solutions;
      first.push_back(found.empty() ? support::IndexSet() : found.front().solution.lost);
      marks.push_back(outcome.outcome.fingerprint());
    }
    EXPECT_EQ(first[0].empty(), factor < 15.356);
    EXPECT_EQ(first[0], first[1]);
    EXPECT_EQ(first[0], first[2]);
    if (first[0].empty()) {
      EXPECT_EQ(marks[0], marks[1]);
      EXPECT_EQ(marks[0], marks[2]);
    }
  }
}

}  // namespace
}  // namespace kusabi::limit
