// Banner, comments, size and numbers.
#include "problems/files/matrices/matrix_market.hpp"

#include <cstdint>
#include <iomanip>
#include <ostream>
#include <utility>

#include <fmt/format.h>

#include "problems/files/abaqus/abaqus_text.hpp"
#include "problems/files/meshes/mesh_text.hpp"
#include "support/input_error.hpp"

namespace kusabi::problems {
namespace {

constexpr std::string_view banner = "%%MATRIXMARKET";

class MarketReader {
 public:
  MarketReader(std::string_view text, const std::string& file) : in_(text, file, " ") {
    data_.file = file;
  }

  MatrixData read();

 private:
  void head();
  void size();
  void array();
  void coordinates();
  bool next_entry();
  void require_entry(std::int64_t number, std::int64_t count, std::size_t fields);

  MeshText in_;
  MatrixData data_;
  bool is_array_ = false;
  std::int64_t count_ = 0;  // of entries, for coordinates only
};

// "%%MatrixMarket matrix coordinate real symmetric"
void MarketReader::head() {
  const bool any = in_.next_line();
  if (!any || !is_matrix_market(in_.line())) {
    in_.fail("the file does not begin with %%MatrixMarket; expected a Matrix Market file");
  }
  const auto word = [&](std::size_t index, std::string_view expected) {
    if (index >= in_.fields()) in_.fail(index, fmt::format("the line ends; expected {}", expected));
    return capitals(in_.field(index));
  };
  const auto refuse = [&](std::size_t index, std::string_view expected) {
    in_.fail(index, fmt::format("a matrix that is {}; expected {}",
                                support::in_quotes(in_.field(index)), expected));
  };
  if (word(1, "matrix") != "MATRIX") refuse(1, "matrix");
  const auto layout = word(2, "coordinate or array");
  if (layout != "COORDINATE" && layout != "ARRAY") refuse(2, "coordinate or array");
  is_array_ = layout == "ARRAY";
  const auto numbers = word(3, "real or integer");
  if (numbers != "REAL" && numbers != "DOUBLE" && numbers != "INTEGER") {
    refuse(3, "real or integer numbers, as a stiffness has");
  }
  const auto symmetry = word(4, "symmetric or general");
  if (symmetry != "SYMMETRIC" && symmetry != "GENERAL") {
    refuse(4, "symmetric, or general with symmetric entries");
  }
  data_.one_triangle = symmetry == "SYMMETRIC";
}

bool MarketReader::next_entry() {
  while (in_.next_line()) {
    if (in_.fields() > 0 && !in_.field(0).starts_with('%')) return true;
  }
  return false;
}

void MarketReader::size() {
  const std::string_view expected =
      is_array_ ? "the numbers of rows and columns" : "the numbers of rows, columns and entries";
  if (!next_entry()) in_.fail(fmt::format("the file ends; expected {}", expected));
  if (in_.fields() != (is_array_ ? 2U : 3U)) {
    in_.fail(fmt::format("the line has {} numbers; expected {}", in_.fields(), expected));
  }
  const int rows = in_.whole(0, "the number of rows", 1);
  const int columns = in_.whole(1, "the number of columns", 1);
  if (!is_array_) count_ = in_.whole(2, "the number of entries", 1);
  if (rows != columns || rows > max_matrix_rows) {
    in_.fail(fmt::format("the matrix is {} x {}; expected a square one of at most {} rows", rows,
                         columns, max_matrix_rows));
  }
  data_.size = rows;
  data_.size_line = in_.number();
}

void MarketReader::require_entry(std::int64_t number, std::int64_t count, std::size_t fields) {
  if (!next_entry()) {
    in_.fail(fmt::format("the file ends; expected entry {} of {}", number, count));
  }
  if (in_.fields() != fields) {
    in_.fail(fmt::format("the line has {} numbers; expected {}", in_.fields(),
                         fields == 1 ? "one" : "a row, a column and a value"));
  }
}

void MarketReader::array() {
  const std::int64_t n = data_.size;
  const std::int64_t count = data_.one_triangle ? n * (n + 1) / 2 : n * n;
  std::int64_t number = 0;
  for (int column = 0; column < data_.size; ++column) {
    for (int row = data_.one_triangle ? column : 0; row < data_.size; ++row) {
      require_entry(++number, count, 1);
      data_.add({row, column, in_.real(0, "an entry"), in_.number()}, in_.field(0));
    }
  }
}

void MarketReader::coordinates() {
  const auto index = [&](std::size_t field, std::string_view called) {
    const int value = in_.whole(field, called, 1);
    if (value > data_.size) {
      in_.fail(field, fmt::format("{} is {}; expected at most {}", called, value, data_.size));
    }
    return value - 1;
  };
  for (std::int64_t number = 1; number <= count_; ++number) {
    require_entry(number, count_, 3);
    const int row = index(0, "a row");
    const int column = index(1, "a column");
    data_.add({row, column, in_.real(2, "an entry"), in_.number()}, in_.field(2));
  }
}

MatrixData MarketReader::read() {
  head();
  size();
  is_array_ ? array() : coordinates();
  if (next_entry()) in_.fail("the file continues after the last entry; expected its end");
  return std::move(data_);
}

}  // namespace

bool is_matrix_market(std::string_view text) {
  return capitals(text.substr(0, banner.size())) == banner;
}

MatrixData read_matrix_market(std::string_view text, const std::string& file) {
  return MarketReader(text, file).read();
}

void write_matrix_market(std::ostream& out, const Eigen::MatrixXd& matrix,
                         std::span<const std::string> comments) {
  constexpr int all_digits = 17;
  out << "%%MatrixMarket matrix array real symmetric\n";
  for (const auto& line : comments) out << "% " << line << '\n';
  out << matrix.rows() << ' ' << matrix.cols() << '\n' << std::setprecision(all_digits);
  for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
    for (Eigen::Index row = column; row < matrix.rows(); ++row) out << matrix(row, column) << '\n';
  }
}

}  // namespace kusabi::problems
