// Every malformed file in tests/bad-input is refused with the message of its first line, a comment:
// `# expect: FILE:LINE:COLUMN: fault; expected ...`. For syntax errors it is `# expect:
// FILE:LINE:COLUMN: ...`, since the text is that of the TOML library.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/files/structure_file.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

/// Minimum number of malformed files that cover the rules of the format.
constexpr std::size_t min_files = 20;

std::vector<std::filesystem::path> malformed_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(test::source_path("tests/bad-input"))) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

std::string contents(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The expected error of the first line.
testing::Matcher<std::string> promised_error(const std::string& text) {
  const std::string_view mark = "# expect: ";
  if (!text.starts_with(mark)) return testing::Eq("what a first line '# expect: ' says");
  const std::string promise = text.substr(mark.size(), text.find('\n') - mark.size());
  const std::string_view any_words = " ...";
  if (!promise.ends_with(any_words)) return testing::Eq(promise);
  return testing::StartsWith(promise.substr(0, promise.size() - any_words.size() + 1));
}

std::string error_of(const std::string& text, const std::string& file_name) {
  try {
    const auto structure = read_structure(text, file_name);
    // Files whose names begin with "limit-" have faults that only limit analysis finds.
    if (file_name.starts_with("limit-")) {
      limit_problem(structure);
    } else {
      wedged_problem(structure);
    }
  } catch (const support::InputError& error) {
    return error.what();
  }
  return "no error";
}

class BadInput : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(BadInput, IsRefusedWithTheExpectedLine) {
  const std::string text = contents(GetParam());
  const std::string error = error_of(text, GetParam().filename().string());
  EXPECT_THAT(error, promised_error(text));
  EXPECT_EQ(error.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Files, BadInput, testing::ValuesIn(malformed_files()),
                         [](const auto& file) {
                           std::string name = file.param.stem().string();
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(BadInputFiles, AreAtLeastAsManyAsTheRules) {
  EXPECT_GE(malformed_files().size(), min_files);
}

TEST(BadInputText, OfZeroBytesIsRefused) {
  EXPECT_EQ(error_of("", "empty.toml"),
            "empty.toml:1:1: the file is empty; expected a problem file in TOML");
}

// The line is that of the first excess candidate.
TEST(BadInputText, OfTooManyContactCandidatesIsRefused) {
  std::string text =
      "name = \"comb\"\ndimension = 2\n"
      "units = { length = \"m\", force = \"kN\" }\n[nodes]\nfoot = [0.0, 0.0]\n";
  std::string all;
  std::string bars;
  for (int i = 0; i < 4097; ++i) {
    text += fmt::format("c{} = [{}.5, 3.0]\n", i, i);
    bars += fmt::format("[\"foot\", \"c{}\"],", i);
    all += fmt::format("\"c{}\",\n", i);
  }
  text += "[[members]]\nEA = 1.0\nbetween = [" + bars + "]\n[[supports]]\nnodes = [\"foot\"]\n" +
          "[[contact]]\nnormal = [0.0, 1.0]\nnodes = [\n" + all + "]\n";
  EXPECT_EQ(error_of(text, "comb.toml"),
            "comb.toml:8207:1: 4097 contact candidates; expected at most 4096, since K and F "
            "are full matrices");
}

TEST(BadInputText, OfCommentsOnlyIsRefused) {
  EXPECT_EQ(error_of("# nothing\n\n", "comments.toml"),
            "comments.toml:1:1: the file is empty; expected at least one entry");
}

TEST(BadInputText, TruncatedAnywhereIsRefusedOrComplete) {
  // Truncated files lead to an input error or to a complete problem.
  const std::string whole = contents(test::source_path("examples/two-bars.toml"));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::string error = error_of(whole.substr(0, length), "cut.toml");
    EXPECT_TRUE(error.starts_with("cut.toml:") || length + 1 >= whole.size())
        << length << ": " << error;
    EXPECT_EQ(error.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace kusabi::problems
