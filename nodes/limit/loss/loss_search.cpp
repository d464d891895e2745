// A start by losing the worst member again and again, then one tree for each target: the factor of
// the worst loss known, less a margin, until no loss below the target is found.
#include "nodes/limit/loss/loss_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "engine/together.hpp"
#include "nodes/limit/root/worst_case.hpp"
#include "nodes/limit/search/proved_ends.hpp"

namespace kusabi::limit {

using support::IndexSet;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Factor by which losses are compared.
double value(LoadStatus status, double factor) {
  if (status == LoadStatus::collapses) return factor;
  return status == LoadStatus::not_carried ? -infinite : infinite;
}

/// Difference of a target and the least factor known, scaled: room for the margins of proofs.
constexpr double target_gap = 4 * closed_gap;

/// A member with less has no stress in a basic solution.
constexpr double no_stress = 1e-12;

/// A result of shared work.
struct Remains {
  std::int32_t status = 0;
  double factor = 0;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& status& factor;
  }
};

/// Outcome of a search, on every rank.
struct Searched {
  engine::Status status = engine::Status::solved;
  std::uint64_t nodes = 0;
  LossTree::Tally tally;
  std::vector<LossTree::Solution> first;  // at most one

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& status& nodes& tally& first;
  }
};

}  // namespace

LossSearch::LossSearch(engine::Analysis& analysis, const verify::Structure& truss,
                       const problems::LimitProblem& problem, const problems::LimitModel& model,
                       const LossQuestion& question)
    : analysis_(analysis),
      model_(model),
      question_(question),
      eligible_(IndexSet::below(problem.member_count())),
      proof_(truss, problem, model),
      remaining_(model, analysis.budget().stop()) {
  for (const int member : question.kept) eligible_ -= IndexSet::single(member);
}

double LossSearch::value_of(const Known& known) const {
  return value(known.status, known.collapse.factor);
}

LossSearch::Known LossSearch::after(const IndexSet& lost) {
  Known known{lost, remaining_.solve(lost), {}};
  if (known.status == LoadStatus::collapses) known.collapse = remaining_.collapse();
  if (known.status == LoadStatus::not_carried)
    known.collapse.motion = remaining_.overpowering_motion();
  return known;
}

// The factor after the loss of each further member. A member without stress is not missed.
std::vector<SingleLoss> LossSearch::after_one_more(const Known& known) {
  std::vector<int> members;
  for (const int i : eligible_ - known.lost) members.push_back(i);
  if (members.empty()) return {};
  const auto one = [&](std::uint64_t piece) -> Remains {
    const int i = members[piece];
    if (std::abs(known.collapse.forces(i)) <= no_stress)
      return {static_cast<std::int32_t>(LoadStatus::collapses), known.collapse.factor};
    auto lost = known.lost;
    lost.insert(i);
    const auto status = remaining_.solve(lost);
    const bool collapses = status == LoadStatus::collapses;
    return {static_cast<std::int32_t>(status), collapses ? remaining_.collapse().factor : 0};
  };
  const auto found = analysis_.share<Remains>(members.size(), one);
  std::vector<SingleLoss> losses;
  for (std::size_t k = 0; k < members.size(); ++k) {
    losses.push_back({members[k], static_cast<LoadStatus>(found[k].status), found[k].factor});
  }
  return losses;
}

// Loses the worst member, then the worst further one, up to K.
void LossSearch::start() {
  worst_ = after({});
  for (int k = 0; k < question_.most && worst_.status == LoadStatus::collapses; ++k) {
    if (analysis_.ended()) return;
    const auto losses = after_one_more(worst_);
    if (losses.empty()) return;
    if (k == 0) {
      answer_.singles = losses;
      for (auto& each : answer_.singles) each.factor *= model_.factor_unit;
    }
    const auto least = std::ranges::min_element(
        losses, {}, [](const SingleLoss& each) { return value(each.status, each.factor); });
    if (value(least->status, least->factor) >= value_of(worst_)) return;
    auto lost = worst_.lost;
    lost.insert(least->member);
    worst_ = after(lost);
  }
}

