// Elimination of the cuts: first the blocks, then the border. The header states the equations.
#include "solvers/conic/cut_elimination.hpp"

#include <cmath>

#include "solvers/conic/pack.hpp"

namespace kusabi::conic {

template <int D>
CutElimination<D>::CutElimination(int most_rows, int most_cuts, int most_cones)
    : cut_of_cone_(static_cast<std::size_t>(most_cones), -1) {
  cuts_.reserve(static_cast<std::size_t>(most_cuts));
  if (most_cuts == 0) return;
  const Eigen::Index room = padded(most_rows + 1);
  outer_.setZero(room * padded(most_cuts));
  border_.setZero(room);
  shares_.setZero(padded(most_cuts));
}

template <int D>
void CutElimination<D>::start(const NodeProgram<D>& program) {
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

template <int D>
void CutElimination<D>::begin(const Eigen::VectorXd& w) {
  Eigen::Index place = first_cut_;
  for (auto& cut : cuts_) {
    const double own = w[place++];
    const double gap = w[cut.row.candidate];
    const double a = cut.row.displacement;
    cut.cut_weight = own * own;
    cut.gap_weight = gap * gap;
    cut.delta = cut.cut_weight + a * a * cut.gap_weight;
  }
}

// With h = (f, a w_i) the block is diag(W, w_i) (I - h h' / delta) diag(W, w_i). Block Cholesky of
// the middle factor: T = I - tau f f' is the root of I - f f' / delta, and leaves -(a w_i / (delta
// sqrt(rest))) f below, and w_cut^2 / (w_cut^2 + a^2 w_i^2) on the diagonal, where delta rest =
// w_cut^2 + a^2 w_i^2.
template <int D>
auto CutElimination<D>::share(int cone, const Square& scaling) -> Share {
  const int at = cut_of_cone_[static_cast<std::size_t>(cone)];
  if (at < 0) return {.root = scaling};
  Own& cut = cuts_[static_cast<std::size_t>(at)];
  cut.f = cut.row.reaction * scaling.col(0);
  cut.first = scaling * cut.f;
  const double others = cut.delta;
  cut.delta += cut.f.squaredNorm();
  const double root_of_rest = std::sqrt(others / cut.delta);
  const double tau = 1 / (cut.delta * (1 + root_of_rest));
  return {.root = scaling - tau * cut.first * cut.f.transpose(),
          .row = cut.row.candidate,
          .in_row = cut.row.displacement * cut.gap_weight / (cut.delta * root_of_rest) * cut.f};
}

template <int D>
PackedColumns CutElimination<D>::outer() const {
  const auto count = static_cast<int>(cuts_.size());
  return {outer_.data(), padded(rows_), 1, count, padded(count)};
}

template <int D>
bool CutElimination<D>::border(const NodeProgram<D>& program) {
  const PackedColumns matrix = program.matrix();
  const PackedColumns outer = this->outer();
  outer_.head(Eigen::Index{outer.rows} * outer.stride).setZero();
  shares_.setZero();
  kappa_ = 0;
  Eigen::Index j = 0;
  for (const auto& [row, cut_weight, gap_weight, f, first, delta] : cuts_) {
    auto p = outer_.segment(j * outer.rows, outer.rows);
    if (row.cone >= 0) {
      for (int d = 0; d < D; ++d)
        p.head(matrix.rows) +=
            first[d] * Eigen::Map<const Eigen::VectorXd>(
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
  return kappa_ > 0 && std::isfinite(kappa_);
}

template <int D>
void CutElimination<D>::complete(Eigen::VectorXd& weights, NormalEquations& equations) const {
  for (const auto& cut : cuts_) {
    const double a = cut.row.displacement;
    weights[cut.row.candidate] *= cut.cut_weight / (cut.cut_weight + a * a * cut.gap_weight);
  }
  equations.add_square(border_.data(), 1 / kappa_);
}

template <int D>
void CutElimination<D>::reduce(const Eigen::VectorXd& whole, Eigen::VectorXd& reduced) const {
  shares_.setZero();
  double phi = 0;
  Eigen::Index j = 0;
  for (const auto& cut : cuts_) {
    const double own = whole[first_cut_ + j] + cut.row.displacement * whole[cut.row.candidate];
    shares_[j] = own / cut.delta;
    phi += cut.row.gamma * shares_[j++];
  }
  product(outer(), shares_.data(), reduced.data());
  reduced.head(first_cut_) += whole.head(first_cut_);
  reduced.head(rows_) -= phi / kappa_ * border_.head(rows_);
}

template <int D>
void CutElimination<D>::expand(const Eigen::VectorXd& solution, Eigen::VectorXd& whole) const {
  double phi = 0;
  Eigen::Index j = 0;
  for (const auto& cut : cuts_) {
    auto& own = whole[first_cut_ + j++];
    own += cut.row.displacement * whole[cut.row.candidate];
    phi += cut.row.gamma * own / cut.delta;
  }
  const double sigma = (phi + border_.head(rows_).dot(solution.head(rows_))) / kappa_;
  transposed_product(outer(), solution.data(), shares_.data());
  whole.head(first_cut_) = solution.head(first_cut_);
  j = 0;
  for (const auto& cut : cuts_) {
    auto& eta = whole[first_cut_ + j];
    eta = (eta + shares_[j++] - cut.row.gamma * sigma) / cut.delta;
    whole[cut.row.candidate] += cut.row.displacement * eta;
  }
}

template <int D>
auto CutElimination<D>::part_of(int candidate, Eigen::VectorXd& along) const -> Part {
  along.setZero();
  const Eigen::Index height = padded(rows_);
  Eigen::Index j = 0;
  for (const auto& [row, cut_weight, gap_weight, f, first, delta] : cuts_) {
    const auto p = outer_.segment(j++ * height, height);
    if (row.candidate != candidate) continue;
    along.head(height) = (p - row.gamma / kappa_ * border_.head(height)) / delta;
    return {.cone = f,
            .slack = row.displacement * std::sqrt(gap_weight),
            .weight = (1 - row.gamma * row.gamma / (delta * kappa_)) / delta};
  }
  return {};
}

template class CutElimination<2>;
template class CutElimination<3>;

}  // namespace kusabi::conic
