// Reading well-formed problem files. The malformed ones are in bad_input_test.cpp.
#include "problems/files/structure_file.hpp"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/files/toml/structure_writer.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

constexpr const char* space_frame = R"(name = "a tripod"
dimension = 3
units = { length = "mm", force = "N" }
[nodes]
zeta = [0, 0, 0]
alpha = [2, 0.5, 0]
mid = [0, 2, 0]
"Spitze µ" = [1, 1, 1e0]
side = [3, 3, 0]
[[members]]
EA = 2
between = [["zeta", "Spitze µ"], ["Spitze µ", "alpha"]]
[[members]]
EA = 5.5
between = [["mid", "Spitze µ"], ["alpha", "side"], ["mid", "side"]]
[[supports]]
nodes = ["zeta", "mid", "alpha"]
[[supports]]
nodes = ["side"]
fixed = ["z"]
[[contact]]
nodes = ["Spitze µ"]
normal = [0, 0, 4]
tangent = [0, 3, 0]
)";

TEST(StructureFile, IsReadCompletely) {
  const Structure structure = read_structure(space_frame, "tripod.toml");
  EXPECT_EQ(structure.name, "a tripod");
  EXPECT_EQ(structure.dimension, 3);
  EXPECT_EQ(structure.units.length, "mm");
  EXPECT_EQ(structure.units.force, "N");
  EXPECT_EQ(structure.coordinates.col(1), Eigen::Vector3d(2, 0.5, 0));
  ASSERT_EQ(structure.members.size(), 5U);
  EXPECT_EQ(structure.members[1].first, 3);
  EXPECT_EQ(structure.members[1].second, 1);
  EXPECT_EQ(structure.members[1].axial_stiffness, 2.0);
  EXPECT_EQ(structure.members[2].axial_stiffness, 5.5);
  EXPECT_THAT(structure.fixed[0], testing::ElementsAre(true, true, true));
  EXPECT_THAT(structure.fixed[3], testing::ElementsAre(false, false, false));
  EXPECT_THAT(structure.fixed[4], testing::ElementsAre(false, false, true));
  ASSERT_EQ(structure.contact.size(), 1U);
  EXPECT_EQ(structure.contact[0].node, 3);
  EXPECT_EQ(structure.contact[0].normal, Eigen::Vector3d::UnitZ());
  ASSERT_TRUE(structure.contact[0].tangent);
  EXPECT_EQ(*structure.contact[0].tangent, Eigen::Vector3d(0, 3, 0));
}

TEST(StructureFile, KeepsTheOrderOfTheNodes) {
  EXPECT_THAT(read_structure(space_frame, "tripod.toml")->node_names,
              testing::ElementsAre("zeta", "alpha", "mid", "Spitze µ", "side"));
}

TEST(StructureFile, RecordsThePositionsOfItsEntries) {
  const Sources sources = read_structure(space_frame, "tripod.toml")->sources;
  EXPECT_EQ(sources.file, "tripod.toml");
  EXPECT_EQ(sources.nodes[2].line, 7);
  EXPECT_EQ(sources.members[1].line, 12);
  EXPECT_EQ(sources.axial_stiffnesses[2].line, 14);
  EXPECT_EQ(sources.contact[0].line, 22);
  EXPECT_EQ(sources.normals[0].line, 23);
  EXPECT_EQ(sources.tangents[0].line, 24);
}

/// Three bars, each a group of its own.
std::string steel_truss(const std::string& first, const std::string& second,
                        const std::string& third) {
  return R"(name = "steel"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
a = [0, 0]
b = [4, 0]
tip = [0, 3]
[[supports]]
nodes = ["a"]
[[supports]]
nodes = ["b"]
fixed = ["y"]
[[members]]
between = [["a", "b"]]
)" + first +
         "\n[[members]]\nbetween = [[\"a\", \"tip\"]]\n" + second +
         "\n[[members]]\nbetween = [[\"b\", \"tip\"]]\n" + third;
}

// All of these products are exact.
TEST(StructureFile, ComputesForcesFromModulusAreaAndYieldStress) {
  const Structure in_stresses =
      read_structure(steel_truss("E = 210e6\nA = 0.0625\nfy = 355e3",
                                 "fy = { compression = 240e3, tension = 355e3 }\nA = 0.125",
                                 "EA = 7\nA = 2\nfy = 1.5"),
                     "stresses");
  const Structure in_forces = read_structure(
      steel_truss("EA = 13125000\nyield = 22187.5",
                  "yield = { tension = 44375, compression = 3e4 }", "EA = 7\nyield = 3"),
      "forces");
  ASSERT_EQ(in_stresses.members.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(in_stresses.members[i].axial_stiffness, in_forces.members[i].axial_stiffness) << i;
    EXPECT_EQ(in_stresses.members[i].yield, in_forces.members[i].yield) << i;
  }
  EXPECT_EQ(structure_text(in_stresses), structure_text(in_forces));
}

TEST(StructureFile, WritesTheForcesComputedFromStresses) {
  const Structure structure = read_structure(
      steel_truss("E = 2.1e8\nA = 1.1e-3\nfy = 0.3", "fy = 1e5\nA = 0.7e-3", "yield = 1"), "steel");
  const Structure again = read_structure(structure_text(structure), "again");
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(again.members[i].axial_stiffness, structure.members[i].axial_stiffness) << i;
    EXPECT_EQ(again.members[i].yield, structure.members[i].yield) << i;
  }
  EXPECT_EQ(structure.members[0].axial_stiffness, 2.1e8 * 1.1e-3);
  EXPECT_EQ(structure.members[1].axial_stiffness, 0);
}

std::string error_of(const std::filesystem::path& file) {
  try {
    load_structure(file);
  } catch (const support::InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(StructureFile, ThatDoesNotExistOrIsADirectoryIsAnInputError) {
  EXPECT_EQ(error_of("no-such-file.toml"),
            "no-such-file.toml: the file cannot be read; expected a problem file in TOML");
  EXPECT_EQ(error_of("/"), "/: the file cannot be read; expected a problem file in TOML");
}

TEST(StructureFile, LargerThanAnyProblemIsRefusedUnread) {
  const auto file = std::filesystem::path(testing::TempDir()) / "kusabi-huge.toml";
  std::ofstream(file).close();
  std::filesystem::resize_file(file, largest_file + 1);
  EXPECT_THAT(error_of(file), testing::EndsWith("the file has 67108865 bytes; expected at most "
                                                "67108864"));
  std::filesystem::remove(file);
}

TEST(StructureFile, WithDeepNestingIsAnErrorAndNotAStackOverflow) {
  EXPECT_THROW(read_structure("name = " + std::string(100000, '['), "deep.toml"),
               support::InputError);
}

}  // namespace
}  // namespace kusabi::problems
