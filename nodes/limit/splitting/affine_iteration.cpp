// Steps and epochs.
#include "nodes/limit/splitting/affine_iteration.hpp"

#include <algorithm>
#include <cmath>

#include "nodes/limit/splitting/block_sweep.hpp"

namespace kusabi::limit::splitting {
namespace {

/// An epoch ends when the residual is this share of its initial value, or below the second share
/// and increasing.
constexpr double much_less = 0.2;
constexpr double less = 0.8;

/// An epoch also ends when it has this share of all steps, and some more.
constexpr double longest_share = 0.36;
constexpr double longest = 50;

}  // namespace

AffineIteration::AffineIteration(const AffineProgram& program, AffineProjection& projection,
                                 const Sharing& sharing)
    : program_(program),
      projection_(projection),
      sharing_(sharing),
      rows_(program.capacity, sharing),
      z_(program.rows(), static_cast<int>(program.columns.size()), sharing),
      y_(z_),
      motion_(Eigen::VectorXd::Zero(program.displacements())) {}

// 2 x - z, where x is z moved towards zero by the threshold of its row; lambda_0 is moved up
// instead.
KUSABI_INLINE Segment AffineIteration::reflected(bool first, int row, const Segment& z) const {
  const Lanes threshold = rows_.threshold(row);
  Segment w;
  for (int h = 0; h < block_lanes; ++h) {
    w.part[h] = z.part[h] - 2 * clamped(z.part[h], -threshold, threshold);
  }
  if (first && row == program_.members()) w.part[0][0] = factor_ + 2 * rows_.threshold(row);
  return w;
}

KUSABI_ALSO_FOR_AVX2 void AffineIteration::move(double relaxation, double share) {
  const int members = program_.members();
  const auto is_first = [](const BlockPlace& place) { return place.first_column() == 0; };
  // By group: the square, and lambda_0, which only the first one has.
  std::vector<double> results(2 * static_cast<std::size_t>(z_.groups()), 0.0);
  Segment sum{};
  const double old_factor = factor_;
  const auto& metric = projection_.metric();
  sweep(
      projection_, program_.columns, z_,
      [&](const BlockPlace& place, int row, const Segment& z) {
        return reflected(is_first(place), row, z);
      },
      [&](const BlockPlace& place, int row, const Segment& /*w*/, Segment& y) {
        auto* const result = results.data() + 2 * static_cast<std::size_t>(place.group);
        const double weight = 1 / metric(row);
        if (row == members && is_first(place)) {
          const double apart = y.part[0][0] - old_factor - rows_.threshold(row);
          result[0] += apart * apart * weight;
          result[1] = share * anchor_factor_ + (1 - share) * (old_factor + relaxation * apart);
          y.part[0][0] = 0;
        }
        auto* const z = z_.block(place.group, place.number) + row;
        const auto* const anchor = anchor_.data() + (z - z_.numbers().data());
        const Lanes threshold = rows_.threshold(row);
        for (int h = 0; h < block_lanes; ++h) {
          Lanes& own = z->part[h];
          const Lanes apart = y.part[h] - own + clamped(own, -threshold, threshold);
          sum.part[h] += weight * apart * apart;
          own = share * anchor->part[h] + (1 - share) * (own + relaxation * apart);
        }
        if (row < members) return;
        result[0] += sum_of(sum);
        sum = {};
        if (is_first(place)) motion_ = projection_.multipliers(0);
      });
  const auto sums = added(results, 2, sharing_);
  factor_ = sums[1];
  residual_ = std::sqrt(sums[0]);
}

void AffineIteration::step(double target) {
  if (epoch_ == 0) {
    anchor_ = z_.numbers();
    anchor_factor_ = factor_;
  }
  rows_.find(z_, factor_, target);
  move(2, 1.0 / (epoch_ + 2));
  ++steps_;
  end_of_epoch();
}

void AffineIteration::end_of_epoch() {
  if (epoch_ == 0) first_residual_ = residual_;
  ++epoch_;
  const bool ends =
      epoch_ > 1 && (residual_ <= much_less * first_residual_ ||
                     (residual_ <= less * first_residual_ && residual_ > last_residual_) ||
                     epoch_ >= longest_share * steps_ + longest);
  last_residual_ = residual_;
  if (!ends) return;
  epoch_ = 0;
  last_residual_ = std::numeric_limits<double>::infinity();
}

Eigen::VectorXd AffineIteration::motion() const {
  std::vector<double> numbers(static_cast<std::size_t>(z_.groups() * program_.displacements()));
  if (z_.first_group() == 0 && z_.end_group() > 0) {
    std::ranges::copy(motion_, numbers.begin());
  }
  sharing_.fill(numbers);
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), program_.displacements());
}

const ColumnBlocks& AffineIteration::affine_point() {
  sweep(
      projection_, program_.columns, z_,
      [&](const BlockPlace& place, int row, const Segment& z) {
        return reflected(place.first_column() == 0, row, z);
      },
      [&](const BlockPlace& place, int row, const Segment& /*w*/, const Segment& y) {
        y_.block(place.group, place.number)[row] = y;
      });
  return y_;
}

double AffineIteration::row_point(int row, int column) const {
  const double z = z_.at(row, column);
  const double threshold = rows_.threshold(row);
  return z - std::clamp(z, -threshold, threshold);
}

}  // namespace kusabi::limit::splitting
