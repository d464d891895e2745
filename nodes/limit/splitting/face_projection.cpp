// Newton's method in one threshold where all numbers have one sign, in two elsewhere.
#include "nodes/limit/splitting/face_projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "nodes/limit/splitting/row_projection.hpp"

namespace kusabi::limit::splitting {
namespace {

constexpr int max_rounds = 60;

/// Number of rounds after which one threshold at a time is changed, which always converges.
constexpr int rounds_of_both = 20;

/// Tolerance of equal thresholds, relative to the larger of one and their size.
constexpr double same = 1e-15;

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

FaceProjection::FaceProjection(const AffineProgram& program, const Face& face,
                               const Sharing& sharing)
    : program_(program),
      face_(face),
      sharing_(sharing),
      upper_(static_cast<std::size_t>(program.rows()), 0.0),
      lower_(upper_),
      signed_(static_cast<std::size_t>(program.rows()), true) {
  const auto members = static_cast<std::size_t>(program.members());
  for (std::size_t i = 0; i < members; ++i) {
    const int stretch = face.stretches[i];
    if (stretch > 0) lower_[i] = infinity;
    if (stretch < 0) upper_[i] = infinity;
    signed_[i] = stretch != 0;
  }
  upper_[members] = infinity;
  const auto columns = program.columns.size();
  works_.resize((columns + block_columns - 1) / block_columns);
  for (std::size_t j = 0; j < face.works.size(); ++j) {
    const auto column = j + 1;
    auto& segment = works_[column / block_columns];
    segment.part[column % block_columns / lanes][column % lanes] = face.works[j] ? 1 : 0;
  }
}

KUSABI_ALSO_FOR_AVX2 void FaceProjection::evaluate(const ColumnBlocks& z) {
  const auto rows = active_.size();
  const auto per_group = rows * 4;
  shared_.assign(static_cast<std::size_t>(z.groups()) * per_group, 0.0);
  struct Parts {
    Lanes above, count_above, below, count_below;
  };
  std::vector<Parts> parts(rows);
  for (int group = z.first_group(); group < z.end_group(); ++group) {
    std::ranges::fill(parts, Parts{});
    for (int number = 0; number < z.blocks_of(group); ++number) {
      const Segment* const block = z.block(group, number);
      const auto& working = works(group * group_columns + number * block_columns);
      for (std::size_t k = 0; k < rows; ++k) {
        const auto row = static_cast<std::size_t>(active_[k]);
        const Lanes upper = upper_[row];
        const Lanes lower = lower_[row];
        auto& part = parts[k];
        for (int h = 0; h < block_lanes; ++h) {
          Lanes each = block[row].part[h];
          if (signed_[row]) each = where_positive(working.part[h], each, Lanes{});
          part.above += positive(each - upper);
          part.count_above += is_positive(each - upper);
          part.below += positive(-each - lower);
          part.count_below += is_positive(-each - lower);
        }
      }
    }
    auto* target = shared_.data() + static_cast<std::size_t>(group) * per_group;
    for (const auto& part : parts) {
      for (const auto* each : {&part.above, &part.count_above, &part.below, &part.count_below}) {
        *target++ = sum_of(*each);
      }
    }
  }
  const auto sums = added(shared_, per_group, sharing_);
  sums_.resize(rows);
  for (std::size_t k = 0; k < rows; ++k) {
    sums_[k] = {sums[4 * k], sums[4 * k + 1], sums[4 * k + 2], sums[4 * k + 3]};
  }
}

// @return true if another round is needed
bool FaceProjection::newton(int row, const Sums& sums, int round) {
  const auto i = static_cast<std::size_t>(row);
  if (!signed_[i]) return newton_of_both(row, sums, round);
  const bool stretches = face_.stretches[i] > 0;
  double& threshold = stretches ? upper_[i] : lower_[i];
  const double over = stretches ? sums.above : sums.below;
  const double count = stretches ? sums.count_above : sums.count_below;
  const double next =
      count == 0 ? 0 : std::max(0.0, threshold + (over - program_.capacity(row)) / count);
  const bool again = std::abs(next - threshold) > same * (1 + next);
  threshold = next;
  return again;
}

// The multipliers of the two constraints are p and n, half the thresholds, and a = a_0 + p - n:
//   2 sum [z - 2 p]_+ - q - a_0 - p + n <= 0,  2 sum [-z - 2 n]_+ - q + a_0 + p - n <= 0,
// each zero unless its multiplier is.
bool FaceProjection::newton_of_both(int row, const Sums& sums, int round) {
  const auto i = static_cast<std::size_t>(row);
  const double p = upper_[i] / 2;
  const double n = lower_[i] / 2;
  const double capacity = program_.capacity(row);
  const double above = 2 * sums.above - capacity - given_(row) - p + n;
  const double below = 2 * sums.below - capacity + given_(row) + p - n;
  const double slope_above = 4 * sums.count_above + 1;
  const double slope_below = 4 * sums.count_below + 1;
  bool move_p = p > 0 || above > 0;
  bool move_n = n > 0 || below > 0;
  const double determinant = slope_above * slope_below - 1;
  if (move_p && move_n && (round >= rounds_of_both || determinant == 0)) {
    move_p = std::abs(above) >= std::abs(below);
    move_n = !move_p;
  }
  double next_p = p;
  double next_n = n;
  if (move_p && move_n) {
    next_p = p + (slope_below * above + below) / determinant;
    next_n = n + (slope_above * below + above) / determinant;
  } else if (move_p) {
    next_p = p + above / slope_above;
  } else if (move_n) {
    next_n = n + below / slope_below;
  }
  next_p = std::max(0.0, next_p);
  next_n = std::max(0.0, next_n);
  upper_[i] = 2 * next_p;
  lower_[i] = 2 * next_n;
  state_(row) = given_(row) + next_p - next_n;
  return std::abs(next_p - p) > same * (1 + next_p) || std::abs(next_n - n) > same * (1 + next_n);
}

void FaceProjection::find(const ColumnBlocks& z, const Eigen::VectorXd& state) {
  given_ = state;
  state_ = state;
  active_.clear();
  for (int i = 0; i < program_.members(); ++i) {
    active_.push_back(i);
    const int stretch = face_.stretches[static_cast<std::size_t>(i)];
    if (stretch != 0) state_(i) = stretch * program_.capacity(i);
  }
  std::vector<int> left;
  for (int round = 0; round < max_rounds && !active_.empty(); ++round) {
    evaluate(z);
    left.clear();
    for (std::size_t k = 0; k < active_.size(); ++k) {
      if (newton(active_[k], sums_[k], round)) left.push_back(active_[k]);
    }
    active_.swap(left);
  }
}

}  // namespace kusabi::limit::splitting
