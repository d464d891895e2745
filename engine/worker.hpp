// One rank of a search, as a state machine.
//
//                 all is done (Termination)      nothing owed to anyone       all reports are in
//   searching ────────────────────────────► closing ──────────────────► reporting ───────────► done
//   open nodes, give, ask                   wait for the last answer    solutions to rank 0
//
// `step` does a bounded amount of work and returns; it never waits. Whoever drives the worker
// (engine/search.hpp over a real transport, engine/simulation.hpp in virtual time) calls it until
// it says that it is done.
//
// All ranks are peers. A rank without an open node asks one other rank at a time; the one asked
// gives every other node from the shallowest on, or refuses. Requests are always answered, also
// while closing; a rank leaves only after a last survey that every rank joins when its own last
// request has been answered. So no message is ever left behind.
#pragma once

#include <algorithm>
#include <cassert>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/expansion.hpp"
#include "engine/frontier.hpp"
#include "engine/options.hpp"
#include "engine/outcome.hpp"
#include "engine/problem.hpp"
#include "engine/survey.hpp"
#include "engine/termination.hpp"
#include "engine/transport/transport.hpp"
#include "engine/victims.hpp"
#include "engine/wire.hpp"

namespace kusabi::engine {

/// An exception that left `expand`, with the path of the node it was expanding; the exception
/// itself is nested in it.
class ExpansionFailed : public std::runtime_error {
 public:
  ExpansionFailed(const Path& path, const std::string& reason)
      : std::runtime_error("node " + to_string(path) + ": " + reason) {}
};

/// What a worker wants after a step.
struct Pace {
  enum class State { working, waiting, done } state = State::working;
  double wait = 0;  ///< if waiting: seconds that nothing needs to be done for
};

template <Problem P>
class Worker {
 public:
  using Node = typename P::Node;

  /// The problem, the transport and the options must outlive the worker. Rank 0 plants the root.
  Worker(P& problem, Transport& transport, const Options& options)
      : problem_(problem),
        transport_(transport),
        options_(options),
        expansion_(frontier_, found_, [this] { poll(); }),
        stride_(std::max(1U, options.nodes_per_step)),
        started_(transport.now()),
        now_(started_),
        step_started_(started_),
        last_survey_(started_),
        idle_since_(started_) {
    if (transport.size() > 1) victims_.emplace(transport.rank(), transport.size(), options.seed);
    if (transport.rank() == 0) frontier_.plant(std::as_const(problem).root());
  }

  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// A bounded amount of work.
  /// @throws ExpansionFailed if the problem's `expand` throws.
  Pace step() {
    now_ = transport_.now();
    const double last_step = std::exchange(step_started_, now_);
    if (phase_ == Phase::searching && !frontier_.empty()) {
      if (worked_) adapt_stride(now_ - last_step);
      open_nodes();
    }
    serve();
    switch (phase_) {
      case Phase::searching:
        if (idle()) ask();
        attend_survey();
        break;
      case Phase::closing:
        close();
        break;
      case Phase::reporting:
        if (transport_.rank() != 0 || reports_in_ == transport_.size() - 1) phase_ = Phase::done;
        break;
      case Phase::done:
        break;
    }
    return pace();
  }

  /// Nodes opened on this rank so far.
  [[nodiscard]] std::uint64_t opened() const { return statistics_.opened; }

  /// The outcome. @pre the last step said done
  Outcome<P> outcome() && {
    Outcome<P> outcome;
    outcome.solutions = std::move(found_);
    std::stable_sort(outcome.solutions.begin(), outcome.solutions.end(),
                     [](const auto& a, const auto& b) { return a.path < b.path; });
    if (transport_.rank() == 0) {
      reports_.resize(static_cast<std::size_t>(transport_.size()));
      reports_.front() = own_report();
      outcome.ranks = std::move(reports_);
    } else {
      outcome.ranks.push_back(own_report());
    }
    return outcome;
  }

 private:
  enum class Phase { searching, closing, reporting, done };

