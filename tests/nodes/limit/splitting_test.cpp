// Operator splitting: projections compared with optimality conditions and simple searches, and
// worst cases with all vertices.
#include <algorithm>
#include <barrier>
#include <cmath>
#include <functional>
#include <random>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "dense.hpp"
#include "nodes/limit/guaranteed_interval.hpp"
#include "nodes/limit/root/split_root.hpp"
#include "nodes/limit/splitting/acceleration.hpp"
#include "nodes/limit/splitting/affine_iteration.hpp"
#include "nodes/limit/splitting/affine_projection.hpp"
#include "nodes/limit/splitting/face_iteration.hpp"
#include "nodes/limit/splitting/face_projection.hpp"
#include "nodes/limit/splitting/row_projection.hpp"
#include "problems/families/grid_truss.hpp"
#include "tests/nodes/limit/load_model.hpp"

namespace kusabi::limit {
namespace {

using namespace splitting;
using test::findings;
using test::PlainTruss;
using test::problem_of;
using test::shown;

/// Three groups of columns, the last of which is not full.
constexpr int columns = 140;

ColumnBlocks random_blocks(int rows, std::mt19937& bits, const Sharing& sharing) {
  std::normal_distribution<double> normal;
  ColumnBlocks z(rows, columns, sharing);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) z.set(i, j, normal(bits));
  }
  return z;
}

// The zero of a decreasing function.
double root_of(const std::function<double(double)>& falling, double lower, double upper) {
  for (int k = 0; k < 200; ++k) {
    const double middle = (lower + upper) / 2;
    (falling(middle) > 0 ? lower : upper) = middle;
  }
  return (lower + upper) / 2;
}

TEST(RowProjection, FindsTheThresholdOfEachBall) {
  std::mt19937 bits(1);
  const Sharing alone;
  const Eigen::VectorXd capacity{{0.01, 1.0, 20.0, 1000.0, 0.3}};
  RowProjection rows(capacity, alone);
  for (int time = 0; time < 3; ++time) {  // the second and third start from other thresholds
    auto z = random_blocks(6, bits, alone);
    z.set(5, 0, 0);
    const double factor = 0.5;
    const double target = 0.7;
    rows.find(z, factor, target);
    for (int i = 0; i < 6; ++i) {
      const auto left = [&](double threshold) {
        double sum = i < 5 ? -capacity(i) : target - factor - threshold;
        for (int j = 0; j < columns; ++j) sum += std::max(0.0, std::abs(z.at(i, j)) - threshold);
        return sum;
      };
      const double expected = left(0) <= 0 ? 0 : root_of(left, 0, 100);
      EXPECT_NEAR(rows.threshold(i), expected, 1e-12) << i;
    }
  }
}

TEST(AffineProjection, IsTheNearestPointInItsMetric) {
  std::mt19937 bits(2);
  std::normal_distribution<double> normal;
  constexpr int rows = 9;
  constexpr int displacements = 5;
  Eigen::MatrixXd a(displacements, rows);
  for (auto& entry : a.reshaped()) entry = normal(bits);
  Eigen::VectorXd metric = Eigen::VectorXd::Ones(rows);
  metric(rows - 1) = 0.1;
  AffineProjection projection(a.sparseView(), metric);
  ASSERT_TRUE(projection.definite());
  std::vector<SparseLoad> loads(block_columns + 3);
  loads.back() = {{1, 2.0}, {4, -1.0}};
  const auto w = random_blocks(rows, bits, {});
  projection.begin(loads, block_columns);
  const Segment* const block = w.block(0, 1);
  for (int i = 0; i < rows; ++i) projection.take(i, block[i]);
  projection.solve();
  const Eigen::MatrixXd gram = a * metric.asDiagonal() * a.transpose();
  for (int c = 0; c < block_columns; ++c) {
    Eigen::VectorXd given(rows);
    for (int i = 0; i < rows; ++i) given(i) = w.at(i, block_columns + c);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(displacements);
    if (c == 2) load << 0, 2, 0, 0, -1;
    const Eigen::VectorXd u = dense::solve(gram, a * given - load);
    const Eigen::VectorXd expected = given - metric.asDiagonal() * a.transpose() * u;
    EXPECT_LT((projection.multipliers(c) - u).norm(), 1e-12);
    for (int i = 0; i < rows; ++i) {
      Segment row = block[i];
      projection.project(i, row);
      EXPECT_NEAR(row.part[c / lanes][c % lanes], expected(i), 1e-12);
    }
  }
}

