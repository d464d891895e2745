// Main loop of a rank: stepping, pace, and the reports at the end.
#include "engine/detail/protocol/rank.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace kusabi::engine {
namespace {

// A rank with more open nodes than this requests none: it may well find further ones among them.
constexpr unsigned max_left = 8;

}  // namespace

Rank::Rank(LocalSearch& local, Transport& transport, const Options& options)
    : local_(local),
      transport_(transport),
      options_(options),
      stride_(std::max(1U, options.nodes_per_step)),
      share_waited_(transport.oversubscribed() ? 1.0 : 0.01),
      lifelines_(transport.rank(), transport.size()),
      reports_(transport.rank(), transport.size(), options.message_bytes,
               [this](int parent, Bytes message) {
                 transport_.send(parent, MessageTag::report, std::move(message));
               }),
      started_(transport.now()),
      now_(started_),
      step_started_(started_),
      last_reduction_(started_),
      last_checkpoint_(started_),
      idle_since_(started_),
      quiet_since_(started_) {
  transport.begin_search();
  if (options.record && transport.size() > 1) {
    throw std::invalid_argument("Options::record requires one rank");
  }
  expect_checkpoint_options();
  if (transport.size() > 1) {
    victims_.emplace(transport.rank(), transport.size(), options.seed, transport.machine());
  }
  int with_nodes = 1;  // ranks from 0 on
  if (!options.checkpoint.resume_from.empty()) {
    with_nodes = resume();
  } else if (transport.rank() == 0) {
    local_.add_root();
  }
  lifelines_.register_idle(with_nodes, transport.rank(), transport.size());
  if (victims_ && transport.rank() >= with_nodes) victims_->give_up();
  if (keeps_checkpoints()) epoch_ = std::max(epoch_, newest_epoch(options.checkpoint.file));
  if (options.trace_events > 0) begin_trace();
}

Pace Rank::step() {
  now_ = transport_.now();
  const double last_step = std::exchange(step_started_, now_);
  if (std::exchange(worked_, false)) update_step_statistics(now_ - last_step);
  // Nodes may come from ranks that have begun already; the trace has not.
  if (phase_ != Phase::gathering) serve();
  switch (phase_) {
    case Phase::gathering:
      gather();
      break;
    case Phase::searching:
      if (idle() || soon_idle()) ask();
      [[fallthrough]];
    case Phase::pausing:
    case Phase::writing:
      attend_reduction();
      break;
    case Phase::reporting:
      if (reports_.complete()) enter(Phase::done);
      break;
    case Phase::done:
      break;
  }
  // A rank at the node limit waits for the reduction that ends the search; without this, a rank
  // that joins late would let the others finish the tree.
  if (phase_ == Phase::searching && local_.has_nodes()) {
    if (const auto left = nodes_left(); left > 0) {
      local_.open_nodes(static_cast<unsigned>(std::min<std::uint64_t>(stride_, left)));
      worked_ = true;
    }
  }
  return pace();
}

double Rank::quiet_until() const {
  const double due = joined_ ? infinity : last_reduction_ + options_.reduction_interval;
  if (worked_) {
    const bool may_speak_any_time = options_.goal != Goal::all || phase_ != Phase::searching ||
                                    options_.limits.nodes != Limits{}.nodes ||
                                    lifelines_.has_registered();
    return may_speak_any_time ? now_ : due;
  }
  const double asleep = quiet_since_ + Pace::min_sleep / share_waited_;
  if (phase_ == Phase::gathering || phase_ == Phase::reporting) return asleep;
  const bool asks = phase_ == Phase::searching && !asking() && !dormant();
  return std::min({asleep, due, asks ? victims_->next_request() : infinity});
}

unsigned Rank::requests_at() const {
  return victims_ && !asking() && !victims_->has_requested_early() ? max_left : 0;
}

bool Rank::soon_idle() const {
  const auto left = local_.open();
  if (left > requests_at() || at_node_limit()) return false;
  return left <= 2 || static_cast<double>(left - 1) * node_seconds_ < answer_seconds_;
}

Rank::Ending Rank::ending() {
  Ending ending;
  ending.status = status_;
  ending.open = last_wave_.open;
  ending.saved = saved_ && status_ != Status::solved;
  ending.bound = std::min(last_wave_.bound, last_wave_.objective);
  if (trace_) {
    traces_.resize(transport_.rank() == 0 ? static_cast<std::size_t>(transport_.size()) : 1);
    traces_.front() = trace_->take();
    align_clocks(traces_);
    ending.traces = std::move(traces_);
  }
  return ending;
}

