// One rank of a search, as a state machine.
//
//                                   ┌──────────── go on ────────────┐
//                                   ▼                               │
//   the root ──► searching ──► (a stop or a ──► pausing ──► writing a checkpoint ──┐
//                    │          checkpoint           │                             │ stop
//                    │ all is done   is due)         │ stop                        │
//                    ▼                               ▼                             ▼
//                 closing ◄────────────────────────────────────────────────────────┘
//                    │ nothing owed to anyone
//                    ▼
//                reporting ──► done
//
// `step` does a bounded amount of work and returns; it never waits. Whoever drives the worker
// (engine/search.hpp over a real transport, engine/simulation.hpp in virtual time) calls it until
// it says that it is done.
//
// All ranks are peers. A rank without an open node asks one other rank at a time; the one asked
// gives every other node from the shallowest on, or refuses. What concerns all ranks at once is
// decided from merged surveys, which all ranks see alike, so all take the same turn at the same
// wave. In `pausing` no rank opens, asks or gives; when two waves are quiet
// (engine/termination.hpp) every open node lies on exactly one rank, and that is the state that a
// checkpoint keeps.
//
// Requests are always answered, also while closing; a rank leaves only after a last survey that
// every rank joins when its own last request has been answered. So no message is ever left behind.
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

#include "engine/checkpoint.hpp"
#include "engine/contract.hpp"
#include "engine/explorer.hpp"
#include "engine/lifelines.hpp"
#include "engine/options.hpp"
#include "engine/outcome.hpp"
#include "engine/problem.hpp"
#include "engine/relay.hpp"
#include "engine/survey.hpp"
#include "engine/termination.hpp"
#include "engine/trace.hpp"
#include "engine/transport/transport.hpp"
#include "engine/victims.hpp"
#include "engine/wire.hpp"

namespace kusabi::engine {

/// What a worker wants after a step.
struct Pace {
  enum class State { working, waiting, done } state = State::working;
  double wait = 0;  ///< if waiting: seconds after which to step again

  /// A wait shorter than this is not worth a sleep (which takes some 50 microseconds, however short
  /// it is meant to be): better step again at once.
  static constexpr double worth_a_sleep = 50e-6;
  [[nodiscard]] bool sleeps() const { return state == State::waiting && wait >= worth_a_sleep; }
};

template <Problem P>
class Worker {
 public:
  using Node = typename P::Node;

  /// The problem, the transport and the options must outlive the worker. Rank 0 plants the root,
  /// unless the search goes on from a checkpoint.
  /// @throws CheckpointError if the checkpoint to go on from cannot be read or is of another search,
  ///   or if one that is there would be overwritten
  /// @throws std::invalid_argument if there is a checkpoint without the problem's fingerprint
  Worker(P& problem, Transport& transport, const Options& options)
      : problem_(problem),
        transport_(transport),
        options_(options),
        explorer_(problem, options, [this] { poll(); }),
        stride_(std::max(1U, options.nodes_per_step)),
        lifelines_(transport.rank(), transport.size()),
        started_(transport.now()),
        now_(started_),
        step_started_(started_),
        last_survey_(started_),
        last_checkpoint_(started_),
        idle_since_(started_),
        quiet_since_(started_) {
    expect_checkpoint_options();
    if (transport.size() > 1) victims_.emplace(transport.rank(), transport.size(), options.seed);
    if (!options.checkpoint.resume_from.empty()) {
      resume();
    } else if (transport.rank() == 0) {
      explorer_.plant();
    }
    if (keeps_checkpoints()) epoch_ = std::max(epoch_, newest_epoch(options.checkpoint.file));
    if (options.trace_events > 0) begin_trace();
  }

  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// A bounded amount of work.
  /// @throws ExpansionFailed if the problem's `expand` throws.
  Pace step() {
    now_ = transport_.now();
    const double last_step = std::exchange(step_started_, now_);
    if (std::exchange(worked_, false)) take_stock(now_ - last_step);
    serve();
    switch (phase_) {
      case Phase::gathering:
        gather();
        break;
      case Phase::searching:
        if (idle()) ask();
        [[fallthrough]];
      case Phase::pausing:
      case Phase::writing:
        attend_survey();
        break;
      case Phase::closing:
        close();
        break;
      case Phase::reporting:
        if (transport_.rank() != 0 || reports_in_ == transport_.size() - 1) enter(Phase::done);
        break;
      case Phase::done:
        break;
    }
    if (phase_ == Phase::searching && explorer_.has_nodes()) {
      explorer_.open_nodes(stride_);
      worked_ = true;
    }
    return pace();
  }

