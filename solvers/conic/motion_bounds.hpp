// What it takes to mend the equations that the motions of a loose body add to a node program, so
// that its bounds hold in spite of rounding (docs/theory/wedged.md, "Loose bodies").
//
// From below, a reaction must be in equilibrium, G'r = 0, and u_n = F_n r + H alpha = 0 on U, H the
// normal rows of G. From above, normal forces y must be in equilibrium, H'y = 0: a motion may be of
// any size, so nothing else keeps it from changing y'u_n.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace kusabi::conic {

/// Bounds for one G, in doubles; sizes of F are given by R_i = sqrt(F_ii).
class MotionBounds {
 public:
  MotionBounds() = default;

  /// @param motions G, D rows a cone  @param lifting how many columns have normal parts
  /// @param roots R of all rows of F  @param first_rows row (n, i) of each candidate
  MotionBounds(Eigen::MatrixXd motions, int lifting, double error, Eigen::VectorXd roots,
               std::vector<Eigen::Index> first_rows)
      : motions_(std::move(motions)),
        roots_(std::move(roots)),
        first_rows_(std::move(first_rows)),
        lifting_(lifting),
        error_(error) {
    least_root_ = roots_.size() == 0 ? 0 : roots_.minCoeff();
    largest_ = motions_.size() == 0 ? 0 : motions_.cwiseAbs().maxCoeff();
  }

  [[nodiscard]] bool any() const { return motions_.cols() > 0; }
  [[nodiscard]] int count() const { return static_cast<int>(motions_.cols()); }
  [[nodiscard]] double least_root() const { return least_root_; }

  /// By what an entry of G may be wrong.
  [[nodiscard]] double error() const { return error_; }

  /// By how much H a of motions `a`, and its like, may be wrong: times the sum of the sizes.
  [[nodiscard]] double noise(double rounding) const {
    return error_ + rounding * std::max(largest_, 1.0);
  }

  /// The size |R delta| of the reactions on the cones of C that carry a load of size 1 on the
  /// motions; infinite if there are none.
  /// @param cones C, D rows each
  [[nodiscard]] double carry(std::span<const int> cones, int dimension) const {
    Eigen::MatrixXd part(static_cast<Eigen::Index>(cones.size()) * dimension, motions_.cols());
    Eigen::Index row = 0;
    for (const int k : cones)
      for (int d = 0; d < dimension; ++d, ++row)
        part.row(row) = motions_.row(dimension * k + d) / roots_[dimension * k + d];
    return inverse_of_least(part, negligible);
  }

  /// The size of the motion that makes gaps of size 1 (over R) on the candidates of U, if some
  /// does.
  [[nodiscard]] double close(std::span<const int> contact) const {
    Eigen::MatrixXd part(static_cast<Eigen::Index>(contact.size()), lifting_);
    Eigen::Index row = 0;
    for (const int i : contact) {
      const auto at = first_rows_[static_cast<std::size_t>(i)];
      part.row(row++) = motions_.row(at).head(lifting_) / roots_[at];
    }
    return inverse_of_least(part, negligible);
  }

  /// |H_j|: by how much a motion of size 1 moves a candidate along its normal.
  [[nodiscard]] double lift(int candidate) const {
    return motions_.row(first_rows_[static_cast<std::size_t>(candidate)]).head(lifting_).norm() +
           error_ * lifting_;
  }

  /// The share of each y_j that brings normal forces into equilibrium, if all change by at most
  /// this share; more than 1 if they cannot.
  /// @param rows candidates with a force  @param sizes by how much each may change
  /// @param y what is to be balanced  @param total the sizes of all that y was summed of
  /// @param whole whether no force may be left out of what can be balanced
  template <class Forces>
  [[nodiscard]] double balance(std::span<const int> rows, const std::vector<double>& sizes,
                               const Forces& y, double total, double rounding, bool whole) const {
    Eigen::VectorXd load = Eigen::VectorXd::Zero(lifting_);
    Eigen::MatrixXd part(static_cast<Eigen::Index>(rows.size()), lifting_);
    for (std::size_t place = 0; place < rows.size(); ++place) {
      const auto at = first_rows_[static_cast<std::size_t>(rows[place])];
      part.row(static_cast<Eigen::Index>(place)) = sizes[place] * motions_.row(at).head(lifting_);
      load += y[place] * motions_.row(at).head(lifting_).transpose();
    }
    const double size = load.norm() + total * noise(rounding) * std::sqrt(double(lifting_));
    if (size == 0) return 0;
    return size * inverse_of_least(part, whole ? 0 : negligible);
  }

 private:
  /// Singular values below this part of the largest are those of motions that nothing of a part
  /// takes part in, up to the rounding of places and directions in the file.
  static constexpr double negligible = 1e-10;

  /// One over the least singular value that counts; zero of a matrix that is zero.
  static double inverse_of_least(const Eigen::MatrixXd& part, double negligible_share) {
    if (part.size() == 0) return 0;
    Eigen::VectorXd values;
    if (part.rows() > part.cols()) {
      const Eigen::HouseholderQR<Eigen::MatrixXd> factor(part);
      const Eigen::MatrixXd small =
          factor.matrixQR().topRows(part.cols()).triangularView<Eigen::Upper>();
      values = Eigen::JacobiSVD<Eigen::MatrixXd>(small).singularValues();
    } else {
      values = Eigen::JacobiSVD<Eigen::MatrixXd>(part).singularValues();
      if (negligible_share == 0 && part.rows() < part.cols())
        return std::numeric_limits<double>::infinity();
    }
    const double floor = negligible_share * values[0];
    double least = std::numeric_limits<double>::infinity();
    for (const double value : values)
      if (value > floor || negligible_share == 0) least = std::min(least, value);
    return std::isfinite(least) ? 1.001 / least : 0;
  }

  Eigen::MatrixXd motions_;
  Eigen::VectorXd roots_;
  std::vector<Eigen::Index> first_rows_;
  int lifting_ = 0;
  double error_ = 0;
  double least_root_ = 0;
  double largest_ = 0;
};

}  // namespace kusabi::conic
