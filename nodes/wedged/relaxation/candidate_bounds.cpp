// Sweeps of programs, each for one side of one candidate.
#include "nodes/wedged/relaxation/candidate_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "engine/analysis/shared_work.hpp"
#include "engine/collectives.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {

using support::IndexSet;

namespace {

/// Smallest bound relative to the first one: smaller bounds would lead to cuts with reactions and
/// gaps so small that t*, which no other inequality then limits, is close to the tolerance.
constexpr double min_share = 1e-2;
/// The same under loads, which have a share of s: with a hundred candidates each reaction is below
/// a hundredth of s on average.
constexpr double min_share_under_loads = 1e-3;

/// Bounds are increased by this share, to leave the proofs a margin for rounding errors.
constexpr double room = 1e-6;
/// The same under loads, where proofs of bounds depend on hundreds of others: with less, some of a
/// slab of 100 candidates are refused.
constexpr double room_under_loads = 1e-4;

/// Improvements of a bound below this share are not added.
constexpr double hardly_better = 1e-2;

/// Weight of t in the row of the bound, relative to its weight in the other rows. Those are then
/// relaxed by t, while the bound decreases by this multiple of t. Larger weights do not improve
/// bounds and take more iterations.
constexpr double level_of_bound = 30;

/// Relative accuracy of a bound: better ones would not be added.
constexpr double close_enough = hardly_better / 2;

/// Gaps of an unconstrained body are bounded from this many mean compliances down; larger bounds
/// are of no use.
constexpr double largest_gap = 100;

/// Candidates whose programs do not wait for each other's bounds.
constexpr int group_size = 8;

/// Sweeps end when bounds decrease by at most this share on average, or after the maximum number.
constexpr double slow_progress = 0.05;
constexpr int max_sweeps = 10;

// The value of the program is the possible decrease of the bound divided by the weight.
conic::StopEarly once_known(double bound) {
  const double worth = bound / level_of_bound;
  return {.when_infeasible = false,
          .when_feasible = false,
          .above = -hardly_better * worth,
          .below = -(1 + hardly_better) * worth,
          .width = close_enough * worth};
}

}  // namespace

bool excludes_all(std::span<const CandidateBounds> bounds, const IndexSet& contact,
                  const IndexSet& separated) {
  const auto of = [&](int i) -> const CandidateBounds& {
    return bounds[static_cast<std::size_t>(i)];
  };
  return std::ranges::any_of(contact, [&](int i) { return !of(i).can_touch(); }) ||
         std::ranges::any_of(separated, [&](int i) { return !of(i).can_separate(); });
}

std::optional<int> one_sided(const IndexSet& free, std::span<const CandidateBounds> bounds) {
  for (const int i : free)
    if (!bounds[static_cast<std::size_t>(i)].is_free()) return i;
  return {};
}

std::vector<conic::Cut> cuts_of(const IndexSet& candidates,
                                std::span<const CandidateBounds> bounds) {
  std::vector<conic::Cut> cuts;
  for (const int i : candidates) {
    const auto& own = bounds[static_cast<std::size_t>(i)];
    if (!own.is_free()) continue;
    if (std::isinf(own.gap) && own.reaction >= 1) continue;
    const double scale = std::min({1.0, own.gap, own.reaction});
    cuts.push_back({.candidate = i,
                    .share = scale,
                    .displacement = scale / own.gap,
                    .reaction = scale / own.reaction,
                    .level = scale});
  }
  return cuts;
}

std::vector<double> node_evidence(const Eigen::VectorXd& multipliers, Eigen::Index motions,
                                  double unit, const MeanMotion& mean_motion,
                                  const LoadPart& part) {
  const Eigen::Index m = mean_motion.candidates();
  const Eigen::Index modes = mean_motion.count();
  const Eigen::VectorXd beta = multipliers.tail(motions);
  Eigen::VectorXd own(m + modes);
  own << multipliers.head(m), beta.head(modes);
  auto numbers = mean_motion.with_multipliers(own, unit);
  if (part.has_equation()) numbers.push_back(part.equation_unit * unit * beta[motions - 1]);
  return numbers;
}

