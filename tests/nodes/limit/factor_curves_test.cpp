// Curves over beta: the published ones, and those of random trusses compared with all vertices of
// their loads, each place solved by itself.
#include "nodes/limit/factor_curves.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <random>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/transport/single_process.hpp"
#include "nodes/limit/limit_loads.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/limit/collapse_mode.hpp"
#include "support/input_error.hpp"

namespace kusabi::limit {
namespace {

using problems::LimitProblem;
using problems::Structure;
using Json = nlohmann::json;

constexpr double infinity = std::numeric_limits<double>::infinity();

double between(std::mt19937& bits, double from, double to) {
  return from + (to - from) * (static_cast<double>(bits()) * 0x1p-32);
}

Json reference() {
  std::ifstream stream(KUSABI_SOURCE_DIR "/tests/reference/limit.json");
  return Json::parse(stream);
}

Structure truss_in(const std::string& file) {
  return problems::load_structure(std::string(KUSABI_SOURCE_DIR "/") + file);
}

LimitAnswer answer(const Structure& truss, const LimitParameters& parameters) {
  engine::SingleProcess alone;
  engine::Analysis analysis(alone);
  return limit_loads(analysis, truss, problems::limit_problem(checked(truss)), parameters).answer;
}

/// @param expected pairs of a place and a factor, the last one at the end of the curve
void expect_points(const LoadCurve& curve, const Json& expected, double unit, double near) {
  ASSERT_EQ(curve.pieces.size() + 1, expected.size());
  for (std::size_t k = 0; k < curve.pieces.size(); ++k) {
    EXPECT_NEAR(curve.pieces[k].from.at, expected[k][0].get<double>() / unit, near);
    EXPECT_NEAR(curve.pieces[k].from.factor, expected[k][1].get<double>(), near);
  }
  EXPECT_EQ(curve.pieces.back().to, expected.back()[0].get<double>() / unit);
  EXPECT_NEAR(curve.pieces.back().factor_at_end, expected.back()[1].get<double>(), near);
}

// The figure is not available, except the letters in the text and the numbers of Figures 2 to 4.
TEST(FactorCurves, AgreeWithFigure5AndTheReference) {
  const auto truss = truss_in("examples/paper/limit-3x3.toml");
  const auto problem = problems::limit_problem(checked(truss));
  const auto twenty = answer(truss, {.alpha = 20});
  const Eigen::VectorXd load = 2 * (dead_load(problem, twenty.worst->zeta) - problem.dead);
  const auto found = answer(truss, {.alpha = 40, .curve = true, .curve_load = load});
  EXPECT_TRUE(found.whole());
  const Json expected = reference().at("figure_5");
  expect_points(*found.curve, expected.at("solid"), 1, 1e-8);
  expect_points(*found.load_curve, expected.at("dashed"), 1, 1e-8);
  expect_points(*found.worst_curve, expected.at("worst"), 1, 1e-6);
  constexpr double printed = 0.5e-4;
  const auto sways = [&](const CurvePiece& piece) {
    return problems::collapse_mode(problem, piece.from.motion).along_reference;
  };
  for (const auto* curve : {&*found.curve, &*found.worst_curve}) {
    const auto& pieces = curve->pieces;
    EXPECT_NEAR(pieces.front().from.factor, 48.3662, printed);   // (A)
    EXPECT_NEAR(pieces.back().factor_at_end, 37.0120, printed);  // (C)
    EXPECT_TRUE(sways(pieces.front()));                          // (A) to (B), and to (E)
    EXPECT_FALSE(sways(pieces.back()));                          // to (C)
  }
  EXPECT_TRUE(sways(found.load_curve->pieces.front()));  // (A) to (D)
  // lambda_min(20), half-way to 40, is on the first piece.
  const auto& first = found.worst_curve->pieces.front();
  EXPECT_GT(first.to, 0.5);
  EXPECT_NEAR(first.from.factor + 0.5 * first.from.slope, 44.3662, printed);
}

TEST(WorstCurve, HasTheBreakpointsOfTheReference) {
  const Json all = reference().at("worst_case_of_alpha");
  for (const char* const name : {"3x3", "4x4"}) {
    const Json& expected = all.at(name);
    const double alpha = 20;
    const auto found = answer(
        truss_in(std::string("examples/paper/limit-") + name + ".toml"),
        {.alpha = alpha, .curve = true, .curve_to = expected.back()[0].get<double>() / alpha});
    ASSERT_TRUE(found.worst_curve->proved());
    expect_points(*found.worst_curve, expected, alpha, 1e-6);
    for (const auto& piece : found.worst_curve->pieces) EXPECT_LT(*piece.error, 1e-7);
  }
}

// By hand: two bars at 45 degrees and a transverse pull of alpha: sqrt(2) - alpha, until both yield
// under the pull alone.
TEST(WorstCurve, EndsWhereNoFactorIsCarried) {
  const auto found =
      answer(truss_in("tests/cases/tie.toml"), {.alpha = 0.1, .curve = true, .curve_to = 1e4});
  for (const auto* curve : {&*found.curve, &*found.worst_curve}) {
    ASSERT_EQ(curve->pieces.size(), 1U);
    EXPECT_NEAR(curve->pieces.front().from.slope, -0.1, 1e-9);
    ASSERT_TRUE(curve->end);
    EXPECT_NEAR(curve->end->carried_at, 10 * std::sqrt(2.0), 1e-5);
    EXPECT_NEAR(curve->end->not_carried_at, 10 * std::sqrt(2.0), 1e-5);
    EXPECT_LT(curve->end->carried_at, curve->end->not_carried_at);
  }
  EXPECT_TRUE(found.worst_curve->proved());
  // The load at the end of the axis has no factor, but a critical part.
  const auto beyond = answer(truss_in("tests/cases/tie.toml"), {.alpha = 2, .curve = true});
  EXPECT_EQ(beyond.worst->status, RootStatus::not_carried);
  EXPECT_NEAR(beyond.worst_curve->end->carried_at, std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(beyond.curve->end->carried_at, std::sqrt(0.5), 1e-6);
  EXPECT_TRUE(beyond.whole());
}

/// A random truss in the plane, with some cables.
Structure random_truss(std::mt19937& bits) {
  Structure truss;
  truss.name = "random";
  truss.dimension = 2;
  truss.units = {"m", "kN"};
  const int nodes = 6;
  truss.coordinates.resize(2, nodes);
  for (int node = 0; node < nodes; ++node) {
    for (int axis = 0; axis < 2; ++axis) truss.coordinates(axis, node) = between(bits, 0, 3);
    truss.node_names.push_back(std::to_string(node));
    truss.fixed.push_back(node < 2 ? std::array{true, true, true} : std::array<bool, 3>{});
  }
  for (int first = 0; first < nodes; ++first) {
    for (int second = first + 1; second < nodes; ++second) {
      if (between(bits, 0, 1) > 0.85) continue;
      const double tension = between(bits, 0.3, 1);
      const double compression = bits() % 3 == 0 ? tension * between(bits, 0, 1) : tension;
      truss.members.push_back(
          {.first = first, .second = second, .yield = problems::YieldForces{tension, compression}});
    }
  }
  const auto load = [&](problems::Load::Kind kind, int node) {
    truss.loads.push_back(
        {kind, node, Eigen::Vector2d(between(bits, -1, 1), between(bits, -1, 1))});
  };
  load(problems::Load::Kind::reference, 5);
  load(problems::Load::Kind::dead, 4);
  return truss;
}

/// lambda* under another dead load, by a program of its own; minus infinity: no factor.
double factor_under(LimitProblem problem, const Eigen::VectorXd& dead) {
  problem.dead = dead;
  const auto model = problems::limit_model(problem);
  LoadFactor solver(model);
  if (solver.solve(model.dead) != LoadStatus::collapses) return -infinity;
  return solver.collapse().factor * model.factor_unit;
}

double min_over_corners(const LimitProblem& problem, double alpha) {
  double minimum = infinity;
  const auto m = static_cast<unsigned>(problem.uncertain_count());
  for (unsigned corner = 0; corner < 1U << m; ++corner) {
    Eigen::VectorXd zeta(m);
    for (unsigned j = 0; j < m; ++j) zeta(j) = ((corner >> j) & 1U) != 0 ? alpha : -alpha;
    minimum = std::min(minimum, factor_under(problem, dead_load(problem, zeta)));
  }
  return minimum;
}

/// Value of a curve at a place; minus infinity: no factor.
double value_of(const LoadCurve& curve, double beta) {
  for (const auto& piece : curve.pieces) {
    if (beta <= piece.to) return piece.from.factor + piece.from.slope * (beta - piece.from.at);
  }
  return -infinity;
}

void expect_same(double said, double truth, double near, double beta) {
  if (std::isfinite(said) && std::isfinite(truth)) {
    EXPECT_NEAR(said, truth, near) << beta;
  } else {
    EXPECT_EQ(said, truth) << beta;
  }
}

TEST(FactorCurves, AgreeWithASeparateAnalysisAtEachPlace) {
  std::mt19937 bits(11);  // NOLINT(cert-msc32-c,cert-msc51-cpp): repeatable on purpose
  int compared = 0;
  int ended = 0;
  std::size_t max_pieces = 0;
  for (int trial = 0; trial < 40; ++trial) {
    SCOPED_TRACE(trial);
    const auto truss = random_truss(bits);
    const double alpha = between(bits, 0.02, 0.3);
    std::optional<LimitProblem> problem;
    try {
      problem = problems::limit_problem(checked(truss));
    } catch (const support::InputError&) {
      continue;  // a mechanism
    }
    Eigen::VectorXd load(problem->free_count());
    for (double& each : load) each = between(bits, -1, 1);
    const double to = 2;
    const auto found =
        answer(truss, {.alpha = alpha, .curve = true, .curve_load = load, .curve_to = to});
    if (!found.nominal) continue;
    ASSERT_TRUE(found.whole());
    ++compared;
    ended += found.worst_curve->end.has_value();
    max_pieces = std::max(max_pieces, found.worst_curve->pieces.size());
    double error = 1e-9;  // of the simplex method
    for (const auto& piece : found.worst_curve->pieces) error = std::max(error, *piece.error);
    EXPECT_LT(error, 1e-6);
    const Eigen::VectorXd critical = dead_load(*problem, found.worst->zeta) - problem->dead;
    for (int step = 0; step <= 16; ++step) {
      const double beta = to * step / 16;
      const auto under = [&](const Eigen::VectorXd& of) {
        return factor_under(*problem, problem->dead + beta * of);
      };
      expect_same(value_of(*found.curve, beta), under(critical), 1e-8, beta);
      expect_same(value_of(*found.load_curve, beta), under(load), 1e-8, beta);
      if (step % 4 != 0) continue;
      expect_same(value_of(*found.worst_curve, beta), min_over_corners(*problem, beta * alpha),
                  error + 1e-9, beta);
    }
  }
  EXPECT_GE(compared, 20);
  EXPECT_GE(ended, 5);
  EXPECT_GE(max_pieces, 3U);
}

}  // namespace
}  // namespace kusabi::limit
