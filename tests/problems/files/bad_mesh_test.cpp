// Every malformed mesh in tests/bad-meshes is refused with its message in expected.txt:
// FILE:LINE:COLUMN: fault; expected ... Where that ends in "...", only its beginning is compared,
// since the rest is that of other checks.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/problems/files/mesh_problems.hpp"

namespace kusabi::problems {
namespace {

class BadMesh : public testing::TestWithParam<std::string> {};

TEST_P(BadMesh, IsRefusedWithTheExpectedLine) {
  const std::string name = test::promised_file(GetParam());
  // Materials missing in an Abaqus file are not defined elsewhere.
  const bool is_gmsh = name.ends_with(".msh");
  ProblemText problem{
      test::head(2) +
          (is_gmsh ? test::mesh_of(name, 2) : "[[mesh]]\nname = \"m\"\nfile = \"" + name + "\"\n") +
          (is_gmsh ? "[[supports]]\nnodes = [\"m.left\"]\n" : ""),
      {}};
  problem.meshes[name] = test::content("tests/bad-meshes/" + name);
  const std::string error = test::error_of(problem);
  const std::string_view any_words = " ...";
  if (GetParam().ends_with(any_words)) {
    EXPECT_THAT(error,
                testing::StartsWith(GetParam().substr(0, GetParam().size() - any_words.size())));
  } else {
    EXPECT_EQ(error, GetParam());
  }
  EXPECT_EQ(error.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Files, BadMesh, testing::ValuesIn(test::promises("tests/bad-meshes")),
                         test::parameter_name);

TEST(BadMeshes, AllHaveAnExpectedLine) {
  test::expect_all_listed("tests/bad-meshes");
}

// Truncated files lead to an error of one line or to a complete mesh.
TEST(BadMeshes, TruncatedAnywhereAreRefusedOrComplete) {
  for (const std::string name :
       {"quads-q4-22.msh", "quads-q4-41.msh", "box-hex20-41.msh", "box-tet4.inp"}) {
    const std::string whole = test::content("tests/meshes/" + name);
    const int dimension = name.starts_with("box") ? 3 : 2;
    for (std::size_t length = 0; length < whole.size(); ++length) {
      ProblemText problem{test::head(dimension) + test::mesh_of(name, dimension), {}};
      problem.meshes[name] = whole.substr(0, length);
      const std::string error = test::error_of(problem);
      EXPECT_EQ(error.find('\n'), std::string::npos);
      EXPECT_TRUE(error.starts_with(name + ":") || length + 2 >= whole.size() ||
                  name.ends_with(".inp"))
          << length << ": " << error;
    }
  }
}

}  // namespace
}  // namespace kusabi::problems
