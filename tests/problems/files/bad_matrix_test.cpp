// Every malformed matrix in tests/bad-matrices is refused with its message in expected.txt:
// FILE:LINE:COLUMN: fault; expected ...
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/problems/files/mesh_problems.hpp"

namespace kusabi::problems {
namespace {

/// A stiffness of two nodes in the plane, with the tags 1 and 2 in CalculiX.
ProblemText problem_of(const std::string& name, const std::string& matrix) {
  const bool knows_nodes = name.starts_with("stored") || name.starts_with("substructure");
  ProblemText problem{test::head(2) + "[nodes]\n1 = [0, 0]\n2 = [1, 0]\n[[stiffness]]\nfile = \"" +
                          name + "\"\n" + (knows_nodes ? "" : "nodes = [\"1\", \"2\"]\n"),
                      {}};
  problem.meshes[name] = matrix;
  const std::string rows = std::filesystem::path(name).replace_extension(".dof").string();
  if (name.ends_with(".sti")) problem.meshes[rows] = "1.1\n1.2\n2.1\n2.2\n";
  return problem;
}

class BadMatrix : public testing::TestWithParam<std::string> {};

TEST_P(BadMatrix, IsRefusedWithTheExpectedLine) {
  const std::string name = test::promised_file(GetParam());
  EXPECT_EQ(test::error_of(problem_of(name, test::content("tests/bad-matrices/" + name))),
            GetParam());
}

INSTANTIATE_TEST_SUITE_P(Files, BadMatrix, testing::ValuesIn(test::promises("tests/bad-matrices")),
                         test::parameter_name);

TEST(BadMatrices, AllHaveAnExpectedLine) {
  test::expect_all_listed("tests/bad-matrices");
}

TEST(BadMatrices, WithInvalidRowsAreRefused) {
  const auto error = [](const std::string& rows) {
    auto problem = problem_of("stored.sti", "1 1 4.\n");
    problem.meshes["stored.dof"] = rows;
    return test::error_of(problem);
  };
  EXPECT_EQ(error(""),
            "stored.dof:1:1: the file has no rows; expected NODE.DIRECTION on each line");
  EXPECT_EQ(error("1.1\n12\n"),
            "stored.dof:2:1: the line is not NODE.DIRECTION; expected a row such as 17.3");
  EXPECT_EQ(error("1.1\n7.1\n"),
            "stored.dof:2:1: node 7 of the matrix would be \"7\", which does not exist; expected "
            "it among the nodes of the problem, or others = \"free\" in [[stiffness]]");
}

// Truncated files lead to an error of one line or to a complete matrix.
TEST(BadMatrices, TruncatedAnywhereAreRefusedOrComplete) {
  for (const std::string name : {"box-hex8-substructure.mtx", "box-hex8-stored.sti"}) {
    const std::string whole = test::content("tests/meshes/" + name);
    auto problem = test::with_meshes(test::head(3) + test::mesh_of("box-hex8-41.msh", 3) +
                                     "[[stiffness]]\nmesh = \"m\"\nfile = \"" + name + "\"\n");
    problem.meshes["box-hex8-stored.dof"] = test::content("tests/meshes/box-hex8-stored.dof");
    for (std::size_t length = 0; length < whole.size(); ++length) {
      problem.meshes[name] = whole.substr(0, length);
      const std::string error = test::error_of(problem);
      EXPECT_EQ(error.find('\n'), std::string::npos);
      EXPECT_TRUE(error.starts_with(name + ":") || error.starts_with("test.toml:") ||
                  length + 24 >= whole.size())
          << length << ": " << error;
    }
  }
}

}  // namespace
}  // namespace kusabi::problems
