// Analysis: a sequence of searches, shared work and work of rank 0, with common limits, progress
// output and a journal; by default without any of these.
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

#include "engine/analysis/budget.hpp"
#include "engine/analysis/recording.hpp"
#include "engine/analysis/shared_work.hpp"
#include "engine/collectives.hpp"
#include "engine/options.hpp"
#include "engine/search.hpp"
#include "engine/shown_objective.hpp"
#include "engine/transport/transport.hpp"

namespace kusabi::engine {

/// Limits, output and journal of an analysis.
struct AnalysisOptions {
  /// Limits of the whole analysis: the time counts from its beginning, the nodes over all searches
  /// and all resumed runs; the other limits apply to each search.
  Limits limits = {};

  /// As Options::interrupt. It is also called between searches; see Budget.
  std::function<Interrupt()> interrupt = {};

  /// Called on rank 0 when a search begins. The returned function receives the progress of that
  /// search and is destroyed when the search ends.
  std::function<std::function<void(const Progress&)>(Goal, const ShownObjective&)> watch = {};

  /// Called on rank 0, now and then, with a line about long work outside searches.
  std::function<void(const std::string&)> say = {};

  /// Minimum interval of lines about quantities that change continuously.
  std::chrono::steady_clock::duration say_every = std::chrono::seconds(2);

  /// Called on rank 0 with a line about a fault that does not end the analysis.
  std::function<void(const std::string&)> warn = {};

  /// Journal of finished parts, from which another run resumes; by default there is none.
  std::optional<JournalOptions> journal_options = {};
};

/// An analysis in progress, on all ranks of a transport. Its parts are searches, shared work and
/// work of rank 0. With a journal, a part that an earlier run finished is not repeated
/// (engine/analysis/recording.hpp).
///
/// @pre with a journal: the parts and their results depend on the analysis alone, not on the number
///     of ranks and not on timing, unless the budget is spent
class Analysis {
 public:
  /// Starts the clock. The transport must outlive this object.
  explicit Analysis(Transport& transport, AnalysisOptions analysis_options = {})
      : transport_(transport),
        options_(std::move(analysis_options)),
        budget_(options_.limits, options_.interrupt) {
    if (options_.journal_options)
      recording_.emplace(transport, *options_.journal_options, options_.warn);
  }
  Analysis(const Analysis&) = delete;
  Analysis& operator=(const Analysis&) = delete;
  ~Analysis() = default;

  [[nodiscard]] Transport& transport() { return transport_; }
  [[nodiscard]] bool is_first() const { return transport_.rank() == 0; }
  [[nodiscard]] const Budget& budget() const { return budget_; }

  /// Counts nodes that rank 0 or all ranks opened outside searches. @pre every rank counts the same
  void count_nodes(std::uint64_t nodes) { budget_.count(nodes); }

  /// True if finished parts are written to a journal.
  [[nodiscard]] bool has_journal() const { return recording_.has_value(); }

