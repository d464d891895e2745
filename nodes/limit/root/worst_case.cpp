// Rounds at the root.
#include "nodes/limit/root/worst_case.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>

#include "nodes/limit/root/corner.hpp"
#include "nodes/limit/root/corner_choice.hpp"
#include "nodes/limit/root/fixed_shares.hpp"

namespace kusabi::limit {
namespace {

using problems::LimitModel;

/// Costs of members that do not move in a pricing program, relative to the mean elongation: the
/// first one, then smaller ones when no cut is violated, finally zero.
constexpr double first_share = 1e-3;
constexpr double min_share = 1e-9;
constexpr double share_fall = 1e-3;

/// Tolerance of violated cuts, where motions are of the order of one.
constexpr double violated = 1e-9;

/// Limit of the dissipation, relative to that of the best collapse, while there are few cuts.
constexpr double dissipation_share = 2;

/// Columns with the largest violation are priced first, one of so many, in whole blocks: the
/// relaxation is inexpensive, and after their cuts most of the other columns are tight.
constexpr int batches = 12;

/// Maximum number of rounds, far more than in any known instance.
constexpr int max_rounds = 1000;

/// One run of the rounds.
class Rounds {
 public:
  Rounds(const LimitModel& model, double alpha, LoadFactor& load_factor, const Pricer& pricer,
         const RootControl& control)
      : model_(model),
        alpha_(alpha),
        load_factor_(load_factor),
        pricer_(pricer),
        control_(control),
        master_(model, alpha, control.stop),
        solves_before_(load_factor.solves()),
        iterations_before_(load_factor.iterations()) {}

  RootResult run(const Collapse& nominal);

 private:
  bool improve(const Eigen::VectorXd& motion);
  bool price(const Eigen::VectorXd& z, std::span<const int> columns, const Relaxed* point);
  bool cut_off(const Relaxed& point);
  bool remove_dissipation_limit();
  void bound_at_the_end();
  [[nodiscard]] bool stopped() const { return support::is_requested(control_.stop); }
  [[nodiscard]] double work() const;
  [[nodiscard]] CornerChoice corners() const;
  bool leave_to_corners(bool is_less);
  RootStatus bound_before_corners();
  RootStatus rounds();

