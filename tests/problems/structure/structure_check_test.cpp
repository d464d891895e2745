// Rules for structures made by programs. Rules that a file can violate have a malformed file each
// in tests/bad-input; here are the others.
#include "problems/structure/checks/structure_check.hpp"

#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

struct Fault {
  const char* name;
  std::function<void(Structure&)> make;
  const char* message;
};

class InvalidStructure : public testing::TestWithParam<Fault> {};

TEST_P(InvalidStructure, IsRefused) {
  Structure structure = test::two_bars();
  GetParam().make(structure);
  try {
    check_structure(structure);
    FAIL() << "accepted";
  } catch (const support::InputError& error) {
    EXPECT_STREQ(error.what(), GetParam().message);
  }
}

constexpr double infinity = std::numeric_limits<double>::infinity();

INSTANTIATE_TEST_SUITE_P(
    Faults, InvalidStructure,
    testing::Values(
        Fault{"Dimension", [](Structure& s) { s.dimension = 1; },
              "test: dimension is 1; expected 2 or 3"},
        Fault{"Coordinates", [](Structure& s) { s.coordinates.conservativeResize(2, 2); },
              "test: coordinates are 2 x 2; expected 2 x 3"},
        Fault{"Supports", [](Structure& s) { s.fixed.pop_back(); },
              "test: supports are given for 2 nodes; expected all 3"},
        Fault{"Infinity", [](Structure& s) { s.coordinates(0, 1) = infinity; },
              "test: node \"node 1\" has a coordinate out of range; expected at most 1e+50 in "
              "magnitude"},
        Fault{"TooManyCandidates", [](Structure& s) { s.contact.resize(4097, s.contact[0]); },
              "test: 4097 contact candidates; expected at most 4096, since K and F are full "
              "matrices"},
        Fault{"NoNodes", [](Structure& s) { s.node_names.clear(); },
              "test: no nodes; expected at least two"},
        Fault{"NoMembers", [](Structure& s) { s.members.clear(); },
              "test: no members; expected at least one"},
        Fault{"YieldForce",
              [](Structure& s) {
                s.members[0].yield = YieldForces{-1, 1};
              },
              "test: a yield force is -1; expected a magnitude: 0, or between 1e-50 and 1e+50"},
        Fault{"LoadNode",
              [](Structure& s) {
                s.loads.push_back({Load::Kind::dead, 9, Eigen::Vector2d(1, 0)});
              },
              "test: load 0 names a node that does not exist"},
        Fault{"LoadSize",
              [](Structure& s) {
                s.loads.push_back({Load::Kind::dead, 2, Eigen::Vector3d(1, 0, 0)});
              },
              "test: the load at \"node 2\" is not a vector of 2 numbers of at most 1e+50"},
        Fault{"UncertainAxis",
              [](Structure& s) {
                s.uncertain = {UncertainParameter{{}, {{2, 2}}}};
              },
              "test: uncertain component 0 does not exist"},
        Fault{"MemberEnd", [](Structure& s) { s.members[1].second = 3; },
              "test: member 1 names a node that does not exist"},
        Fault{"ContactNode", [](Structure& s) { s.contact[0].node = -1; },
              "test: contact candidate 0 names a node that does not exist"},
        Fault{"AlmostZeroLength",
              [](Structure& s) { s.coordinates.col(2) = Eigen::Vector2d(1, 1 + 1e-11); },
              "test: member from \"node 1\" to \"node 2\" has zero length; expected two nodes at "
              "different places"},
        Fault{"LongNormal", [](Structure& s) { s.contact[0].normal *= 2; },
              "test: the normal at \"node 2\" is not a unit vector; expected 2 components of norm "
              "1"},
        Fault{"NormalInSpace", [](Structure& s) { s.contact[0].normal = Eigen::Vector3d::UnitX(); },
              "test: the normal at \"node 2\" is not a unit vector; expected 2 components of norm "
              "1"},
        Fault{"InfiniteTangent",
              [](Structure& s) { s.contact[0].tangent = Eigen::Vector2d(infinity, 0); },
              "test: the tangent at \"node 2\" is not a vector of 2 finite numbers"}),
    [](const auto& fault) { return fault.param.name; });

TEST(StructureCheck, AcceptsASoundStructure) {
  EXPECT_NO_THROW(check_structure(test::two_bars()));
  EXPECT_NO_THROW(check_structure(test::cantilever(30)));
}

TEST(StructureCheck, AcceptsASupportedNodeWithoutAMember) {
  Structure structure = test::two_bars();
  test::fix(structure, test::add_node(structure, Eigen::Vector2d(5, 5)));
  EXPECT_NO_THROW(check_structure(structure));
}

}  // namespace
}  // namespace kusabi::problems
