// Four-node elements: patch tests, hand calculations, meshes in files.
#include <string>

#include <Eigen/SparseCholesky>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dense.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/files/toml/structure_writer.hpp"
#include "problems/structure/assembly/solid_element.hpp"
#include "problems/structure/bodies/mechanism.hpp"
#include "problems/structure/checks/structure_check.hpp"
#include "problems/wedged/precise_compliance.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

/// One element of any shape, with no supports.
Structure one_element(const Eigen::Matrix<double, 2, 4>& vertices, PlaneState state) {
  Structure structure = test::empty_structure(2);
  for (int vertex = 0; vertex < 4; ++vertex) test::add_node(structure, vertices.col(vertex));
  structure.elements = {{{0, 1, 2, 3}, 200.0, 0.3, 0.5, state}};
  return structure;
}

const Eigen::Matrix<double, 2, 4> skew =
    (Eigen::Matrix<double, 2, 4>() << 0, 2, 2.5, -0.3, 0, 0.4, 1.9, 1.2).finished();

Eigen::MatrixXd stiffness_of(const Structure& structure) {
  return element_stiffness(structure, free_degrees(structure));
}

TEST(Element, IsStrainedByAllButThreeRigidBodyModes) {
  for (const auto state : {PlaneState::stress, PlaneState::strain}) {
    const auto structure = one_element(skew, state);
    const Eigen::MatrixXd stiffness = stiffness_of(structure);
    EXPECT_EQ(stiffness, stiffness.transpose());
    Eigen::MatrixXd rigid(8, 3);
    for (int node = 0; node < 4; ++node) {
      rigid.middleRows(2 * node, 2) << 1, 0, -skew(1, node), 0, 1, skew(0, node);
    }
    EXPECT_LT((stiffness * rigid).cwiseAbs().maxCoeff(), 1e-12 * stiffness.maxCoeff());
    const auto values = dense::eigenvalues(stiffness);
    EXPECT_GT(values(3), 1e-3 * values(7));
  }
}

// Patch test: a displacement linear in the position has one strain e everywhere, and the energy e^T
// D e t A / 2, for any shape of the element.
TEST(Element, HasTheEnergyOfAUniformStrain) {
  const Eigen::Vector3d strain(0.3, -0.2, 0.5);  // xx, yy, and the shear angle xy
  Eigen::VectorXd motion(8);
  for (int node = 0; node < 4; ++node) {
    motion(2 * node) = strain(0) * skew(0, node) + strain(2) * skew(1, node);
    motion(2 * node + 1) = strain(1) * skew(1, node);
  }
  double area = 0;  // the shoelace formula
  for (int node = 0; node < 4; ++node) {
    const int next = (node + 1) % 4;
    area += (skew(0, node) * skew(1, next) - skew(0, next) * skew(1, node)) / 2;
  }
  // The inverse of Hooke's law: e = C s, with s_zz = 0 (stress) or e_zz = 0 (strain).
  const double modulus = 200;
  const double ratio = 0.3;
  Eigen::Matrix3d thin;
  thin << 1, -ratio, 0, -ratio, 1, 0, 0, 0, 2 * (1 + ratio);
  Eigen::Matrix3d thick = thin;
  thick.topLeftCorner<2, 2>().array() -= ratio * ratio;
  for (const auto& [state, law] :
       {std::pair(PlaneState::stress, thin), std::pair(PlaneState::strain, thick)}) {
    const Eigen::Matrix3d elasticity = dense::inverse(law / modulus);
    const double energy = strain.dot(elasticity * strain) * 0.5 * area / 2;
    const Eigen::MatrixXd stiffness = stiffness_of(one_element(skew, state));
    EXPECT_NEAR(motion.dot(stiffness * motion) / 2, energy, 1e-12 * energy);
  }
}

TEST(Element, MayBeNumberedInEitherSense) {
  Eigen::Matrix<double, 2, 4> turned = skew;
  turned.col(1).swap(turned.col(3));
  const Eigen::MatrixXd there = stiffness_of(one_element(skew, PlaneState::stress));
  const Eigen::MatrixXd back = stiffness_of(one_element(turned, PlaneState::stress));
  const std::vector<int> order{0, 1, 6, 7, 4, 5, 2, 3};
  EXPECT_LT((there - back(order, order)).cwiseAbs().maxCoeff(), 1e-12 * there.maxCoeff());
}