// @return whether the loss of a search is worth another search
bool LossSearch::take(const LossTree::Solution& solution) {
  auto found = after(solution.lost);
  if (found.status == LoadStatus::undetermined) return false;
  pool_ = solution.supports;
  const double margin = target_gap * model_.factor_unit;
  const double factor = value_of(found) * model_.factor_unit;
  target_ = std::min(target_, factor) - margin;
  if (value_of(found) < value_of(worst_)) worst_ = std::move(found);
  return worst_.status == LoadStatus::collapses && !question_.at_least;
}

void LossSearch::search_below() {
  for (;;) {
    const LossTarget target{std::min(question_.most, eligible_.size()), target_, eligible_};
    LossTree tree(model_, proof_, target, pool_, analysis_.budget().stop());
    engine::Options options;
    options.goal = engine::Goal::first;
    analysis_.say_now_and_then([&] {
      return fmt::format("losses of up to {} members below the load factor {:.10g}", target.most,
                         target.factor);
    });
    const auto outcome = analysis_.search(tree, options);
    const auto result = engine::from_first_rank(analysis_.transport(), [&] {
      Searched known{outcome.status, outcome.opened(), outcome.tally(), {}};
      if (!outcome.solutions.empty()) known.first.push_back(outcome.solutions.front().solution);
      return known;
    });
    answer_.search = result.status;
    ++answer_.counts.searches;
    answer_.counts.nodes += result.nodes;
    answer_.counts.programs += result.tally.programs;
    answer_.counts.states += result.tally.states;
    if (!result.first.empty()) {
      if (take(result.first.front())) continue;
      return;
    }
    answer_.undecided = result.tally.undecided;
    const bool whole = result.status == engine::Status::solved && answer_.undecided == 0;
    if (whole) lower_ = target.factor;
    return;
  }
}

// Removes members of the worst loss that it does not need.
void LossSearch::drop_useless() {
  for (const int member : IndexSet(worst_.lost)) {
    auto fewer = after(worst_.lost - IndexSet::single(member));
    const bool as_bad =
        fewer.status == worst_.status && value_of(fewer) <= value_of(worst_) + closed_gap / 10;
    if (as_bad) worst_ = std::move(fewer);
  }
}

void LossSearch::settle_target() {
  if (!question_.at_least) return;
  answer_.target = question_.at_least;
  const auto& ends = answer_.ends;
  if (lower_) {
    answer_.reaches_target = answer_.proved = true;
  } else if (ends.upper_proved && ends.upper < *question_.at_least) {
    answer_.reaches_target = false;
    answer_.proved = true;
  }
}

void LossSearch::conclude() {
  const double unit = model_.factor_unit;
  auto& ends = answer_.ends;
  answer_.lost.assign(worst_.lost.begin(), worst_.lost.end());
  if (worst_.status == LoadStatus::collapses) {
    answer_.collapse = LimitCollapse{worst_.collapse.factor * unit,
                                     {},
                                     problems::forces_in_units(model_, worst_.collapse.forces),
                                     problems::motion_in_units(model_, worst_.collapse.motion)};
    const auto proved = proof_.upper(worst_.lost, worst_.collapse.motion);
    ends.upper = proved.value_or(answer_.collapse->factor);
    ends.upper_proved = proved.has_value();
    if (lower_) {
      ends.lower = *lower_;
      ends.lower_proved = true;
    }
    answer_.proved =
        ends.lower_proved && ends.upper_proved && ends.upper - ends.lower <= answered_gap * unit;
  } else {
    ends.upper_proved = proof_.shows_no_factor(worst_.lost, worst_.collapse.motion);
    answer_.proved = ends.upper_proved;
  }
}

LossAnswer LossSearch::solve() {
  answer_.most = question_.most;
  answer_.eligible = eligible_.size();
  start();
  if (worst_.status == LoadStatus::undetermined) worst_ = after({});
  answer_.nominal = after({}).collapse.factor * model_.factor_unit;
  const bool ended = analysis_.ended();
  if (worst_.status == LoadStatus::collapses && !ended) {
    const double margin = target_gap * model_.factor_unit;
    const double known = value_of(worst_) * model_.factor_unit;
    target_ = question_.at_least.value_or(known - margin);
    const bool below = question_.at_least && known < target_ - margin;
    if (!below) search_below();
  }
  if (ended) answer_.search = analysis_.budget().why();
  drop_useless();
  conclude();
  settle_target();
  return std::move(answer_);
}

}  // namespace kusabi::limit
