// Stresses compared with Hooke's law in its inverse form, and with the forces of the stiffness
// matrix.
#include "problems/structure/assembly/element_stress.hpp"

#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "dense.hpp"
#include "patches.hpp"
#include "problems/structure/assembly/solid_element.hpp"

namespace kusabi::problems {
namespace {

class ElementStress : public testing::TestWithParam<ElementShape> {
 protected:
  std::mt19937 bits{11};

  double random() { return static_cast<double>(bits()) * 0x1p-31 - 1; }
  Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns) {
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [this] { return random(); });
  }
};

INSTANTIATE_TEST_SUITE_P(Each, ElementStress, testing::ValuesIn(test::all_shapes),
                         [](const auto& each) { return test::name_of(each.param); });

using QuadraticElementStress = ElementStress;
using SimplexStress = ElementStress;

INSTANTIATE_TEST_SUITE_P(Each, QuadraticElementStress,
                         testing::ValuesIn(test::shapes_if(test::is_quadratic)),
                         [](const auto& each) { return test::name_of(each.param); });

INSTANTIATE_TEST_SUITE_P(Each, SimplexStress, testing::ValuesIn(test::shapes_if([](auto shape) {
                           return !test::is_quadratic(shape) &&
                                  test::corners_of(shape) == test::dimension_of(shape) + 1;
                         })),
                         [](const auto& each) { return test::name_of(each.param); });

Eigen::Matrix3d tensor_of(const Eigen::VectorXd& stress) {
  Eigen::Matrix3d tensor;
  tensor << stress(0), stress(3), stress(5),  //
      stress(3), stress(1), stress(4),        //
      stress(5), stress(4), stress(2);
  return tensor;
}

// The strain of a stress by Hooke's law must be that of the displacements: in the plane its
// in-plane part, with zero strain in the third direction in plane strain, and zero stress in plane
// stress.
void expect_strain(const Element& element, const Eigen::VectorXd& stress,
                   const Eigen::MatrixXd& gradient) {
  const Eigen::Matrix3d tensor = tensor_of(stress);
  const Eigen::Matrix3d strain = ((1 + element.ratio) * tensor -
                                  element.ratio * tensor.trace() * Eigen::Matrix3d::Identity()) /
                                 element.modulus;
  const Eigen::Index d = gradient.rows();
  const Eigen::MatrixXd wanted = (gradient + gradient.transpose()) / 2;
  EXPECT_LT((strain.topLeftCorner(d, d) - wanted).norm(), 1e-13 * wanted.norm());
  if (d == 3) return;
  EXPECT_EQ(stress(4), 0);
  EXPECT_EQ(stress(5), 0);
  if (element.state == PlaneState::stress) {
    EXPECT_EQ(stress(2), 0);
  } else {
    EXPECT_NEAR(strain(2, 2), 0, 1e-13 * wanted.norm());
  }
}

TEST_P(ElementStress, PassesThePatchTest) {
  for (const auto state : {PlaneState::stress, PlaneState::strain}) {
    auto body = test::patch(GetParam(), 0.25, bits);
    for (auto& element : body.elements) element.state = state;
    const auto gradient = random_matrix(body.dimension, body.dimension);
    const Eigen::MatrixXd motion =
        (gradient * body.coordinates).colwise() + random_matrix(body.dimension, 1).col(0);
    const auto stresses = element_stresses(body, motion);
    ASSERT_EQ(stresses.cols(), static_cast<Eigen::Index>(body.elements.size()));
    for (Eigen::Index i = 0; i < stresses.cols(); ++i) {
      expect_strain(body.elements[static_cast<std::size_t>(i)], stresses.col(i), gradient);
    }
  }
}