  const LimitModel& model_;
  double alpha_;
  LoadFactor& load_factor_;
  const Pricer& pricer_;
  const RootControl& control_;
  Master master_;
  std::uint64_t solves_before_;      // of load_factor_
  std::uint64_t iterations_before_;  //
  double share_ = first_share;
  bool limited_ = true;
  bool has_bound_ = true;  // false if the last cuts have none
  RootResult result_;
};

bool Rounds::improve(const Eigen::VectorXd& motion) {
  return descend_from(model_, alpha_, load_factor_, motion, result_);
}

// Adds the cuts that the point violates, or all if there is no point yet. @return true if any
bool Rounds::price(const Eigen::VectorXd& z, std::span<const int> columns, const Relaxed* point) {
  bool any = false;
  result_.counts.pricings += columns.size();
  for (auto& cut : pricer_(pricing_aim(z, share_), columns)) {
    if (point != nullptr && point->gamma(cut.column) - cut.bound(point->z) < violated) continue;
    master_.add(cut);
    result_.cuts.push_back(std::move(cut));
    any = true;
  }
  return any;
}

// Prices columns in the order of their violation until some cut is violated; if none is, with
// smaller costs of members that do not move. @return true if any
bool Rounds::cut_off(const Relaxed& point) {
  const Eigen::VectorXd violations = violations_at(model_, point);
  std::vector<int> columns;
  for (int j = 0; j < model_.uncertain_count(); ++j) {
    if (violations(j) > violated) columns.push_back(j);
  }
  std::ranges::stable_sort(columns, std::greater<>(), [&](int j) { return violations(j); });
  const auto blocks = model_.uncertain.size() / (static_cast<std::size_t>(batches) * pricing_block);
  const auto batch = std::max<std::size_t>(1, blocks) * pricing_block;
  while (!columns.empty()) {
    for (std::size_t first = 0; first < columns.size(); first += batch) {
      const auto count = std::min(batch, columns.size() - first);
      std::vector<int> some(columns.begin() + static_cast<std::ptrdiff_t>(first),
                            columns.begin() + static_cast<std::ptrdiff_t>(first + count));
      std::ranges::sort(some);
      if (price(point.z, some, &point)) return true;
      if (stopped()) return false;
    }
    if (share_ == 0) return false;
    share_ = share_ > min_share ? share_ * share_fall : 0;
  }
  return false;
}

// @return true if the limit was active and has been removed
bool Rounds::remove_dissipation_limit() {
  if (!limited_ || !master_.dissipation_limit_is_active()) return false;
  limited_ = false;
  master_.limit_dissipation(linear::infinity);
  return true;
}

// Computes the bound of the present cuts without the limit of the dissipation, which gives no bound
// while it is active; in little time.
void Rounds::bound_at_the_end() {
  using Clock = std::chrono::steady_clock;
  constexpr auto grace = std::chrono::milliseconds(300);
  const auto end = Clock::now() + grace;
  master_.set_stop([end] { return Clock::now() > end; });
  master_.limit_dissipation(linear::infinity);
  if (!master_.solve() || master_.box_is_active()) return;
  result_.lower = master_.objective();
  if (master_.solve_with_margin(first_room)) result_.proof = master_.proof();
}

// Work of the rounds so far, in iterations of (5): those of the relaxation count in proportion to
// its rows. The pricing programs of other ranks are not known, so each counts as (5) from the slack
// basis.
double Rounds::work() const {
  const double rows =
      static_cast<double>(model_.member_count()) + static_cast<double>(master_.cuts());
  const double larger = rows / std::max(1, model_.free_count());
  return static_cast<double>(load_factor_.iterations() - iterations_before_) +
         larger * static_cast<double>(master_.iterations()) +
         static_cast<double>(result_.counts.pricings * load_factor_.first_iterations());
}

// From the descents so far, of which there is at least one.
CornerChoice Rounds::corners() const {
  const auto solves = load_factor_.solves() - solves_before_;
  const auto iterations = load_factor_.iterations() - iterations_before_;
  return {
      undecided_count(model_, alpha_, Signs(model_.uncertain.size(), 0)),
      static_cast<double>(load_factor_.first_iterations()),
      static_cast<double>(iterations) / static_cast<double>(std::max<std::uint64_t>(1, solves))};
}

// @param is_less whether the corners of all loads are predicted to take less work than the rounds
// @return true if they take the place of the rounds
bool Rounds::leave_to_corners(bool is_less) {
  if (control_.corners == Corners::never) return false;
  if (!is_less && control_.corners != Corners::always) return false;
  result_.enumerated = corners().loads();
  return true;
}

// Solves once more with the last cuts and without the limit of the dissipation, since the bound of
// the root holds if the search of the corners is stopped, and may meet the upper one.
RootStatus Rounds::bound_before_corners() {
  if (limited_) master_.limit_dissipation(linear::infinity);
  limited_ = false;
  has_bound_ = master_.solve() && !master_.box_is_active();
  if (!has_bound_) return master_.is_interrupted() ? RootStatus::stopped : RootStatus::open;
  result_.lower = master_.objective();
  const bool meet = result_.worst->collapse.factor - result_.lower <= closed_gap;
  return meet ? RootStatus::closed : RootStatus::open;
}

RootStatus Rounds::rounds() {
  if (leave_to_corners(corners().is_less_than_a_round())) return RootStatus::open;
  const Eigen::VectorXd z =
      (model_.equilibrium.transpose() * result_.worst->collapse.motion).cwiseAbs();
  master_.limit_dissipation(dissipation_share * model_.yield().dot(z));
  std::vector<int> columns(model_.uncertain.size());
  for (std::size_t j = 0; j < columns.size(); ++j) columns[j] = static_cast<int>(j);
  price(z, columns, nullptr);
  while (result_.counts.rounds < max_rounds) {
    if (stopped()) return RootStatus::stopped;
    ++result_.counts.rounds;
    if (!master_.solve())
      return master_.is_interrupted() ? RootStatus::stopped : RootStatus::failed;
    const bool is_bound = !master_.dissipation_limit_is_active() && !master_.box_is_active();
    const double bound = master_.objective();
    if (is_bound) result_.lower = bound;
    const Relaxed point = master_.relaxed();
    if (!improve(point.motion)) return RootStatus::not_carried;
    if (control_.watcher) {
      control_.watcher(result_.counts.rounds, result_.lower, result_.worst->collapse.factor);
    }
    const bool meet = result_.worst->collapse.factor - bound <= closed_gap;
    const bool cut = !meet && cut_off(point);
    if (stopped()) return RootStatus::stopped;
    if (!cut && !remove_dissipation_limit()) {
      if (meet) return RootStatus::closed;
      const double of_a_round = work() / static_cast<double>(result_.counts.rounds);
      if (control_.corners == Corners::if_less_work)
        result_.enumerated = corners().signs_within(of_a_round);
      return RootStatus::open;
    }
    if (leave_to_corners(corners().is_less_than(work()))) return bound_before_corners();
  }
  return RootStatus::open;
}

RootResult Rounds::run(const Collapse& nominal) {
  result_.nominal_basis = load_factor_.first_basis();
  result_.status = improve(nominal.motion) ? RootStatus::open : RootStatus::not_carried;
  if (result_.status == RootStatus::open && !result_.worst) {
    result_.status = stopped() ? RootStatus::stopped : RootStatus::failed;
  }
  if (result_.status == RootStatus::open) result_.status = rounds();
  switch (result_.status) {
    case RootStatus::open:
    case RootStatus::closed:
      if (master_.solves() == 0 || !has_bound_) break;  // no rounds, or no bound
      // At the box of the relaxation the bound is that of the box.
      if (master_.box_is_active()) result_.status = RootStatus::unbounded;
      if (master_.solve_with_margin(first_room)) result_.proof = master_.proof();
      if (stopped()) result_.status = RootStatus::stopped;
      result_.basis = master_.basis();
      break;
    case RootStatus::stopped:
      bound_at_the_end();
      break;
    default:
      break;
  }
  result_.counts.relaxations = master_.solves();
  result_.counts.load_factors = load_factor_.solves() - solves_before_;
  return std::move(result_);
}

}  // namespace

bool descend_from(const LimitModel& model, double alpha, LoadFactor& load_factor,
                  const Eigen::VectorXd& motion, RootResult& result) {
  const Eigen::VectorXd plus = Eigen::VectorXd::Zero(model.uncertain_count());
  auto found = descend(model, load_factor, alpha, worst_for(model, alpha, motion, plus));
  if (found.status == LoadStatus::not_carried) {
    result.overpowering_load = std::move(found.overpowering_load);
    result.overpowering_motion = std::move(found.overpowering_motion);
    return false;
  }
  if (found.status != LoadStatus::collapses) return true;
  if (!result.worst || found.worst.collapse.factor < result.worst->collapse.factor) {
    result.worst = std::move(found.worst);
  }
  return true;
}

std::vector<StaticCut> price_block(StaticPricing& pricing, std::span<const int> columns) {
  std::vector<StaticCut> cuts;
  pricing.restart();
  for (const int column : columns) {
    if (pricing.stopped()) break;
    if (auto cut = pricing.cut(column)) cuts.push_back(std::move(*cut));
  }
  return cuts;
}

std::vector<StaticCut> price_alone(StaticPricing& pricing, const Eigen::VectorXd& z,
                                   std::span<const int> columns) {
  std::vector<StaticCut> cuts;
  if (columns.empty()) return cuts;
  pricing.set_point(z, columns.front());
  for (std::size_t first = 0; first < columns.size(); first += pricing_block) {
    const auto count = std::min(pricing_block, columns.size() - first);
    for (auto& cut : price_block(pricing, columns.subspan(first, count))) {
      cuts.push_back(std::move(cut));
    }
  }
  return cuts;
}

Eigen::VectorXd violations_at(const LimitModel& model, const Relaxed& point) {
  Eigen::VectorXd violations(model.uncertain_count());
  for (int j = 0; j < model.uncertain_count(); ++j) {
    const auto& column = model.uncertain[static_cast<std::size_t>(j)];
    violations(j) = column.weight * (point.gamma(j) - std::abs(column.along(point.motion)));
  }
  return violations;
}

Eigen::VectorXd pricing_aim(const Eigen::VectorXd& z, double share) {
  return z.array() + share * z.mean();
}

RootResult solve_root(const LimitModel& model, double alpha, const Collapse& nominal,
                      LoadFactor& load_factor, const Pricer& pricer, const RootControl& control) {
  return Rounds(model, alpha, load_factor, pricer, control).run(nominal);
}

std::optional<StaticProof> proof_with_room(const LimitModel& model, double alpha,
                                           std::span<const StaticCut> cuts, const Signs& signs,
                                           double share, bool for_all) {
  // The master program is too large for such problems and has weaker proofs.
  const bool decided = std::ranges::any_of(signs, [](int sign) { return sign != 0; });
  const bool is_large =
      model.uncertain_count() >= default_split_from && is_one_for_each(cuts, model);
  if (!decided && is_large) {
    splitting::SafeStates states(model);
    return proof_of_fixed_shares(states, model, alpha, cuts, share, for_all);
  }
  Master master(model, alpha);
  for (const auto& cut : cuts) master.add(cut);
  master.decide(signs);
  if (!master.solve() || !master.solve_with_margin(share, for_all)) return {};
  return master.proof();
}

}  // namespace kusabi::limit
