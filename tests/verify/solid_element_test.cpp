// Elements of every shape: the intervals contain the results in 104 bits up to their error bound,
// although both have only the nodes in common.
#include "verify/structure/solid_element.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "nodes/evidence/verified_structure.hpp"
#include "problems/structure/assembly/solid_element.hpp"
#include "tests/problems/structure/patches.hpp"

namespace kusabi::verify {
namespace {

class SolidElement : public testing::TestWithParam<problems::ElementShape> {};

INSTANTIATE_TEST_SUITE_P(Each, SolidElement, testing::ValuesIn(problems::test::all_shapes),
                         [](const auto& each) { return problems::test::name_of(each.param); });

mpq_class exactly(const numbers::Precise& number) {
  return mpq_class(number.x[0]) + mpq_class(number.x[1]);
}

// Also far from the origin, flat, and almost incompressible: the bound remains valid.
TEST_P(SolidElement, ContainsTheStiffnessOfTheSolver) {
  std::mt19937 bits(3);
  for (const double flat : {1.0, 1e-3}) {
    for (const bool strain : {false, true}) {
      auto body = problems::test::one_element(GetParam(), 0.25, bits);
      body.coordinates.row(1) *= flat;
      if (strain) body.coordinates.array() += 1e6;
      auto& element = body.elements[0];
      element.state = strain ? problems::PlaneState::strain : problems::PlaneState::stress;
      element.ratio = strain ? 0.4999 : -0.3;
      const auto verified = evidence::verified_structure(body);
      const auto enclosed = enclosed_stiffness(verified, Freedom(verified));
      const auto precise = problems::element_matrix<numbers::Precise>(body, element);
      const auto bounds = problems::element_matrix<numbers::RunningError>(body, element);
      const double largest = bounds(0, 0).maximum() + bounds(1, 1).maximum();
      for (std::size_t i = 0; i < enclosed.size(); ++i) {
        for (std::size_t j = 0; j < enclosed.size(); ++j) {
          const auto& entry = enclosed[i].at(j);
          ASSERT_TRUE(entry.finite());
          const mpq_class lower = entry.lower().rational();
          const mpq_class upper = entry.upper().rational();
          const auto row = static_cast<Eigen::Index>(i);
          const auto column = static_cast<Eigen::Index>(j);
          const mpq_class bound = mpq_class(bounds(row, column).error * 1.001) *
                                  mpq_class(numbers::unit_roundoff<numbers::Precise>);
          const mpq_class own = exactly(precise(row, column));
          EXPECT_LE(lower - own, bound);
          EXPECT_LE(own - upper, bound);
          // Both are narrow.
          EXPECT_LE(mpq_class(upper - lower).get_d(), 1e-75 * largest);
          EXPECT_LE(bound.get_d(), 1e-16 * largest);
        }
      }
    }
  }
}

}  // namespace
}  // namespace kusabi::verify