  /// A part of the analysis: engine::search within the remaining budget, with progress output.
  /// @param options the analysis adds interrupt and progress, tightens the limits to what remains
  ///   and, with a journal, sets the checkpoint
  template <class P>
  OutcomeOf<P> search(P& problem, Options options, const ShownObjective& shown = {}) {
    if (!recording_) return search_anew(problem, std::move(options), shown);
    const auto kind = kind_of_search(typeid(P).name());
    if (const auto known = recording_->known(kind, budget_.spent(), false)) {
      auto outcome = recorded_outcome<P>(*known);
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

  /// As `search`, but not a part of the analysis: every run repeats it.
  template <class P>
  OutcomeOf<P> search_anew(P& problem, Options options, const ShownObjective& shown = {}) {
    complete<P>(options, shown);
    auto outcome = engine::search(problem, transport_, options);
    count<P>(outcome);
    return outcome;
  }

  /// A part of the analysis: engine::share_work. It does not end early unless its pieces test the
  /// budget.
  template <class Result>
  std::vector<Result> share(std::uint64_t pieces, std::function<Result(std::uint64_t)> piece) {
    return part<std::vector<Result>>(
        [&] { return share_work<Result>(transport_, pieces, std::move(piece)); });
  }

  /// As `share`, within the time and the nodes of the analysis and with its progress, as `search`.
  /// @pre pieces > 0 @return on every rank all results; none if the analysis was stopped
  template <class Result>
  std::vector<Result> share_within_limits(std::uint64_t pieces,
                                          const std::function<Result(std::uint64_t)>& piece) {
    std::vector<Result> results;
    const auto packed =
        share_packed(pieces, [&](std::uint64_t number) { return pack(piece(number)); });
    results.reserve(packed.size());
    for (const auto& bytes : packed) results.push_back(unpack<Result>(bytes));
    return results;
  }

  /// A part of the analysis: engine::from_first_rank, for long computations.
  template <class Make>
  std::invoke_result_t<Make> by_first_rank(Make make) {
    return part<std::invoke_result_t<Make>>([&] { return from_first_rank(transport_, make); });
  }

  /// Seconds since the analysis began.
  [[nodiscard]] double seconds() const { return budget_.seconds(); }

  /// True on all ranks if the budget of rank 0 is spent.
  bool ended() {
    return from_first_rank(transport_, [this] { return budget_.spent(); });
  }

  /// Budget::stop_reason() of rank 0, on all ranks.
  Status stop_reason() {
    return from_first_rank(transport_, [this] { return budget_.stop_reason(); });
  }

  /// engine::search on this rank alone, within the remaining budget and with progress output, for
  /// use inside by_first_rank(). The caller of that counts the nodes.
  template <class P>
  OutcomeOf<P> search_alone(P& problem, Options options) {
    const auto nodes = options.limits.nodes;
    complete<P>(options, {});
    auto outcome = engine::search(problem, options);
    cut_short_ =
        cut_short_ || (outcome.status == Status::node_limit && options.limits.nodes < nodes);
    return outcome;
  }

  void say(const std::string& line) {
    if (is_first() && options_.say) options_.say(line);
  }

  /// Reports quantities that change continuously, at most every `say_every`.
  /// @param line makes a line
  template <class Line>
  void say_now_and_then(Line line) {
    const auto now = std::chrono::steady_clock::now();
    if (now - said_ < options_.say_every) return;
    said_ = now;
    say(line());
  }

 private:
  // One search, compiled once, serves all types of results.
  std::vector<Bytes> share_packed(std::uint64_t pieces, std::function<Bytes(std::uint64_t)> piece);

  // A part whose result every rank needs.
  template <class Value, class Make>
  Value part(Make make) {
    if (!recording_) return make();
    const std::string kind = typeid(Value).name();
    if (const auto known = recording_->known(kind, budget_.spent(), true))
      return unpack<Value>(std::span<const char>(known->data(), known->size()));
    Value value = make();
    if (recording_->sound(budget_.spent() || cut_short_))
      recording_->keep(kind, is_first() ? pack(value) : Bytes());
    return value;
  }

  template <class P>
  void complete(Options& options, const ShownObjective& shown) {
    auto left = budget_.left();
    // The results of shared work are not solutions, which the other limits are for.
    if constexpr (std::is_same_v<P, SharedWork<Bytes>>)
      left = {.seconds = left.seconds, .nodes = left.nodes};
    options.limits = {.seconds = std::min(left.seconds, options.limits.seconds),
                      .nodes = std::min(left.nodes, options.limits.nodes),
                      .solutions = std::min(left.solutions, options.limits.solutions),
                      .gap = std::max(left.gap, options.limits.gap)};
    options.interrupt = budget_.interrupt();
    if (!options.warn) options.warn = options_.warn;
    if (is_first() && options_.watch) options.progress = options_.watch(options.goal, shown);
  }

  // Adds the opened nodes of all ranks, which rank 0 knows, to the budget.
  template <class P>
  void count(const OutcomeOf<P>& outcome) {
    if (options_.limits.nodes != Limits{}.nodes)
      budget_.count(from_first_rank(transport_, [&] { return outcome.opened(); }));
  }

  // Outcome of a search that an earlier run finished: complete on rank 0, as after any search.
  template <class P>
  OutcomeOf<P> recorded_outcome(const Bytes& known) {
    if (is_first()) return unpack<OutcomeOf<P>>(std::span<const char>(known.data(), known.size()));
    OutcomeOf<P> outcome;
    outcome.ranks.resize(1);
    return outcome;
  }

  Transport& transport_;
  AnalysisOptions options_;
  Budget budget_;
  std::chrono::steady_clock::time_point said_ = std::chrono::steady_clock::now();
  std::optional<Recording> recording_;
  bool cut_short_ = false;  // the nodes of the analysis ended a search of this rank alone
};

}  // namespace kusabi::engine