// The square of the change of a row that limits the sum of its positive numbers.
double squared_cut(const ColumnBlocks& z, int row, double sign, double maximum) {
  const auto over = [&](double threshold) {
    double sum = -std::max(0.0, maximum);
    for (int j = 1; j < columns; ++j) sum += std::max(0.0, sign * z.at(row, j) - threshold);
    return sum;
  };
  const double threshold = over(0) <= 0 ? 0 : root_of(over, 0, 100);
  double total = 0;
  for (int j = 1; j < columns; ++j) {
    const double cut = std::min(threshold, std::max(0.0, sign * z.at(row, j)));
    total += cut * cut;
  }
  return total;
}

TEST(FaceProjection, FindsTheNearestStateAndBothThresholds) {
  std::mt19937 bits(3);
  const Sharing alone;
  AffineProgram program;
  program.capacity = Eigen::VectorXd{{1.0, 30.0, 2.0, 500.0, 40.0}};
  program.columns.resize(columns);
  Face face;
  face.stretches = {0, 0, 1, 0, -1};
  face.works.assign(columns - 1, true);
  face.works[7] = false;
  FaceProjection rows(program, face, alone);
  for (int time = 0; time < 3; ++time) {
    auto z = random_blocks(6, bits, alone);
    for (int i = 0; i < 6; ++i) z.set(i, 0, 0);
    const Eigen::VectorXd state{{0.3, 55.0, 0.0, -20.0, 0.0, 9.0}};
    rows.find(z, state);
    for (const int i : {0, 1, 3}) {
      const double capacity = program.capacity(i);
      const auto distance = [&](double a) {
        return (a - state(i)) * (a - state(i)) + squared_cut(z, i, 1, (capacity + a) / 2) +
               squared_cut(z, i, -1, (capacity - a) / 2);
      };
      EXPECT_LE(std::abs(rows.state()(i)), capacity + 1e-12);
      const double found = distance(rows.state()(i));
      for (const double step : {1e-3, 1e-2, 1e-1}) {
        for (const double sign : {-1.0, 1.0}) {
          const double other = std::clamp(rows.state()(i) + sign * step, -capacity, capacity);
          EXPECT_LE(found, distance(other) + 1e-9) << i;
        }
      }
    }
    EXPECT_EQ(rows.state()(2), 2);
    EXPECT_EQ(rows.state()(4), -40);
    for (const int i : {2, 4, 5}) {
      double sum = 0;
      for (int j = 0; j < columns; ++j) {
        const auto& works = rows.works(j / block_columns * block_columns);
        const Segment segment = z.block(j / group_columns, j % group_columns / block_columns)[i];
        const Segment cut = rows.cut_off(i, segment, works);
        const int within = j % block_columns;
        const double x = z.at(i, j) - cut.part[within / lanes][within % lanes];
        EXPECT_GE(i == 2 ? x : -x, 0);
        if (j == 8) {  // the load without work
          EXPECT_EQ(x, 0);
        }
        sum += std::abs(x);
      }
      if (i < 5) {
        EXPECT_LE(sum, program.capacity(i) * (1 + 1e-12));
      }
    }
  }
}