bool Rank::dormant() const {
  return !victims_ || (victims_->refused_often() && lifelines_.all_aware());
}

bool Rank::quiet() const {
  return resting() && !asking() && (phase_ != Phase::searching || dormant());
}

bool Rank::resting() const {
  const bool pausing = phase_ == Phase::pausing || phase_ == Phase::writing;
  return idle() || (pausing && !local_.expanding());
}

void Rank::enter(Phase phase) {
  phase_ = phase;
  record_activity();
}

void Rank::update_step_statistics(double elapsed) {
  adapt_stride(elapsed);
  const auto opened = local_.statistics().opened;
  const auto since = opened - std::exchange(opened_before_, opened);
  // The time of messages is not that of nodes. A first node is better known roughly than not.
  const bool only_nodes = !std::exchange(exchanged_, false);
  if (since > 0 && (only_nodes || node_seconds_ == 0))
    take_mean(node_seconds_, elapsed / static_cast<double>(since));
  if (local_.just_improved()) broadcast_incumbent(nobody);
  if (!local_.has_nodes()) idle_since_ = quiet_since_ = now_;
  record_activity();
}

void Rank::adapt_stride(double elapsed) {
  constexpr double too_short = 10e-6;
  constexpr double too_long = 20e-6;
  constexpr unsigned largest = 4096;
  if (options_.nodes_per_step != 0) return;
  if (elapsed < too_short) stride_ = std::min(2 * stride_, largest);
  if (elapsed > too_long) stride_ = std::max(stride_ / 2, 1U);
}

bool Rank::poll() {
  if (local_.checking()) return false;
  now_ = transport_.now();
  if (local_.just_improved()) broadcast_incumbent(nobody);
  serve();
  if (phase_ == Phase::searching) attend_reduction();
  return status_ != Status::solved;
}

void Rank::finish() {
  auto& statistics = local_.statistics();
  if (idle()) {
    statistics.tail_seconds = now_ - idle_since_;
    statistics.idle_seconds += now_ - idle_since_;
  }
  statistics.seconds = now_ - started_;
  enter(Phase::reporting);
  if (trace_) trace_->end(transport_.now());
  if (transport_.rank() != 0) send_report();
  reports_.finish_own();
  // Rank 0 may start the next search as soon as it has all reports.
  if (reports_.complete()) enter(Phase::done);
}

void Rank::send_report() {
  if (trace_) {
    for (auto& piece : trace_->take().pieces(options_.message_bytes / sizeof(TraceEvent) + 1)) {
      reports_.put({transport_.rank(), std::move(piece), {}});
    }
  }
  local_.report(options_.message_bytes, [this](Bytes body) {
    reports_.put({transport_.rank(), {}, std::move(body)});
  });
}

void Rank::receive_report(ReportPart&& part) {
  if (!part.trace.events.empty()) receive_trace(part.rank, part.trace);
  if (!part.body.empty()) local_.receive_report(part.rank, part.body);
}

Pace Rank::pace() const {
  if (phase_ == Phase::done) return {Pace::State::done, 0};
  if (worked_) return {Pace::State::working, 0};
  constexpr double shortest = 1e-6;
  constexpr double longest = 1e-3;
  // The short wait is active, so that the clocks are compared precisely.
  if (phase_ == Phase::gathering) return {Pace::State::waiting, shortest};
  const double wait = share_waited_ * (now_ - quiet_since_);
  return {Pace::State::waiting, std::clamp(wait, shortest, longest)};
}

void Rank::begin_trace() {
  trace_.emplace(options_.trace_events);
  phase_ = Phase::gathering;
  trace_->join(transport_.now());
  transport_.join_reduction({.ranks = 1});
}

void Rank::gather() {
  if (!transport_.reduction()) return;
  now_ = last_reduction_ = idle_since_ = quiet_since_ = transport_.now();
  trace_->begin(now_);
  enter(Phase::searching);
}

void Rank::record(TraceEvent::Kind kind, int peer, std::uint64_t value) {
  if (!trace_) return;
  trace_->record({.time = transport_.now(),
                  .value = value,
                  .open = local_.open(),
                  .peer = peer,
                  .kind = kind});
}

void Rank::record_activity() {
  if (trace_) record(activity());
}

TraceEvent::Kind Rank::activity() const {
  if (local_.expanding()) return TraceEvent::Kind::busy;
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

void Rank::receive_trace(int from, const RankTrace& piece) {
  traces_.resize(static_cast<std::size_t>(transport_.size()));
  traces_[static_cast<std::size_t>(from)].append(piece);
}

}  // namespace kusabi::engine
