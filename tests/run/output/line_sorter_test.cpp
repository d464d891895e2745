// Lines sorted in blocks, against std::sort of all.
#include "run/output/line_sorter.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace kusabi::test {
namespace {

std::vector<std::string> sorted(const std::vector<std::string>& lines, std::size_t block) {
  const auto folder = std::filesystem::temp_directory_path() / "kusabi-line-sorter";
  std::filesystem::create_directories(folder);
  run::LineSorter sorter((folder / "list").string(), std::less<std::string_view>(), block);
  for (const auto& line : lines) sorter.add(line);
  EXPECT_TRUE(std::filesystem::is_empty(folder)) << "blocks have no name";
  std::vector<std::string> all;
  sorter.each([&](std::string_view line) { all.emplace_back(line); });
  std::filesystem::remove_all(folder);
  return all;
}

TEST(LineSorter, GivesEachLineOnceInOrderForAnyBlockSize) {
  std::mt19937 random(1);
  for (const int count : {0, 1, 2, 1000}) {
    std::vector<std::string> lines;
    for (int i = 0; i < count; ++i) {
      const auto number = random() % 700;
      lines.push_back(std::string(number % 7, 'x') + std::to_string(number));
    }
    auto expected = lines;
    std::ranges::sort(expected);
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    for (const std::size_t block : {1U, 50U, 3000U, 1U << 20U})
      EXPECT_EQ(sorted(lines, block), expected) << count << " lines, blocks of " << block;
  }
}

TEST(LineSorter, ThrowsIfItCannotWriteItsBlocks) {
  run::LineSorter sorter("/nowhere/at/all", std::less<std::string_view>(), 1);
  sorter.add("a");
  EXPECT_THROW(sorter.add("b"), std::runtime_error);
}

}  // namespace
}  // namespace kusabi::test