std::vector<double> cut_evidence(const ContactSolver& solver, const MeanMotion& mean_motion,
                                 std::span<const conic::Cut> cuts, const LoadPart& part) {
  // Far smaller multipliers of cuts are due to the barrier of the interior-point method; those of an
  // unconstrained body would have to be in equilibrium with the others.
  constexpr double negligible_cut = 1e-7;
  const Eigen::Index m = solver.candidates() - part.loads;
  const auto y = solver.multipliers().head(m);
  auto numbers = node_evidence(solver.multipliers(), solver.motion_multipliers().size(),
                               solver.unit(), mean_motion, part);
  const double least = mean_motion.count() == 0 ? 0 : negligible_cut * y.cwiseAbs().maxCoeff();
  const auto first = numbers.size();
  numbers.resize(first + static_cast<std::size_t>(m));
  for (std::size_t cut = 0; cut < cuts.size(); ++cut) {
    const double of_cut = cuts[cut].share * solver.cut_multiplier(cut);
    const double in_y = cuts[cut].displacement * solver.cut_multiplier(cut);
    const auto place = static_cast<std::size_t>(cuts[cut].candidate);
    if (std::max(of_cut, in_y) > least)
      numbers[first + place] = solver.unit() * of_cut;
    else
      numbers[place] += in_y;
  }
  return numbers;
}

// u_ni <= s max_k (F_nn,ik + mu_k |F_nt,ik|), k != i; for an unconstrained body without its
// rigid-body displacement.
CandidateBounding::CandidateBounding(const problems::WedgedProblem& problem,
                                     std::span<const double> friction, conic::Tolerances tolerances,
                                     const LoadPart& part, MeanMotion mean_motion)
    : solver_(problem, friction, tolerances, Precision::escalating, part.loads, part.equation),
      mean_motion_(std::move(mean_motion)),
      part_(part),
      bounds_(friction.size() - static_cast<std::size_t>(part.loads)),
      minimum_(bounds_.size()) {
  solver_.make_room(candidates() + 1);
  const double share = part.loads > 0 ? min_share_under_loads : min_share;
  const Eigen::Index d = problem.dimension;
  for (int i = 0; i < candidates(); ++i) {
    double maximum = 0;
    for (int k = 0; k < solver_.candidates(); ++k) {
      if (k == i) continue;
      const auto row = problem.compliance.matrix.row(d * i).segment(d * k, d);
      const double mu = friction[static_cast<std::size_t>(k)];
      maximum = std::max(maximum, row[0] + mu * row.tail(d - 1).norm());
    }
    // Far larger than the error of F.
    maximum += room * problem.compliance.matrix.row(d * i).cwiseAbs().maxCoeff();
    minimum_[static_cast<std::size_t>(i)] = {.gap = share * (maximum / solver_.unit()),
                                             .reaction = share};
    if (mean_motion_.count() > 0) continue;
    std::vector<double> numbers(2 * bounds_.size() + (part.has_equation() ? 2 : 1));
    numbers[static_cast<std::size_t>(i)] = 1;
    numbers.back() = 1;
    add_bound({.candidate = i, .side = Side::separated, .maximum = maximum, .numbers = numbers});
  }
}

double& CandidateBounding::known(int candidate, Side side) {
  auto& own = bounds_[static_cast<std::size_t>(candidate)];
  return side == Side::contact ? own.reaction : own.gap;
}

double CandidateBounding::in_units(double scaled, Side side) const {
  return side == Side::contact ? scaled : solver_.unit() * scaled;
}

void CandidateBounding::add_bound(ProvedBound bound) {
  known(bound.candidate, bound.side) =
      bound.maximum / (bound.side == Side::contact ? 1 : solver_.unit());
  proved_.push_back(std::move(bound));
}

std::vector<double> CandidateBounding::evidence(std::span<const conic::Cut> cuts, Side side) const {
  auto numbers = cut_evidence(solver_, mean_motion_, cuts.first(cuts.size() - 1), part_);
  const double own = solver_.cut_multiplier(cuts.size() - 1);
  numbers.push_back(side == Side::contact ? solver_.unit() * own : own);
  return numbers;
}

// The program of the side with the cuts and the row  r_ni - bound s >= weight t, or the same for
// u_ni. Its multipliers prove an upper bound of r_ni - bound s; if this is negative, the bound is
// improved by it.
std::optional<ProvedBound> CandidateBounding::improved(int candidate, Side side) {
  const double bound = std::isinf(known(candidate, side)) ? largest_gap : known(candidate, side);
  if (!bounds_[static_cast<std::size_t>(candidate)].is_free()) return {};
  IndexSet contact, separated, free;
  for (int i = 0; i < candidates(); ++i) {
    const auto& other = bounds_[static_cast<std::size_t>(i)];
    if (i == candidate) {
      (side == Side::contact ? contact : separated).insert(i);
    } else if (!other.can_separate()) {
      contact.insert(i);
    } else if (!other.can_touch()) {
      separated.insert(i);
    } else {
      free.insert(i);
    }
  }
  auto cuts = cuts_of(free, bounds_);
  cuts.push_back({.candidate = candidate,
                  .share = -bound,
                  .displacement = side == Side::separated ? -1.0 : 0.0,
                  .reaction = side == Side::contact ? -1.0 : 0.0,
                  .level = level_of_bound});
  solver_.solve_with(cuts, contact, separated, once_known(bound));
  const double maximum = bound + solver_.max_of(cuts.size() - 1);
  const auto& minimum = minimum_[static_cast<std::size_t>(candidate)];
  const double own_room = (part_.loads > 0 ? room_under_loads : room) * bound;
  ProvedBound result{.candidate = candidate, .side = side, .maximum = maximum, .numbers = {}};
  if (!(maximum < -own_room)) {
    result.maximum =
        std::max(maximum + own_room, side == Side::contact ? minimum.reaction : minimum.gap);
    if (!(result.maximum < (1 - hardly_better) * bound)) return {};
  }
  result.maximum = in_units(result.maximum, side);
  result.numbers = evidence(cuts, side);
  if (result.excludes_side()) result.numbers.pop_back();
  return result;
}

