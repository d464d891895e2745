// Solutions: the solutions that one rank keeps, and the incumbent that a further one must reach.
//
// Goal::best keeps the solutions of Options::pool in a heap, the worst first. Its incumbent is the
// worst solution that is still wanted: the last of a full pool, or the least objective plus the
// gap. Both only improve, and each is at least as bad as every solution of the answer, on any rank.
// A node that the incumbent rules out therefore contains no solution of the answer, and the answer
// is the best part of the union of all pools.
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <iomanip>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/detail/found_list.hpp"
#include "engine/detail/incumbent.hpp"
#include "engine/detail/nodes/saved_list.hpp"
#include "engine/expansion.hpp"
#include "engine/options.hpp"
#include "engine/problem.hpp"

namespace kusabi::engine {

/// A bound that a solution below its node contradicts; values in the user's sense.
class BoundContradicted : public std::logic_error {
 public:
  BoundContradicted(double bound, double objective, bool maximises)
      : std::logic_error(text(bound, objective, maximises)) {}

 private:
  static std::string text(double bound, double objective, bool maximises) {
    std::ostringstream line;
    line << std::setprecision(std::numeric_limits<double>::max_digits10) << "the bound " << bound
         << " of this node is " << (maximises ? "less" : "greater") << " than the objective "
         << objective << " of its solution; expected " << (maximises ? "an upper" : "a lower")
         << " bound of the objectives of all solutions below the node";
    return line.str();
  }
};

template <class P>
class Solutions {
 public:
  using Solution = typename P::Solution;

  /// @throws std::invalid_argument if the options contradict each other or the problem
  Solutions(P& problem, const Options& options)
      : problem_(problem),
        goal_(options.goal),
        pool_(options.goal == Goal::best ? options.pool : Pool{}),
        bound_tolerance_(options.bound_tolerance) {
    expect_pool();
    if (options.cutoff && goal_ == Goal::best)
      incumbent_ = {true, oriented<P>(*options.cutoff), after_all_paths};
  }

  /// Keeps a solution, or passes it to the problem's own `emit`.
  /// @param bound of its node, to be minimised; -infinity if there is none
  /// @return true if it is kept or passed on
  bool report(Solution&& solution, Path&& path, double bound) {
    if (goal_ == Goal::all) {
      store({std::move(path), std::move(solution)});
      return true;
    }
    const double value = objective(solution);
    if (std::isnan(value)) throw std::domain_error("the objective is not a number");
    if (bound > value + bound_tolerance_ * std::max(1.0, std::abs(value))) {
      throw BoundContradicted(oriented<P>(bound), oriented<P>(value), is_maximising<P>);
    }
    return keep(value, {std::move(path), std::move(solution)});
  }

  /// Takes the incumbent of another rank. Solutions worse than it are dropped.
  /// @return true if the incumbent of this rank improved
  bool learn(const Incumbent& received) {
    if (!received.better_than(incumbent_)) return false;
    incumbent_ = received;
    drop_unwanted();
    return true;
  }

  [[nodiscard]] const Incumbent& incumbent() const { return incumbent_; }

  /// Least objective of the solutions reported on this rank; infinity if there is none.
  [[nodiscard]] double objective() const { return minimum_; }

  /// True if this rank improved the incumbent since the last call.
  [[nodiscard]] bool just_improved() { return std::exchange(improved_, false); }

  [[nodiscard]] std::size_t size() const { return all_.size() + kept_.size(); }

  /// The solutions, those of Goal::best from the best to the worst, as long as this object does not
  /// change.
  [[nodiscard]] SavedList<FoundSolution<P>> list() const {
    return {size(), [this](const auto& look) {
              all_.for_each(look);
              std::vector<const Kept*> sorted;
              for (const auto& each : kept_) sorted.push_back(&each);
              std::sort(sorted.begin(), sorted.end(),
                        [](const Kept* one, const Kept* other) { return before(*one, *other); });
              for (const auto* each : sorted) look(each->found);
            }};
  }

  /// Removes them one by one, and calls `take(std::move(found))` for each.
  template <class Take>
  void take_each(Take take) {
    all_.take_each(take);
    std::sort(kept_.begin(), kept_.end(), before);
    for (auto& each : kept_) take(std::move(each.found));
    kept_.clear();
  }

