// ReactionCone: assembly of A from F and mu, and coordinates of a ray from its zero set.
#include "solvers/rays/reaction_cone.hpp"

#include <bit>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace kusabi::rays {

ReactionCone::ReactionCone(const LongMatrix& compliance, std::span<const double> friction,
                           const LongMatrix& motions)
    : compliance_(compliance), friction_(friction.begin(), friction.end()) {
  const auto m = static_cast<Eigen::Index>(friction.size());
  if (m < 1 || m > 64 || compliance.rows() != 2 * m || compliance.cols() != 2 * m ||
      (motions.cols() > 0 && motions.rows() != 2 * m)) {
    throw std::invalid_argument("a reaction cone takes 2m x 2m numbers, 1 <= m <= 64");
  }
  motions_.moves.resize(2 * m, 0);
  if (motions.cols() > 0) motions_ = combined(motions);
  const Eigen::Index p = motions_.moves.cols();
  LongMatrix by_reaction(m + p, 2 * m);  // u_n and G'r
  by_reaction.topRows(m) = compliance(Eigen::seqN(0, m, 2), Eigen::all);
  by_reaction.bottomRows(p) = motions_.moves.transpose();
  gaps_ = LongMatrix::Zero(m + p, 2 * m + motions_.lifting());
  for (Eigen::Index k = 0; k < m; ++k) {
    const double mu = friction_[static_cast<std::size_t>(k)];
    if (!(mu >= 0) || !std::isfinite(mu)) {
      throw std::invalid_argument("friction coefficients are not negative");
    }
    if (mu == 0) {
      gaps_.col(2 * k) = by_reaction.col(2 * k);
      continue;
    }
    for (Eigen::Index i = 0; i < m + p; ++i) {
      const long double by_normal = by_reaction(i, 2 * k) / (2 * mu);
      const long double by_tangential = by_reaction(i, 2 * k + 1) / 2;
      gaps_(i, 2 * k) = by_normal - by_tangential;
      gaps_(i, 2 * k + 1) = by_normal + by_tangential;
    }
  }
  // Unit of the modes, so that their numbers are of the size of those of reactions.
  unit_ = gaps_.topRows(m).cwiseAbs().maxCoeff();
  gaps_.topRightCorner(m, motions_.lifting()) =
      unit_ * motions_.moves(Eigen::seqN(0, m, 2), Eigen::seqN(0, motions_.lifting()));
  // Rows are scaled by the magnitude of all their entries: the remaining entries in the columns of
  // a ray may consist of the rounding of zeros, which full pivoting must recognise.
  scaled_gaps_ = gaps_;
  for (Eigen::Index i = 0; i < gaps_.rows(); ++i) {
    const long double size = gaps_.row(i).lpNorm<Eigen::Infinity>();
    if (size > 0) scaled_gaps_.row(i) /= size;
  }
  rounded_gaps_ = scaled_gaps_.cast<double>();
}

namespace {

/// Equalities and unknowns that remain for a zero set.
struct Remaining {
  std::vector<int> rows;
  std::vector<int> columns;

  Eigen::Index reactions = 0;  ///< number of columns of reactions

  Remaining(const ZeroSet& zero, const ReactionCone& cone, const ReactionCone::Stage& stage) {
    const int m = cone.candidates();
    for (int i = 0; i < m; ++i) {
      if ((zero.u & bit(i)) != 0) rows.push_back(i);
      if ((zero.p & bit(i)) == 0) columns.push_back(2 * i);
      if ((zero.q & bit(i)) == 0) columns.push_back(2 * i + 1);
    }
    reactions = static_cast<Eigen::Index>(columns.size());
    for (int column = 2 * m; column < cone.unknowns(); ++column) columns.push_back(column);
    for (int k = 0; k < cone.equations(); ++k) {
      if (reactions > 0 && (stage.balanced & bit(k)) != 0) rows.push_back(m + k);
    }
  }

