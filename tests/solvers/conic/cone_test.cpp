// Cone algebra tests by the defining identities, inside the cone and close to its boundary.
#include "solvers/conic/cone.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "dense.hpp"

namespace kusabi::conic {
namespace {

template <int D>
using Vector = Eigen::Matrix<double, D, 1>;

template <int D>
ConePoint<D> point(const Vector<D>& x) {
  ConePoint<D> values;
  Vector<D>::Map(values.data()) = x;
  return values;
}

template <std::size_t D>
Vector<static_cast<int>(D)> vector(const std::array<double, D>& values) {
  return Vector<static_cast<int>(D)>::Map(values.data());
}

template <int D>
bool inside(const Vector<D>& x) {
  return margin(point<D>(x)) > 0;
}

template <int D>
Vector<D> jordan(const Vector<D>& x, const Vector<D>& y) {
  return vector(jordan_product(point<D>(x), point<D>(y)));
}

template <int D>
Eigen::Matrix<double, D, D> matrix(const NesterovToddScaling<D>& scaling) {
  return Eigen::Matrix<double, D, D>::NullaryExpr([&](Eigen::Index i, Eigen::Index j) {
    return scaling.entry(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  });
}

// Rounding of a D-vector operation, with a margin for its constant.
constexpr double rounding = 100 * std::numeric_limits<double>::epsilon();

// Relative distances of the points from the boundary.
constexpr double depths[] = {1.0, 1e-2, 1e-5, 1e-8};

template <class Dimension>
class Cone : public ::testing::Test {
 public:
  static constexpr int dimension = Dimension::value;

  /// A point at the relative depth `depth` in the cone, of random size and direction.
  Vector<dimension> interior(double depth) {
    Vector<dimension> x = anywhere();
    x[0] = x.template tail<dimension - 1>().norm() * (1 + depth);
    return x * std::exp(3 * uniform_(generator_));
  }
  Vector<dimension> anywhere() {
    return Vector<dimension>::NullaryExpr([&] { return uniform_(generator_); });
  }

 private:
  std::mt19937_64 generator_{7};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>,
                                    std::integral_constant<int, 5>>;
TYPED_TEST_SUITE(Cone, Dimensions);

TYPED_TEST(Cone, ScalingTakesBothPointsToTheSamePoint) {
  constexpr int D = TestFixture::dimension;
  for (const double deep_x : depths)
    for (const double deep_z : depths)
      for (int repetition = 0; repetition < 20; ++repetition) {
        const Vector<D> x = this->interior(deep_x), z = this->interior(deep_z);
        const NesterovToddScaling<D> scaling(point<D>(x), point<D>(z));
        // The determinants of x and z carry a relative error of rounding / depth each.
        const double tolerance = rounding * (1 / deep_x + 1 / deep_z);
        const Vector<D> lambda = vector(scaling.lambda());
        EXPECT_LE((matrix(scaling) * lambda - x).norm(), tolerance * x.norm());
        EXPECT_LE((dense::inverse(matrix(scaling)) * lambda - z).norm(),
                  tolerance * z.norm() / deep_x);
        EXPECT_LE((vector(scaling.times(point<D>(z))) - matrix(scaling) * z).norm(),
                  rounding * matrix(scaling).norm() * z.norm());
        EXPECT_NEAR(lambda.squaredNorm(), x.dot(z), tolerance * x.norm() * z.norm());
        EXPECT_NEAR(determinant(scaling.lambda()) /
                        std::sqrt(determinant(point<D>(x)) * determinant(point<D>(z))),
                    1, tolerance / std::min(deep_x, deep_z));
        EXPECT_TRUE(inside<D>(lambda));
      }
}

TYPED_TEST(Cone, ScalingIsSymmetricPositiveDefinite) {
  constexpr int D = TestFixture::dimension;
  for (int repetition = 0; repetition < 20; ++repetition) {
    const NesterovToddScaling<D> scaling(point<D>(this->interior(0.1)),
                                         point<D>(this->interior(1e-4)));
    const Eigen::Matrix<double, D, D> w = matrix(scaling);
    EXPECT_LE((w - w.transpose()).norm(), rounding * w.norm());
    EXPECT_GT(dense::eigenvalues(w)[0], 0);
  }
}

TYPED_TEST(Cone, JordanProductHasItsIdentityAndCommutes) {
  constexpr int D = TestFixture::dimension;
  const Vector<D> x = this->anywhere(), y = this->anywhere();
  const Vector<D> identity = Vector<D>::Unit(0);
  EXPECT_LE((jordan<D>(identity, x) - x).norm(), rounding);
  EXPECT_LE((jordan<D>(x, y) - jordan<D>(y, x)).norm(), rounding);
  // x o x - 2 x_0 x + det(x) e = 0: every element is a root of its characteristic polynomial.
  EXPECT_LE((jordan<D>(x, x) - 2 * x[0] * x + determinant(point<D>(x)) * identity).norm(),
            rounding * 10);
}

TYPED_TEST(Cone, JordanDivisionInvertsTheProduct) {
  constexpr int D = TestFixture::dimension;
  for (const double depth : depths) {
    const NesterovToddScaling<D> scaling(point<D>(this->interior(depth)),
                                         point<D>(this->interior(depth)));
    const Vector<D> right_side = this->anywhere();
    const Vector<D> quotient = vector(scaling.jordan_divide(point<D>(right_side)));
    const Vector<D> lambda = vector(scaling.lambda());
    EXPECT_LE((jordan<D>(lambda, quotient) - right_side).norm(),
              rounding * (right_side.norm() + lambda.norm() * quotient.norm()) / depth);
  }
}

TYPED_TEST(Cone, StepEndsOnTheBoundary) {
  constexpr int D = TestFixture::dimension;
  int bounded = 0;
  for (const double depth : depths)
    for (int repetition = 0; repetition < 50; ++repetition) {
      const NesterovToddScaling<D> scaling(point<D>(this->interior(depth)),
                                           point<D>(this->interior(depth)));
      const Vector<D> lambda = vector(scaling.lambda());
      const Vector<D> direction = this->anywhere();
      const double inverse = scaling.inverse_step_length(point<D>(direction));
      if (inverse <= 0) {
        EXPECT_TRUE(inside<D>(lambda + 1e6 * direction));
        continue;
      }
      ++bounded;
      EXPECT_TRUE(inside<D>(lambda + 0.999 / inverse * direction));
      EXPECT_FALSE(inside<D>(lambda + 1.001 / inverse * direction));
    }
  EXPECT_GT(bounded, 50);
}

TYPED_TEST(Cone, StepAlongTheConeIsUnbounded) {
  constexpr int D = TestFixture::dimension;
  const NesterovToddScaling<D> scaling(point<D>(this->interior(0.3)),
                                       point<D>(this->interior(0.01)));
  EXPECT_LE(scaling.inverse_step_length(point<D>(this->interior(0.5))), 0);
  EXPECT_GT(scaling.inverse_step_length(point<D>(-this->interior(0.5))), 0);
}

TYPED_TEST(Cone, VectorisedOperationsEqualScalarOnesBitwise) {
  constexpr int D = TestFixture::dimension;
  ConePoint<D, Pack> x, z;
  std::array<ConePoint<D>, lanes<>> each_x, each_z;
  for (std::size_t lane = 0; lane < lanes<>; ++lane) {
    each_x[lane] = point<D>(this->interior(depths[lane]));
    each_z[lane] = point<D>(this->interior(depths[lanes<> - 1 - lane]));
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = Pack::Lanes{each_x[0][i], each_x[1][i], each_x[2][i], each_x[3][i]};
    z[i] = Pack::Lanes{each_z[0][i], each_z[1][i], each_z[2][i], each_z[3][i]};
  }
  const NesterovToddScaling<D, Pack> scaling(x, z);
  for (int lane = 0; lane < lanes<>; ++lane) {
    const auto at = static_cast<std::size_t>(lane);
    const NesterovToddScaling<D> alone(each_x[at], each_z[at]);
    EXPECT_EQ(scaling.inverse_step_length(z)[lane], alone.inverse_step_length(each_z[at]));
    for (std::size_t i = 0; i < x.size(); ++i) {
      EXPECT_EQ(scaling.lambda()[i][lane], alone.lambda()[i]);
      EXPECT_EQ(scaling.times(x)[i][lane], alone.times(each_x[at])[i]);
      EXPECT_EQ(scaling.jordan_divide(x)[i][lane], alone.jordan_divide(each_x[at])[i]);
    }
  }
}

TEST(ConeDeterminant, KeepsItsDigitsNearTheBoundary) {
  // x = (5 + 2^-40, 3, 4): det = 2^-40 (10 + 2^-40), where x_0^2 loses all significant digits.
  const double little = std::ldexp(1.0, -40);
  const ConePoint<3> x{5 + little, 3, 4};
  EXPECT_NEAR(determinant(x) / (little * (10 + little)), 1, 1e-15);
}

}  // namespace
}  // namespace kusabi::conic
