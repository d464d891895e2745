// Greedy first loss, member by member; then rounds of nodes of one tree, shared among the ranks.
// The target decreases whenever a worse loss is found.
#include "nodes/limit/loss/loss_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "engine/collectives.hpp"
#include "nodes/limit/root/root_search.hpp"
#include "nodes/limit/root/worst_case.hpp"
#include "nodes/limit/search/proved_ends.hpp"
#include "nodes/limit/search/worst_case_search.hpp"

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

/// A suspect is consistent with a remaining factor up to this above the target, scaled: the margin
/// of the yield forces costs about as much.
constexpr double consistent = 10 * closed_gap;

/// Decreases of the target, scaled, after which losses without a proof are tried again: a state
/// with less factor leaves more margin. Their sum is below `answered_gap`.
constexpr double decreases[] = {1e-7, 4e-7};

/// A member with less, relative to its unit, has no stress in a basic solution.
constexpr double no_stress = 1e-12;

/// Nodes of a round: few while there are few states, since all nodes of a round find states that
/// others could have used. States against the loss of one member have most members in common, so
/// that each excludes few losses.
std::size_t nodes_of_a_round(std::size_t states, int losses) {
  constexpr std::size_t maximum = 64;
  const std::size_t states_per_node = losses == 1 ? 4 : 16;
  return std::clamp<std::size_t>(states / states_per_node, 1, maximum);
}

/// Load factor after one loss, packed for other ranks.
struct FactorAfterLoss {
  std::int32_t status = 0;
  double factor = 0;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& status& factor;
  }
};

}  // namespace

LossSearch::LossSearch(engine::Analysis& analysis, const verify::Structure& truss,
                       const problems::LimitProblem& problem, const problems::LimitModel& model,
                       const LossParameters& parameters, double alpha)
    : analysis_(analysis),
      truss_(truss),
      problem_(problem),
      model_(model),
      parameters_(parameters),
      alpha_(alpha),
      eligible_(IndexSet::below(problem.member_count())),
      proof_(truss, problem, alpha, parameters.sudden),
      remaining_(model, alpha / model.force_unit) {
  for (const int member : parameters.kept) eligible_ -= IndexSet::single(member);
}

// The worst load known after a loss. An answer without a proof that a load has no factor would end
// the search, and is none.
// @param stop empty: the few programs of one loss are solved also after the end of the budget, so
//        that the worst loss known is reported with its collapse
LossSearch::Known LossSearch::after(const IndexSet& lost, const support::Stop& stop) {
  if (support::is_requested(stop)) return {};
  const Eigen::VectorXd start = worst_.zeta / model_.force_unit;
  auto found = remaining_.solve(lost, start, stop);
  Known known{lost, found.status, {}, {}};
  if (found.status == LoadStatus::collapses) {
    auto& [zeta, collapse] = found.worst;
    known.zeta = zeta * model_.force_unit;
    known.collapse = {collapse.factor * model_.factor_unit,
                      {},
                      problems::forces_in_units(model_, collapse.forces),
                      problems::motion_in_units(model_, collapse.motion)};
  } else if (found.status == LoadStatus::not_carried) {
    known.zeta = found.overpowering_load * model_.force_unit;
    if (found.overpowering_motion.size() > 0)
      known.collapse.motion = problems::motion_in_units(model_, found.overpowering_motion);
    const auto zeta = alpha_ == 0 ? Eigen::VectorXd() : known.zeta;
    if (!proof_.shows_no_factor(lost, zeta, known.collapse.motion))
      known = {lost, LoadStatus::undetermined, {}, {}};
  }
  return known;
}

