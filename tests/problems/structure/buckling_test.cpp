// The buckling resistance compared with worked examples and a table of the reduction factor, which
// another program computed from EN 1993-1-1, 6.3.1.
#include "problems/structure/model/buckling.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>

#include "problems/files/structure_file.hpp"

namespace kusabi::problems {
namespace {

// HEB 200 of S235 about its weak axis, 4 m; units m and kN.
TEST(Buckling, ResistanceOfARolledSectionIsThatOfTheWorkedExample) {
  const CompressedBar bar{.modulus = 210e6,
                          .area = 78.08e-4,
                          .yield_stress = 235e3,
                          .radius = 5.07e-2,
                          .length = 4,
                          .imperfection = *imperfection_factor("c")};
  EXPECT_NEAR(buckling_resistance(bar), 1168.845, 1e-3);
}

// CHS 114.3 x 5 of S355, 3 m, hot finished and cold formed.
TEST(Buckling, ResistanceOfATubeIsThatOfTheWorkedExample) {
  CompressedBar bar{.modulus = 210e6,
                    .area = 0.0017168803851868209,
                    .yield_stress = 355e3,
                    .radius = 0.03868379828817228,
                    .length = 3,
                    .imperfection = *imperfection_factor("a")};
  EXPECT_NEAR(buckling_resistance(bar), 399.302, 1e-3);
  bar.imperfection = *imperfection_factor("c");
  EXPECT_NEAR(buckling_resistance(bar), 323.829, 1e-3);
  bar.partial = 1.1;
  EXPECT_NEAR(buckling_resistance(bar), 323.829 / 1.1, 1e-3);
}

TEST(Buckling, ReductionFactorsAreThoseOfTheTable) {
  const auto chi = [](double slenderness, const char* curve) {
    const double modulus = 1000;
    return buckling_resistance({.modulus = modulus,
                                .area = 1,
                                .yield_stress = 1,
                                .radius = 1,
                                .length = slenderness * std::numbers::pi * std::sqrt(modulus),
                                .imperfection = *imperfection_factor(curve)});
  };
  EXPECT_NEAR(chi(0.2, "d"), 1, 1e-12);
  EXPECT_NEAR(chi(0.1, "d"), 1, 1e-12);
  EXPECT_NEAR(chi(1, "a0"), 0.7253, 5e-5);
  EXPECT_NEAR(chi(1, "a"), 0.6656, 5e-5);
  EXPECT_NEAR(chi(1, "b"), 0.5970, 5e-5);
  EXPECT_NEAR(chi(0.6, "c"), 0.7854, 5e-5);
  EXPECT_NEAR(chi(3, "d"), 0.0882, 5e-5);
  EXPECT_LE(chi(0.2, "d"), 1);
  EXPECT_FALSE(imperfection_factor("e"));
}

// The length is that between the nodes, times its factor; tension is A fy.
TEST(Buckling, IsOfEachBarOfAGroup) {
  const Structure structure = read_structure(R"(name = "two lengths"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
a = [0, 0]
b = [3, 0]
c = [3, 4]
[[members]]
E = 210e6
fy = 355e3
A = 0.0017168803851868209
buckling = { curve = "a", i = 0.03868379828817228, length = 0.75 }
between = [["a", "b"], ["b", "c"]]
[[supports]]
nodes = ["a", "c"]
)",
                                             "two-lengths.toml");
  EXPECT_NEAR(structure.members[1].yield->compression, 399.302, 1e-3);
  EXPECT_GT(structure.members[0].yield->compression, 399.302);
  EXPECT_NEAR(structure.members[0].yield->tension, 609.493, 1e-3);
}

}  // namespace
}  // namespace kusabi::problems