// A bar of unit width under tension: u = P L / (E A), and its width decreases by nu.
TEST(Element, StretchesABarByTheTextbookAmount) {
  const auto structure = read_structure(R"(
name = "bar"
dimension = 2
units = { length = "m", force = "kN" }
[[mesh]]
name = "bar"
corners = [[0, 0], [4, 0], [4, 1], [0, 1]]
divisions = [7, 3]
E = 50
nu = 0.25
thickness = 0.2
plane = "stress"
[[supports]]
nodes = ["bar.0,1", "bar.0,2", "bar.0,3"]
fixed = ["x"]
[[supports]]
nodes = ["bar.0,0"]
[[contact]]
nodes = ["bar.right"]
normal = [-1, 0]
)",
                                        "bar");
  const auto problem = wedged_problem(structure);
  EXPECT_EQ(problem.provenance.elements, 21);
  EXPECT_EQ(problem.provenance.members, 0);
  EXPECT_THAT(problem.contact_names,
              testing::ElementsAre("bar.7,0", "bar.7,1", "bar.7,2", "bar.7,3"));
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(8);  // 1 kN, spread evenly; n points to the left
  for (const auto& [node, share] : {std::pair(0, 0.5), {1, 1.0}, {2, 1.0}, {3, 0.5}}) {
    pull(2 * node) = -share / 3;
  }
  const Eigen::VectorXd displacement = problem.compliance.matrix * pull;
  const double stretch = 4 / (50 * 0.2);
  for (int node = 0; node < 4; ++node) {
    EXPECT_NEAR(-displacement(2 * node), stretch, 1e-12);
    EXPECT_NEAR(std::abs(displacement(2 * node + 1)), 0.25 * stretch / 4 * node / 3, 1e-12);
  }
}

TEST(Mesh, IsJoinedToMeshesThatItTouches) {
  const auto text = [](const char* second) {
    return std::string(R"(
name = "two blocks and a bar"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
wall = [-1, 0]
corner = [0, 0]
[[mesh]]
name = "a"
corners = [[0, 0], [1, 0], [1, 1], [0, 1]]
divisions = [2, 2]
E = 1
nu = 0.25
thickness = 1
plane = "strain"
[[mesh]]
name = "b"
corners = )") +
           second + R"(
divisions = [3, 2]
E = 2
nu = 0.25
thickness = 1
plane = "strain"
[[members]]
EA = 1
between = [["wall", "corner"]]
[[supports]]
nodes = ["wall", "a.top"]
[[contact]]
nodes = ["b.right"]
normal = [-1, 0]
)";
  };
  const Structure joined = read_structure(text("[[1, 0], [2, 0], [2, 1], [1, 1]]"), "joined");
  // 9 of the first, one of which is the common vertex; 3 of the second's 12 lie on the first.
  EXPECT_EQ(joined.node_names.size(), 1U + 9 + 9);
  EXPECT_EQ(joined.elements.size(), 4U + 6);
  EXPECT_NO_THROW(wedged_problem(checked(joined)));
  const auto apart = read_structure(text("[[1.1, 0], [2, 0], [2, 1], [1.1, 1]]"), "apart");
  EXPECT_EQ(wedged_problem(apart).modes.bodies.size(),
            1U);  // the second block is disconnected
}

TEST(Mesh, IsWrittenAsElementsAndReadBack) {
  const Structure body = load_structure(test::source_path("examples/elastic-body.toml"));
  const Structure copy = read_structure(structure_text(body), "copy");
  EXPECT_EQ(copy.node_names, body.node_names);
  EXPECT_EQ(copy.coordinates, body.coordinates);
  EXPECT_EQ(copy.fixed, body.fixed);
  const auto own = wedged_problem(checked(body));
  EXPECT_EQ(wedged_problem(checked(copy)).provenance.fingerprint, own.provenance.fingerprint);
  auto stiffer = body;
  stiffer.elements[7].modulus *= 1 + 1e-9;
  EXPECT_NE(wedged_problem(checked(stiffer)).provenance.fingerprint, own.provenance.fingerprint);
  auto thick = body;
  thick.elements[7].state = PlaneState::strain;
  EXPECT_NE(wedged_problem(checked(thick)).provenance.fingerprint, own.provenance.fingerprint);
}

TEST(Mechanism, OfAnUnconstrainedBodyIsFound) {
  Structure body = load_structure(test::source_path("examples/elastic-body.toml"));
  for (auto& axes : body.fixed) axes[1] = false;  // free to slide up and down
  EXPECT_EQ(moving_nodes(body, free_degrees(body)).size(), body.node_names.size());
}

TEST(PreciseCompliance, IsTheComplianceWithMoreDigits) {
  std::mt19937 bits(2);
  for (const auto& structure : {load_structure(test::source_path("examples/elastic-body.toml")),
                                load_structure(test::source_path("examples/space-truss.toml")),
                                checked(test::random_wedge(2, 9, bits))}) {
    const auto problem = wedged_problem(structure);
    const auto precise = precise_compliance(problem);
    EXPECT_EQ(precise, precise.transpose());
    EXPECT_LT((precise.cast<double>() - problem.compliance.matrix).cwiseAbs().maxCoeff(),
              1e-13 * problem.compliance.matrix.maxCoeff());
  }
}

}  // namespace
}  // namespace kusabi::problems