// The same, with a proof that no admissible load is worse, if loads are uncertain.
LossSearch::Known LossSearch::worst_after(const IndexSet& lost) {
  auto known = after(lost);
  if (alpha_ == 0 || known.status == LoadStatus::not_carried) return known;
  auto problem = problem_;
  auto truss = truss_;
  for (auto& bar : truss.bars) {
    bar.tension /= parameters_.sudden;
    bar.compression /= parameters_.sudden;
  }
  for (const int i : lost) {
    problem.tension(i) = problem.compression(i) = 0;
    truss.bars[static_cast<std::size_t>(i)].tension = 0;
    truss.bars[static_cast<std::size_t>(i)].compression = 0;
  }
  RootSearch search(analysis_, problem);
  const auto status = search.set_up(problems::limit_model(problem, model_.force_unit));
  if (status != LoadStatus::collapses) return known;
  const LimitParameters parameters{.alpha = alpha_};
  auto worst = WorstCaseSearch(search, parameters, truss).solve();
  if (worst.status == RootStatus::not_carried) {
    known.status = LoadStatus::not_carried;
    known.zeta = worst.zeta;
    known.collapse = {};
    known.collapse.motion = worst.overpowering_motion;
  } else if (worst.collapse && (known.status != LoadStatus::collapses ||
                                worst.collapse->factor < known.collapse.factor)) {
    known.status = LoadStatus::collapses;
    known.zeta = worst.zeta;
    known.collapse = *worst.collapse;
  }
  return known;
}

// The factor after the loss of each further member. A member without stress is not missed by the
// load of the known loss.
std::vector<SingleLoss> LossSearch::after_one_more(const Known& known) {
  std::vector<int> members;
  for (const int i : eligible_ - known.lost) members.push_back(i);
  if (members.empty()) return {};
  const auto one = [&](std::uint64_t piece) -> FactorAfterLoss {
    const int i = members[piece];
    const bool idle = std::abs(known.collapse.forces(i)) <= no_stress * model_.member_unit(i);
    if (idle && alpha_ == 0)
      return {static_cast<std::int32_t>(LoadStatus::collapses), known.collapse.factor};
    const auto found = after(known.lost | IndexSet::single(i), analysis_.budget().stop());
    return {static_cast<std::int32_t>(found.status), found.collapse.factor};
  };
  const auto found = analysis_.share<FactorAfterLoss>(members.size(), one);
  std::vector<SingleLoss> losses;
  for (std::size_t k = 0; k < members.size(); ++k) {
    losses.push_back({members[k], static_cast<LoadStatus>(found[k].status), found[k].factor});
  }
  return losses;
}

// Loses the worst member, then the worst further one, up to K. A loss whose factor the simplex
// method does not determine is not kept.
void LossSearch::start() {
  worst_ = after({});
  answer_.nominal = worst_.collapse.factor;
  for (int k = 0; k < parameters_.maximum && worst_.status == LoadStatus::collapses; ++k) {
    if (analysis_.ended()) return;
    const auto losses = after_one_more(worst_);
    if (losses.empty()) return;
    if (k == 0) answer_.singles = losses;
    const auto minimum = std::ranges::min_element(
        losses, {}, [](const SingleLoss& each) { return value(each.status, each.factor); });
    const double now = value(worst_.status, worst_.collapse.factor);
    if (value(minimum->status, minimum->factor) >= now) return;
    auto next = after(worst_.lost | IndexSet::single(minimum->member));
    if (next.status == LoadStatus::undetermined) return;
    worst_ = std::move(next);
  }
}

// A suspect is a worse loss, or its node stays undecided.
void LossSearch::judge(const IndexSet& suspect) {
  auto found = worst_after(suspect);
  const double unit = model_.factor_unit;
  const double factor = value(found.status, found.collapse.factor);
  if (factor > known_.target + consistent * unit) {
    known_.undecided.push_back(suspect);
    return;
  }
  if (factor < value(worst_.status, worst_.collapse.factor)) worst_ = std::move(found);
  if (parameters_.at_least) {
    missed_ = true;
  } else {
    known_.target = std::min(known_.target, factor) - target_gap * unit;
  }
}

// Opens no more nodes than the analysis may.
std::vector<LossPiece> LossSearch::open_round(const std::vector<LossNode>& batch) {
  const auto most =
      std::min(LossOpener::nodes_of_a_piece, analysis_.budget().left().nodes / batch.size());
  return analysis_.share<LossPiece>(batch.size(), [&](std::uint64_t k) {
    LossOpener opener(*program_, proof_, model_.factor_unit, known_, analysis_.budget().stop());
    return opener.open(batch[k], most);
  });
}

