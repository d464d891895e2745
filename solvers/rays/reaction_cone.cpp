// From F and mu to A, and from a zero set to a ray.
#include "solvers/rays/reaction_cone.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace kusabi::rays {

ReactionCone::ReactionCone(const PreciseMatrix& compliance, std::span<const double> friction)
    : compliance_(compliance), friction_(friction.begin(), friction.end()) {
  const auto m = static_cast<Eigen::Index>(friction.size());
  if (m < 1 || m > 64 || compliance.rows() != 2 * m || compliance.cols() != 2 * m) {
    throw std::invalid_argument("a reaction cone takes 2m x 2m numbers, 1 <= m <= 64");
  }
  gaps_.resize(m, 2 * m);
  for (Eigen::Index k = 0; k < m; ++k) {
    const double mu = friction_[static_cast<std::size_t>(k)];
    if (!(mu >= 0) || !std::isfinite(mu)) {
      throw std::invalid_argument("friction coefficients are not negative");
    }
    if (mu == 0) {
      gaps_.col(2 * k) = compliance(Eigen::seqN(0, m, 2), 2 * k);
      gaps_.col(2 * k + 1).setZero();
      continue;
    }
    for (Eigen::Index i = 0; i < m; ++i) {
      const long double by_normal = compliance(2 * i, 2 * k) / (2 * mu);
      const long double by_tangential = compliance(2 * i, 2 * k + 1) / 2;
      gaps_(i, 2 * k) = by_normal - by_tangential;
      gaps_(i, 2 * k + 1) = by_normal + by_tangential;
    }
  }
  // Rows of one unit, by the size of all their entries: what is left in the columns of a ray may be
  // no more than the rounding of zeros, and full pivoting must see that.
  scaled_gaps_ = gaps_;
  for (Eigen::Index i = 0; i < m; ++i)
    scaled_gaps_.row(i) /= gaps_.row(i).lpNorm<Eigen::Infinity>();
  rounded_gaps_ = scaled_gaps_.cast<double>();
}

namespace {

/// Which equalities and which unknowns a zero set leaves.
struct Remaining {
  std::vector<int> rows;
  std::vector<int> columns;

  Remaining(const ZeroSet& zero, int candidates) {
    for (int i = 0; i < candidates; ++i) {
      if ((zero.u & bit(i)) != 0) rows.push_back(i);
      if ((zero.p & bit(i)) == 0) columns.push_back(2 * i);
      if ((zero.q & bit(i)) == 0) columns.push_back(2 * i + 1);
    }
  }

  /// Whether there are enough equalities to leave one unknown free, and not just one unknown.
  bool determined() const { return columns.size() > 1 && rows.size() + 1 >= columns.size(); }
};

template <class Vector>
Vector among_all(const Vector& nonzero, const std::vector<int>& columns, int candidates) {
  Vector x = Vector::Zero(2 * candidates);
  for (std::size_t place = 0; place < columns.size(); ++place) {
    x(columns[place]) = nonzero(static_cast<Eigen::Index>(place));
  }
  return x;
}

}  // namespace

PreciseVector ReactionCone::coordinates(const ZeroSet& zero) const {
  const Remaining left(zero, candidates());
  PreciseVector nonzero = PreciseVector::Ones(static_cast<Eigen::Index>(left.columns.size()));
  if (left.determined()) nonzero = null_vector(scaled_gaps_(left.rows, left.columns));
  return among_all(nonzero, left.columns, candidates());
}

Eigen::VectorXd ReactionCone::rounded_coordinates(const ZeroSet& zero) const {
  const Remaining left(zero, candidates());
  if (left.determined()) {
    const auto rounded = rounded_null_vector(scaled_gaps_(left.rows, left.columns),
                                             rounded_gaps_(left.rows, left.columns));
    if (rounded) return among_all(*rounded, left.columns, candidates());
  }
  return coordinates(zero).cast<double>();
}

Ray ReactionCone::ray(const ZeroSet& zero, Health& health) const {
  const int m = candidates();
  const PreciseVector x = coordinates(zero);
  for (int i = 0; i < m; ++i) {
    const auto contradicts = [&](Candidates zeros, long double value) {
      return (zeros & bit(i)) == 0 && !(value > 0);
    };
    if (contradicts(zero.p, x(2 * i)) || contradicts(zero.q, x(2 * i + 1))) ++health.doubtful;
  }

  PreciseVector reaction(2 * m);
  long double normal_sum = 0;
  for (int i = 0; i < m; ++i) {
    const double mu = friction_[static_cast<std::size_t>(i)];
    reaction(2 * i) = mu == 0 ? x(2 * i) : (x(2 * i) + x(2 * i + 1)) / (2 * mu);
    reaction(2 * i + 1) = mu == 0 ? 0 : (x(2 * i + 1) - x(2 * i)) / 2;
    normal_sum += reaction(2 * i);
  }
  reaction /= normal_sum;
  PreciseVector displacement = compliance_ * reaction;
  for (int i = 0; i < m; ++i) {
    const long double magnitude = gaps_.row(i).cwiseAbs().dot(x.cwiseAbs());
    const long double relative = magnitude > 0 ? gaps_.row(i).dot(x) / magnitude : 0;
    const bool vanishes = (zero.u & bit(i)) != 0;
    if (health.sign(static_cast<double>(relative)) != (vanishes ? 0 : 1)) ++health.doubtful;
    if (vanishes) displacement(2 * i) = 0;
  }
  return {reaction.cast<double>(), displacement.cast<double>()};
}

}  // namespace kusabi::rays
