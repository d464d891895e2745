// The family of space trusses, and problem files written by the program.
#include "problems/families/space_truss.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/files/structure_file.hpp"
#include "problems/files/toml/structure_writer.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

// Compares all data except names, and frames up to rounding.
void expect_alike(const Structure& a, const Structure& b) {
  EXPECT_EQ(a.dimension, b.dimension);
  EXPECT_EQ(a.coordinates, b.coordinates);
  ASSERT_EQ(a.members.size(), b.members.size());
  for (std::size_t i = 0; i < a.members.size(); ++i) {
    EXPECT_EQ(a.members[i].first, b.members[i].first);
    EXPECT_EQ(a.members[i].second, b.members[i].second);
    EXPECT_EQ(a.members[i].axial_stiffness, b.members[i].axial_stiffness);
  }
  EXPECT_EQ(a.fixed, b.fixed);
  ASSERT_EQ(a.contact.size(), b.contact.size());
  for (std::size_t i = 0; i < a.contact.size(); ++i) {
    EXPECT_EQ(a.contact[i].node, b.contact[i].node);
    EXPECT_EQ(a.contact[i].friction, b.contact[i].friction);
    EXPECT_LT((a.contact[i].normal - b.contact[i].normal).norm(), 1e-15);
    ASSERT_EQ(a.contact[i].tangent.has_value(), b.contact[i].tangent.has_value());
    if (a.contact[i].tangent) {
      EXPECT_LT((*a.contact[i].tangent - *b.contact[i].tangent).norm(), 1e-15);
    }
  }
}

TEST(SpaceTruss, OfDefaultSizeIsTheExample) {
  expect_alike(space_truss({}), load_structure(test::source_path("examples/space-truss.toml")));
}

TEST(SpaceTruss, OfAnySizeIsNoMechanism) {
  for (const int rows : {2, 3, 6}) {
    for (const int depth : {2, 3, 5}) {
      for (int bays = 1; bays <= rows; ++bays) {
        const auto truss = space_truss({rows, depth, bays});
        const auto problem = wedged_problem(checked(truss));  // throws if it is a mechanism
        EXPECT_EQ(problem.contact_names.size(), static_cast<std::size_t>(rows * depth));
      }
    }
  }
}

TEST(SpaceTruss, OfAnImpossibleSizeIsRefused) {
  EXPECT_THROW(space_truss({1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(space_truss({2, 1, 3}), std::invalid_argument);
  EXPECT_THROW(space_truss({2, 2, 0}), std::invalid_argument);
  EXPECT_THROW(space_truss({4, 2, 5}), std::invalid_argument);
  EXPECT_THROW(space_truss({2049, 2, 3}), std::invalid_argument);
  EXPECT_THROW(space_truss({1'000'000'000, 5, 3}), std::invalid_argument);
}

TEST(StructureText, IsReadBackToTheLastBit) {
  for (const auto& size : {SpaceTrussSize{}, SpaceTrussSize{2, 2, 1}, SpaceTrussSize{7, 3, 2}}) {
    const auto truss = space_truss(size);
    const Structure copy = read_structure(structure_text(truss), "copy");
    EXPECT_EQ(copy.name, truss.name);
    EXPECT_EQ(copy.node_names, truss.node_names);
    expect_alike(copy, truss);
  }
}

TEST(StructureText, KeepsNamesUnitsRollersAndGroups) {
  const Structure structure = read_structure(R"(
name = "a \"quoted\" name, \\ and 'more'"
dimension = 2
units = { length = "µm", force = "k\"N" }
[nodes]
"north pier" = [0.1, 0]
"ß" = [1e-7, 1]
plain = [1, 0.30000000000000004]
tip = [3, 1]
[[members]]
EA = 1.5
between = [["north pier", "plain"], ["ß", "plain"]]
[[members]]
EA = 3
between = [["plain", "tip"], ["ß", "tip"], ["north pier", "ß"]]
[[supports]]
nodes = ["north pier"]
[[supports]]
nodes = ["ß"]
fixed = ["x"]
[[contact]]
nodes = ["plain"]
normal = [-1, 2]
[[contact]]
nodes = ["tip"]
normal = [0, 1]
tangent = [1, 0.5]
friction_factor = 0.1
)",
                                             "original");
  const Structure copy = read_structure(structure_text(structure), "copy");
  EXPECT_EQ(copy.name, structure.name);
  EXPECT_EQ(copy.units.length, structure.units.length);
  EXPECT_EQ(copy.units.force, structure.units.force);
  EXPECT_EQ(copy.node_names, structure.node_names);
  expect_alike(copy, structure);
}

}  // namespace
}  // namespace kusabi::problems
