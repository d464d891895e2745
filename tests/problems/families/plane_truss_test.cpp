// The family of plane trusses.
#include "problems/families/plane_truss.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "problems/files/structure_file.hpp"
#include "problems/files/toml/structure_writer.hpp"
#include "problems/structure/checks/structure_check.hpp"
#include "problems/structure/model/truss.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

TEST(PlaneTruss, OfDefaultSizeIsTheExample) {
  const auto truss = plane_truss({});
  const Structure example = load_structure(test::source_path("examples/plane-truss.toml"));
  // The coordinates of the example are typed with sixteen digits.
  EXPECT_LT((truss.coordinates - example.coordinates).cwiseAbs().maxCoeff(), 1e-14);
  ASSERT_EQ(truss.members.size(), example.members.size());
  const auto pairs = [](const Structure& structure) {
    std::vector<std::pair<int, int>> list;
    for (const Member& bar : structure.members) {
      EXPECT_EQ(bar.axial_stiffness, 1);
      list.push_back(std::minmax(bar.first, bar.second));
    }
    std::sort(list.begin(), list.end());
    return list;
  };
  EXPECT_EQ(pairs(truss), pairs(example));
  EXPECT_EQ(truss.fixed, example.fixed);
  const auto own = wedged_problem(checked(truss));
  const auto theirs = wedged_problem(checked(example));
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(truss.contact[i].node, example.contact[i].node);
    EXPECT_LT((own.frames[i] - theirs.frames[i]).cwiseAbs().maxCoeff(), 1e-15);
  }
}

TEST(PlaneTruss, OfThePaperHasBarsOfOneStiffnessAndAMirroredNormal) {
  const auto truss = paper_plane_truss(5);
  EXPECT_EQ(truss.members.size(), 17U);
  for (const double stiffness : member_stiffnesses(truss)) EXPECT_NEAR(stiffness, 1, 1e-15);
  for (const auto& candidate : truss.contact) {
    const double lean = std::atan2(truss.coordinates(0, 9) - truss.coordinates(0, 1), 4.0);
    EXPECT_NEAR(candidate.normal(0), -std::cos(lean), 1e-15);
    EXPECT_NEAR(candidate.normal(1), -std::sin(lean), 1e-15);
  }
  EXPECT_THROW((void)paper_plane_truss(1), std::invalid_argument);
}

TEST(PlaneTruss, OfAnySizeAndBracingIsNoMechanism) {
  for (const int rows : {2, 3, 7, 12}) {
    for (const int bays : {1, 2, 3, 4}) {
      for (const auto verticals : {Verticals::none, Verticals::inner, Verticals::all}) {
        const auto truss = plane_truss({.rows = rows, .bays = bays, .verticals = verticals});
        EXPECT_EQ(wedged_problem(checked(truss)).contact_names.size(),
                  static_cast<std::size_t>(rows))
            << rows << ' ' << bays;
      }
    }
  }
}

TEST(PlaneTruss, HasTheRequestedWidthAndLean) {
  const auto truss = plane_truss({.rows = 3, .bays = 1, .width = 4, .lean = 45});
  EXPECT_EQ(truss.coordinates(0, 1), 4);
  EXPECT_NEAR(truss.coordinates(0, 5), 6, 1e-14);
  EXPECT_LT((truss.contact[0].normal - Eigen::Vector2d(-1, 1).normalized()).norm(), 1e-15);
}

TEST(PlaneTruss, OfAnImpossibleSizeIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(plane_truss({.rows = 1}), std::invalid_argument);
  EXPECT_THROW(plane_truss({.bays = 0}), std::invalid_argument);
  EXPECT_THROW(plane_truss({.bays = 1'000'000'000}), std::invalid_argument);
  EXPECT_THROW(plane_truss({.rows = max_contact_candidates + 1}), std::invalid_argument);
  EXPECT_THROW(plane_truss({.width = 0}), std::invalid_argument);
  EXPECT_THROW(plane_truss({.width = nan}), std::invalid_argument);
  EXPECT_THROW(plane_truss({.lean = 90}), std::invalid_argument);
  EXPECT_THROW(plane_truss({.lean = nan}), std::invalid_argument);
}

TEST(PlaneTruss, IsWrittenAndReadBackToTheLastBit) {
  const auto truss = plane_truss({.rows = 6, .bays = 3, .width = 4.4, .lean = 17});
  const Structure copy = read_structure(structure_text(truss), "copy");
  EXPECT_EQ(copy.coordinates, truss.coordinates);
  EXPECT_EQ(copy.node_names, truss.node_names);
}

}  // namespace
}  // namespace kusabi::problems