// Nodes are kept with the next one in depth-first order last.
void LossSearch::search_below() {
  const auto kept = IndexSet::below(model_.member_count()) - eligible_;
  std::vector<LossNode> open{{{}, kept, std::min(parameters_.maximum, eligible_.size())}};
  program_.emplace(model_, alpha_ / model_.force_unit, known_.target / model_.factor_unit,
                   analysis_.budget().stop());
  while (!open.empty() && !missed_ && worst_.status == LoadStatus::collapses) {
    if (analysis_.ended()) return;
    analysis_.say_now_and_then([&] {
      return fmt::format(
          "losses of up to {} members: none of the closed nodes below the load factor {:.10g}; {} "
          "nodes closed, {} open, {} states",
          parameters_.maximum, known_.target, answer_.counts.nodes, open.size(), states_.size());
    });
    const auto whole_pieces =
        std::max<std::uint64_t>(analysis_.budget().left().nodes / LossOpener::nodes_of_a_piece, 1);
    const auto size = std::min<std::uint64_t>(
        {open.size(), nodes_of_a_round(states_.size(), parameters_.maximum), whole_pieces});
    const std::vector<LossNode> batch(open.rbegin(),
                                      open.rbegin() + static_cast<std::ptrdiff_t>(size));
    auto pieces = open_round(batch);
    open.resize(open.size() - pieces.size());  // fewer than now, if an earlier run opened them
    ++answer_.counts.rounds;
    std::set<IndexSet> suspects;
    for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece)
      open.insert(open.end(), piece->open.rbegin(), piece->open.rend());
    std::uint64_t opened = 0;
    for (auto& piece : pieces) {
      opened += piece.nodes;
      answer_.counts.programs += piece.programs;
      if (piece.has_suspect) suspects.insert(piece.suspect);
      for (auto& state : piece.states) {
        known_.supports.push_back(state.support);
        states_.push_back(std::move(state));
      }
    }
    answer_.counts.nodes += opened;
    analysis_.count_nodes(opened);
    if (analysis_.ended()) return;
    for (const auto& suspect : suspects) judge(suspect);
  }
  if (open.empty() && known_.undecided.empty()) lower_ = known_.target;
}

// A smaller target may decide what is left.
void LossSearch::search() {
  search_below();
  for (const double decrease : decreases) {
    const bool final = known_.undecided.empty() || parameters_.at_least ||
                       worst_.status != LoadStatus::collapses || analysis_.ended();
    if (final) return;
    known_.undecided.clear();
    known_.target -= decrease * model_.factor_unit;
    search_below();
  }
}

// Removes members of the worst loss that it does not need.
void LossSearch::drop_useless() {
  const double room = closed_gap / 10 * model_.factor_unit;
  for (const int member : IndexSet(worst_.lost)) {
    auto fewer = after(worst_.lost - IndexSet::single(member));
    const bool as_bad =
        fewer.status == worst_.status && (fewer.status == LoadStatus::not_carried ||
                                          fewer.collapse.factor <= worst_.collapse.factor + room);
    if (as_bad) worst_ = std::move(fewer);
  }
}

// Without any load but the reference load, factor zero is carried without any force.
void LossSearch::use_no_load() {
  if (alpha_ > 0 || !problem_.dead.isZero(0) || lower_.value_or(-1) >= 0) return;
  // The exact sum of the loads at a node may differ from zero: the verifier decides.
  auto state = proof_.proved({{}, {verify::StressColumn{}}}, {}, 0, {}, false, {});
  if (!state || !state->support.empty()) return;
  lower_ = 0;
  known_.supports.assign(1, {});
  states_.assign(1, *std::move(state));
}

void LossSearch::settle_target() {
  if (!parameters_.at_least) return;
  answer_.target = parameters_.at_least;
  const auto& ends = answer_.ends;
  if (lower_.value_or(-infinite) >= *parameters_.at_least) {
    answer_.reaches_target = true;
    answer_.standing = support::Standing::proved;
  } else if (answer_.fatal == support::Standing::proved ||
             (is_proved(ends.upper) && ends.at_most() < *parameters_.at_least)) {
    answer_.reaches_target = false;
    answer_.standing = support::Standing::proved;
  }
}

