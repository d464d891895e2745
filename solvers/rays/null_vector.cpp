// Null vector by elimination in either precision, and iterative refinement of the result in
// doubles.
#include "solvers/rays/null_vector.hpp"

#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace kusabi::rays {
namespace {

/// Relative size of a correction after which the error is below the last digit of a double: a
/// correction in doubles has a relative error of about its own size.
constexpr double small_correction = 1e-9;

/// If elimination in doubles has some correct digits, the second correction is small enough.
constexpr int max_corrections = 3;

template <class Scalar>
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
template <class Scalar>
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

/// P A Q = L U, of which the leading n - 1 rows and columns are used.
template <class Scalar>
class PivotedElimination {
 public:
  explicit PivotedElimination(Matrix<Scalar> equalities)
      : lu_(std::move(equalities)),
        rank_(lu_.cols() - 1),
        rows_(static_cast<std::size_t>(lu_.rows())),
        columns_(static_cast<std::size_t>(lu_.cols())) {
    std::iota(rows_.begin(), rows_.end(), 0);
    std::iota(columns_.begin(), columns_.end(), 0);
    eliminate();
  }

  Eigen::Index rank() const { return rank_; }
  /// True if all expected pivots were found.
  bool complete() const { return pivots_ == rank_; }
  /// Row, or column, of A at a position.
  Eigen::Index row(Eigen::Index place) const { return rows_[static_cast<std::size_t>(place)]; }
  Eigen::Index column(Eigen::Index place) const {
    return columns_[static_cast<std::size_t>(place)];
  }

  /// The null vector by positions, with 1 at the last.
  Vector<Scalar> null_vector() const {
    Vector<Scalar> x(rank_ + 1);
    x(rank_) = 1;
    x.head(rank_) = -upper().solve(lu_.col(rank_).head(rank_));
    return x;
  }

  /// Correction to be subtracted from the first numbers of x, by positions, such that `residual` of
  /// the first rows of A x, by positions, vanishes.
  Vector<Scalar> correction(const Vector<Scalar>& residual) const {
    return upper().solve(square().template triangularView<Eigen::UnitLower>().solve(residual));
  }

 private:
  auto square() const { return lu_.topLeftCorner(rank_, rank_); }
  auto upper() const {
    return lu_.topLeftCorner(rank_, rank_).template triangularView<Eigen::Upper>();
  }

  struct Pivot {
    Eigen::Index row = 0;
    Eigen::Index column = 0;
    Scalar size = 0;
  };

  // The largest of the entries from `step` on, each given by `entry`, column by column.
  template <class Entry>
  Pivot largest(Eigen::Index step, const Entry& entry) const {
    Pivot pivot;
    for (Eigen::Index j = step; j < lu_.cols(); ++j) {
      for (Eigen::Index i = step; i < lu_.rows(); ++i) {
        const Scalar size = std::abs(entry(i, j));
        if (size > pivot.size) pivot = {i, j, size};
      }
    }
    return pivot;
  }

  void eliminate() {
    Pivot pivot = largest(0, [&](auto i, auto j) { return lu_(i, j); });
    for (Eigen::Index step = 0; step < rank_ && pivot.size > 0; ++step, ++pivots_) {
      exchange(step, pivot);
      const Eigen::Index below = lu_.rows() - step - 1;
      lu_.col(step).tail(below) /= lu_(step, step);
      pivot = largest(step + 1,
                      [&](auto i, auto j) { return lu_(i, j) -= lu_(i, step) * lu_(step, j); });
    }
  }

  void exchange(Eigen::Index step, const Pivot& pivot) {
    if (pivot.row != step) lu_.row(step).swap(lu_.row(pivot.row));
    if (pivot.column != step) lu_.col(step).swap(lu_.col(pivot.column));
    const auto at = static_cast<std::size_t>(step);
    std::swap(rows_[at], rows_[static_cast<std::size_t>(pivot.row)]);
    std::swap(columns_[at], columns_[static_cast<std::size_t>(pivot.column)]);
  }

  Matrix<Scalar> lu_;
  Eigen::Index rank_;
  Eigen::Index pivots_ = 0;
  std::vector<Eigen::Index> rows_;
  std::vector<Eigen::Index> columns_;
};

// Reorders from positions to columns, and normalises.
template <class Scalar>
LongVector in_order(const PivotedElimination<Scalar>& elimination, const LongVector& by_place,
                    Eigen::Index summed) {
  LongVector x(by_place.size());
  for (Eigen::Index place = 0; place < x.size(); ++place) {
    x(elimination.column(place)) = by_place(place);
  }
  if (summed > 0) return x / x.head(summed).sum();
  Eigen::Index largest = 0;
  x.cwiseAbs().maxCoeff(&largest);
  return x / x(largest);
}

}  // namespace

LongVector null_vector(const LongMatrix& equalities, Eigen::Index summed) {
  const PivotedElimination<long double> elimination(equalities);
  return in_order(elimination, elimination.null_vector(), summed);
}

std::optional<Eigen::VectorXd> rounded_null_vector(const LongMatrix& equalities,
                                                   const Eigen::MatrixXd& rounded,
                                                   Eigen::Index summed) {
  const PivotedElimination<double> elimination(rounded);
  if (!elimination.complete()) return std::nullopt;
  const Eigen::Index rank = elimination.rank();
  LongVector x = elimination.null_vector().cast<long double>();
  LongMatrix used(rank, rank + 1);
  for (Eigen::Index j = 0; j <= rank; ++j) {
    for (Eigen::Index i = 0; i < rank; ++i) {
      used(i, j) = equalities(elimination.row(i), elimination.column(j));
    }
  }
  for (int done = 0; done < max_corrections; ++done) {
    const LongVector residual = used * x;
    const Eigen::VectorXd correction = elimination.correction(residual.cast<double>());
    x.head(rank) -= correction.cast<long double>();
    const Eigen::ArrayXd size = x.head(rank).cast<double>().array().abs();
    if ((correction.array().abs() <= small_correction * size).all()) {
      return in_order(elimination, x, summed).cast<double>();
    }
  }
  return std::nullopt;
}

}  // namespace kusabi::rays