  /// Adds solutions of another rank or of an earlier run, and takes their incumbent.
  void add(std::vector<FoundSolution<P>>&& list, const Incumbent& incumbent = {}) {
    for (auto& found : list) {
      if (goal_ == Goal::all) {
        all_.push_back(std::move(found));
      } else {
        const double value = objective(found.solution);
        keep(value, std::move(found));
      }
    }
    learn(incumbent);
    improved_ = false;
  }

  /// Begins the first of two expansions of a node: stores the state that `end_trial_expansion`
  /// restores. Nothing is emitted until then.
  void begin_trial_expansion() {
    trial_state_ = {incumbent_, minimum_, kept_, all_.position(), improved_};
    in_trial_ = true;
  }
  void end_trial_expansion() {
    std::tie(incumbent_, minimum_, kept_, improved_) = std::tie(
        trial_state_.incumbent, trial_state_.minimum, trial_state_.kept, trial_state_.improved);
    all_.return_to(trial_state_.all);
    in_trial_ = false;
  }

 private:
  struct Kept {
    double objective = 0;
    std::uint64_t age = 0;  // a node may report several of one objective
    FoundSolution<P> found;
  };

  // Order of the answer. Nodes that report several solutions are rare, and list them in this order.
  static bool before(const Kept& one, const Kept& other) {
    return std::tie(one.objective, one.found.path, one.age) <
           std::tie(other.objective, other.found.path, other.age);
  }

  void expect_pool() const {
    const bool gaps_valid = pool_.gap >= 0 && (pool_.relative_gap == unlimited ||
                                               (pool_.relative_gap >= 0 && pool_.relative_gap < 1));
    if (pool_.count > 0 && gaps_valid) return;
    throw std::invalid_argument(
        "Options::pool needs a count of at least 1, a gap of at least 0 and a relative gap of at "
        "least 0 and less than 1");
  }

  void store(FoundSolution<P>&& found) {
    if constexpr (Emitting<P>) {
      if (in_trial_ || problem_.emit(std::as_const(found.path), found.solution)) return;
    }
    all_.push_back(std::move(found));
  }

  [[nodiscard]] double objective(const Solution& solution) const {
    if constexpr (Optimising<P>) {
      if (goal_ == Goal::best) return oriented<P>(std::as_const(problem_).objective(solution));
    }
    return 0;  // Goal::first: all objectives are equal, the smaller path is better
  }

  bool keep(double value, FoundSolution<P>&& found) {
    if (incumbent_.better_than({true, value, found.path})) return false;
    const auto age = ++age_;
    kept_.push_back({value, age, std::move(found)});
    std::push_heap(kept_.begin(), kept_.end(), before);
    minimum_ = std::min(minimum_, value);
    if (kept_.size() > pool_.count && drop_worst() == age) return false;
    if (kept_.size() == pool_.count) {
      tighten({true, kept_.front().objective, kept_.front().found.path});
    }
    if (gap() < unlimited) tighten({true, minimum_ + gap(), after_all_paths});
    drop_unwanted();
    return true;
  }

  [[nodiscard]] double gap() const {
    if (pool_.relative_gap == unlimited) return pool_.gap;
    return std::min(pool_.gap, pool_.relative_gap * std::abs(minimum_));
  }

  void tighten(const Incumbent& candidate) {
    if (!candidate.better_than(incumbent_)) return;
    incumbent_ = candidate;
    improved_ = true;
  }

  // @return its age
  std::uint64_t drop_worst() {
    std::pop_heap(kept_.begin(), kept_.end(), before);
    const auto age = kept_.back().age;
    kept_.pop_back();
    return age;
  }

  void drop_unwanted() {
    while (!kept_.empty() &&
           incumbent_.better_than({true, kept_.front().objective, kept_.front().found.path})) {
      drop_worst();
    }
  }

  static constexpr double unlimited = std::numeric_limits<double>::infinity();
  // No node has so many children.
  inline static const Path after_all_paths{std::numeric_limits<std::uint32_t>::max()};

  struct TrialState {
    Incumbent incumbent;
    double minimum = 0;
    std::vector<Kept> kept;
    typename FoundList<P>::Position all;
    bool improved = false;
  };

  P& problem_;
  Goal goal_;
  Pool pool_;
  double bound_tolerance_;
  FoundList<P> all_;        // of Goal::all
  std::vector<Kept> kept_;  // of the other goals: a heap, the worst first
  Incumbent incumbent_;
  double minimum_ = unlimited;
  std::uint64_t age_ = 0;
  bool improved_ = false;
  bool in_trial_ = false;
  TrialState trial_state_;
};

}  // namespace kusabi::engine