// The sums do not depend on the distribution of columns over ranks.
TEST(ColumnBlocks, SumsAreTheSameOnAnyNumberOfRanks) {
  std::mt19937 bits(4);
  const auto whole = random_blocks(4, bits, {});
  const auto expected = row_sizes(whole, {});
  for (const int ranks : {2, 3, 5}) {
    std::vector<std::vector<double>> parts;
    for (int rank = 0; rank < ranks; ++rank) {
      Sharing sharing{rank, ranks, [&](std::span<double> numbers) {
                        parts.emplace_back(numbers.begin(), numbers.end());
                      }};
      ColumnBlocks own(4, columns, sharing);
      for (int j = own.first_group() * group_columns;
           j < std::min(columns, own.end_group() * group_columns); ++j) {
        for (int i = 0; i < 4; ++i) own.set(i, j, whole.at(i, j));
      }
      row_sizes(own, sharing);
    }
    std::vector<double> sums(4, 0.0);
    for (std::size_t k = 0; k < parts.front().size(); ++k) {
      double only = 0;
      for (const auto& part : parts) only += part[k];  // all but one are zero
      sums[k % 4] += only;
    }
    EXPECT_EQ(sums, expected) << ranks;
  }
}

/// Some steps of both iterations: points and residuals, on every rank.
std::vector<double> steps_of(const AffineProgram& program, const Face& face,
                             const Sharing& sharing) {
  Eigen::VectorXd metric = Eigen::VectorXd::Ones(program.rows());
  metric(program.members()) = 0.1;
  AffineProjection projection(program.equilibrium, metric);
  AffineIteration iteration(program, projection, sharing);
  for (int k = 0; k < 30; ++k) iteration.step(face.factor);
  FaceIteration on_face(program, projection, sharing, face, iteration);
  for (int k = 0; k < 35; ++k) on_face.step();  // three cycles
  std::vector<double> numbers{iteration.residual(), on_face.residual()};
  for (const auto* const point : {&iteration.affine_point(), &on_face.affine_point()}) {
    const auto all = all_columns(*point, sharing);
    numbers.insert(numbers.end(), all.begin(), all.end());
  }
  const auto motion = iteration.motion();
  numbers.insert(numbers.end(), motion.begin(), motion.end());
  return numbers;
}

/// Ranks as threads.
std::vector<std::vector<double>> steps_on(int ranks, const AffineProgram& program,
                                          const Face& face) {
  const int groups = groups_of(static_cast<int>(program.columns.size()));
  std::barrier meeting(ranks);
  std::vector<double> common;
  std::vector<std::vector<double>> results(static_cast<std::size_t>(ranks));
  std::vector<std::jthread> threads;
  for (int rank = 0; rank < ranks; ++rank) {
    threads.emplace_back([&, rank] {
      Sharing sharing{rank, ranks};
      sharing.exchange = [&, sharing](std::span<double> numbers) {
        const auto part = numbers.size() / static_cast<std::size_t>(groups);
        if (rank == 0) common.resize(numbers.size());
        meeting.arrive_and_wait();
        const auto first = static_cast<std::size_t>(sharing.first_group(groups)) * part;
        const auto end = static_cast<std::size_t>(sharing.end_group(groups)) * part;
        std::copy(numbers.begin() + static_cast<std::ptrdiff_t>(first),
                  numbers.begin() + static_cast<std::ptrdiff_t>(end),
                  common.begin() + static_cast<std::ptrdiff_t>(first));
        meeting.arrive_and_wait();
        std::ranges::copy(common, numbers.begin());
        meeting.arrive_and_wait();
      };
      results[static_cast<std::size_t>(rank)] = steps_of(program, face, sharing);
    });
  }
  threads.clear();
  return results;
}

TEST(Splitting, MakesTheSameStepsOnAnyNumberOfRanks) {
  const auto model = limit_model(limit_problem(checked(problems::grid_truss(8))));
  LoadFactor load_factor(model);
  ASSERT_EQ(load_factor.solve(model.dead), LoadStatus::collapses);
  const auto program = affine_program(model, 40 / model.force_unit);
  const auto collapse = load_factor.collapse();
  const auto face =
      face_of(program, collapse.factor, collapse.motion, std::vector<int>(program.loads.size(), 1));
  const auto expected = steps_of(program, face, {});
  for (const int ranks : {2, 4}) {  // of three groups
    for (const auto& found : steps_on(ranks, program, face)) EXPECT_EQ(found, expected) << ranks;
  }
}

