// The example files contain the structures of tests/reference, node by node and member by member.
#include <algorithm>
#include <fstream>
#include <set>
#include <span>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "problems/files/structure_file.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

using Json = nlohmann::json;

/// The reference frames are typed with sixteen digits and normalised again on reading.
constexpr double frame_tolerance = 1e-14;

Json reference(const std::string& name) {
  std::ifstream stream(test::source_path("tests/reference/" + name));
  return Json::parse(stream);
}

Structure example(const std::string& name) {
  return load_structure(test::source_path("examples/" + name));
}

void expect_same_structure(const Structure& structure, const Json& expected) {
  const auto& nodes = expected.at("nodes");
  ASSERT_EQ(structure.node_names.size(), nodes.size());
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    for (int axis = 0; axis < structure.dimension; ++axis) {
      EXPECT_EQ(structure.coordinates(axis, static_cast<Eigen::Index>(node)),
                nodes.at(node).at(static_cast<std::size_t>(axis)).get<double>())
          << structure.node_names[node];
    }
  }
  std::multiset<std::pair<int, int>> members;
  for (const Member& member : structure.members) {
    members.insert(std::minmax(member.first, member.second));
    EXPECT_EQ(member.axial_stiffness, 1.0);
  }
  EXPECT_EQ(members, (expected.at("members").get<std::multiset<std::pair<int, int>>>()));
  std::set<int> supported;
  for (std::size_t node = 0; node < structure.fixed.size(); ++node) {
    const auto axes =
        std::span(structure.fixed[node]).first(static_cast<std::size_t>(structure.dimension));
    const auto fixed = std::ranges::count(axes, true);
    EXPECT_TRUE(fixed == 0 || fixed == structure.dimension);
    if (fixed > 0) supported.insert(static_cast<int>(node));
  }
  EXPECT_EQ(supported, expected.at("supported").get<std::set<int>>());
  std::vector<int> contact;
  for (const ContactCandidate& candidate : structure.contact) contact.push_back(candidate.node);
  EXPECT_EQ(contact, expected.at("contact").get<std::vector<int>>());
}

/// Every frame has the columns `expected`.
void expect_frames(const Structure& structure, const std::vector<std::vector<double>>& expected) {
  for (const Eigen::MatrixXd& frame : wedged_problem(checked(structure)).frames) {
    for (Eigen::Index column = 0; column < frame.cols(); ++column) {
      const auto& vector = expected.at(static_cast<std::size_t>(column));
      const Eigen::Map<const Eigen::VectorXd> map(vector.data(), structure.dimension);
      EXPECT_LT((frame.col(column) - map).norm(), frame_tolerance);
    }
  }
}

TEST(Examples, SpaceTrussIsTheReferenceTruss) {
  const Json expected = reference("space-truss.json");
  const Structure structure = example("space-truss.toml");
  expect_same_structure(structure, expected);
  const Json& frame = expected.at("frame");
  expect_frames(structure, {frame.at("n"), frame.at("t1"), frame.at("t2")});
}

TEST(Examples, SpaceTrussNamesItsNodesByPlaneRowAndColumn) {
  const Structure structure = example("space-truss.toml");
  for (std::size_t node = 0; node < structure.node_names.size(); ++node) {
    const Eigen::Vector3d place = structure.coordinates.col(static_cast<Eigen::Index>(node));
    const char plane = place.z() == 0.0 ? 'b' : 't';
    const auto row = static_cast<int>(place.y() / 2.5) + 1;
    const char column = structure.node_names[node].back();
    EXPECT_EQ(structure.node_names[node], plane + std::to_string(row) + column);
    EXPECT_EQ(place.x() == 0.0, column == '0');
    EXPECT_EQ(place.x() >= 10.0, column == '3');
  }
}

TEST(Examples, PlaneTrussIsTheReferenceTruss) {
  const Json expected = reference("plane-truss.json").at("five");
  const Structure structure = example("plane-truss.toml");
  expect_same_structure(structure, expected);
  expect_frames(structure, expected.at("frame"));
}

}  // namespace
}  // namespace kusabi::problems
