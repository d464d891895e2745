// Rounds on all ranks in the same order; cuts are priced in distributed blocks.
#include "nodes/limit/root/root_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "engine/collectives.hpp"
#include "engine/transport/exchange.hpp"
#include "nodes/limit/model/balanced_model.hpp"
#include "nodes/limit/root/split_root.hpp"

namespace kusabi::limit {
namespace {

/// Maximum number of searches with adjusted units, if the worst case collapses at another order of
/// forces than the nominal load.
constexpr int max_balances = 3;

/// Shorter computations show no progress.
constexpr auto patience = std::chrono::seconds(2);

}  // namespace

// Every rank must make this call, and all get the same answer.
bool RootSearch::ended() {
  if (!ended_) ended_ = engine::from_first_rank(analysis_.transport(), analysis_.budget().stop());
  return ended_;
}

support::Stop RootSearch::lockstep_stop() {
  return [this] { return sharing_ ? analysis_.budget().spent() : ended(); };
}

// Shows the progress of a long root, every two seconds.
void RootSearch::say(const std::string& what) {
  analysis_.say_now_and_then([&] { return "at the root: " + what; });
}

// Shows each round of a long root. The lower bound is unknown while the dissipation is limited.
void RootSearch::say_ends(std::uint64_t round, double lower, double upper) {
  if (std::chrono::steady_clock::now() - began_ < patience) return;
  const double unit = model().factor_unit;
  const auto low = std::isfinite(lower) ? fmt::format("{:.6g}", lower * unit) : "unknown";
  analysis_.say(
      fmt::format("at the root: round {}, load factor {} ... {:.6g}", round, low, upper * unit));
}

LoadStatus RootSearch::set_up(problems::LimitModel model) {
  solvers_ = std::make_unique<Solvers>(std::move(model), lockstep_stop());
  const auto status = solvers_->load_factor.solve(solvers_->model.dead);
  if (status == LoadStatus::collapses) solvers_->nominal = solvers_->load_factor.collapse();
  return status;
}

void RootSearch::choose_units(double alpha) {
  double load = 0;
  for (const auto& column : problem_.uncertain) load = std::max(load, alpha * column.largest());
  const double before = model().force_unit;
  constexpr double far = 0x1p6;
  if (load <= far * before) return;
  if (set_up(problems::limit_model(problem_, load)) != LoadStatus::collapses) {
    set_up(problems::limit_model(problem_, before));
  }
}

LimitCollapse RootSearch::in_units(const Collapse& collapse, const Eigen::VectorXd& dead) {
  const auto opposite = load_factor().opposite_collapse(dead);
  return in_units(collapse, opposite ? std::optional(-opposite->factor) : std::nullopt);
}

LimitCollapse RootSearch::in_units(const Collapse& collapse, std::optional<double> minimum) const {
  if (minimum) {
    // A load of zero has the exact factor zero.
    if (std::abs(*minimum) <= closed_gap) *minimum = 0;
    *minimum *= model().factor_unit;
  }
  return {collapse.factor * model().factor_unit, minimum,
          problems::forces_in_units(model(), collapse.forces),
          problems::motion_in_units(model(), collapse.motion)};
}

// The cuts do not depend on the rank that makes them: see pricing_block.
std::vector<StaticCut> RootSearch::price(const Eigen::VectorXd& z, std::span<const int> columns) {
  auto& pricing = solvers_->pricing;
  say(fmt::format("{} of {} uncertain loads are looked at for cuts", columns.size(),
                  model().uncertain_count()));
  const bool small = analysis_.transport().size() == 1 || columns.size() <= pricing_block;
  // Stored results are distributed in any case, so that a resumed run need not price again.
  if (columns.empty() || (small && !analysis_.has_journal())) {
    return price_alone(pricing, z, columns);
  }
  pricing.set_point(z, columns.front());
  const auto blocks = (columns.size() + pricing_block - 1) / pricing_block;
  const auto block = [&](std::uint64_t number) {
    const auto first = number * pricing_block;
    return price_block(pricing,
                       columns.subspan(first, std::min(pricing_block, columns.size() - first)));
  };
  sharing_ = true;
  auto shared = analysis_.share<std::vector<StaticCut>>(blocks, block);
  sharing_ = false;
  std::vector<StaticCut> cuts;
  for (auto& some : shared) std::move(some.begin(), some.end(), std::back_inserter(cuts));
  return cuts;
}

// Groups of columns of the splitting, distributed if the ranks are processes.
splitting::Sharing RootSearch::shared_columns() {
  auto& transport = analysis_.transport();
  auto* const exchange = dynamic_cast<engine::Exchange*>(&transport);
  if (transport.size() == 1 || exchange == nullptr) return {};
  splitting::Sharing sharing{transport.rank(), transport.size()};
  const int groups = splitting::groups_of(model().uncertain_count() + 1);
  std::vector<std::size_t> ends;
  for (int rank = 1; rank <= transport.size(); ++rank)
    ends.push_back(static_cast<std::size_t>(sharing.first_group_of(rank, groups)));
  sharing.exchange = [exchange, ends, groups](std::span<double> numbers) {
    auto own = ends;
    for (auto& end : own) end *= numbers.size() / static_cast<std::size_t>(groups);
    exchange->complete(numbers, own);
  };
  return sharing;
}

RootResult RootSearch::solve(double alpha, Corners corners) {
  load_factor().restart();
  const RootControl control{.stop = lockstep_stop(),
                            .watcher = [this](std::uint64_t round, double lower,
                                              double upper) { say_ends(round, lower, upper); },
                            .enough = enough_ / model().factor_unit,
                            .corners = corners};
  if (alpha > 0 && model().uncertain_count() > 0 && splits()) {
    auto split = split_root(model(), alpha, nominal(), load_factor(), shared_columns(), control);
    if (split.status != RootStatus::open && split.status != RootStatus::failed) return split;
    load_factor().restart();
  }
  return solve_root(
      model(), alpha, nominal(), load_factor(),
      [this](const Eigen::VectorXd& z, std::span<const int> columns) { return price(z, columns); },
      control);
}

RootResult RootSearch::solve_balanced(double alpha, Corners corners) {
  RootResult result = solve(scaled(alpha), corners);
  for (int time = 0; time < max_balances; ++time) {
    const bool undecided = result.status == RootStatus::open ||
                           result.status == RootStatus::unbounded ||
                           result.status == RootStatus::failed;
    if (!undecided || !result.worst) break;
    const double size = dissipation(problem_, model(), result.worst->collapse.motion);
    if (!is_out_of_balance(size)) break;
    if (set_up(rebalanced(problem_, model(), size, alpha)) != LoadStatus::collapses) break;
    result = solve(scaled(alpha), corners);
  }
  return result;
}

}  // namespace kusabi::limit
