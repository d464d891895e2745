// F in 104 bits compared with 60-digit arithmetic, and its error bound, which must be valid and
// useful.
#include "problems/wedged/precise_compliance.hpp"

#include <cmath>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::problems {
namespace {

using nlohmann::json;
using numbers::Precise;

Eigen::VectorXd vector_of(const json& list) {
  Eigen::VectorXd vector(static_cast<Eigen::Index>(list.size()));
  for (Eigen::Index i = 0; i < vector.size(); ++i) vector(i) = list[static_cast<std::size_t>(i)];
  return vector;
}

Structure structure_of(const json& data) {
  Structure structure;
  structure.name = "random";
  structure.dimension = data.at("dimension");
  structure.units = {"m", "kN"};
  const auto& places = data.at("coordinates");
  structure.coordinates.resize(structure.dimension, static_cast<Eigen::Index>(places.size()));
  for (std::size_t node = 0; node < places.size(); ++node) {
    const bool held = node >= data.at("free").get<std::size_t>();
    structure.node_names.push_back("n" + std::to_string(node));
    structure.fixed.push_back({held, held, held});
    structure.coordinates.col(static_cast<Eigen::Index>(node)) = vector_of(places[node]);
  }
  for (const auto& bar : data.at("members"))
    structure.members.push_back({bar[0], bar[1], bar[2], std::nullopt});
  for (const auto& element : data.at("elements"))
    structure.elements.push_back({element.at("nodes"), element.at("E"), element.at("nu"),
                                  element.at("thickness"), PlaneState::stress});
  for (const auto& candidate : data.at("contact")) {
    std::optional<Eigen::VectorXd> tangent;
    if (!candidate[2].is_null()) tangent = vector_of(candidate[2]);
    structure.contact.push_back({candidate[0], vector_of(candidate[1]), tangent, 1.0});
  }
  return structure;
}

json references() {
  std::ifstream file(KUSABI_SOURCE_DIR "/tests/reference/mpmath_compliances.json");
  return json::parse(file);
}

TEST(PreciseCompliance, AgreesWithSixtyDigitsWithinItsErrorBound) {
  const json cases = references();
  ASSERT_EQ(cases.size(), 12U);
  for (std::size_t number = 0; number < cases.size(); ++number) {
    SCOPED_TRACE(::testing::Message() << "case " << number);
    const auto& data = cases[number];
    // For any normals, including those that point out of the body, which problem files must not
    // have.
    const auto structure = structure_of(data);
    const auto enclosed = enclosed_compliance(structure, free_degrees(structure));
    const auto& rows = data.at("compliance");
    ASSERT_EQ(enclosed.matrix.rows(), static_cast<Eigen::Index>(rows.size()));
    EXPECT_LE(enclosed.error, 1e-17);
    const auto truth = [&](std::size_t i, std::size_t j) {
      return Precise(rows[i][j].get<std::string>().c_str());
    };
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = 0; j < rows.size(); ++j) {
        const auto row = static_cast<Eigen::Index>(i);
        const auto column = static_cast<Eigen::Index>(j);
        const double size = to_double(sqrt(truth(i, i) * truth(j, j)));
        const Precise off = enclosed.matrix(row, column) - truth(i, j);
        // The true value itself is rounded to 104 bits here.
        EXPECT_LE(std::abs(to_double(off)), (enclosed.error + 1e-31) * size);
      }
    }
  }
}

// The stiffness in doubles is the rounding of the inverse.
TEST(PreciseCompliance, HasTheStiffnessAsItsInverse) {
  for (const auto& data : references()) {
    if (!data.at("elements").empty()) continue;
    const WedgedProblem problem = wedged_problem(checked(structure_of(data)));
    const double size = problem.compliance.matrix.diagonal().maxCoeff();
    EXPECT_LE((problem.compliance.precise.cast<double>() - problem.compliance.matrix)
                  .cwiseAbs()
                  .maxCoeff(),
              problem.compliance.error * size);
    EXPECT_LE(problem.compliance.error, 1.2e-16);
    const numbers::PreciseMatrix stiffness = stiffness_of(problem.compliance.precise);
    EXPECT_EQ(problem.compliance.stiffness, stiffness.cast<double>());
    const numbers::PreciseMatrix product = stiffness * problem.compliance.precise;
    const Eigen::MatrixXd rest =
        product.cast<double>() - Eigen::MatrixXd::Identity(product.rows(), product.cols());
    EXPECT_LE(rest.cwiseAbs().maxCoeff(), 1e-17);
    EXPECT_TRUE(problem.compliance.stiffness == problem.compliance.stiffness.transpose());
  }
}

