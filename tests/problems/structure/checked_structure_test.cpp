// CheckedStructure: refusals of the rules, and facts that are derived once and shared.
#include "problems/structure/checks/checked_structure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_error.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

TEST(CheckedStructure, RefusesAStructureThatViolatesARule) {
  Structure structure = test::two_bars();
  structure.members.clear();
  EXPECT_THROW(checked(structure), support::InputError);
}

TEST(CheckedStructure, SharesDerivedDataWithItsCopies) {
  const CheckedStructure structure = checked(test::two_bars());
  const CheckedStructure copy = structure;
  EXPECT_EQ(&*copy, &*structure);
  EXPECT_EQ(&copy.degrees(), &structure.degrees());
  EXPECT_EQ(&copy.unconstrained_bodies(), &structure.unconstrained_bodies());
  EXPECT_EQ(&*in_chosen_case(structure, ""), &*structure);
}

TEST(CheckedStructure, HasTheDegreesOfFreedomAndBodiesOfItsStructure) {
  Structure bar = test::empty_structure(2);
  test::add_node(bar, Eigen::Vector2d(0, 0));
  test::add_node(bar, Eigen::Vector2d(1, 0));
  bar.members.push_back({0, 1, 1.0});
  const auto structure = checked(bar);
  EXPECT_EQ(structure.degrees().number, free_degrees(bar).number);
  ASSERT_EQ(structure.unconstrained_bodies().size(), 1U);
  EXPECT_EQ(structure.unconstrained_bodies().front().nodes, (std::vector<int>{0, 1}));
}

TEST(CheckedStructure, HasTheLoadsOfAChosenLoadCase) {
  Structure structure = test::two_bars();
  structure.loads = {{Load::Kind::dead, 2, Eigen::Vector2d(1, 0), "snow"},
                     {Load::Kind::dead, 2, Eigen::Vector2d(0, 1), "gust"}};
  const auto both = checked(structure);
  EXPECT_EQ(in_chosen_case(both, "snow")->loads.size(), 1U);
  EXPECT_THROW(in_chosen_case(both, "wind"), support::InputError);
}

}  // namespace
}  // namespace kusabi::problems
