// Rounds of Newton's method on all rows that have not converged.
#include "nodes/limit/splitting/row_projection.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kusabi::limit::splitting {
namespace {

constexpr int max_rounds = 60;

/// Tolerance of equal thresholds, relative to the larger of one and their size.
constexpr double same = 1e-15;

}  // namespace

RowProjection::RowProjection(const Eigen::VectorXd& capacity, const Sharing& sharing)
    : capacity_(capacity),
      sharing_(sharing),
      thresholds_(static_cast<std::size_t>(capacity.size()) + 1, 0.0) {}

// Sums of the numbers above the thresholds of the active rows.
KUSABI_ALSO_FOR_AVX2 void RowProjection::evaluate(const ColumnBlocks& z) {
  const auto rows = active_.size();
  shared_.assign(static_cast<std::size_t>(z.groups()) * rows * 2, 0.0);
  std::vector<Segment> over(rows);
  std::vector<Segment> count(rows);
  for (int group = z.first_group(); group < z.end_group(); ++group) {
    std::ranges::fill(over, Segment{});
    std::ranges::fill(count, Segment{});
    for (int number = 0; number < z.blocks_of(group); ++number) {
      const Segment* const block = z.block(group, number);
      for (std::size_t k = 0; k < rows; ++k) {
        const Lanes threshold = thresholds_[static_cast<std::size_t>(active_[k])];
        for (int h = 0; h < block_lanes; ++h) {
          const Lanes above = size_of(block[active_[k]].part[h]) - threshold;
          over[k].part[h] += positive(above);
          count[k].part[h] += is_positive(above);
        }
      }
    }
    auto* const target = shared_.data() + static_cast<std::size_t>(group) * rows * 2;
    for (std::size_t k = 0; k < rows; ++k) {
      target[2 * k] = sum_of(over[k]);
      target[2 * k + 1] = sum_of(count[k]);
    }
  }
  const auto sums = added(shared_, rows * 2, sharing_);
  over_.resize(rows);
  count_.resize(rows);
  for (std::size_t k = 0; k < rows; ++k) {
    over_[k] = sums[2 * k];
    count_[k] = sums[2 * k + 1];
  }
}

double RowProjection::newton(std::size_t place, double factor, double target) const {
  const int row = active_[place];
  const double threshold = thresholds_[static_cast<std::size_t>(row)];
  const bool of_factor = row == static_cast<int>(capacity_.size());
  if (of_factor) {
    const double lacking = over_[place] + target - factor - threshold;
    return std::max(0.0, threshold + lacking / (count_[place] + 1));
  }
  if (count_[place] == 0) return 0;
  return std::max(0.0, threshold + (over_[place] - capacity_(row)) / count_[place]);
}

void RowProjection::find(const ColumnBlocks& z, double factor, double target) {
  active_.resize(thresholds_.size());
  std::iota(active_.begin(), active_.end(), 0);
  std::vector<int> left;
  for (int round = 0; round < max_rounds && !active_.empty(); ++round) {
    evaluate(z);
    left.clear();
    for (std::size_t k = 0; k < active_.size(); ++k) {
      double& threshold = thresholds_[static_cast<std::size_t>(active_[k])];
      const double next = newton(k, factor, target);
      if (std::abs(next - threshold) > same * (1 + next)) left.push_back(active_[k]);
      threshold = next;
    }
    active_.swap(left);
  }
}

std::vector<double> added(std::vector<double>& numbers, std::size_t per_group,
                          const Sharing& sharing) {
  sharing.fill(numbers);
  std::vector<double> sums(per_group, 0.0);
  for (std::size_t first = 0; first < numbers.size(); first += per_group) {
    for (std::size_t k = 0; k < per_group; ++k) sums[k] += numbers[first + k];
  }
  return sums;
}

std::vector<double> row_sizes(const ColumnBlocks& y, const Sharing& sharing) {
  const auto rows = static_cast<std::size_t>(y.rows());
  std::vector<double> numbers(rows * static_cast<std::size_t>(y.groups()), 0.0);
  for (int group = y.first_group(); group < y.end_group(); ++group) {
    auto* const target = numbers.data() + static_cast<std::size_t>(group) * rows;
    for (int number = 0; number < y.blocks_of(group); ++number) {
      const Segment* const block = y.block(group, number);
      for (std::size_t i = 0; i < rows; ++i) {
        Segment segment = block[i];
        if (group == 0 && number == 0) segment.part[0][0] = 0;
        for (auto& part : segment.part) part = size_of(part);
        target[i] += sum_of(segment);
      }
    }
  }
  return added(numbers, rows, sharing);
}

}  // namespace kusabi::limit::splitting