  /// Nodes opened on this rank so far.
  [[nodiscard]] std::uint64_t opened() { return explorer_.statistics().opened; }

  /// Nodes waiting on this rank.
  [[nodiscard]] std::uint64_t open() const { return explorer_.open(); }

  /// A moment before which this rank, as long as it has nodes to open and nothing reaches it, sends
  /// nothing and joins no survey.
  [[nodiscard]] double quiet_until() const {
    const bool may_speak_any_time = options_.goal != Goal::all || phase_ != Phase::searching ||
                                    options_.limits.nodes != Limits{}.nodes;
    if (may_speak_any_time) return now_;
    return joined_ ? infinity : last_survey_ + options_.survey_interval;
  }

  /// The outcome. @pre the last step said done
  Outcome<P> outcome() && {
    Outcome<P> outcome;
    outcome.status = status_;
    outcome.open = last_wave_.open;
    outcome.saved = saved_ && status_ != Status::solved;
    outcome.bound = std::min(last_wave_.bound, last_wave_.objective);
    outcome.solutions = std::move(explorer_.found());
    std::stable_sort(outcome.solutions.begin(), outcome.solutions.end(),
                     [](const auto& a, const auto& b) { return a.path < b.path; });
    outcome.earlier = std::move(earlier_);
    reports_.resize(transport_.rank() == 0 ? static_cast<std::size_t>(transport_.size()) : 1);
    reports_.front() = own_report();
    outcome.ranks = std::move(reports_);
    if (trace_) {
      traces_.resize(outcome.ranks.size());
      traces_.front() = trace_->take();
      align_clocks(traces_);
    }
    outcome.traces = std::move(traces_);
    return outcome;
  }

 private:
  enum class Phase { gathering, searching, pausing, writing, closing, reporting, done };

  // A part of a rank's report: some solutions, then some of the trace, and with the last part the
  // rest.
  struct ReportPart {
    std::vector<Found<P>> found;
    RankTrace trace;
    bool last = false;
    RankReport<P> rank;
    std::vector<RankReport<P>> earlier;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& found& trace& last;
      if (last) archive& rank& earlier;
    }
  };