  // A part of a rank's report: some solutions, and with the last part the rest.
  struct ReportPart {
    std::vector<Found<P>> found;
    bool last = false;
    RankReport<P> rank;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& found& last;
      if (last) archive& rank;
    }
  };

  [[nodiscard]] bool idle() const { return frontier_.empty() && !expanding_; }

  // ---- opening nodes ----------------------------------------------------------------------------

  void open_nodes() {
    for (unsigned count = 0; count < stride_ && !frontier_.empty(); ++count) open_node();
    worked_ = true;
    if (frontier_.empty()) idle_since_ = transport_.now();
  }

  void open_node() {
    Node node = frontier_.open();
    ++statistics_.opened;
    statistics_.fingerprint += frontier_.current().hash;
    expanding_ = true;
    try {
      problem_.expand(std::move(node), expansion_);
    } catch (const std::exception& error) {
      std::throw_with_nested(ExpansionFailed(frontier_.path(), error.what()));
    } catch (...) {
      std::throw_with_nested(ExpansionFailed(frontier_.path(), "an unknown exception"));
    }
    expanding_ = false;
    if (frontier_.current().branches == 0) closed_ += frontier_.current().share;
    frontier_.close();
  }

  // Messages should be looked at every 10 to 20 microseconds: seldom enough not to be felt with the
  // cheapest nodes, often enough not to let a thief wait. A fixed number of nodes is wrong by a
  // factor of a thousand for one problem or another.
  void adapt_stride(double elapsed) {
    constexpr double too_short = 10e-6;
    constexpr double too_long = 20e-6;
    constexpr unsigned largest = 4096;
    if (options_.nodes_per_step != 0) return;
    if (elapsed < too_short) stride_ = std::min(2 * stride_, largest);
    if (elapsed > too_long) stride_ = std::max(stride_ / 2, 1U);
  }

  void poll() {
    now_ = transport_.now();
    serve();
    if (phase_ == Phase::searching) attend_survey();
  }

  // ---- messages ---------------------------------------------------------------------------------

  void serve() {
    while (auto message = transport_.receive()) {
      waits_ = 0;
      switch (message->tag) {
        case Tag::request:
          answer(message->from);
          break;
        case Tag::gift:
          receive_gift(*message);
          break;
        case Tag::refusal:
          asked_ = nobody;
          victims_->refused(message->from, now_);
          break;
        case Tag::report:
          receive_report(*message);
          break;
      }
    }
  }

  void answer(int thief) {
    if (!frontier_.can_give()) {
      transport_.send(thief, Tag::refusal, {});
      return;
    }
    const std::size_t limit = std::max<std::size_t>(1, options_.message_bytes / bytes_per_node_);
    const auto gift = frontier_.give(limit);
    auto body = pack(gift);
    bytes_per_node_ = std::max<std::size_t>(1, body.size() / gift.nodes.size());
    ++statistics_.gifts_sent;
    statistics_.nodes_given += gift.nodes.size();
    transport_.send(thief, Tag::gift, std::move(body));
  }

  void ask() {
    if (!victims_ || asked_ != nobody || !victims_->due(now_)) return;
    asked_ = victims_->choose();
    ++statistics_.requests;
    transport_.send(asked_, Tag::request, {});
  }

  void receive_gift(const Message& message) {
    assert(idle() && phase_ == Phase::searching && message.from == asked_);
    asked_ = nobody;
    victims_->gave(message.from);
    ++statistics_.gifts_received;
    frontier_.take(unpack<Gift<Node>>(message.body));
    statistics_.idle_seconds += now_ - idle_since_;
    worked_ = false;
  }

  // ---- surveys ----------------------------------------------------------------------------------

  void attend_survey() {
    if (joined_) {
      const auto wave = transport_.survey();
      if (!wave) return;
      joined_ = false;
      last_survey_ = now_;
      if (transport_.rank() == 0 && options_.progress) show(*wave);
      if (termination_.observe(*wave)) {
        statistics_.idle_seconds += now_ - idle_since_;
        phase_ = Phase::closing;
        return;
      }
    }
    // An idle rank joins at once: the wave then ends as soon as the last busy rank joins it.
    if (idle() || now_ - last_survey_ >= options_.survey_interval) join();
  }

