// Elimination of the cuts: first the blocks, then the border. The header states the equations.
#include "solvers/conic/cut_elimination.hpp"

#include <cmath>

#include "solvers/conic/pack.hpp"

namespace kusabi::conic {

template <int D, class Real>
CutElimination<D, Real>::CutElimination(int max_rows, int max_cuts, int max_cones)
    : cut_of_cone_(static_cast<std::size_t>(max_cones), -1) {
  cuts_.reserve(static_cast<std::size_t>(max_cuts));
  if (max_cuts == 0) return;
  const Eigen::Index room = padded<Real>(max_rows + 1);
  outer_.setZero(room * padded<Real>(max_cuts));
  border_.setZero(room);
  shares_.setZero(padded<Real>(max_cuts));
}

template <int D, class Real>
void CutElimination<D, Real>::start(const NodeProgram<D, Real>& program) {
  for (const auto& cut : cuts_)
    if (cut.row.cone >= 0) cut_of_cone_[static_cast<std::size_t>(cut.row.cone)] = -1;
  cuts_.clear();
  first_cut_ = program.first_cut();
  rows_ = first_cut_ + 1;
  for (const auto& row : program.cut_rows()) {
    if (row.cone >= 0)
      cut_of_cone_[static_cast<std::size_t>(row.cone)] = static_cast<int>(cuts_.size());
    cuts_.push_back({.row = row});
  }
}

template <int D, class Real>
void CutElimination<D, Real>::begin(const VectorOf<Real>& w) {
  Eigen::Index place = first_cut_;
  for (auto& cut : cuts_) {
    const Real own = w[place++];
    const Real gap = w[cut.row.candidate];
    const Real a = cut.row.displacement;
    cut.cut_weight = own * own;
    cut.gap_weight = gap * gap;
    cut.delta = cut.cut_weight + a * a * cut.gap_weight;
  }
}

// With h = (f, a w_i) the block is diag(W, w_i) (I - h h' / delta) diag(W, w_i). Block Cholesky of
// the middle factor: T = I - tau f f' is the root of I - f f' / delta, and leaves -(a w_i / (delta
// sqrt(rest))) f below, and w_cut^2 / (w_cut^2 + a^2 w_i^2) on the diagonal, where delta rest =
// w_cut^2 + a^2 w_i^2.
template <int D, class Real>
auto CutElimination<D, Real>::share(int cone, const Square& scaling) -> Share {
  const int at = cut_of_cone_[static_cast<std::size_t>(cone)];
  if (at < 0) return {.root = scaling};
  Own& cut = cuts_[static_cast<std::size_t>(at)];
  cut.f = cut.row.reaction * scaling.col(0);
  cut.first = scaling * cut.f;
  const Real others = cut.delta;
  cut.delta += cut.f.squaredNorm();
  const Real root_of_rest = root(Real(others / cut.delta));
  const Real tau = 1.0 / (cut.delta * (1 + root_of_rest));
  return {.root = scaling - tau * cut.first * cut.f.transpose(),
          .row = cut.row.candidate,
          .in_row = cut.row.displacement * cut.gap_weight / (cut.delta * root_of_rest) * cut.f};
}

template <int D, class Real>
PackedColumns<Real> CutElimination<D, Real>::outer() const {
  const auto count = static_cast<int>(cuts_.size());
  return {outer_.data(), padded<Real>(rows_), 1, count, padded<Real>(count)};
}

template <int D, class Real>
bool CutElimination<D, Real>::border(const NodeProgram<D, Real>& program) {
  const PackedColumns<Real> matrix = program.matrix();
  const PackedColumns<Real> outer = this->outer();
  outer_.head(Eigen::Index{outer.rows} * outer.stride).setZero();
  shares_.setZero();
  kappa_ = Real(0);
  Eigen::Index j = 0;
  for (const auto& [row, cut_weight, gap_weight, f, first, delta] : cuts_) {
    auto p = outer_.segment(j * outer.rows, outer.rows);
    if (row.cone >= 0) {
      for (int d = 0; d < D; ++d)
        p.head(matrix.rows) +=
            first[d] * Eigen::Map<const VectorOf<Real>>(
                           matrix.data + Eigen::Index{d * matrix.stride + row.cone} * matrix.rows,
                           matrix.rows);
      p[rows_ - 1] = first[0];
    }
    p[row.candidate] -= row.displacement * gap_weight;
    shares_[j++] = row.gamma / delta;
    kappa_ += row.gamma * row.gamma / delta;
  }
  product(outer, shares_.data(), border_.data());
  border_[rows_ - 1] -= 1;
  return kappa_ > 0 && std::isfinite(numbers::rounded(kappa_));
}

template <int D, class Real>
void CutElimination<D, Real>::complete(VectorOf<Real>& weights,
                                       NormalEquations<Real>& equations) const {
  for (const auto& cut : cuts_) {
    const Real a = cut.row.displacement;
    weights[cut.row.candidate] *= cut.cut_weight / (cut.cut_weight + a * a * cut.gap_weight);
  }
  equations.add_square(border_.data(), 1.0 / kappa_);
}

template <int D, class Real>
void CutElimination<D, Real>::reduce(const VectorOf<Real>& whole, VectorOf<Real>& reduced) const {
  shares_.setZero();
  Real phi = 0;
  Eigen::Index j = 0;
  for (const auto& cut : cuts_) {
    const Real own = whole[first_cut_ + j] + cut.row.displacement * whole[cut.row.candidate];
    shares_[j] = own / cut.delta;
    phi += cut.row.gamma * shares_[j++];
  }
  product(outer(), shares_.data(), reduced.data());
  reduced.head(first_cut_) += whole.head(first_cut_);
  reduced.head(rows_) -= phi / kappa_ * border_.head(rows_);
}

template <int D, class Real>
void CutElimination<D, Real>::expand(const VectorOf<Real>& solution, VectorOf<Real>& whole) const {
  Real phi = 0;
  Eigen::Index j = 0;
  for (const auto& cut : cuts_) {
    auto& own = whole[first_cut_ + j++];
    own += cut.row.displacement * whole[cut.row.candidate];
    phi += cut.row.gamma * own / cut.delta;
  }
  const Real sigma = (phi + border_.head(rows_).dot(solution.head(rows_))) / kappa_;
  transposed_product(outer(), solution.data(), shares_.data());
  whole.head(first_cut_) = solution.head(first_cut_);
  j = 0;
  for (const auto& cut : cuts_) {
    auto& eta = whole[first_cut_ + j];
    eta = (eta + shares_[j++] - cut.row.gamma * sigma) / cut.delta;
    whole[cut.row.candidate] += cut.row.displacement * eta;
  }
}

template <int D, class Real>
auto CutElimination<D, Real>::part_of(int candidate, VectorOf<Real>& along) const -> Part {
  along.setZero();
  const Eigen::Index height = padded<Real>(rows_);
  Eigen::Index j = 0;
  for (const auto& [row, cut_weight, gap_weight, f, first, delta] : cuts_) {
    const auto p = outer_.segment(j++ * height, height);
    if (row.candidate != candidate) continue;
    along.head(height) = (p - row.gamma / kappa_ * border_.head(height)) / delta;
    return {.cone = f,
            .slack = row.displacement * root(gap_weight),
            .weight = (1.0 - row.gamma * row.gamma / (delta * kappa_)) / delta};
  }
  return {};
}

template class CutElimination<2, double>;
template class CutElimination<3, double>;
template class CutElimination<2, long double>;
template class CutElimination<3, long double>;
template class CutElimination<2, numbers::Precise>;
template class CutElimination<3, numbers::Precise>;

}  // namespace kusabi::conic
