// Short fuzz run in every build: each reader gets the corpus and thousands of mutations, and reads
// or refuses each in one line. The corpus contains all inputs that once revealed a defect.
#include "readers.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kusabi::fuzz {
namespace {

namespace fs = std::filesystem;

// All files of a reader's kind in tests/ and examples/, ordered by name.
std::vector<std::string> corpus(Reader reader) {
  const auto source = fs::path(KUSABI_SOURCE_DIR);
  std::vector<fs::path> folders{source / "tests/fuzz/corpus" / name_of(reader)};
  std::string extension;
  if (reader == Reader::structure) {
    extension = ".toml";
    folders.insert(folders.end(),
                   {source / "examples", source / "examples/paper", source / "tests/bad-input"});
  }
  if (reader == Reader::gmsh || reader == Reader::abaqus) {
    extension = reader == Reader::gmsh ? ".msh" : ".inp";
    folders.insert(folders.end(), {source / "tests/meshes", source / "tests/bad-meshes"});
  }
  if (reader == Reader::matrix) {
    extension = ".mtx";
    folders.push_back(source / "tests/bad-matrices");
  }
  if (reader == Reader::mps || reader == Reader::lp) {
    extension = "." + name_of(reader);
    folders.insert(folders.end(), {source / "tests/programs", source / "tests/bad-programs"});
  }
  std::vector<fs::path> files;
  for (const auto& folder : folders) {
    if (!fs::exists(folder)) continue;
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (extension.empty() || entry.path().extension() == extension || folder == folders.front())
        files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> texts;
  for (const auto& file : files) {
    std::ifstream stream(file, std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return texts;
}

using Bits = std::mt19937_64;

std::size_t below(Bits& bits, std::size_t maximum) {
  return static_cast<std::size_t>(bits() % std::max<std::size_t>(1, maximum));
}

// One change: a byte, a piece left out, doubled, moved from another file, or a number made extreme.
void change(std::string& text, const std::string& other, Bits& bits) {
  constexpr std::size_t longest_piece = 60;
  const std::size_t at = below(bits, text.size() + 1);
  const auto piece = [&](const std::string& from) {
    const std::size_t start = below(bits, from.size() + 1);
    return from.substr(start, 1 + below(bits, longest_piece));
  };
  switch (bits() % 6) {
    case 0:
      if (!text.empty()) text[below(bits, text.size())] = static_cast<char>(bits());
      break;
    case 1:
      text.erase(at, 1 + below(bits, longest_piece));
      break;
    case 2:
      text.insert(at, piece(text));
      break;
    case 3:
      text.insert(at, piece(other));
      break;
    case 4:
      text.resize(at);
      break;
    default: {
      const auto digit = text.find_first_of("0123456789", at);
      if (digit == std::string::npos) break;
      static const std::vector<std::string> numbers{
          "0",     "-1",  "1e308", "1e-320",     "nan", "-inf",
          "1e400", "0x1", "1e",    "2147483648", "64",  "18446744073709551616"};
      const auto end = text.find_first_not_of("0123456789.", digit);
      text.replace(digit, end == std::string::npos ? end : end - digit,
                   numbers[below(bits, numbers.size())]);
    }
  }
}

class Readers : public testing::TestWithParam<Reader> {};

TEST_P(Readers, AcceptOrRefuseTheCorpusInOneLine) {
  const auto texts = corpus(GetParam());
  ASSERT_FALSE(texts.empty());
  int accepted = 0;
  for (const auto& text : texts) {
    SCOPED_TRACE(text.substr(0, 200));
    accepted += try_reader(GetParam(), text) ? 0 : 1;
  }
  EXPECT_GT(accepted, 0);  // otherwise nothing after the reader is tested
}

TEST_P(Readers, AcceptOrRefuseMutationsInOneLine) {
  const auto texts = corpus(GetParam());
  constexpr int tries = 1500;
  Bits bits(1);
  for (int i = 0; i < tries; ++i) {
    auto text = texts[below(bits, texts.size())];
    const auto& other = texts[below(bits, texts.size())];
    for (auto changes = 1 + bits() % 4; changes > 0; --changes) change(text, other, bits);
    repair(GetParam(), text);
    SCOPED_TRACE(text);
    ASSERT_NO_THROW(try_reader(GetParam(), text));
  }
}

INSTANTIATE_TEST_SUITE_P(Each, Readers, testing::ValuesIn(readers),
                         [](const auto& reader) { return name_of(reader.param); });

}  // namespace
}  // namespace kusabi::fuzz