  void join() {
    joined_ = true;
    transport_.join_survey({.ranks = 1,
                            .idle = idle() ? 1U : 0U,
                            .sent = statistics_.gifts_sent,
                            .received = statistics_.gifts_received,
                            .opened = statistics_.opened,
                            .open = frontier_.size(),
                            .found = found_.size(),
                            .closed = closed_});
  }

  void show(const Survey& wave) const {
    options_.progress({.seconds = now_ - started_,
                       .opened = wave.opened,
                       .open = wave.open,
                       .found = wave.found,
                       .closed = std::min(1.0, wave.closed),
                       .idle = wave.idle});
  }

  // ---- the end ----------------------------------------------------------------------------------

  // The last survey is complete when no rank waits for an answer any more and none will ask again.
  void close() {
    if (!joined_ && asked_ == nobody) join();
    if (!joined_ || !transport_.survey()) return;
    statistics_.found = found_.size();
    statistics_.peak_open = frontier_.peak();
    statistics_.seconds = now_ - started_;
    if (transport_.rank() != 0) send_report();
    phase_ = Phase::reporting;
  }

  RankReport<P> own_report() const {
    RankReport<P> report;
    report.statistics = statistics_;
    if constexpr (Tallying<P>) report.tally = problem_.tally();
    return report;
  }

  void send_report() {
    auto rest = found_.begin();
    std::size_t count = 1;
    while (rest != found_.end()) {
      ReportPart part;
      while (rest != found_.end() && part.found.size() < count)
        part.found.push_back(std::move(*rest++));
      auto body = pack(part);
      count = std::max<std::size_t>(1, options_.message_bytes * part.found.size() / body.size());
      transport_.send(0, Tag::report, std::move(body));
    }
    found_.clear();
    transport_.send(0, Tag::report, pack(ReportPart{{}, true, own_report()}));
  }

  void receive_report(const Message& message) {
    auto part = unpack<ReportPart>(message.body);
    std::move(part.found.begin(), part.found.end(), std::back_inserter(found_));
    if (!part.last) return;
    reports_.resize(static_cast<std::size_t>(transport_.size()));
    reports_[static_cast<std::size_t>(message.from)] = std::move(part.rank);
    ++reports_in_;
  }

  // ---- pace -------------------------------------------------------------------------------------

  // A rank that waits looks again after a pause that doubles while nothing arrives: the core it
  // sits on may have better things to do, and a millisecond is not missed.
  Pace pace() {
    if (phase_ == Phase::done) return {Pace::State::done, 0};
    if (phase_ == Phase::searching && !frontier_.empty()) return {Pace::State::working, 0};
    constexpr double first_wait = 1e-6;
    constexpr unsigned doublings = 10;  // up to 1 ms
    const double wait = first_wait * static_cast<double>(1U << waits_);
    waits_ = std::min(waits_ + 1, doublings);
    return {Pace::State::waiting, wait};
  }

  static constexpr int nobody = -1;

  P& problem_;
  Transport& transport_;
  const Options& options_;

  Frontier<Node> frontier_;
  std::vector<Found<P>> found_;
  Expansion<P> expansion_;
  bool expanding_ = false;
  unsigned stride_;
  bool worked_ = false;  // the last step opened nodes, so its duration tells how long they take
  double closed_ = 0;

  std::optional<Victims> victims_;
  int asked_ = nobody;
  std::size_t bytes_per_node_ = sizeof(OpenNode<Node>);

  Phase phase_ = Phase::searching;
  Termination termination_;
  bool joined_ = false;

  std::vector<RankReport<P>> reports_;
  int reports_in_ = 0;

  RankStatistics statistics_;
  double started_;
  double now_;
  double step_started_;
  double last_survey_;
  double idle_since_;
  unsigned waits_ = 0;
};

}  // namespace kusabi::engine
