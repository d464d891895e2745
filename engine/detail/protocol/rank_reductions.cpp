// Global decisions from reductions: limits, checkpoints and termination.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/checkpoint.hpp"
#include "engine/detail/protocol/rank.hpp"

namespace kusabi::engine {
namespace {

// The goal as a checkpoint names it, in one word: nodes that another pool or cutoff requires may be
// pruned.
std::string goal_of(const Options& options) {
  std::ostringstream text;
  text << name_of(options.goal) << std::setprecision(std::numeric_limits<double>::max_digits10);
  if (options.goal != Goal::best) return text.str();
  const auto& [count, gap, relative_gap] = options.pool;
  if (count != Pool{}.count) text << ",count=" << count;
  if (gap != Pool{}.gap) text << ",gap=" << gap;
  if (relative_gap != Pool{}.relative_gap) text << ",relative_gap=" << relative_gap;
  if (options.cutoff) text << ",cutoff=" << *options.cutoff;
  return text.str();
}

}  // namespace

void Rank::attend_reduction() {
  if (joined_) {
    const auto wave = transport_.reduction();
    if (!wave) return;
    joined_ = false;
    last_reduction_ = quiet_since_ = now_;
    last_wave_ = *wave;
    record(TraceEvent::Kind::reduction_arrived, nobody, wave->idle);
    act_on(*wave);
    if (phase_ == Phase::reporting || phase_ == Phase::done) return;
  }
  // A quiet rank joins at once: the wave is then complete as soon as the last other one joins.
  const bool due = now_ - last_reduction_ >= options_.reduction_interval || at_node_limit() ||
                   is_worth_keeping(local_.objective());
  if (quiet() || due) join();
}

std::uint64_t Rank::nodes_left() const {
  const auto limit = options_.limits.nodes;
  if (limit == std::numeric_limits<std::uint64_t>::max()) return limit;  // in every step
  const auto opened = local_.statistics().opened + local_.before().opened;
  return limit - std::min(limit, opened);
}

void Rank::join() {
  joined_ = true;
  ++waves_joined_;
  const auto& statistics = local_.statistics();
  Reduction own{.ranks = 1,
                .idle = resting() ? 1U : 0U,
                .quiet = quiet() ? 1U : 0U,
                .crossed = std::exchange(crossed_, false) ? 1U : 0U,
                .sent = sent_,
                .received = received_,
                .opened = statistics.opened,
                .open = local_.open(),
                .found = local_.found(),
                .fingerprint = statistics.fingerprint,
                .request_flags = request_flags(),
                .closed = local_.closed(),
                .objective = local_.objective(),
                .bound = local_.bound()};
  const auto [opened, fingerprint, found] = local_.before();
  own.opened += opened;
  own.fingerprint += fingerprint;
  record(TraceEvent::Kind::reduction_joined);
  transport_.join_reduction(own);
}

std::uint64_t Rank::request_flags() {
  std::uint64_t request_flags = 0;
  if (std::exchange(failed_, false)) request_flags |= report_write_failure;
  const Interrupt interrupt = options_.interrupt ? options_.interrupt() : Interrupt::none;
  if (interrupt == Interrupt::stop) request_flags |= request_stop_interrupt;
  if (interrupt == Interrupt::checkpoint) request_flags |= request_checkpoint;
  if (transport_.rank() != 0) return request_flags;
  if (now_ - started_ >= options_.limits.seconds) request_flags |= request_stop_time;
  if (now_ - last_checkpoint_ >= options_.checkpoint.interval) request_flags |= request_checkpoint;
  return request_flags;
}

void Rank::act_on(const Reduction& wave) {
  if (transport_.rank() == 0 && options_.progress) show(wave);
  note_stop(wave);
  switch (phase_) {
    case Phase::searching:
      if (all_quiet(wave)) {
        status_ = Status::solved;
        finish();
      } else if (status_ != Status::solved || checkpoint_due(wave)) {
        enter(Phase::pausing);
      }
      break;
    case Phase::pausing:
      if (all_quiet(wave)) act_when_quiet(wave);
      break;
    case Phase::writing:
      finish_checkpoint(wave);
      status_ == Status::solved ? continue_search() : finish();
      break;
    default:
      break;
  }
}

bool Rank::keeps_checkpoints() const {
  return !options_.checkpoint.file.empty();
}

bool Rank::is_worth_keeping(double objective) const {
  return keeps_checkpoints() && options_.checkpoint.on_improvement && objective < kept_objective_;
}

bool Rank::checkpoint_due(const Reduction& wave) const {
  const bool requested = keeps_checkpoints() && (wave.request_flags & request_checkpoint) != 0;
  return requested || is_worth_keeping(wave.objective);
}

void Rank::note_stop(const Reduction& wave) {
  if (status_ != Status::solved) return;
  if ((wave.request_flags & request_stop_interrupt) != 0) {
    status_ = Status::interrupted;
  } else if ((wave.request_flags & request_stop_time) != 0) {
    status_ = Status::time_limit;
  } else if (wave.opened >= options_.limits.nodes) {
    status_ = Status::node_limit;
  } else if (wave.found >= options_.limits.solutions) {
    status_ = Status::solution_limit;
  } else if (gap_closed(wave)) {
    status_ = Status::gap_limit;
  }
}

bool Rank::gap_closed(const Reduction& wave) const {
  if (options_.limits.gap <= 0 || !(wave.objective < infinity)) return false;
  return wave.objective - wave.bound <= options_.limits.gap * std::abs(wave.objective);
}

void Rank::act_when_quiet(const Reduction& wave) {
  if (wave.open == 0) {  // the tree was completed meanwhile
    status_ = Status::solved;
    finish();
  } else if (status_ == Status::gap_limit && !gap_closed(wave)) {
    status_ = Status::solved;  // an earlier wave missed a node in flight
    continue_search();
  } else if (keeps_checkpoints()) {
    write_checkpoint(wave);
  } else {
    status_ == Status::solved ? continue_search() : finish();
  }
}

void Rank::continue_search() {
  enter(Phase::searching);
}

void Rank::show(const Reduction& wave) const {
  options_.progress({.seconds = now_ - started_,
                     .opened = wave.opened,
                     .open = wave.open,
                     .found = wave.found,
                     .closed = std::min(1.0, wave.closed),
                     .idle = wave.idle,
                     .ranks = wave.ranks,
                     .objective = local_.oriented(wave.objective),
                     .bound = local_.oriented(wave.bound)});
}

void Rank::expect_checkpoint_options() const {
  const auto& [file, interval, on_improvement, resume_from, problem] = options_.checkpoint;
  if (file.empty() && resume_from.empty()) return;
  if (!problem) {
    throw std::invalid_argument(
        "a checkpoint requires the fingerprint of its problem; expected "
        "Options::checkpoint.problem");
  }
  // Rank 0 checks before any rank writes.
  if (file.empty() || transport_.rank() != 0) return;
  expect_folder(file);
  expect_no_other(file, resume_from);
}

Manifest Rank::manifest(const Reduction& wave) const {
  return {.problem = *options_.checkpoint.problem,
          .epoch = epoch_,
          .ranks = transport_.size(),
          .opened = wave.opened,
          .fingerprint = wave.fingerprint,
          .open = wave.open,
          .goal = goal_of(options_),
          .node = local_.node_type(),
          .solution = local_.solution_type()};
}

void Rank::write_checkpoint(const Reduction& wave) {
  enter(Phase::writing);
  ++epoch_;
  try {
    write_part(options_.checkpoint.file, manifest(wave), transport_.rank(),
               [this](std::streambuf& target) { local_.save(target); });
  } catch (const CheckpointError& error) {
    warn(error.what());
    failed_ = true;
  }
}

void Rank::finish_checkpoint(const Reduction& wave) {
  last_checkpoint_ = now_;
  kept_objective_ = wave.objective;
  saved_ = false;
  if (transport_.rank() != 0) return;
  if ((wave.request_flags & report_write_failure) != 0) {
    warn("a part of checkpoint " + std::to_string(epoch_) + " could not be written; " +
         "the previous one remains valid");
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

void Rank::warn(const std::string& line) const {
  if (options_.warn) return options_.warn(line);
  std::fprintf(stderr, "%s\n", line.c_str());
}

int Rank::resume() {
  const auto& file = options_.checkpoint.resume_from;
  const auto found = read_manifest(file);
  expect_same_search(file, found, manifest({}));
  epoch_ = good_epoch_ = found.epoch;
  // Parts are dealt cyclically to the ranks, whose number may differ; a rank without a part
  // requests work.
  for (int part = transport_.rank(); part < found.ranks; part += transport_.size()) {
    local_.restore(read_part(file, found, part));
  }
  return std::min(found.ranks, transport_.size());
}

}  // namespace kusabi::engine
