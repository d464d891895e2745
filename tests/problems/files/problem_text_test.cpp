// The files named in a problem file, read from disk.
#include "problems/files/problem_text.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "problems/files/structure_file.hpp"
#include "support/input_error.hpp"
#include "tests/problems/files/mesh_problems.hpp"

namespace kusabi::problems {
namespace {

namespace fs = std::filesystem;

class ProblemTexts : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_ / "parts"); }
  void TearDown() override { fs::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  std::string error() const {
    try {
      problem_text(folder_ / "p.toml");
    } catch (const support::InputError& error) {
      return error.what();
    }
    return "no error";
  }

  fs::path folder_ =
      fs::temp_directory_path() / ("kusabi-problem-text-" + std::to_string(getpid()));
};

const std::string square =
    "*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n*INCLUDE, INPUT=elements.txt\n";

// The path of an included file is relative to the including file.
TEST_F(ProblemTexts, HaveAllNamedAndIncludedFiles) {
  write("p.toml", test::head(2) + test::mesh_of("parts/a.inp", 2));
  write("parts/a.inp", square);
  write("parts/elements.txt", "*ELEMENT, TYPE=CPS4\n1, 1, 2, 3, 4\n");
  const auto text = problem_text(folder_ / "p.toml");
  EXPECT_EQ(text.meshes.size(), 2U);
  EXPECT_EQ(text.meshes.at("parts/a.inp"), square);
  EXPECT_TRUE(text.meshes.contains("parts/elements.txt"));
  EXPECT_EQ(load_structure(folder_ / "p.toml")->elements.size(), 1U);
  // As saved by an editor that begins each text with a byte order mark.
  write("parts/a.inp", "\xEF\xBB\xBF" + square);
  EXPECT_EQ(problem_text(folder_ / "p.toml").meshes.at("parts/a.inp"), square);
}

TEST_F(ProblemTexts, ReportTheFileThatRefersToAMissingFile) {
  write("p.toml", test::head(2) + test::mesh_of("parts/a.inp", 2));
  EXPECT_THAT(error(), testing::StartsWith((folder_ / "p.toml").string() +
                                           ":6:8: the file \"parts/a.inp\" cannot be read"));
  write("parts/a.inp", square);
  EXPECT_THAT(error(), testing::StartsWith((folder_ / "parts/a.inp").string() +
                                           ":6:1: the file \"parts/elements.txt\" cannot be read"));
}

// Faults of the file are reported by the reader.
TEST_F(ProblemTexts, HaveNoMeshesIfTheProblemFileIsInvalid) {
  write("p.toml", "[[mesh]\nfile = 1");
  EXPECT_EQ(error(), "no error");
  EXPECT_TRUE(problem_text(folder_ / "p.toml").meshes.empty());
}

}  // namespace
}  // namespace kusabi::problems
