// Single distorted elements compared with other programs: in space CalculiX, in the plane mpmath
// with 40 digits.
#include <cmath>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "patches.hpp"
#include "problems/structure/assembly/solid_element.hpp"
#include "problems/structure/model/element_shape.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

TEST(SolidElement, HasTheStiffnessOfCalculix) {
  std::ifstream file(test::source_path("tests/reference/calculix_elements.json"));
  const auto cases = nlohmann::json::parse(file);
  ASSERT_EQ(cases.size(), 4U);
  for (const auto& data : cases) {
    SCOPED_TRACE(data.at("shape").get<std::string>());
    Structure body = test::empty_structure(3);
    Element element{{}, data.at("modulus"), data.at("ratio"), 0, PlaneState::stress};
    for (const auto& place : data.at("nodes"))
      element.nodes.push_back(test::add_node(body, Eigen::Vector3d(place[0], place[1], place[2])));
    element.shape = shape_of(3, element.nodes.size()).value();
    const auto stiffness = element_matrix<double>(body, element);
    const auto& rows = data.at("stiffness");
    ASSERT_EQ(stiffness.rows(), static_cast<Eigen::Index>(rows.size()));
    // Written with 14 digits.
    const double tolerance = 1e-12 * stiffness.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < stiffness.rows(); ++i) {
      for (Eigen::Index j = 0; j < stiffness.cols(); ++j) {
        EXPECT_NEAR(stiffness(i, j),
                    rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].get<double>(),
                    tolerance);
      }
    }
  }
}

TEST(SolidElement, HasTheStiffnessComputedWithFortyDigits) {
  std::ifstream file(test::source_path("tests/reference/mpmath_elements.json"));
  const auto cases = nlohmann::json::parse(file);
  ASSERT_EQ(cases.size(), 8U);
  for (const auto& data : cases) {
    Structure body = test::empty_structure(2);
    Element element{{},
                    data.at("modulus"),
                    data.at("ratio"),
                    data.at("thickness"),
                    data.at("strain").get<bool>() ? PlaneState::strain : PlaneState::stress};
    for (const auto& place : data.at("nodes"))
      element.nodes.push_back(test::add_node(body, Eigen::Vector2d(place[0], place[1])));
    element.shape = shape_of(2, element.nodes.size()).value();
    const auto stiffness = element_matrix<numbers::Precise>(body, element);
    const auto& rows = data.at("stiffness");
    ASSERT_EQ(stiffness.rows(), static_cast<Eigen::Index>(rows.size()));
    const double largest = stiffness.cast<double>().cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < stiffness.rows(); ++i) {
      for (Eigen::Index j = 0; j < stiffness.cols(); ++j) {
        const auto text =
            rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].get<std::string>();
        const numbers::Precise off = stiffness(i, j) - numbers::Precise(text.c_str());
        EXPECT_LE(std::abs(to_double(off)), 1e-28 * largest);
      }
    }
  }
}

}  // namespace
}  // namespace kusabi::problems
