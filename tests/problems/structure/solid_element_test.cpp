// Elements of every shape: rigid-body modes, patch tests, symmetries of the numbering, bending.
#include "problems/structure/assembly/solid_element.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "dense.hpp"
#include "patches.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/files/toml/structure_writer.hpp"
#include "problems/structure/bodies/mechanism.hpp"
#include "problems/structure/checks/element_check.hpp"

namespace kusabi::problems {
namespace {

class SolidElement : public testing::TestWithParam<ElementShape> {
 protected:
  std::mt19937 bits{7};
};

INSTANTIATE_TEST_SUITE_P(Each, SolidElement, testing::ValuesIn(test::all_shapes),
                         [](const auto& each) { return test::name_of(each.param); });

using QuadraticElement = SolidElement;

INSTANTIATE_TEST_SUITE_P(Each, QuadraticElement,
                         testing::ValuesIn(test::shapes_if(test::is_quadratic)),
                         [](const auto& each) { return test::name_of(each.param); });

/// Displacement of all nodes, from a function of places.
Eigen::VectorXd motion_of(const Structure& body,
                          const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& field) {
  Eigen::MatrixXd motion(body.dimension, body.coordinates.cols());
  for (Eigen::Index node = 0; node < motion.cols(); ++node)
    motion.col(node) = field(body.coordinates.col(node));
  return motion.reshaped();
}

/// d x (number of nodes) columns: all rigid-body modes.
Eigen::MatrixXd rigid_motions(const Structure& body) {
  const Eigen::Index d = body.dimension;
  Eigen::MatrixXd motions(body.coordinates.size(), d * (d + 1) / 2);
  Eigen::Index column = 0;
  for (Eigen::Index k = 0; k < d; ++k) {
    motions.col(column++) =
        motion_of(body, [&](const auto&) { return Eigen::VectorXd(Eigen::VectorXd::Unit(d, k)); });
    for (Eigen::Index l = 0; l < k; ++l) {
      motions.col(column++) = motion_of(body, [&](const Eigen::VectorXd& x) {
        return Eigen::VectorXd(x(l) * Eigen::VectorXd::Unit(d, k) -
                               x(k) * Eigen::VectorXd::Unit(d, l));
      });
    }
  }
  return motions;
}

Eigen::MatrixXd stiffness_of_body(const Structure& body) {
  return element_stiffness(body, free_degrees(body));
}

TEST_P(SolidElement, IsStrainedByAllButRigidBodyModes) {
  for (const double moved : {0.0, 0.25}) {
    for (const auto state : {PlaneState::stress, PlaneState::strain}) {
      auto body = test::one_element(GetParam(), moved, bits);
      body.elements[0].state = state;
      const Eigen::MatrixXd stiffness = stiffness_of_body(body);
      EXPECT_EQ(stiffness, stiffness.transpose());
      const auto rigid = rigid_motions(body);
      EXPECT_LT((stiffness * rigid).cwiseAbs().maxCoeff(), 1e-12 * stiffness.maxCoeff());
      const auto values = dense::eigenvalues(stiffness);
      EXPECT_GT(values(rigid.cols()), 1e-4 * values.maxCoeff());
    }
  }
}

/// Hooke's law in inverse form: strain of a stress, with s_zz = 0 or e_zz = 0 in the plane. Twice
/// the energy of a uniform strain (d x d, symmetric) per volume.
double twice_energy(const Element& material, const Eigen::MatrixXd& strain) {
  const Eigen::Index d = strain.rows();
  const bool thick = d == 2 && material.state == PlaneState::strain;
  const double ratio = material.ratio;
  Eigen::MatrixXd law = (1 + ratio) * Eigen::MatrixXd::Identity(d, d) -
                        ratio * (thick ? 1 + ratio : 1) * Eigen::MatrixXd::Ones(d, d);
  const Eigen::VectorXd normal = dense::inverse(law) * strain.diagonal() * material.modulus;
  double energy = normal.dot(strain.diagonal());
  const double shear = material.modulus / (1 + ratio);  // 2 G
  for (Eigen::Index k = 0; k < d; ++k) {
    for (Eigen::Index l = 0; l < k; ++l) energy += 2 * shear * strain(k, l) * strain(k, l);
  }
  return energy;
}

// A displacement linear in the position has one strain everywhere, hence the energy of the whole
// square or cube, and no forces on the interior nodes, for any shapes of the elements.
TEST_P(SolidElement, PassesThePatchTest) {
  for (const auto state : {PlaneState::stress, PlaneState::strain}) {
    auto body = test::patch(GetParam(), 0.25, bits);
    for (auto& element : body.elements) element.state = state;
    const Eigen::Index d = body.dimension;
    Eigen::MatrixXd gradient(d, d);
    for (double& entry : gradient.reshaped()) entry = static_cast<double>(bits()) * 0x1p-32 - 0.4;
    const auto motion =
        motion_of(body, [&](const Eigen::VectorXd& x) { return Eigen::VectorXd(gradient * x); });
    const Eigen::VectorXd forces = element_stiffness(body, free_degrees(body)) * motion;
    const Eigen::MatrixXd strain = (gradient + gradient.transpose()) / 2;
    const double volume = d == 2 ? 0.5 : 1;
    const double energy = volume * twice_energy(body.elements[0], strain);
    EXPECT_NEAR(motion.dot(forces), energy, 1e-12 * energy);
    int within = 0;
    for (int node = 0; node < body.coordinates.cols(); ++node) {
      if (test::on_surface(body, node)) continue;
      ++within;
      EXPECT_LT(forces.segment(d * node, d).norm(), 1e-12 * forces.norm());
    }
    EXPECT_GE(within, 4);
  }
}

// Pure bending, u = x y, v = -x^2 / 2 with nu = 0: quadratic elements represent it exactly.
TEST_P(QuadraticElement, BendsAsABeam) {
  auto body = test::patch(GetParam(), 0, bits);
  for (auto& element : body.elements) element.ratio = 0;
  const auto motion = motion_of(body, [](const Eigen::VectorXd& x) {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(x.size());
    u(0) = x(0) * x(1);
    u(1) = -x(0) * x(0) / 2;
    return u;
  });
  const Eigen::VectorXd forces = element_stiffness(body, free_degrees(body)) * motion;
  const double thickness = body.dimension == 2 ? 0.5 : 1;
  EXPECT_NEAR(motion.dot(forces), thickness * 200.0 / 3, 1e-11);  // E t times the integral of y^2
  for (int node = 0; node < body.coordinates.cols(); ++node) {
    if (test::on_surface(body, node)) continue;
    EXPECT_LT(forces.segment(body.dimension * node, body.dimension).norm(), 1e-12 * forces.norm());
  }
}

/// Permutations of the vertices that do not change the element; they generate all others.
std::vector<std::vector<int>> turns_of(ElementShape shape) {
  switch (test::corners_of(shape)) {
    case 3:
      return {{1, 2, 0}, {0, 2, 1}};  // the second reverses the orientation
    case 5:
      return {{1, 2, 3, 0, 4}, {0, 3, 2, 1, 4}};
    case 6:
      return {{1, 2, 0, 4, 5, 3}, {0, 2, 1, 3, 5, 4}, {3, 4, 5, 0, 1, 2}};
    case 8:
      return {{1, 2, 3, 0, 5, 6, 7, 4}, {4, 5, 1, 0, 7, 6, 2, 3}, {4, 5, 6, 7, 0, 1, 2, 3}};
    default:
      if (test::dimension_of(shape) == 2) return {{1, 2, 3, 0}, {0, 3, 2, 1}};
      return {{1, 2, 0, 3}, {0, 2, 3, 1}, {1, 0, 2, 3}};
  }
}

TEST_P(SolidElement, MayBeNumberedFromAnyVertexInEitherSense) {
  const auto body = test::one_element(GetParam(), 0.25, bits);
  const Eigen::MatrixXd stiffness = stiffness_of_body(body);
  const auto& edges = test::edges_of(GetParam());
  for (const auto& turn : turns_of(GetParam())) {
    auto turned = body;
    auto& nodes = turned.elements[0].nodes;
    for (std::size_t vertex = 0; vertex < turn.size(); ++vertex)
      nodes[vertex] = body.elements[0].nodes[static_cast<std::size_t>(turn[vertex])];
    for (std::size_t edge = 0; edge < edges.size(); ++edge) {
      const int a = turn[static_cast<std::size_t>(edges[edge][0])];
      const int b = turn[static_cast<std::size_t>(edges[edge][1])];
      const auto old = std::ranges::find_if(edges, [&](const auto& each) {
        return each == std::array{a, b} || each == std::array{b, a};
      });
      ASSERT_NE(old, edges.end());
      nodes[turn.size() + edge] =
          body.elements[0].nodes[turn.size() + static_cast<std::size_t>(old - edges.begin())];
    }
    EXPECT_NO_THROW(check_elements(turned));
    EXPECT_LT((stiffness_of_body(turned) - stiffness).cwiseAbs().maxCoeff(),
              1e-12 * stiffness.maxCoeff());
  }
}

TEST_P(SolidElement, StiffnessIsTheSumOfSquaresOfShapeVectors) {
  auto body = test::one_element(GetParam(), 0.25, bits);
  const auto degrees = free_degrees(body);
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& vector : shape_vectors(body, degrees, body.elements[0]))
    add_square(vector, 1.0, entries);
  Eigen::SparseMatrix<double> squares(degrees.size(), degrees.size());
  squares.setFromTriplets(entries.begin(), entries.end());
  auto& element = body.elements[0];
  element.modulus = element.thickness = 1;
  element.ratio = 0;
  const double scale = body.dimension == 2 ? 1 : element_extent(body, element);
  const Eigen::MatrixXd stiffness = stiffness_of_body(body) / scale;
  EXPECT_LT((Eigen::MatrixXd(squares) - stiffness).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_LT((shape_matrix(body, element) - stiffness).cwiseAbs().maxCoeff(), 1e-13);
}

TEST_P(SolidElement, IsNoMechanismIfConstrained) {
  auto body = test::patch(GetParam(), 0.25, bits);
  EXPECT_EQ(moving_nodes(body, free_degrees(body)).size(), body.node_names.size());
  for (int node = 0; node < body.coordinates.cols(); ++node) {
    const bool held = body.coordinates(0, node) < 1e-9;
    body.fixed[static_cast<std::size_t>(node)] = {held, held, held && body.dimension == 3};
  }
  EXPECT_TRUE(moving_nodes(body, free_degrees(body)).empty());
}

TEST_P(SolidElement, IsWrittenAndReadBack) {
  auto body = test::patch(GetParam(), 0.25, bits);
  body.name = "patch";
  body.units = {"m", "kN"};
  body.fixed[0] = {true, true, body.dimension == 3};
  const Structure copy = read_structure(structure_text(body), "copy");
  ASSERT_EQ(copy.elements.size(), body.elements.size());
  for (std::size_t i = 0; i < body.elements.size(); ++i) {
    EXPECT_EQ(copy.elements[i].shape, GetParam());
    EXPECT_EQ(copy.elements[i].nodes, body.elements[i].nodes);
  }
  EXPECT_EQ(stiffness_of_body(copy), stiffness_of_body(body));
}

TEST_P(SolidElement, IsRefusedIfInvertedOrWithAnotherNumberOfNodes) {
  const auto body = test::one_element(GetParam(), 0.25, bits);
  EXPECT_NO_THROW(check_elements(body));
  auto fewer = body;
  fewer.elements[0].nodes.pop_back();
  EXPECT_THROW(check_elements(fewer), support::InputError);
  auto elsewhere = body;
  elsewhere.dimension = 5 - body.dimension;
  EXPECT_THROW(check_elements(elsewhere), support::InputError);
  if (test::corners_of(GetParam()) > body.dimension + 1 || test::is_quadratic(GetParam())) {
    auto crossed = body;
    std::swap(crossed.elements[0].nodes[1], crossed.elements[0].nodes[2]);
    EXPECT_THROW(check_elements(crossed), support::InputError);
  }
}

}  // namespace
}  // namespace kusabi::problems
