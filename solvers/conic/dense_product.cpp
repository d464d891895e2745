// Blocks of rows of both factors are copied, so that their columns lie side by side: a block of B
// stays in the first cache while those of A pass.
#include "solvers/conic/dense_product.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "solvers/conic/block_product.hpp"

namespace kusabi::conic {
namespace {

constexpr int width = lanes<double>;
constexpr int height = block_height<double> * width;

// Some columns of a matrix, by blocks of rows; the last block is padded with zeros.
class CopiedRows {
 public:
  explicit CopiedRows(Eigen::Index rows)
      : blocks_((rows + height - 1) / height),
        numbers_(static_cast<std::size_t>(blocks_ * height * copied_columns)) {}

  void copy(const Eigen::Ref<const Eigen::MatrixXd>& matrix, Eigen::Index first, int count) {
    for (int k = 0; k < count; ++k)
      for (Eigen::Index row = 0; row < matrix.rows(); ++row)
        numbers_[static_cast<std::size_t>((row / height * copied_columns + k) * height +
                                          row % height)] = matrix(row, first + k);
  }

  [[nodiscard]] const double* block(Eigen::Index row) const {
    return numbers_.data() + row * copied_columns;
  }
  [[nodiscard]] Eigen::Index padded_rows() const { return blocks_ * height; }

 private:
  Eigen::Index blocks_;
  std::vector<double> numbers_;
};

// sum += A B' of the copied columns. @param sum padded rows of A by padded rows of B
KUSABI_ALSO_FOR_AVX2 void add_copied(const CopiedRows& a, const CopiedRows& b, int count,
                                     double* sum) {
  const auto rows = a.padded_rows();
  for (Eigen::Index column = 0; column < b.padded_rows(); column += height)
    for (Eigen::Index row = 0; row < rows; row += height)
      for (int part = 0; part < height; part += width) {
        double* const place = sum + (column + part) * rows + row;
        Sums<double, block_height<double>> sums;
        for (int j = 0; j < width; ++j)
          for (int i = 0; i < block_height<double>; ++i)
            sums[j][i] = load(place + j * rows + width * i);
        add_products<block_height<double>>(a.block(row), height, b.block(column) + part, height,
                                           count, sums);
        for (int j = 0; j < width; ++j)
          for (int i = 0; i < block_height<double>; ++i)
            store(place + j * rows + width * i, sums[j][i]);
      }
}

}  // namespace

Eigen::MatrixXd product_with_transpose(const Eigen::Ref<const Eigen::MatrixXd>& a,
                                       const Eigen::Ref<const Eigen::MatrixXd>& b) {
  CopiedRows left(a.rows()), right(b.rows());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(left.padded_rows(), right.padded_rows());
  for (Eigen::Index first = 0; first < a.cols(); first += copied_columns) {
    const auto count = static_cast<int>(std::min<Eigen::Index>(copied_columns, a.cols() - first));
    left.copy(a, first, count);
    right.copy(b, first, count);
    add_copied(left, right, count, sum.data());
  }
  return sum.topLeftCorner(a.rows(), b.rows());
}

}  // namespace kusabi::conic