// Four differences determine the fixed point of a linear map with four eigenvalues.
TEST(Acceleration, FindsTheFixedPointOfALinearMap) {
  std::mt19937 bits(5);
  const Sharing alone;
  const MixedPoint fixed{random_blocks(3, bits, alone), Eigen::Vector2d(1, -2)};
  MixedPoint point{random_blocks(3, bits, alone), Eigen::Vector2d(5, 7)};
  constexpr double shares[] = {0.9, 0.5, 0.2, -0.7};
  const auto apply = [&](MixedPoint& z) {
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < 3; ++i) {
        const double apart = z.columns.at(i, j) - fixed.columns.at(i, j);
        z.columns.set(i, j, fixed.columns.at(i, j) + shares[(i + j) % 4] * apart);
      }
    }
    z.rest = fixed.rest + 0.9 * (z.rest - fixed.rest);
  };
  Acceleration acceleration(point, alone);
  for (int cycle = 0; cycle < 5; ++cycle) {
    apply(point);
    acceleration.advance(point);
    EXPECT_EQ(acceleration.extrapolates(), cycle > 0);
  }
  EXPECT_LT((point.rest - fixed.rest).norm(), 1e-5);
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(point.columns.at(i, j), fixed.columns.at(i, j), 1e-5);
  }
  auto result = point;
  apply(result);
  const auto expected = result.rest;
  acceleration.advance(result);
  acceleration.reject(result);
  EXPECT_EQ(result.rest, expected);
  EXPECT_FALSE(acceleration.extrapolates());
}

// L by all corners.
std::optional<double> greatest_least_factor(problems::Structure truss, double alpha) {
  for (auto& load : truss.loads) {
    if (load.kind == problems::Load::Kind::reference) load.force *= -1;
  }
  const auto opposite = PlainTruss(truss).min_over_corners(alpha);
  return opposite ? std::optional(-*opposite) : std::nullopt;
}

TEST(Splitting, AgreesWithAllVerticesOnRandomTrusses) {
  int compared = 0;
  int empty = 0;
  for (std::uint32_t seed = 5001; seed < 5061; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto [truss, alpha] = test::correlated_truss(seed);
    if (!problem_of(truss)) continue;
    const auto found = findings(truss, {.alpha = alpha, .split_from = 1});
    EXPECT_TRUE(found.answer.whole());
    if (!found.answer.worst) continue;
    const auto minimum = PlainTruss(truss).min_over_corners(alpha);
    if (!minimum) {
      EXPECT_EQ(found.answer.worst->status, RootStatus::not_carried);
      continue;
    }
    ++compared;
    EXPECT_NEAR(found.answer.worst->ends.at_most(), *minimum, test::near);
    EXPECT_NEAR(found.answer.worst->ends.at_least(), *minimum, test::near);
    ASSERT_FALSE(found.theorems.empty());
    EXPECT_EQ(shown(found.theorems.front(), truss).why, "");
    const double from = greatest_least_factor(truss, alpha).value();
    const auto interval = guaranteed_interval(found.answer);
    EXPECT_LE(interval.minimum.at_least(), from + test::near);
    EXPECT_GE(interval.minimum.at_most(), from - test::near);
    if (std::abs(from - *minimum) < test::near) continue;
    EXPECT_EQ(interval.is_empty(), from > *minimum);
    ASSERT_EQ(found.theorems.size(), 2U);
    if (!found.theorems.back().nodes.empty()) continue;
    ++empty;
    EXPECT_TRUE(interval.is_empty());
  }
  EXPECT_GE(compared, 25);
  EXPECT_GE(empty, 1);  // ended once the interval was known to be empty
}

TEST(Splitting, LeavesGapsOfStaticCutsToTheTree) {
  for (const std::uint32_t seed : {1807U, 2041U}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto [truss, alpha] = test::correlated_truss(seed);
    const auto found = findings(truss, {.alpha = alpha, .split_from = 1});
    EXPECT_GT(found.answer.worst->nodes, 1U);
    EXPECT_NEAR(found.answer.worst->ends.at_most(),
                PlainTruss(truss).min_over_corners(alpha).value(), test::near);
    EXPECT_FALSE(found.theorems.empty());
  }
}

}  // namespace
}  // namespace kusabi::limit