  // A rank's part of a checkpoint.
  struct Saved {
    typename Explorer<P>::State state;
    std::vector<RankReport<P>> reports;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& state& reports;
    }
  };

  [[nodiscard]] bool idle() const { return !explorer_.busy(); }
  // Opens no node, and will not before a gift arrives or all ranks go on together. (A survey may
  // say "pause" while a long expansion polls; that expansion comes to its end first.)
  [[nodiscard]] bool resting() const {
    const bool pausing = phase_ == Phase::pausing || phase_ == Phase::writing;
    return idle() || (pausing && !explorer_.expanding());
  }

  void enter(Phase phase) {
    phase_ = phase;
    record_activity();
  }

  // ---- opening nodes ----------------------------------------------------------------------------

  // After a step that opened nodes, for `elapsed` seconds.
  void take_stock(double elapsed) {
    adapt_stride(elapsed);
    if (explorer_.just_improved()) tell(nobody);
    if (!explorer_.has_nodes()) idle_since_ = quiet_since_ = now_;
    record_activity();
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

  // Called from inside a long expansion.
  void poll() {
    if (explorer_.checking()) return;
    now_ = transport_.now();
    if (explorer_.just_improved()) tell(nobody);
    serve();
    if (phase_ == Phase::searching) attend_survey();
  }

  // ---- messages ---------------------------------------------------------------------------------

  void serve() {
    while (auto message = transport_.receive()) {
      quiet_since_ = now_;
      switch (message->tag) {
        case Tag::request:
          answer(message->from);
          break;
        case Tag::plea:
          if (!answer(message->from)) lifelines_.remember(message->from);
          break;
        case Tag::gift:
          receive_gift(*message);
          break;
        case Tag::refusal:
          receive_refusal(message->from);
          break;
        case Tag::parcel:
          lifelines_.served_by(message->from);
          take_nodes(*message);
          break;
        case Tag::news:
          ++received_;
          if (explorer_.learn(unpack<Incumbent>(message->body))) tell(message->from);
          break;
        case Tag::report:
          receive_report(*message);
          break;
      }
    }
    if (lifelines_.wanted() && can_give()) give(lifelines_.take(), Tag::parcel);
  }

  void send(int to, Tag tag, Bytes body) {
    ++explorer_.statistics().messages_sent;
    transport_.send(to, tag, std::move(body));
  }

  [[nodiscard]] bool can_give() const { return phase_ == Phase::searching && explorer_.can_give(); }

  // @return whether there was something to give
  bool answer(int thief) {
    const bool can = can_give();
    can ? give(thief, Tag::gift) : send(thief, Tag::refusal, {});
    return can;
  }

  void give(int thief, Tag tag) {
    const auto gift = explorer_.give(options_.message_bytes);
    const auto nodes = size_of(gift);
    auto& statistics = explorer_.statistics();
    ++statistics.gifts_sent;
    statistics.nodes_given += nodes;
    ++sent_;
    record(tag == Tag::gift ? TraceEvent::Kind::gift_sent : TraceEvent::Kind::parcel_sent, thief,
           nodes);
    send(thief, tag, pack(gift));
  }

  // Asks around at first; when that was in vain, leaves its name with one lifeline after another,
  // and asks around again now and then.
  void ask() {
    if (!victims_ || asked_ != nobody) return;
    const auto lifeline = victims_->in_vain() ? lifelines_.next() : std::nullopt;
    if (!lifeline && !victims_->due(now_)) return;
    pleaded_ = lifeline.has_value();
    asked_ = lifeline ? *lifeline : victims_->choose();
    ++explorer_.statistics().requests;
    record(TraceEvent::Kind::request_sent, asked_);
    send(asked_, pleaded_ ? Tag::plea : Tag::request, {});
  }

  void receive_gift(const Message& message) {
    ensure(message.from == asked_, "a gift comes from the rank that was asked");
    asked_ = nobody;
    take_nodes(message);
  }

  void receive_refusal(int victim) {
    ensure(victim == asked_, "a refusal comes from the rank that was asked");
    asked_ = nobody;
    record(TraceEvent::Kind::refusal_arrived, victim);
    if (pleaded_) {
      lifelines_.left_name_with(victim);
    } else {
      victims_->refused(victim, now_);
    }
  }

  void take_nodes(const Message& message) {
    ++received_;
    victims_->gave(message.from);
    auto& statistics = explorer_.statistics();
    if (idle()) {
      statistics.idle_seconds += now_ - idle_since_;
      if (statistics.opened == 0) statistics.ramp_up_seconds = now_ - idle_since_;
    }
    ++statistics.gifts_received;
    auto gift = unpack<Gift<Node>>(message.body);
    record(message.tag == Tag::gift ? TraceEvent::Kind::gift_arrived
                                    : TraceEvent::Kind::parcel_arrived,
           message.from, size_of(gift));
    explorer_.take(std::move(gift));
    record_activity();
  }

  // Passes the incumbent on to the neighbours in the relay tree, but not back to where it is from.
  void tell(int source) {
    if (source == nobody) record(TraceEvent::Kind::improved);
    const auto body = pack(explorer_.incumbent());
    for (const int neighbour : relay_neighbours(transport_.rank(), transport_.size())) {
      if (neighbour == source) continue;
      ++sent_;
      send(neighbour, Tag::news, body);
    }
  }

  // ---- surveys ----------------------------------------------------------------------------------

  void attend_survey() {
    if (joined_) {
      const auto wave = transport_.survey();
      if (!wave) return;
      joined_ = false;
      last_survey_ = quiet_since_ = now_;
      last_wave_ = *wave;
      record(TraceEvent::Kind::survey_arrived, nobody, wave->idle);
      act_on(*wave);
      if (phase_ == Phase::closing) return;
    }
    // A resting rank joins at once: the wave then ends as soon as the last busy rank joins it.
    const bool due = now_ - last_survey_ >= options_.survey_interval ||
                     explorer_.statistics().opened >= options_.limits.nodes;
    if (resting() || due) join();
  }

  void join() {
    joined_ = true;
    const auto& statistics = explorer_.statistics();
    Survey own{.ranks = 1,
               .idle = resting() ? 1U : 0U,
               .sent = sent_,
               .received = received_,
               .opened = statistics.opened,
               .open = explorer_.open(),
               .found = explorer_.found().size(),
               .fingerprint = statistics.fingerprint,
               .wishes = wishes(),
               .closed = explorer_.closed(),
               .objective = explorer_.incumbent().objective,
               .bound = explorer_.bound()};
    for (const auto& report : earlier_) {
      own.opened += report.statistics.opened;
      own.fingerprint += report.statistics.fingerprint;
    }
    record(TraceEvent::Kind::survey_joined);
    transport_.join_survey(own);
  }

  // What this rank wants all to do. The clock of rank 0 counts.
  std::uint64_t wishes() {
    std::uint64_t wishes = 0;
    if (std::exchange(failed_, false)) wishes |= wish_failed;
    const Interrupt interrupt = options_.interrupt ? options_.interrupt() : Interrupt::none;
    if (interrupt == Interrupt::stop) wishes |= wish_stop_interrupt;
    if (interrupt == Interrupt::checkpoint) wishes |= wish_checkpoint;
    if (transport_.rank() != 0) return wishes;
    if (now_ - started_ >= options_.limits.seconds) wishes |= wish_stop_time;
    if (now_ - last_checkpoint_ >= options_.checkpoint.interval) wishes |= wish_checkpoint;
    return wishes;
  }

  // Every rank comes here with the same waves in the same order, and so to the same decisions.
  void act_on(const Survey& wave) {
    if (transport_.rank() == 0 && options_.progress) show(wave);
    note_stop(wave);
    switch (phase_) {
      case Phase::searching:
        if (termination_.observe(wave)) {
          start_closing();
        } else if (status_ != Status::solved ||
                   ((wave.wishes & wish_checkpoint) != 0 && keeps_checkpoints())) {
          enter(Phase::pausing);
          termination_ = {};
        }
        break;
      case Phase::pausing:
        if (termination_.observe(wave)) act_at_rest(wave);
        break;
      case Phase::writing:
        finish_checkpoint(wave);
        status_ == Status::solved ? go_on() : start_closing();
        break;
      default:
        break;
    }
  }

  [[nodiscard]] bool keeps_checkpoints() const { return !options_.checkpoint.file.empty(); }

  void note_stop(const Survey& wave) {
    if (status_ != Status::solved) return;
    if ((wave.wishes & wish_stop_interrupt) != 0) {
      status_ = Status::interrupted;
    } else if ((wave.wishes & wish_stop_time) != 0) {
      status_ = Status::time_limit;
    } else if (wave.opened >= options_.limits.nodes) {
      status_ = Status::node_limit;
    } else if (wave.found >= options_.limits.solutions) {
      status_ = Status::solution_limit;
    } else if (gap_closed(wave)) {
      status_ = Status::gap_limit;
    }
  }

  [[nodiscard]] bool gap_closed(const Survey& wave) const {
    if (options_.limits.gap <= 0 || !(wave.objective < infinity)) return false;
    return wave.objective - wave.bound <= options_.limits.gap * std::abs(wave.objective);
  }

  // All ranks pause and nothing is in flight: sums and minima of this wave are exact.
  void act_at_rest(const Survey& wave) {
    if (wave.open == 0) {  // the tree was done after all
      status_ = Status::solved;
      start_closing();
    } else if (status_ == Status::gap_limit && !gap_closed(wave)) {
      status_ = Status::solved;  // an earlier wave missed a node that was on its way
      go_on();
    } else if (keeps_checkpoints()) {
      write_checkpoint(wave);
    } else {
      status_ == Status::solved ? go_on() : start_closing();
    }
  }

  void go_on() {
    enter(Phase::searching);
    termination_ = {};
  }

  void show(const Survey& wave) const {
    options_.progress({.seconds = now_ - started_,
                       .opened = wave.opened,
                       .open = wave.open,
                       .found = wave.found,
                       .closed = std::min(1.0, wave.closed),
                       .idle = wave.idle,
                       .ranks = wave.ranks,
                       .objective = wave.objective,
                       .bound = wave.bound});
  }

  // ---- checkpoints ------------------------------------------------------------------------------

  void expect_checkpoint_options() const {
    const auto& [file, interval, resume_from, problem] = options_.checkpoint;
    if (file.empty() && resume_from.empty()) return;
    if (!problem) {
      throw std::invalid_argument(
          "a checkpoint needs the fingerprint of its problem; expected "
          "Options::checkpoint.problem");
    }
    // No other rank can have written anything before this one takes part.
    if (!file.empty() && transport_.rank() == 0) expect_no_other(file, resume_from);
  }

  [[nodiscard]] Manifest manifest(const Survey& wave) const {
    return {.problem = *options_.checkpoint.problem,
            .epoch = epoch_,
            .ranks = transport_.size(),
            .opened = wave.opened,
            .fingerprint = wave.fingerprint,
            .open = wave.open,
            .goal = name_of(options_.goal),
            .node = typeid(Node).name(),
            .solution = typeid(typename P::Solution).name()};
  }

  void write_checkpoint(const Survey& wave) {
    enter(Phase::writing);
    ++epoch_;
    Saved saved{explorer_.state(), earlier_};
    saved.reports.push_back(own_report());
    try {
      write_part(options_.checkpoint.file, manifest(wave), transport_.rank(), pack(saved));
    } catch (const CheckpointError& error) {
      warn(error.what());
      failed_ = true;
    }
  }

  // The wave after the parts were written: it counts if no rank failed.
  void finish_checkpoint(const Survey& wave) {
    last_checkpoint_ = now_;
    saved_ = false;
    if (transport_.rank() != 0) return;
    if ((wave.wishes & wish_failed) != 0) {
      warn("a part of checkpoint " + std::to_string(epoch_) + " could not be written; " +
           "the one before still counts");
      remove_leftovers(options_.checkpoint.file);
      return;
    }
    try {
      commit(options_.checkpoint.file, manifest(wave), good_epoch_);
      good_epoch_ = epoch_;
      saved_ = true;
    } catch (const CheckpointError& error) {
      warn(error.what());
    }
  }

  void warn(const std::string& line) const {
    if (options_.warn) options_.warn(line);
  }

  void resume() {
    const auto& file = options_.checkpoint.resume_from;
    const auto found = read_manifest(file);
    expect_same_search(file, found, manifest({}));
    epoch_ = good_epoch_ = found.epoch;
    // As many ranks as there were, or fewer, or more: parts are dealt round, ranks without one ask.
    for (int part = transport_.rank(); part < found.ranks; part += transport_.size()) {
      auto saved = unpack<Saved>(read_part(file, found, part));
      explorer_.restore(std::move(saved.state));
      std::move(saved.reports.begin(), saved.reports.end(), std::back_inserter(earlier_));
    }
  }

  // ---- the end ----------------------------------------------------------------------------------

  void start_closing() {
    if (idle()) {
      explorer_.statistics().tail_seconds = now_ - idle_since_;
      explorer_.statistics().idle_seconds += now_ - idle_since_;
    }
    enter(Phase::closing);
  }

  // The last survey is complete when no rank waits for an answer any more and none will ask again.
  void close() {
    if (!joined_ && asked_ == nobody) {
      joined_ = true;
      transport_.join_survey({.ranks = 1});
    }
    if (!joined_ || !transport_.survey()) return;
    explorer_.statistics().seconds = now_ - started_;
    if (trace_) trace_->end(transport_.now());
    if (transport_.rank() != 0) send_report();
    enter(Phase::reporting);
  }

  RankReport<P> own_report() {
    RankReport<P> report;
    report.statistics = explorer_.statistics();
    if constexpr (Tallying<P>) report.tally = problem_.tally();
    return report;
  }

  void send_report() {
    ReportPart part;
    PackedSize<Found<P>> packed_size;
    std::size_t bytes = 0;
    for (auto& found : explorer_.found()) {
      bytes += packed_size(found);
      if (bytes > options_.message_bytes && !part.found.empty()) {
        transport_.send(0, Tag::report, pack(part));
        part.found.clear();
        bytes = packed_size(found);
      }
      part.found.push_back(std::move(found));
    }
    explorer_.found().clear();
    if (trace_) send_trace(part);
    part.last = true;
    part.rank = own_report();
    part.earlier = earlier_;
    transport_.send(0, Tag::report, pack(part));
  }

  void receive_report(const Message& message) {
    auto part = unpack<ReportPart>(message.body);
    auto& found = explorer_.found();
    std::move(part.found.begin(), part.found.end(), std::back_inserter(found));
    if (!part.trace.events.empty()) receive_trace(message.from, part.trace);
    if (!part.last) return;
    std::move(part.earlier.begin(), part.earlier.end(), std::back_inserter(earlier_));
    reports_.resize(static_cast<std::size_t>(transport_.size()));
    reports_[static_cast<std::size_t>(message.from)] = std::move(part.rank);
    ++reports_in_;
  }

  // ---- the trace --------------------------------------------------------------------------------

  // A survey precedes the search, so that clocks can be compared (engine/trace.hpp).
  void begin_trace() {
    trace_.emplace(options_.trace_events);
    phase_ = Phase::gathering;
    trace_->join(transport_.now());
    transport_.join_survey({.ranks = 1});
  }

  void gather() {
    if (!transport_.survey()) return;
    now_ = last_survey_ = idle_since_ = quiet_since_ = transport_.now();
    trace_->begin(now_);
    enter(Phase::searching);
  }

  void record(TraceEvent::Kind kind, int peer = nobody, std::uint64_t value = 0) {
    if (!trace_) return;
    trace_->record({.time = transport_.now(),
                    .value = value,
                    .open = explorer_.open(),
                    .peer = peer,
                    .kind = kind});
  }

  void record_activity() {
    if (trace_) record(activity());
  }

  [[nodiscard]] TraceEvent::Kind activity() const {
    if (explorer_.expanding()) return TraceEvent::Kind::busy;
    switch (phase_) {
      case Phase::pausing:
        return TraceEvent::Kind::pausing;
      case Phase::writing:
        return TraceEvent::Kind::writing;
      case Phase::gathering:
      case Phase::searching:
        return idle() ? TraceEvent::Kind::idle : TraceEvent::Kind::busy;
      default:
        return TraceEvent::Kind::closing;
    }
  }

  // Sends what `part` holds and then the trace, but for the last piece, which stays in `part`.
  void send_trace(ReportPart& part) {
    for (auto& piece : trace_->take().pieces(options_.message_bytes / sizeof(TraceEvent) + 1)) {
      transport_.send(0, Tag::report, pack(part));
      part.found.clear();
      part.trace = std::move(piece);
    }
  }

  void receive_trace(int from, const RankTrace& piece) {
    traces_.resize(static_cast<std::size_t>(transport_.size()));
    traces_[static_cast<std::size_t>(from)].append(piece);
  }

  // ---- pace -------------------------------------------------------------------------------------

  // A rank that waits looks again after as long as nothing has happened so far: an answer is met at
  // once, and in vain a rank looks ever less often. The core it sits on may have better things to
  // do, and a millisecond is not missed.
  [[nodiscard]] Pace pace() const {
    if (phase_ == Phase::done) return {Pace::State::done, 0};
    if (worked_) return {Pace::State::working, 0};
    constexpr double shortest = 1e-6;
    constexpr double longest = 1e-3;
    // A short wait, spent awake: clocks are to be compared as closely as may be.
    if (phase_ == Phase::gathering) return {Pace::State::waiting, shortest};
    return {Pace::State::waiting, std::clamp(now_ - quiet_since_, shortest, longest)};
  }

  static constexpr int nobody = -1;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  P& problem_;
  Transport& transport_;
  const Options& options_;

  Explorer<P> explorer_;
  unsigned stride_;
  bool worked_ = false;  // the last step opened nodes, so its duration tells how long they take

  std::optional<Victims> victims_;
  Lifelines lifelines_;
  int asked_ = nobody;
  bool pleaded_ = false;        // and not only asked
  std::uint64_t sent_ = 0;      // gifts and news
  std::uint64_t received_ = 0;  // gifts and news

  Phase phase_ = Phase::searching;
  Status status_ = Status::solved;  // otherwise: why the search stops, or will
  Termination termination_;
  bool joined_ = false;
  Survey last_wave_;

  std::uint64_t epoch_ = 0;       // of the last checkpoint written, good or not
  std::uint64_t good_epoch_ = 0;  // the last that counts, as far as rank 0 knows
  bool failed_ = false;           // to write the own part
  bool saved_ = false;            // the last one counts

  std::optional<TraceRecorder> trace_;
  std::vector<RankTrace> traces_;  // of all ranks, on rank 0

  std::vector<RankReport<P>> earlier_;
  std::vector<RankReport<P>> reports_;
  int reports_in_ = 0;

  double started_;
  double now_;
  double step_started_;
  double last_survey_;
  double last_checkpoint_;
  double idle_since_;
  double quiet_since_;  // no message, no survey, no node opened
};

}  // namespace kusabi::engine
