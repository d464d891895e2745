// Binary meshes of Gmsh: one that Gmsh wrote, and the ASCII ones of tests/meshes in binary, as the
// reference manual describes the formats.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/files/structure_file.hpp"
#include "tests/problems/files/mesh_problems.hpp"

namespace kusabi::problems::binary_mesh_test {
namespace {

/// Writer of a binary file from an ASCII one.
class Encoder {
 public:
  Encoder(const std::string& ascii, bool swapped) : in_(ascii), swapped_(swapped) {}

  std::string bytes() {
    std::string name;
    while (in_ >> name) {
      out_ += name + "\n";
      if (name == "$MeshFormat") {
        double version = 0;
        int kind = 0;
        int size = 0;
        in_ >> version >> kind >> size;
        old_ = version < 3;
        out_ += old_ ? "2.2 1 8\n" : "4.1 1 8\n";
        put(std::int32_t{1});
      } else if (name == "$PhysicalNames") {
        std::string line;
        std::getline(in_, line);
        while (std::getline(in_, line) && line != "$EndPhysicalNames") out_ += line + "\n";
        out_ += line + "\n";
        continue;
      } else if (name == "$Entities") {
        entities();
      } else if (name == "$Nodes") {
        old_ ? nodes_2() : nodes_4();
      } else if (name == "$Elements") {
        old_ ? elements_2() : elements_4();
      }
      in_ >> name;
      out_ += "\n" + name + "\n";
    }
    return out_;
  }

 private:
  template <class Number>
  void put(Number number) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if (swapped_) std::ranges::reverse(raw);
    out_.append(raw.data(), raw.size());
  }
  template <class Number>
  Number copy() {
    Number number{};
    in_ >> number;
    put(number);
    return number;
  }
  std::uint64_t size() { return copy<std::uint64_t>(); }

  void entities() {
    std::array<std::uint64_t, 4> counts{};
    for (auto& each : counts) each = size();
    for (std::size_t dimension = 0; dimension < 4; ++dimension) {
      for (std::uint64_t i = 0; i < counts[dimension]; ++i) {
        copy<std::int32_t>();
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) copy<double>();
        for (int list = 0; list < (dimension == 0 ? 1 : 2); ++list) {
          const auto length = size();
          for (std::uint64_t k = 0; k < length; ++k) copy<std::int32_t>();
        }
      }
    }
  }
  void nodes_4() {
    const auto blocks = size();
    for (int k = 0; k < 3; ++k) size();
    for (std::uint64_t block = 0; block < blocks; ++block) {
      for (int k = 0; k < 3; ++k) copy<std::int32_t>();
      const auto count = size();
      for (std::uint64_t i = 0; i < count; ++i) size();
      for (std::uint64_t i = 0; i < 3 * count; ++i) copy<double>();
    }
  }
  void elements_4() {
    const auto blocks = size();
    for (int k = 0; k < 3; ++k) size();
    for (std::uint64_t block = 0; block < blocks; ++block) {
      for (int k = 0; k < 3; ++k) copy<std::int32_t>();
      const auto count = size();
      std::string line;
      std::getline(in_, line);
      for (std::uint64_t i = 0; i < count; ++i) {
        std::getline(in_, line);
        std::istringstream numbers(line);
        for (std::uint64_t tag = 0; numbers >> tag;) put(tag);
      }
    }
  }
  void nodes_2() {
    int count = 0;
    in_ >> count;
    out_ += std::to_string(count) + "\n";
    for (int i = 0; i < count; ++i) {
      copy<std::int32_t>();
      for (int k = 0; k < 3; ++k) copy<double>();
    }
  }
  // One block for each element.
  void elements_2() {
    int count = 0;
    std::string line;
    in_ >> count;
    out_ += std::to_string(count) + "\n";
    std::getline(in_, line);
    for (int i = 0; i < count; ++i) {
      std::getline(in_, line);
      std::istringstream numbers(line);
      std::int32_t tag = 0;
      std::int32_t type = 0;
      std::int32_t tags = 0;
      numbers >> tag >> type >> tags;
      for (const std::int32_t each : {type, 1, tags, tag}) put(each);
      for (std::int32_t each = 0; numbers >> each;) put(each);
    }
  }

  std::istringstream in_;
  bool swapped_;
  bool old_ = false;
  std::string out_;
};

ProblemText problem(const std::string& name, const std::string& bytes) {
  const int dimension = name.starts_with("box") ? 3 : 2;
  ProblemText text{test::head(dimension) + test::mesh_of(name, dimension) +
                       "[[supports]]\nnodes = [\"m." + (dimension == 2 ? "left" : "bottom") +
                       "\"]\n",
                   {}};
  text.meshes[name] = bytes;
  return text;
}

void expect_equal(const Structure& one, const Structure& other) {
  EXPECT_EQ(one.node_names, other.node_names);
  ASSERT_EQ(one.coordinates.size(), other.coordinates.size());
  // Gmsh writes 16 digits into ASCII files.
  EXPECT_LT((one.coordinates - other.coordinates).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_EQ(one.fixed, other.fixed);
  ASSERT_EQ(one.elements.size(), other.elements.size());
  for (std::size_t i = 0; i < one.elements.size(); ++i)
    EXPECT_EQ(one.elements[i].nodes, other.elements[i].nodes);
}

TEST(BinaryMesh, OfGmshEqualsTheAsciiMesh) {
  expect_equal(
      read_structure(problem("quads-binary.msh", test::content("tests/meshes/quads-binary.msh")),
                     "b"),
      read_structure(problem("quads-q4-41.msh", test::content("tests/meshes/quads-q4-41.msh")),
                     "a"));
}

class BinaryMeshes : public testing::TestWithParam<const char*> {};

TEST_P(BinaryMeshes, EqualTheAsciiMeshesInEitherByteOrder) {
  const std::string name = GetParam();
  const std::string ascii = test::content("tests/meshes/" + name);
  const auto expected = read_structure(problem(name, ascii), "a");
  for (const bool swapped : {false, true})
    expect_equal(read_structure(problem(name, Encoder(ascii, swapped).bytes()), "b"), expected);
}

INSTANTIATE_TEST_SUITE_P(Files, BinaryMeshes,
                         testing::Values("plate-t3-22.msh", "plate-t6-41.msh", "quads-q8-22.msh",
                                         "quads-q8-41.msh", "box-tet10-22.msh", "box-tet4-41.msh",
                                         "box-hex20-41.msh", "box-hex8-22.msh"));

TEST(BinaryMesh, TruncatedAnywhereIsRefusedWithoutALineNumber) {
  for (const std::string name : {"quads-q4-22.msh", "quads-q4-41.msh"}) {
    const std::string whole = Encoder(test::content("tests/meshes/" + name), false).bytes();
    for (std::size_t length = 0; length + 1 < whole.size(); ++length) {
      const std::string error = test::error_of(problem(name, whole.substr(0, length)));
      EXPECT_THAT(error, testing::StartsWith(name + ":")) << length;
      EXPECT_EQ(error.find('\n'), std::string::npos);
    }
  }
}

// The length of its elements is not known, so the rest of the file is not read.
TEST(BinaryMesh, WithUnknownElementsIsRefusedByTheirNames) {
  std::string ascii = test::content("tests/meshes/box-hex27.msh");
  EXPECT_THAT(test::error_of(problem("box-hex27.msh", Encoder(ascii, false).bytes())),
              testing::StartsWith("box-hex27.msh: an element that is a quadrilateral of 9 nodes"));
}

}  // namespace
}  // namespace kusabi::problems::binary_mesh_test
