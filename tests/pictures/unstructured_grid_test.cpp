// VTU writer tests: arrays decode to the original data, compressed or not.
#include "pictures/vtu/unstructured_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/pictures/decoded_grid.hpp"

namespace {

using namespace kusabi::pictures;
using test::array;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::string text_of(const UnstructuredGrid& grid) {
  std::ostringstream out;
  write_vtu(out, grid);
  return out.str();
}

// Random bits, which zlib cannot compress.
UnstructuredGrid random_grid(int points) {
  std::mt19937 bits(7);
  std::normal_distribution<double> normal;
  const auto next = [&] { return normal(bits); };
  UnstructuredGrid grid;
  grid.points = Eigen::Matrix3Xd::NullaryExpr(3, points, next);
  for (int i = 0; i + 1 < points; ++i) grid.cells.push_back({CellType::line, {i, i + 1}});
  Eigen::MatrixXd vectors = Eigen::MatrixXd::NullaryExpr(3, points, next);
  grid.point_data.push_back({"vectors", vectors});
  SmallNumbers flags = SmallNumbers::Zero(1, points);
  for (int i = 0; i < points; ++i) flags(0, i) = static_cast<std::int8_t>(i % 200 - 100);
  grid.point_data.push_back({"flags", flags});
  Eigen::MatrixXd numbers = Eigen::MatrixXd::NullaryExpr(1, points - 1, next);
  grid.cell_data.push_back({"numbers", numbers});
  return grid;
}

void expect_all_of(const std::string& text, const UnstructuredGrid& grid) {
  const auto points = array<double>(text, "points");
  ASSERT_EQ(points.size(), static_cast<std::size_t>(grid.points.size()));
  EXPECT_TRUE(std::equal(points.begin(), points.end(), grid.points.data()));
  const auto& wanted = std::get<Eigen::MatrixXd>(grid.point_data.at(0).values);
  const auto vectors = array<double>(text, "vectors");
  ASSERT_EQ(vectors.size(), static_cast<std::size_t>(wanted.size()));
  EXPECT_TRUE(std::equal(vectors.begin(), vectors.end(), wanted.data()));
  const auto& small = std::get<SmallNumbers>(grid.point_data.at(1).values);
  const auto flags = array<std::int8_t>(text, "flags");
  ASSERT_EQ(flags.size(), static_cast<std::size_t>(small.size()));
  EXPECT_TRUE(std::equal(flags.begin(), flags.end(), small.data()));
}

TEST(VtuFile, StoresFewNumbersUncompressed) {
  const auto grid = random_grid(4);
  const auto text = text_of(grid);
  EXPECT_THAT(text, Not(HasSubstr("compressor")));
  expect_all_of(text, grid);
  EXPECT_THAT(array<std::int64_t>(text, "connectivity"), ElementsAre(0, 1, 1, 2, 2, 3));
  EXPECT_THAT(array<std::int64_t>(text, "offsets"), ElementsAre(2, 4, 6));
  EXPECT_THAT(array<std::uint8_t>(text, "types"), ElementsAre(3, 3, 3));
}

TEST(VtuFile, CompressesManyNumbersInBlocks) {
  const auto grid = random_grid(5000);
  const auto text = text_of(grid);
  EXPECT_THAT(text, HasSubstr("compressor=\"vtkZLibDataCompressor\""));
  expect_all_of(text, grid);
}

// 4096 numbers of eight bytes fill one block exactly: the last block is full.
TEST(VtuFile, CompressesNumbersThatFillTheirBlocks) {
  UnstructuredGrid grid;
  grid.points = Eigen::Matrix3Xd::Zero(3, 4096);
  grid.cells.push_back({CellType::vertex, {0}});
  Eigen::MatrixXd numbers = Eigen::MatrixXd::Zero(1, 4096);
  numbers(0, 4095) = 0.1;
  grid.point_data.push_back({"numbers", numbers});
  const auto read = array<double>(text_of(grid), "numbers");
  ASSERT_EQ(read.size(), 4096U);
  EXPECT_EQ(read.back(), 0.1);
}

TEST(VtuFile, KeepsNan) {
  auto grid = random_grid(2);
  std::get<Eigen::MatrixXd>(grid.cell_data[0].values)(0, 0) =
      std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(array<double>(text_of(grid), "numbers").at(0)));
}

TEST(PvdFile, ListsFilesInTheirOrder) {
  std::ostringstream out;
  write_pvd(out, {{"a.vtu", 1}, {"b & c.vtu", 2}}, "two--things");
  EXPECT_THAT(out.str(), HasSubstr("<!-- two- -things -->"));
  EXPECT_THAT(out.str(), HasSubstr("<DataSet timestep=\"1\" part=\"0\" file=\"a.vtu\"/>\n"
                                   "<DataSet timestep=\"2\" part=\"0\" file=\"b &amp; c.vtu\"/>"));
}

}  // namespace
