// Sections [[actions]] and [combinations]: the resulting load cases and their boxes.
#include <cmath>
#include <map>
#include <string>

#include <boost/multiprecision/cpp_int.hpp>
#include <gmock/gmock.h>

#include "problems/files/structure_file.hpp"
#include "problems/structure/model/load_cases.hpp"

namespace kusabi::problems {
namespace {

using testing::ElementsAre;
using Rational = boost::multiprecision::cpp_rational;

std::string one_bar(const std::string& combinations, const std::string& more = "") {
  return R"(name = "hanger"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
top = [0, 1]
low = [0, 0]
left = [-1, 0]
[[members]]
yield = 100
between = [["top", "low"], ["left", "low"]]
[[supports]]
nodes = ["top", "left"]
)" + combinations +
         R"(
[[actions]]
name = "own weight"
permanent = [0.9, 1.1]
forces = [{ nodes = ["low"], force = [0, -3] }]
[[actions]]
name = "snow"
variable = true
psi0 = 0.5
forces = [{ nodes = ["low"], force = [0, -7] }]
[[actions]]
name = "wind"
variable = 1.6
psi0 = 0.6
either_way = true
forces = [{ nodes = ["low"], force = [0.1, 0] }, { nodes = ["low"], force = [0.2, 0.7] }]
)" + more;
}

const std::string general = "[combinations]\nrule = \"6.10\"\nreference = \"snow\"";

// The uncertain loads of one case, by name.
std::map<std::string, UncertainParameter> ranges(const Structure& structure,
                                                 const std::string& load_case) {
  std::map<std::string, UncertainParameter> found;
  const Structure of_case = in_load_case(structure, load_case);
  for (const auto& each : *of_case.uncertain) found[each.name] = each;
  return found;
}

double reference_force(const Structure& structure, const std::string& load_case) {
  double sum = 0;
  for (const Load& load : in_load_case(structure, load_case).loads) {
    if (load.kind == Load::Kind::reference) sum += load.force(1);
  }
  return sum;
}

TEST(Actions, EachVariableActionLeadsOnce) {
  const auto structure = read_structure(one_bar(general), "hanger.toml");
  EXPECT_THAT(load_cases(structure), ElementsAre("6.10 snow leads", "6.10 wind leads"));
  EXPECT_EQ(reference_force(structure, "6.10 snow leads"), -1.5 * 7);
  EXPECT_EQ(reference_force(structure, "6.10 wind leads"), -1.5 * 0.5 * 7);
}

TEST(Actions, WithoutALeadingActionAllAreReduced) {
  const auto structure = read_structure(
      one_bar("[combinations]\nrule = \"6.10ab\"\nxi = 0.8\nreference = \"snow\""), "hanger.toml");
  EXPECT_THAT(load_cases(structure), ElementsAre("6.10a", "6.10b snow leads", "6.10b wind leads"));
  EXPECT_EQ(reference_force(structure, "6.10a"), -1.5 * 0.5 * 7);
  // 0.8 x 1.1 = 0.88 is below the favourable factor 0.9.
  const auto own_weight = ranges(structure, "6.10b wind leads").at("own weight");
  EXPECT_NEAR(*own_weight.half_width * std::abs(own_weight.components.front().weight), 3 * 0.01,
              1e-15);
}

// The bounds of each range, as exact products, are within the nominal load and the half-width.
TEST(Actions, RangesContainBothFactors) {
  const auto structure = read_structure(one_bar(general), "hanger.toml");
  const auto expect_held = [&](const std::string& load_case, const std::string& action,
                               double lower, double upper, int axis, double force) {
    const auto parameter = ranges(structure, load_case).at(action);
    Rational width = 0;
    for (const auto& each : parameter.components) {
      if (each.axis == axis) width = abs(Rational(each.weight)) * Rational(*parameter.half_width);
    }
    Rational middle = 0;
    for (const Load& load : in_load_case(structure, load_case).loads) {
      if (load.kind == Load::Kind::dead && (action == "wind") == (axis == 0))
        middle += Rational(load.force(axis));
    }
    for (const double end : {lower, upper}) {
      EXPECT_LE(abs(Rational(end) * Rational(force) - middle), width)
          << load_case << ", " << action;
    }
    EXPECT_NEAR(static_cast<double>(width), (upper - lower) / 2 * std::abs(force), 1e-14);
  };
  expect_held("6.10 snow leads", "own weight", 0.9, 1.1, 1, -3);
  expect_held("6.10 snow leads", "wind", -1.6 * 0.6, 1.6 * 0.6, 0, 0.1 + 0.2);
  expect_held("6.10 wind leads", "wind", -1.6, 1.6, 0, 0.1 + 0.2);
}

TEST(Actions, ExclusiveActionsAreNeverCombined) {
  const std::string tail = R"([[actions]]
name = "crane left"
variable = 1.35
psi0 = 0.7
exclusive = "crane"
forces = [{ nodes = ["low"], force = [-1, 0] }]
[[actions]]
name = "crane right"
variable = 1.35
psi0 = 0.7
exclusive = "crane"
forces = [{ nodes = ["low"], force = [1, 0] }]
)";
  const auto structure = read_structure(one_bar(general, tail), "hanger.toml");
  EXPECT_THAT(load_cases(structure),
              ElementsAre("6.10 snow leads, crane left", "6.10 wind leads, crane left",
                          "6.10 crane left leads, crane left", "6.10 snow leads, crane right",
                          "6.10 wind leads, crane right", "6.10 crane right leads, crane right"));
  EXPECT_FALSE(ranges(structure, "6.10 snow leads, crane left").contains("crane right"));
}

// A single number is not a range: the load is not uncertain.
TEST(Actions, EqualFactorsAreNominal) {
  std::string text = one_bar(general);
  text.replace(text.find("[0.9, 1.1]"), 10, "[1.2, 1.2]");
  const auto structure = read_structure(text, "hanger.toml");
  EXPECT_FALSE(ranges(structure, "6.10 snow leads").contains("own weight"));
}

}  // namespace
}  // namespace kusabi::problems
