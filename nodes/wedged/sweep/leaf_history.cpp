// Newton's method for the first change, bisection for later ones, which few leaves have.
#include "nodes/wedged/sweep/leaf_history.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace kusabi::wedged {
namespace {

using Kind = LeafStage::Kind;

/// Largest width of a cell in points of the grid: two if the point in its middle is undecided.
constexpr std::int64_t narrow = 2;

/// State of the leaf at a point.
struct Station {
  std::int64_t point = 0;
  LeafStage stage;

  [[nodiscard]] bool unresolved() const { return stage.kind == Kind::unresolved; }
};

class Bisection {
 public:
  Bisection(CriticalFriction& critical, const SignPattern& leaf)
      : critical_(critical), leaf_(leaf) {}

  [[nodiscard]] Station at(std::int64_t point) { return {point, critical_.stage(leaf_, point)}; }

  /// Adds all changes between two decided points.
  void between(const Station& low, const Station& high) {
    if (low.stage == high.stage) return;
    const auto middle = at(std::midpoint(low.point, high.point));
    const auto below = middle.unresolved() ? decided(middle.point, low, -1) : middle;
    const auto above = middle.unresolved() ? decided(middle.point, high, 1) : middle;
    const bool found = below.point > low.point || above.point < high.point;
    if (high.point - low.point == 1 || !found) {
      changes_.push_back({low.point, high.point, high.stage});
      return;
    }
    between(low, below);
    if (middle.unresolved() && below.stage != above.stage)
      changes_.push_back({below.point, above.point, above.stage});
    between(above, high);
  }

  [[nodiscard]] std::vector<LeafChange>& changes() { return changes_; }

 private:
  // The nearest decided station, at increasing distances from a point.
  Station decided(std::int64_t from, const Station& end, int direction) {
    for (std::int64_t step = 1; step < (end.point - from) * direction; step *= 2) {
      auto station = at(from + direction * step);
      if (!station.unresolved()) return station;
    }
    return end;
  }

  CriticalFriction& critical_;
  const SignPattern& leaf_;
  std::vector<LeafChange> changes_;
};

/// A feasible leaf remains feasible as friction grows. From a change to infeasible on, its state is
/// therefore numerically undecided.
LeafHistory closed(std::vector<LeafChange> changes) {
  const auto back = std::ranges::find(changes, Kind::infeasible,
                                      [](const auto& change) { return change.to.kind; });
  if (back == changes.end()) return {.changes = std::move(changes)};
  const auto open_above = back->before;
  changes.erase(back, changes.end());
  return {.changes = std::move(changes), .open_above = open_above};
}

}  // namespace

const LeafChange* LeafHistory::change_to(const LeafStage& stage) const {
  const auto found = std::ranges::find(changes, stage, &LeafChange::to);
  return found == changes.end() ? nullptr : &*found;
}

LeafHistory leaf_history(CriticalFriction& critical, const SignPattern& leaf, const LeafStage& last,
                         std::int64_t maximum) {
  const Station at_most{maximum, last};
  const CriticalCell known{0, at_most.unresolved() ? CriticalCell::nowhere : maximum};
  const auto cell = critical.locate(leaf, known, CriticalMethod::newton, maximum);
  if (cell.feasible == CriticalCell::nowhere) return {.changes = {}, .open_above = cell.infeasible};
  Bisection bisection(critical, leaf);
  const Station infeasible{cell.infeasible, {}};
  const auto first = cell.feasible == maximum ? at_most : bisection.at(cell.feasible);
  if (first.unresolved() && at_most.unresolved())
    return {.changes = {}, .open_above = cell.infeasible};
  // A wide cell contains degenerate points, which may be flat cones that Newton's method does not
  // detect.
  // Near its own coefficient a degenerate leaf may be feasible to Newton's method and infeasible by
  // its relative interior, which decides the state.
  if (first.stage.kind == Kind::infeasible) {
    if (at_most.unresolved()) return {.changes = {}, .open_above = cell.infeasible};
    bisection.between(first, at_most);
    return closed(std::move(bisection.changes()));
  }
  if (first.unresolved())
    bisection.between(infeasible, at_most);
  else if (cell.feasible - cell.infeasible > narrow)
    bisection.between(infeasible, first);
  else
    bisection.changes().push_back({cell.infeasible, cell.feasible, first.stage});
  const bool grows = first.stage.kind == Kind::flat;
  if (grows && at_most.unresolved()) return {std::move(bisection.changes()), cell.feasible};
  if (grows) bisection.between(first, at_most);
  return closed(std::move(bisection.changes()));
}

}  // namespace kusabi::wedged
