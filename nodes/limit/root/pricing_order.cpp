// Breadth-first search from the current column to the next.
#include "nodes/limit/root/pricing_order.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

namespace kusabi::limit {
namespace {

using Entry = Eigen::SparseMatrix<double>::InnerIterator;

/// Tolerance of opposite forces. A missed neighbour only costs time.
constexpr double opposite = 1e-9;

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

}  // namespace

PricingOrder::PricingOrder(const problems::LimitModel& model)
    : neighbours_(at(model.free_count())) {
  for (const auto& column : model.uncertain) degree_.push_back(column.direction.front().degree);
  for (int i = 0; i < model.member_count(); ++i) {
    for (Entry here(model.equilibrium, i); here; ++here) {
      for (Entry there(model.equilibrium, i); there; ++there) {
        const double sum = std::abs(here.value() + there.value());
        if (sum < opposite * std::abs(here.value())) {
          neighbours_[at(static_cast<int>(here.row()))].push_back(static_cast<int>(there.row()));
        }
      }
    }
  }
}

std::vector<int> PricingOrder::walk(std::span<const int> columns) const {
  std::set<int> left(columns.begin(), columns.end());
  std::vector<std::vector<int>> waiting(neighbours_.size());  // remaining columns, by displacement
  for (const int j : columns) waiting[at(degree_[at(j)])].push_back(j);
  std::vector<std::size_t> seen(neighbours_.size());  // in which step of the walk, from 1
  std::vector<int> order;
  while (!left.empty()) {
    int next = *left.begin();
    std::vector<int> ring;
    if (!order.empty()) {
      ring.push_back(degree_[at(order.back())]);
      seen[at(ring.front())] = order.size();
    }
    while (!ring.empty()) {
      int nearest = -1;
      std::vector<int> wider;
      for (const int degree : ring) {
        const auto& here = waiting[at(degree)];
        if (!here.empty() && (nearest < 0 || here.front() < nearest)) nearest = here.front();
        for (const int neighbour : neighbours_[at(degree)]) {
          if (std::exchange(seen[at(neighbour)], order.size()) != order.size()) {
            wider.push_back(neighbour);
          }
        }
      }
      if (nearest >= 0) {
        next = nearest;
        break;
      }
      ring = std::move(wider);
    }
    auto& here = waiting[at(degree_[at(next)])];
    here.erase(std::ranges::find(here, next));
    left.erase(next);
    order.push_back(next);
  }
  return order;
}

}  // namespace kusabi::limit