  /// True if there are enough equalities to leave one unknown free, and more than one unknown.
  bool determined() const { return columns.size() > 1 && rows.size() + 1 >= columns.size(); }
};

template <class Vector>
Vector among_all(const Vector& nonzero, const std::vector<int>& columns, Eigen::Index unknowns) {
  Vector x = Vector::Zero(unknowns);
  for (std::size_t place = 0; place < columns.size(); ++place) {
    x(columns[place]) = nonzero(static_cast<Eigen::Index>(place));
  }
  return x;
}

/// Sign of a mode alone, chosen such that it separates.
template <class Vector>
Vector turned(Vector x, const Remaining& left, const LongMatrix& gaps, const ZeroSet& zero,
              Candidates cut) {
  if (left.reactions > 0) return x;
  long double lift = 0;
  for (Candidates rest = cut & ~zero.u; rest != 0; rest &= rest - 1)
    lift += gaps.row(std::countr_zero(rest)).dot(x.template cast<long double>());
  if (lift < 0) x = -x;
  return x;
}

}  // namespace

LongVector ReactionCone::coordinates(const ZeroSet& zero, const Stage& stage) const {
  const Remaining left(zero, *this, stage);
  LongVector nonzero = LongVector::Ones(static_cast<Eigen::Index>(left.columns.size()));
  if (left.determined())
    nonzero = null_vector(scaled_gaps_(left.rows, left.columns), left.reactions);
  return turned(among_all(nonzero, left.columns, unknowns()), left, gaps_, zero, stage.gaps);
}

Eigen::VectorXd ReactionCone::rounded_coordinates(const ZeroSet& zero, const Stage& stage) const {
  const Remaining left(zero, *this, stage);
  if (left.determined()) {
    const auto rounded =
        rounded_null_vector(scaled_gaps_(left.rows, left.columns),
                            rounded_gaps_(left.rows, left.columns), left.reactions);
    if (rounded)
      return turned(among_all(*rounded, left.columns, unknowns()), left, gaps_, zero, stage.gaps);
  }
  return coordinates(zero, stage).cast<double>();
}

LongVector ReactionCone::unknowns_of(const Eigen::VectorXd& reaction) const {
  LongVector x = LongVector::Zero(2 * candidates());
  for (int i = 0; i < candidates(); ++i) {
    const long double mu = friction_[static_cast<std::size_t>(i)];
    const long double normal = reaction(2 * i);
    const long double tangential = reaction(2 * i + 1);
    x(2 * i) = mu == 0 ? normal : mu * normal - tangential;
    if (mu != 0) x(2 * i + 1) = mu * normal + tangential;
  }
  return x;
}

Ray ReactionCone::ray(const ZeroSet& zero, Health& health) const {
  const int m = candidates();
  const LongVector x = coordinates(zero);
  for (int i = 0; i < m; ++i) {
    const auto contradicts = [&](Candidates zeros, long double value) {
      return (zeros & bit(i)) == 0 && !(value > 0);
    };
    if (contradicts(zero.p, x(2 * i)) || contradicts(zero.q, x(2 * i + 1))) ++health.undecided;
  }

  LongVector reaction(2 * m);
  long double normal_sum = 0;
  for (int i = 0; i < m; ++i) {
    const double mu = friction_[static_cast<std::size_t>(i)];
    reaction(2 * i) = mu == 0 ? x(2 * i) : (x(2 * i) + x(2 * i + 1)) / (2 * mu);
    reaction(2 * i + 1) = mu == 0 ? 0 : (x(2 * i + 1) - x(2 * i)) / 2;
    normal_sum += reaction(2 * i);
  }
  const bool loaded = normal_sum > 0;
  if (loaded) reaction /= normal_sum;
  LongVector displacement = compliance_ * reaction;
  if (const auto lifting = motions_.lifting(); lifting > 0) {
    const long double unit = loaded ? unit_ / normal_sum : unit_;
    displacement += unit * motions_.moves.leftCols(lifting) * x.tail(lifting);
    if (!loaded) displacement /= displacement.cwiseAbs().maxCoeff();
  }
  for (int i = 0; i < gaps_.rows(); ++i) {
    const long double magnitude = gaps_.row(i).cwiseAbs().dot(x.cwiseAbs());
    const long double relative = magnitude > 0 ? gaps_.row(i).dot(x) / magnitude : 0;
    const bool vanishes = i >= m || (zero.u & bit(i)) != 0;
    if (health.sign(static_cast<double>(relative)) != (vanishes ? 0 : 1)) ++health.undecided;
    if (i < m && vanishes) displacement(2 * i) = 0;
  }
  return {reaction.cast<double>(), displacement.cast<double>()};
}

}  // namespace kusabi::rays
