// Steps at the root in their order.
#include "nodes/zero_one/root.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "nodes/zero_one/big_m.hpp"
#include "nodes/zero_one/cut_rounds.hpp"
#include "nodes/zero_one/objective_steps.hpp"

namespace kusabi::zero_one {
namespace {

using linear::LinearStatus;

// The largest number of which every cost is a multiple, if only binaries have costs and these are
// integers after multiplication by a small power of ten; otherwise 0.
struct Grid {
  double width = 0;
  double error = 0;
};

Grid grid_of_objectives(const linear::MixedProgram& mixed) {
  constexpr double largest_whole = 1e9;
  std::vector<bool> binary(mixed.program.columns.size());
  for (const int column : mixed.binaries) binary[static_cast<std::size_t>(column)] = true;
  for (std::size_t j = 0; j < binary.size(); ++j) {
    if (!binary[j] && mixed.program.columns[j].cost != 0) return {};
  }
  for (const double power : {1.0, 10.0, 100.0, 1000.0}) {
    std::int64_t divisor = 0;
    double sum = 0;
    bool whole = true;
    for (const auto& column : mixed.program.columns) {
      const double scaled = column.cost * power;
      const double nearest = std::round(scaled);
      sum += std::abs(nearest);
      whole = whole && sum < largest_whole && nearest / power == column.cost;
      if (!whole) break;
      divisor = std::gcd(divisor, static_cast<std::int64_t>(nearest));
    }
    if (!whole) continue;
    double size = 0;
    for (const auto& column : mixed.program.columns) size += std::abs(column.cost);
    return {static_cast<double>(divisor) / power, power == 1 ? 0 : 0x1p-51 * size};
  }
  return {};
}

void relax(ZeroOneRoot& root) {
  root.status = root.relaxation.solve(root.relaxation.root(), root.basis);
  // Every intermediate bound is valid; the last may be one of a stopped solve.
  root.bound = std::max(root.bound, root.relaxation.bound());
  if (root.status != LinearStatus::optimal) return;
  root.basis = root.relaxation.basis();
}

void keep_better(std::optional<ZeroOnePoint>& best, std::optional<ZeroOnePoint>&& found) {
  if (found && (!best || found->objective < best->objective)) best = std::move(found);
}

Fixings fixings_of(const Relaxation& relaxation, const std::vector<double>& values) {
  auto fixings = relaxation.root();
  for (std::size_t k = 0; k < relaxation.binaries(); ++k) {
    fixings.fix(k, values[static_cast<std::size_t>(relaxation.column(k))] > 0.5);
  }
  return fixings;
}

void find_points(ZeroOneRoot& root, const ZeroOneRootOptions& options) {
  auto& relaxation = root.relaxation;
  if (options.start.size() == relaxation.program().columns.size()) {
    keep_better(root.point,
                point_at(relaxation, fixings_of(relaxation, options.start), root.basis));
  }
  if (!options.dive) return;
  relaxation.solve(relaxation.root(), root.basis);
  const auto rounded = rounded_fixings(relaxation, relaxation.root());
  keep_better(root.point, point_at(relaxation, rounded, root.basis));
  keep_better(root.point, dive(relaxation, relaxation.root(), root.basis));
}

// True if bounds are useful: if the program is too large for rational numbers and its columns have
// no bounds, or very wide ones, rounding alone may decrease the bounds by more than the resolution
// of objectives, and no node would be closed.
bool bounds_are_of_use(ZeroOneRoot& root) {
  relax(root);
  constexpr double share = 0.25;
  return root.status != LinearStatus::optimal ||
         root.relaxation.objective() - root.bound <= share * step_width(root.bound);
}

// Decreases coefficients as the best known point allows; better points may then be found, which
// allow smaller ones.
void tighten(ZeroOneRoot& root, const ZeroOneRootOptions& options) {
  constexpr int max_times = 3;
  BigMs big_ms(root.relaxation.mixed());
  for (int time = 0; time < max_times && root.point && !support::is_requested(options.stop);
       ++time) {
    const double before = root.point->objective;
    const double step = step_width(before);
    auto mixed = root.relaxation.mixed();
    const auto done = big_ms.tighten(mixed, before + step, options.stop);
    root.counts.tightened = big_ms.smaller();
    root.counts.tighten_programs += done.programs;
    root.counts.fixed += done.fixed;
    if (!done.changed) return;
    const std::uint64_t programs = root.relaxation.programs();
    root.relaxation = Relaxation(std::move(mixed));
    root.relaxation.end_when(options.stop);
    root.counts.programs += programs;
    root.basis = {};
    relax(root);
    if (root.status != LinearStatus::optimal || done.nothing_left) return;
    find_points(root, options);
    if (root.point->objective > before - step) return;
  }
}

}  // namespace

ZeroOneRoot prepare_root(linear::MixedProgram mixed, const ZeroOneRootOptions& options) {
  const auto grid = grid_of_objectives(mixed);
  ZeroOneRoot root{
      .relaxation = Relaxation(std::move(mixed)), .grid = grid.width, .grid_error = grid.error};
  root.relaxation.end_when(options.stop);
  root.as_printed = options.as_printed;
  root.point = options.incumbent;
  relax(root);
  if (root.status == LinearStatus::optimal) {
    root.counts.first_bound = root.relaxation.objective();
    find_points(root, options);
    if (options.tighten) tighten(root, options);
  }
  if (root.status == LinearStatus::optimal && !support::is_requested(options.stop)) {
    if (root.point) {
      const double objective = root.point->objective;
      root.relaxation.limit_objective(objective + step_width(objective));
    }
    if (!bounds_are_of_use(root)) root.relaxation.use_unproved_bounds();
    if (options.cuts == ZeroOneCuts::disjunctive) {
      auto cuts = add_disjunctive_cuts(root.relaxation, root.basis);
      root.counts.cut_rounds = cuts.rounds;
      root.counts.cut_programs = cuts.programs;
      root.counts.cuts = cuts.kept;
      root.counts.proved = root.counts.proved && (cuts.kept == 0 || root.relaxation.all_bounded());
      root.basis = std::move(cuts.basis);
    }
    relax(root);
    root.counts.last_bound = root.bound;
  }
  root.interrupted =
      root.status == LinearStatus::interrupted || support::is_requested(options.stop);
  root.counts.programs +=
      root.relaxation.programs() + root.counts.tighten_programs + root.counts.cut_programs;
  return root;
}

}  // namespace kusabi::zero_one
