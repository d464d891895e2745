// A question that takes several searches, and how whoever asks it takes part: where to stop, what
// is shown meanwhile. Without a word the question runs to its end, in silence.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <typeinfo>
#include <utility>
#include <vector>

#include "engine/budget.hpp"
#include "engine/options.hpp"
#include "engine/recording.hpp"
#include "engine/search.hpp"
#include "engine/shared_work.hpp"
#include "engine/shown_objective.hpp"
#include "engine/together.hpp"
#include "engine/transport/transport.hpp"

namespace kusabi::engine {

/// What a caller wants of a question, and wants to see of it.
struct Supervision {
  /// Over all that the question takes. The time counts from its beginning, the nodes over all
  /// searches, and over all runs of a question that is kept; the rest is for each search by itself.
  Limits limits = {};

  /// As Options::interrupt, but asked outside of searches, too: see Budget.
  std::function<Interrupt()> interrupt = {};

  /// Called on rank 0 when a search begins. What it returns is told of the search's progress, and
  /// destroyed when the search has ended.
  std::function<std::function<void(const Progress&)>(Goal, const ShownObjective&)> watch = {};

  /// Told, on rank 0, what long work outside of searches is doing: one line, now and then.
  std::function<void(const std::string&)> say = {};

  /// Of what changes all the time, so often.
  std::chrono::steady_clock::duration say_every = std::chrono::seconds(2);

  /// Told, on rank 0, of what went wrong without ending the question: one line.
  std::function<void(const std::string&)> warn = {};

  /// Where what is finished of the question is kept, so that another run can go on with it; unless
  /// given, nowhere.
  std::optional<Keeping> keeping = {};
};

/// One question on all ranks of a transport, under way. Its parts are searches, works that are
/// shared and works of rank 0; each is done once, however many runs the question takes, if it is
/// kept: what was finished in an earlier run is not done again (engine/recording.hpp).
///
/// Requires then: what the parts are and come to depends on the question alone, not on the number
/// of ranks nor on timing, unless the budget is spent.
class Campaign {
 public:
  /// The time begins to count. The transport must outlive it.
  explicit Campaign(Transport& transport, Supervision supervision = {})
      : transport_(transport),
        supervision_(std::move(supervision)),
        budget_(supervision_.limits, supervision_.interrupt) {
    if (supervision_.keeping)
      recording_.emplace(transport, *supervision_.keeping, supervision_.warn);
  }
  Campaign(const Campaign&) = delete;
  Campaign& operator=(const Campaign&) = delete;
  ~Campaign() = default;

  [[nodiscard]] Transport& transport() { return transport_; }
  [[nodiscard]] bool is_first() const { return transport_.rank() == 0; }
  [[nodiscard]] const Budget& budget() const { return budget_; }

  /// Nodes that were opened beside its searches, say by rank 0; every rank counts the same.
  void count_nodes(std::uint64_t nodes) { budget_.count(nodes); }

  /// Whether what is finished is kept.
  [[nodiscard]] bool is_kept() const { return recording_.has_value(); }

  /// engine::search within what is left of the budget, watched. A part of the question.
  /// @param options is completed by interrupt and progress, and its limits by what is left; if the
  ///   question is kept, by where its checkpoint is as well
  template <class P>
  OutcomeOf<P> search(P& problem, Options options, const ShownObjective& shown = {}) {
    if (!recording_) return search_anew(problem, std::move(options), shown);
    const auto kind = kind_of_search(typeid(P).name());
    if (const auto known = recording_->known(kind, budget_.spent(), false)) {
      auto outcome = told<P>(*known);
      count<P>(outcome);
      return outcome;
    }
    const bool sound = recording_->sound(budget_.spent());
    if (sound) options.checkpoint = recording_->checkpoint();
    auto outcome = search_anew(problem, std::move(options), shown);
    if (sound && outcome.status == Status::solved)
      recording_->keep(kind, is_first() ? pack(outcome) : Bytes());
    return outcome;
  }

  /// The same, but no part of the question: every run does it again.
  template <class P>
  OutcomeOf<P> search_anew(P& problem, Options options, const ShownObjective& shown = {}) {
    complete(options, shown);
    auto outcome = engine::search(problem, transport_, options);
    count<P>(outcome);
    return outcome;
  }

  /// engine::share_work, as a part of the question.
  template <class Result>
  std::vector<Result> share(std::uint64_t pieces, std::function<Result(std::uint64_t)> piece) {
    return part<std::vector<Result>>(
        [&] { return share_work<Result>(transport_, pieces, std::move(piece)); });
  }

  /// engine::from_first_rank, as a part of the question: for work that takes long.
  template <class Make>
  std::invoke_result_t<Make> by_first_rank(Make make) {
    return part<std::invoke_result_t<Make>>([&] { return from_first_rank(transport_, make); });
  }

  /// Since it began.
  [[nodiscard]] double seconds() const { return budget_.seconds(); }

  /// Whether the budget of rank 0 is spent, on all ranks alike.
  bool ended() {
    return from_first_rank(transport_, [this] { return budget_.spent(); });
  }

  /// engine::search on this rank alone, within what is left of the budget, watched: for
  /// by_first_rank. Its nodes are counted by whoever calls that.
  template <class P>
  OutcomeOf<P> search_alone(P& problem, Options options) {
    complete(options, {});
    return engine::search(problem, options);
  }

  void say(const std::string& line) {
    if (is_first() && supervision_.say) supervision_.say(line);
  }

  /// The same of what changes all the time, now and then. @param line makes a line
  template <class Line>
  void say_now_and_then(Line line) {
    const auto now = std::chrono::steady_clock::now();
    if (now - said_ < supervision_.say_every) return;
    said_ = now;
    say(line());
  }

 private:
  // What every rank gets alike.
  template <class Value, class Make>
  Value part(Make make) {
    if (!recording_) return make();
    const std::string kind = typeid(Value).name();
    if (const auto known = recording_->known(kind, budget_.spent(), true))
      return unpack<Value>(std::span<const char>(known->data(), known->size()));
    Value value = make();
    if (recording_->sound(budget_.spent()))
      recording_->keep(kind, is_first() ? pack(value) : Bytes());
    return value;
  }

  void complete(Options& options, const ShownObjective& shown) {
    const auto left = budget_.left();
    options.limits = {.seconds = std::min(left.seconds, options.limits.seconds),
                      .nodes = std::min(left.nodes, options.limits.nodes),
                      .solutions = std::min(left.solutions, options.limits.solutions),
                      .gap = std::max(left.gap, options.limits.gap)};
    options.interrupt = budget_.interrupt();
    if (!options.warn) options.warn = supervision_.warn;
    if (is_first() && supervision_.watch)
      options.progress = supervision_.watch(options.goal, shown);
  }

  // What rank 0 knows of all ranks.
  template <class P>
  void count(const OutcomeOf<P>& outcome) {
    if (supervision_.limits.nodes != Limits{}.nodes)
      budget_.count(from_first_rank(transport_, [&] { return outcome.opened(); }));
  }

  // The outcome of a search that was done before: whole on rank 0, as it is after any.
  template <class P>
  OutcomeOf<P> told(const Bytes& known) {
    if (is_first()) return unpack<OutcomeOf<P>>(std::span<const char>(known.data(), known.size()));
    OutcomeOf<P> outcome;
    outcome.ranks.resize(1);
    return outcome;
  }

  Transport& transport_;
  Supervision supervision_;
  Budget budget_;
  std::chrono::steady_clock::time_point said_ = std::chrono::steady_clock::now();
  std::optional<Recording> recording_;
};

}  // namespace kusabi::engine