void LossSearch::conclude() {
  const double unit = model_.factor_unit;
  auto& ends = answer_.ends;
  answer_.lost.assign(worst_.lost.begin(), worst_.lost.end());
  answer_.zeta = alpha_ == 0 ? Eigen::VectorXd() : worst_.zeta;
  answer_.undecided = known_.undecided.size();
  answer_.counts.states = states_.size();
  if (worst_.status == LoadStatus::collapses) {
    answer_.collapse = worst_.collapse;
    const auto proved = proof_.upper(worst_.lost, answer_.zeta, worst_.collapse.motion);
    ends.upper = support::Bound{proved.value_or(worst_.collapse.factor),
                                support::proved_if(proved.has_value())};
    if (lower_) ends.lower = support::Bound{*lower_, support::Standing::proved};
    answer_.standing = support::proved_if(ends.proved_within(answered_gap * unit));
  } else if (worst_.status != LoadStatus::undetermined) {
    answer_.fatal_motion = worst_.collapse.motion;
    answer_.standing = support::proved_if(
        proof_.shows_no_factor(worst_.lost, answer_.zeta, worst_.collapse.motion));
    answer_.fatal = answer_.standing;
  }
}

verify::LossCover LossSearch::cover() const {
  const int members = problem_.member_count();
  return {known_.supports, IndexSet::below(members) - eligible_,
          std::clamp(eligible_.size(), 1, parameters_.maximum)};
}

// The claims that are proved, with the states that the proof needs.
void LossSearch::record() {
  const bool fatal = answer_.fatal.has_value();
  if (!analysis_.is_first() || !(fatal ? answer_.proved() : is_proved(answer_.ends.upper))) return;
  const auto& motion = fatal ? answer_.fatal_motion : answer_.collapse->motion;
  auto collapse = proof_.collapse(worst_.lost, answer_.zeta, motion);
  if (!collapse) return;
  auto& theorem = answer_.theorem.emplace();
  theorem.truss = proof_.truss();
  if (fatal) theorem.claim = verify::LimitClaim::none;
  theorem.losses = static_cast<std::size_t>(std::clamp(eligible_.size(), 1, parameters_.maximum));
  theorem.sudden = parameters_.sudden;
  for (const int i : IndexSet::below(problem_.member_count()) - eligible_)
    theorem.kept.push_back(static_cast<std::size_t>(i));
  theorem.collapse = *std::move(collapse);
  if (!lower_ || fatal) return;
  theorem.lower = *lower_;
  for (const auto k : cover().needed()) theorem.states.push_back(states_[k].state);
}

LossAnswer LossSearch::solve() {
  answer_.maximum = parameters_.maximum;
  answer_.uncertain = alpha_ > 0;
  answer_.sudden = parameters_.sudden;
  answer_.eligible = eligible_.size();
  start();
  const bool ended = analysis_.ended();
  if (worst_.status == LoadStatus::collapses && !ended) {
    const double margin = target_gap * model_.factor_unit;
    known_.target = parameters_.at_least.value_or(worst_.collapse.factor - margin);
    missed_ = parameters_.at_least && worst_.collapse.factor < known_.target - margin;
    if (!missed_) search();
  }
  if (lower_ && cover().flaw()) lower_.reset();  // the proof of verify would refuse it
  const bool complete = lower_.has_value();
  if (worst_.status == LoadStatus::collapses) use_no_load();
  drop_useless();
  conclude();
  settle_target();
  // Losses of one member that were not computed.
  if (analysis_.ended())
    std::erase_if(answer_.singles,
                  [](const auto& each) { return each.status == LoadStatus::undetermined; });
  if (analysis_.ended() && !complete && !answer_.proved())
    answer_.search = analysis_.budget().stop_reason();
  record();
  return std::move(answer_);
}

}  // namespace kusabi::limit