namespace {

// Logarithm of the ratio; a first bound counts as one.
double fall(double before, double after) {
  if (std::isinf(before)) return std::isinf(after) ? 0 : 1;
  return std::log(before / after);
}

// Mean logarithm of the factors by which the bounds of a candidate decrease; an excluded side
// counts as one.
double progress(std::span<const CandidateBounds> before, std::span<const CandidateBounds> after) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (!before[i].is_free()) continue;
    ++count;
    sum +=
        after[i].is_free()
            ? (fall(before[i].gap, after[i].gap) + fall(before[i].reaction, after[i].reaction)) / 2
            : 1;
  }
  return count == 0 ? 0 : sum / count;
}

// Summary for the log.
std::string in_short(std::span<const CandidateBounds> bounds, int sweep, int done) {
  int fixed = 0;
  double sum = 0;
  for (const auto& own : bounds) {
    fixed += own.is_free() ? 0 : 1;
    sum += std::max(0.0, own.reaction);
  }
  return fmt::format(
      "bounds: sweep {}, {} of {} candidates; {} fixed; largest reactions add up to {:.4g} of all",
      sweep, done, bounds.size(), fixed, sum);
}

bool is_decided(std::span<const CandidateBounds> bounds) {
  const auto impossible = [](const auto& own) { return !own.can_separate() && !own.can_touch(); };
  const auto free = [](const auto& own) { return own.is_free(); };
  return std::ranges::any_of(bounds, impossible) || std::ranges::none_of(bounds, free);
}

}  // namespace

std::uint64_t improve_bounds(engine::Analysis& analysis, CandidateBounding& bounding) {
  bounding.end_when(analysis.budget().stop());
  std::uint64_t programs = 0;
  bool spent = false;
  for (int sweep = 0; sweep < max_sweeps && !spent; ++sweep) {
    const auto before = bounding.bounds();
    for (int first = 0; first < bounding.candidates() && !spent; first += group_size) {
      const auto pieces =
          static_cast<std::uint64_t>(2 * std::min(group_size, bounding.candidates() - first));
      auto found = analysis.share<std::vector<ProvedBound>>(pieces, [&](std::uint64_t piece) {
        std::vector<ProvedBound> own;
        const int candidate = first + static_cast<int>(piece / 2);
        try {
          if (auto one =
                  bounding.improved(candidate, piece % 2 == 0 ? Side::separated : Side::contact))
            own.push_back(std::move(*one));
        } catch (const support::Stopped&) {
          own.clear();
        }
        return own;
      });
      for (auto& each : found)
        for (auto& one : each) bounding.add_bound(std::move(one));
      programs += pieces;
      analysis.say_now_and_then([&] {
        return in_short(bounding.bounds(), sweep + 1,
                        std::min(first + group_size, bounding.candidates()));
      });
      spent =
          engine::from_first_rank(analysis.transport(), [&] { return analysis.budget().spent(); });
    }
    if (is_decided(bounding.bounds()) || progress(before, bounding.bounds()) < slow_progress) break;
  }
  return programs;
}

RootBounds bound_candidates(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                            std::span<const double> friction, std::uint32_t block,
                            conic::Tolerances tolerances) {
  const auto candidates = problems::blocks_of(problem)[block];
  std::vector<double> own_friction;
  for (const int i : candidates) own_friction.push_back(friction[static_cast<std::size_t>(i)]);
  CandidateBounding bounding(problems::block_problem(problem, candidates), own_friction,
                             tolerances);
  RootBounds result{.bounds = {}, .proved = {}, .programs = improve_bounds(analysis, bounding)};
  result.bounds = bounding.bounds();
  result.proved = bounding.proved();
  std::vector<int> in_whole(candidates.begin(), candidates.end());
  for (auto& each : result.proved) {
    each.theorem = block;
    each.candidate = in_whole[static_cast<std::size_t>(each.candidate)];
  }
  return result;
}

}  // namespace kusabi::wedged
