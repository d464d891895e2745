// A question that takes several searches, and how whoever asks it takes part: where to stop, what
// is shown meanwhile. Without a word the question runs to its end, in silence.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "engine/budget.hpp"
#include "engine/options.hpp"
#include "engine/search.hpp"
#include "engine/shown_objective.hpp"
#include "engine/transport/transport.hpp"

namespace kusabi::engine {

/// What a caller wants of a question, and wants to see of it.
struct Supervision {
  /// Over all that the question takes. The time counts from its beginning; the rest is for each
  /// search by itself.
  Limits limits = {};

  /// As Options::interrupt, but asked outside of searches, too: see Budget.
  std::function<Interrupt()> interrupt = {};

  /// Called on rank 0 when a search begins. What it returns is told of the search's progress, and
  /// destroyed when the search has ended.
  std::function<std::function<void(const Progress&)>(Goal, const ShownObjective&)> watch = {};

  /// Told, on rank 0, what long work outside of searches is doing: one line, now and then.
  std::function<void(const std::string&)> say = {};
};

/// One question on all ranks of a transport, under way.
class Campaign {
 public:
  /// The time begins to count. The transport must outlive it.
  explicit Campaign(Transport& transport, Supervision supervision = {})
      : transport_(transport),
        supervision_(std::move(supervision)),
        budget_(supervision_.limits, supervision_.interrupt) {}
  Campaign(const Campaign&) = delete;
  Campaign& operator=(const Campaign&) = delete;
  ~Campaign() = default;

  [[nodiscard]] Transport& transport() { return transport_; }
  [[nodiscard]] bool is_first() const { return transport_.rank() == 0; }
  [[nodiscard]] const Budget& budget() const { return budget_; }

  /// engine::search within what is left of the budget, watched.
  /// @param options is completed by limits, interrupt and progress
  template <class P>
  OutcomeOf<P> search(P& problem, Options options, const ShownObjective& shown = {}) {
    options.limits = budget_.left();
    options.interrupt = budget_.interrupt();
    if (is_first() && supervision_.watch)
      options.progress = supervision_.watch(options.goal, shown);
    return engine::search(problem, transport_, options);
  }

  void say(const std::string& line) {
    if (is_first() && supervision_.say) supervision_.say(line);
  }

 private:
  Transport& transport_;
  Supervision supervision_;
  Budget budget_;
};

}  // namespace kusabi::engine