// A bar along the normal and one across it: F = diag(L_n / EA_n, L_t / EA_t).
TEST(PreciseCompliance, OfTwoCrossingBarsOfAnyContrastIsAccepted) {
  for (const double stiff : {1.0, 1e6, 1e9, 1e12}) {
    Structure structure;
    structure.name = "cross";
    structure.dimension = 2;
    structure.node_names = {"c", "a", "b"};
    structure.coordinates.resize(2, 3);
    structure.coordinates << 0, 1, 0, 0, 0, 3;
    structure.fixed = {{false, false, false}, {true, true, true}, {true, true, true}};
    structure.members = {{0, 1, stiff, {}}, {0, 2, 1.0, {}}};
    structure.contact = {{0, Eigen::Vector2d(1, 0), std::nullopt, 1.0}};
    const WedgedProblem problem = wedged_problem(checked(structure));
    EXPECT_EQ(problem.compliance.matrix(0, 0), 1 / stiff);
    EXPECT_EQ(problem.compliance.matrix(1, 1), 3);
    EXPECT_EQ(problem.compliance.matrix(0, 1), 0);
    EXPECT_EQ(problem.compliance.stiffness(0, 0), stiff);
    EXPECT_LE(problem.compliance.precise_error, 1e-21);
  }
}

// 5000 bars in a row, of which only the last end also moves transversely: F = sum of L / EA,
// exactly. Systems of this size are solved in doubles first.
TEST(PreciseCompliance, OfALongChainIsTheSumOfItsBars) {
  constexpr int bars = 5000;
  Structure structure;
  structure.name = "chain";
  structure.dimension = 2;
  structure.coordinates.setZero(2, bars + 2);
  double sum = 0;
  for (int node = 0; node <= bars; ++node) {
    structure.node_names.push_back("n" + std::to_string(node));
    structure.coordinates(0, node) = node;
    structure.fixed.push_back({node == 0, node < bars, false});
    if (node == 0) continue;
    const double stiffness = std::exp2(node * node % 7 - 3);
    structure.members.push_back({node - 1, node, stiffness, {}});
    sum += 1 / stiffness;
  }
  structure.node_names.emplace_back("below");
  structure.coordinates.col(bars + 1) << bars, -3;
  structure.fixed.push_back({true, true, false});
  structure.members.push_back({bars, bars + 1, 1.0, {}});
  structure.contact = {{bars, Eigen::Vector2d(1, 0), std::nullopt, 1.0}};
  const auto compliance = enclosed_compliance(structure, free_degrees(structure));
  EXPECT_LE(compliance.error, 1e-20);
  EXPECT_LE(std::abs(to_double(compliance.matrix(0, 0) - Precise(sum))), compliance.error * sum);
  EXPECT_LE(std::abs(to_double(compliance.matrix(1, 1) - Precise(3.0))), compliance.error * 3);
  EXPECT_LE(std::abs(to_double(compliance.matrix(0, 1))), compliance.error * std::sqrt(3 * sum));
}

// 1400 branches of four bars between a node and a support act as springs in parallel. The factor
// in doubles takes no step, so that F is exact by the correction with the residuals alone.
TEST(PreciseCompliance, OfManyBranchesIsThatOfSpringsInParallel) {
  constexpr int branches = 1400;
  constexpr int first = 3;  // after the node, the support, and one below the node
  Structure structure;
  structure.name = "branches";
  structure.dimension = 2;
  structure.coordinates.setZero(2, first + 3 * branches);
  structure.coordinates.col(1) << 4, 0;
  structure.coordinates.col(2) << 0, -3;
  structure.fixed = {{false, false, false}, {true, true, false}, {true, true, false}};
  structure.members = {{0, 2, 1.0, {}}};
  Precise parallel = 0.0;
  for (int branch = 0; branch < branches; ++branch) {
    Precise compliance = 0.0;
    int before = 0;
    for (int bar = 0; bar < 4; ++bar) {
      const int next = bar == 3 ? 1 : first + 3 * branch + bar;
      const double stiffness = 1 + 0.1 * bar + 0.001 * branch;
      structure.members.push_back({before, next, stiffness, {}});
      compliance += 1.0 / Precise(stiffness);
      if (bar < 3) {
        structure.coordinates(0, next) = bar + 1;
        structure.fixed.push_back({false, true, false});
      }
      before = next;
    }
    parallel += 1.0 / compliance;
  }
  for (Eigen::Index node = 0; node < structure.coordinates.cols(); ++node)
    structure.node_names.push_back("n" + std::to_string(node));
  structure.contact = {{0, Eigen::Vector2d(1, 0), std::nullopt, 1.0}};
  const auto compliance = enclosed_compliance(structure, free_degrees(structure));
  const Precise sum = 1.0 / parallel;
  EXPECT_LE(compliance.error, 1e-24);
  EXPECT_LE(std::abs(to_double(compliance.matrix(0, 0) - sum)), compliance.error * to_double(sum));
  EXPECT_LE(std::abs(to_double(compliance.matrix(1, 1) - Precise(3.0))), compliance.error * 3);
}

}  // namespace
}  // namespace kusabi::problems
