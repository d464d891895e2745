// Least squares by normal equations; the history is a ring.
#include "nodes/limit/splitting/acceleration.hpp"

#include <utility>

#include <Eigen/Cholesky>

#include "nodes/limit/splitting/row_projection.hpp"

namespace kusabi::limit::splitting {
namespace {

/// Number of differences.
constexpr std::size_t maximum = 6;

/// Regularisation of the normal equations, relative to their diagonal.
constexpr double regularisation = 1e-10;

// one <- times one + factor other
KUSABI_ALSO_FOR_AVX2 void combine(MixedPoint& one, double times, double factor,
                                  const MixedPoint& other) {
  auto& numbers = one.columns.numbers();
  const auto& others = other.columns.numbers();
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    for (int h = 0; h < block_lanes; ++h) {
      numbers[k].part[h] = times * numbers[k].part[h] + factor * others[k].part[h];
    }
  }
  one.rest = times * one.rest + factor * other.rest;
}

// The products of `one` with each of `others`, on every rank.
KUSABI_ALSO_FOR_AVX2 Eigen::VectorXd products(const MixedPoint& one,
                                              const std::vector<MixedPoint>& others,
                                              const Sharing& sharing) {
  const auto& columns = one.columns;
  std::vector<double> numbers(static_cast<std::size_t>(columns.groups()) * others.size(), 0.0);
  for (int group = columns.first_group(); group < columns.end_group(); ++group) {
    for (std::size_t i = 0; i < others.size(); ++i) {
      Segment sum{};
      for (int number = 0; number < columns.blocks_of(group); ++number) {
        const auto* const a = columns.block(group, number);
        const auto* const b = others[i].columns.block(group, number);
        for (int row = 0; row < columns.rows(); ++row) {
          for (int h = 0; h < block_lanes; ++h) sum.part[h] += a[row].part[h] * b[row].part[h];
        }
      }
      numbers[static_cast<std::size_t>(group) * others.size() + i] = sum_of(sum);
    }
  }
  const auto sums = added(numbers, others.size(), sharing);
  Eigen::VectorXd all(static_cast<Eigen::Index>(others.size()));
  for (std::size_t i = 0; i < others.size(); ++i) {
    all(static_cast<Eigen::Index>(i)) = sums[i] + one.rest.dot(others[i].rest);
  }
  return all;
}

}  // namespace

// Keeps the differences to the last cycle, in place of the oldest ones.
void Acceleration::remember(const MixedPoint& result) {
  auto& change = last_[0];
  auto& image = last_[1];
  combine(change, -1, 1, change_);
  combine(image, -1, 1, result);
  const auto at = static_cast<Eigen::Index>(oldest_);
  if (changes_.size() < maximum) {
    changes_.push_back(std::move(change));
    results_.push_back(std::move(image));
    gram_.conservativeResize(at + 1, at + 1);
  } else {
    changes_[oldest_] = std::move(change);
    results_[oldest_] = std::move(image);
  }
  gram_.row(at) = products(changes_[oldest_], changes_, sharing_).transpose();
  gram_.col(at) = gram_.row(at).transpose();
  oldest_ = (oldest_ + 1) % maximum;
}

Eigen::VectorXd Acceleration::coefficients() {
  Eigen::MatrixXd regular = gram_;
  regular.diagonal() *= 1 + regularisation;
  return regular.ldlt().solve(products(last_[0], changes_, sharing_));
}

void Acceleration::advance(MixedPoint& point) {
  combine(change_, -1, 1, point);
  if (!last_.empty()) remember(point);
  last_.clear();
  last_.push_back(std::move(change_));
  last_.push_back(point);
  extrapolates_ = false;
  if (!changes_.empty()) {
    const Eigen::VectorXd g = coefficients();
    extrapolates_ = g.allFinite();
    for (std::size_t i = 0; extrapolates_ && i < results_.size(); ++i) {
      combine(point, 1, -g(static_cast<Eigen::Index>(i)), results_[i]);
    }
  }
  change_ = point;
}

void Acceleration::reject(MixedPoint& point) {
  point = last_[1];
  change_ = point;
  last_.clear();
  changes_.clear();
  results_.clear();
  gram_.resize(0, 0);
  oldest_ = 0;
  extrapolates_ = false;
}

}  // namespace kusabi::limit::splitting
