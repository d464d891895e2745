// Both triangular solves gather, so that sixteen sums stay in registers.
#include "nodes/limit/splitting/affine_projection.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/SparseCholesky>

namespace kusabi::limit::splitting {

using SparseMatrix = Eigen::SparseMatrix<double>;

AffineProjection::AffineProjection(const SparseMatrix& a, Eigen::VectorXd metric)
    : metric_(std::move(metric)) {
  const SparseMatrix gram = a * metric_.asDiagonal() * a.transpose();
  const Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<int>> factor(gram);
  if (factor.info() != Eigen::Success) return;
  definite_ = true;
  const SparseMatrix lower = factor.matrixL();
  const SparseMatrix upper = lower.transpose();
  by_column_ = triangle(lower);
  by_row_ = triangle(upper);
  for (int k = 0; k < lower.rows(); ++k) inverse_diagonal_.push_back(1 / lower.coeff(k, k));
  const auto& order = factor.permutationP().indices();
  order_.assign(order.data(), order.data() + order.size());
  first_.push_back(0);
  for (int i = 0; i < a.cols(); ++i) {
    for (SparseMatrix::InnerIterator entry(a, i); entry; ++entry) {
      place_.push_back(order_[static_cast<std::size_t>(entry.row())]);
      value_.push_back(entry.value());
      scaled_.push_back(entry.value() * metric_(i));
    }
    first_.push_back(place_.size());
  }
  solution_.resize(order_.size());
}

AffineProjection::Triangle AffineProjection::triangle(const SparseMatrix& matrix) {
  Triangle triangle;
  triangle.first.push_back(0);
  for (int k = 0; k < matrix.outerSize(); ++k) {
    for (SparseMatrix::InnerIterator entry(matrix, k); entry; ++entry) {
      if (entry.row() == entry.col()) continue;
      triangle.place.push_back(static_cast<int>(entry.row()));
      triangle.value.push_back(entry.value());
    }
    triangle.first.push_back(static_cast<int>(triangle.place.size()));
  }
  return triangle;
}

void AffineProjection::begin(const std::vector<SparseLoad>& loads, int first_column) {
  std::ranges::fill(solution_, Segment{});
  const int end = std::min(static_cast<int>(loads.size()), first_column + block_columns);
  for (int j = first_column; j < end; ++j) {
    const int within = j - first_column;
    for (const auto& [degree, value] : loads[static_cast<std::size_t>(j)]) {
      const auto at = static_cast<std::size_t>(order_[static_cast<std::size_t>(degree)]);
      solution_[at].part[within / lanes][within % lanes] -= value;
    }
  }
}

namespace {

// x_k <- (x_k - sum value_a x_place(a)) / l_kk for one place k.
KUSABI_INLINE void eliminate(Segment* x, std::size_t k, int first, int end, const int* place,
                             const double* value, double inverse) {
  Segment sum = x[k];
  for (int at = first; at < end; ++at) {
    const Segment& other = x[place[at]];
    for (int h = 0; h < block_lanes; ++h) sum.part[h] -= value[at] * other.part[h];
  }
  for (int h = 0; h < block_lanes; ++h) x[k].part[h] = sum.part[h] * inverse;
}

// L L' x = b in place. @param rows L by rows @param columns by columns
KUSABI_ALSO_FOR_AVX2 void solve_both(Segment* x, std::size_t count, const int* row_first,
                                     const int* row_place, const double* row_value,
                                     const int* column_first, const int* column_place,
                                     const double* column_value, const double* inverse) {
  for (std::size_t k = 0; k < count; ++k) {
    eliminate(x, k, row_first[k], row_first[k + 1], row_place, row_value, inverse[k]);
  }
  for (std::size_t k = count; k-- > 0;) {
    eliminate(x, k, column_first[k], column_first[k + 1], column_place, column_value, inverse[k]);
  }
}

}  // namespace

void AffineProjection::solve() {
  solve_both(solution_.data(), solution_.size(), by_row_.first.data(), by_row_.place.data(),
             by_row_.value.data(), by_column_.first.data(), by_column_.place.data(),
             by_column_.value.data(), inverse_diagonal_.data());
}

Eigen::VectorXd AffineProjection::multipliers(int column) const {
  Eigen::VectorXd u(static_cast<Eigen::Index>(order_.size()));
  for (std::size_t k = 0; k < order_.size(); ++k) {
    u(static_cast<Eigen::Index>(k)) =
        solution_[static_cast<std::size_t>(order_[k])].part[column / lanes][column % lanes];
  }
  return u;
}

}  // namespace kusabi::limit::splitting