// u_k = x^T A_k x: the gradient at the centre, the mean of the vertices, is 2 x^T A_k.
TEST_P(QuadraticElementStress, IsThatAtTheCentre) {
  const auto body = test::patch(GetParam(), 0, bits);
  const int d = body.dimension;
  std::vector<Eigen::MatrixXd> forms;
  for (int k = 0; k < d; ++k) {
    const auto half = random_matrix(d, d);
    forms.emplace_back(half + half.transpose());
  }
  Eigen::MatrixXd motion(d, body.coordinates.cols());
  for (Eigen::Index node = 0; node < motion.cols(); ++node) {
    const Eigen::VectorXd x = body.coordinates.col(node);
    for (int k = 0; k < d; ++k) motion(k, node) = x.dot(forms[static_cast<std::size_t>(k)] * x);
  }
  const auto stresses = element_stresses(body, motion);
  for (std::size_t i = 0; i < body.elements.size(); ++i) {
    Eigen::VectorXd centre = Eigen::VectorXd::Zero(d);
    const int vertices = test::corners_of(GetParam());
    for (int vertex = 0; vertex < vertices; ++vertex) {
      const int node = body.elements[i].nodes[static_cast<std::size_t>(vertex)];
      centre += body.coordinates.col(node) / vertices;
    }
    Eigen::MatrixXd gradient(d, d);
    for (int k = 0; k < d; ++k)
      gradient.row(k) = 2 * (forms[static_cast<std::size_t>(k)] * centre).transpose();
    expect_strain(body.elements[i], stresses.col(static_cast<Eigen::Index>(i)), gradient);
  }
}

// In a simplex without midpoint nodes the stress is constant, with a force V sigma grad N_a on node
// a; all forces together are K u.
TEST_P(SimplexStress, HasTheNodalForcesOfTheStiffness) {
  const int d = test::dimension_of(GetParam());
  auto body = test::patch(GetParam(), 0.25, bits);
  body.elements.front().state = PlaneState::strain;
  const auto motion = random_matrix(d, body.coordinates.cols());
  const auto stresses = element_stresses(body, motion);
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(d, motion.cols());
  for (std::size_t i = 0; i < body.elements.size(); ++i) {
    const auto& element = body.elements[i];
    // N_a = 1 at node a, 0 at the others, linear between: rows of the inverse of [1 x].
    Eigen::MatrixXd places(d + 1, d + 1);
    for (int a = 0; a <= d; ++a)
      places.row(a) << 1,
          body.coordinates.col(element.nodes[static_cast<std::size_t>(a)]).transpose();
    const double volume =
        d == 2 ? std::abs(Eigen::Matrix3d(places).determinant()) / 2 * element.thickness
               : std::abs(Eigen::Matrix4d(places).determinant()) / 6;
    const Eigen::MatrixXd gradients = dense::inverse(places).bottomRows(d);
    const Eigen::MatrixXd stress =
        tensor_of(stresses.col(static_cast<Eigen::Index>(i))).topLeftCorner(d, d);
    for (int a = 0; a <= d; ++a)
      forces.col(element.nodes[static_cast<std::size_t>(a)]) += volume * stress * gradients.col(a);
  }
  const Eigen::VectorXd wanted = element_stiffness(body, free_degrees(body)) * motion.reshaped();
  EXPECT_LT((forces.reshaped() - wanted).norm(), 1e-13 * wanted.norm());
}

TEST(VonMises, AgreesWithThePrincipalStresses) {
  std::mt19937 bits{3};
  Stresses stresses(6, 20);
  for (double& entry : stresses.reshaped()) entry = static_cast<double>(bits()) * 0x1p-31 - 1;
  stresses.col(0) << 4, 4, 4, 0, 0, 0;   // pressure alone
  stresses.col(1) << 0, -3, 0, 0, 0, 0;  // a bar
  const auto equivalent = von_mises(stresses);
  EXPECT_NEAR(equivalent(0), 0, 1e-14);
  EXPECT_NEAR(equivalent(1), 3, 1e-14);
  for (Eigen::Index i = 0; i < stresses.cols(); ++i) {
    const auto principal = dense::eigenvalues(tensor_of(stresses.col(i)));
    const double squares = std::pow(principal(0) - principal(1), 2) +
                           std::pow(principal(1) - principal(2), 2) +
                           std::pow(principal(2) - principal(0), 2);
    EXPECT_NEAR(equivalent(i), std::sqrt(squares / 2), 1e-13);
  }
}

TEST(Utilisations, UseTheStrengthForTheSignOfTheForce) {
  Structure truss;
  truss.members.resize(5, Member{0, 1, 1.0, YieldForces{8, 2}});
  truss.members[3].yield.reset();
  truss.members[4].yield = YieldForces{8, 0};
  const auto used = utilisations(truss, (Eigen::VectorXd(5) << 2, -1, 0, 5, -1).finished());
  EXPECT_EQ(used(0), 0.25);
  EXPECT_EQ(used(1), 0.5);
  EXPECT_EQ(used(2), 0);
  EXPECT_TRUE(std::isnan(used(3)));
  EXPECT_EQ(used(4), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace kusabi::problems
