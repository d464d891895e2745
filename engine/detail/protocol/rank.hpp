// Rank: the protocol of one rank of a search, as a state machine.
//
//                                   ┌──────────── resume ───────────┐
//                                   ▼                               │
//   the root ──► searching ──► (a stop or a ──► pausing ──► writing a checkpoint ──┐
//                    │          checkpoint           │                             │ stop
//                    │ tree done     is due)         │ stop                        │
//                    ▼                               ▼                             ▼
//                reporting ◄───────────────────────────────────────────────────────┘
//                    │ all below have reported
//                    ▼
//                  done
//
// `step` does a bounded amount of work and returns; it never waits. The driver (engine/search.hpp
// over a real transport, engine/simulation.hpp in virtual time) calls it until it returns done.
//
// All ranks are peers. A rank that has no open node, or soon none, requests work from one other
// rank at a time; that rank gives every other node from the shallowest on, or refuses. Global
// decisions use reductions, whose results all ranks see in the same order; all ranks therefore
// change state at the same wave. In `pausing` no rank opens, requests or gives nodes; when all are
// quiet (engine/detail/protocol/termination.hpp) every open node is on exactly one rank, and a
// checkpoint stores that state.
//
// A quiet wave also shows that no message is in flight and none follows. A rank leaves when it
// knows of it and has passed on the reports of the ranks below it
// (engine/detail/protocol/report_relay.hpp).
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/checkpoint.hpp"
#include "engine/detail/local_search.hpp"
#include "engine/detail/protocol/lifelines.hpp"
#include "engine/detail/protocol/report_relay.hpp"
#include "engine/detail/protocol/stamp.hpp"
#include "engine/detail/protocol/termination.hpp"
#include "engine/detail/protocol/victims.hpp"
#include "engine/options.hpp"
#include "engine/reduction.hpp"
#include "engine/statistics.hpp"
#include "engine/trace.hpp"
#include "engine/transport/transport.hpp"

namespace kusabi::engine {

/// State of a worker after a step.
struct Pace {
  enum class State { working, waiting, done } state = State::working;
  double wait = 0;  ///< if waiting: seconds until the next step

  /// Shorter waits are not slept, since a sleep takes some 50 microseconds at least: the next step
  /// follows at once.
  static constexpr double min_sleep = 50e-6;
  [[nodiscard]] bool sleeps() const { return state == State::waiting && wait >= min_sleep; }
};

/// Protocol of one rank, independent of the problem.
class Rank {
 public:
  /// All arguments must outlive the rank. Rank 0 adds the root unless the search resumes from a
  /// checkpoint.
  /// @throws CheckpointError if the checkpoint to resume from cannot be read or belongs to another
  ///   search, or if another checkpoint would be overwritten
  /// @throws std::invalid_argument if a checkpoint is given without the problem's fingerprint
  Rank(LocalSearch& local, Transport& transport, const Options& options);
  Rank(const Rank&) = delete;
  Rank& operator=(const Rank&) = delete;

  /// Does a bounded amount of work. @throws exceptions of `expand`
  Pace step();

  /// Answers messages; called by a long expansion. @return true if the search ends early
  bool poll();

  /// Lower bound of the time at which this rank next sends a message, joins a reduction or falls
  /// asleep, as long as it receives nothing and, if it is busy, more nodes than `requests_at()` are
  /// open.
  [[nodiscard]] double quiet_until() const;

  /// Number of open nodes above which this rank requests none.
  [[nodiscard]] unsigned requests_at() const;

  /// The part of an Outcome that does not depend on the problem's type.
  struct Ending {
    Status status = Status::solved;
    std::uint64_t open = 0;
    bool saved = false;
    double bound = -std::numeric_limits<double>::infinity();
    std::vector<RankTrace> traces;
  };
  /// @pre the last step returned done
  Ending ending();

 private:
  enum class Phase { gathering, searching, pausing, writing, reporting, done };

  [[nodiscard]] bool busy() const { return local_.expanding() || local_.has_nodes(); }
  [[nodiscard]] bool idle() const { return !busy(); }
  // True if this rank opens no node until a transfer arrives or all ranks resume. (A reduction may
  // start the pause while a long expansion polls; that expansion is completed first.)
  [[nodiscard]] bool resting() const;

  // True if a request of this rank, to a victim or a lifeline, has not been answered.
  [[nodiscard]] bool asking() const { return asked_ != nobody || lifelines_.asking(); }

  // True if this rank requests nothing until nodes arrive: it is registered with all lifelines.
  [[nodiscard]] bool dormant() const;

  // True if this rank sends no message by itself (engine/detail/protocol/termination.hpp).
  [[nodiscard]] bool quiet() const;
  void enter(Phase phase);

  // ---- opening nodes ----------------------------------------------------------------------------

  // Moves a running mean towards a value.
  static void take_mean(double& mean, double value) {
    constexpr double weight = 0.125;
    mean = mean == 0 ? value : mean + weight * (value - mean);
  }

  // Updates statistics and stride after a step that opened nodes for `elapsed` seconds.
  void update_step_statistics(double elapsed);

  // Adapts the number of nodes per step, so that messages are polled every 10 to 20 microseconds:
  // the overhead is then negligible for the cheapest nodes, and a requesting rank hardly waits. The
  // cost of a node varies by a factor of a thousand between problems.
  void adapt_stride(double elapsed);

  // ---- messages ---------------------------------------------------------------------------------

  // Handles a bounded number of messages, and all pieces among them, so that a rank that many ask
  // opens nodes in between, and one that receives many pieces answers others.
  void serve();
  void handle(Message&& message);
  void send(int to, MessageTag tag, Bytes body);
  void send_counted(int to, MessageTag tag, Bytes body);
  void count_received(Message& message);
  [[nodiscard]] bool can_transfer() const;

  // @return true if nodes were given
  bool answer(int requester);
  void give(int requester, MessageTag tag);

  // Requests work from random ranks; after some refusals an idle rank registers with its lifelines,
  // and is dormant when all know of it.
  void ask();
  void request_from_lifelines();
  void receive_transfer(Message&& message);
  void receive_refusal(int victim);
  void receive_answer();
  void take_nodes(Message&& message);

  // True if the open nodes are likely to be done before an answer could arrive.
  [[nodiscard]] bool soon_idle() const;

  // Broadcasts the incumbent along the relay tree: sends it to all neighbours except `source`.
  void broadcast_incumbent(int source);

  // ---- reductions -------------------------------------------------------------------------------

  void attend_reduction();
  void join();
  // Nodes up to the limit, counting those that this rank opened only, in earlier runs, too.
  [[nodiscard]] std::uint64_t nodes_left() const;
  [[nodiscard]] bool at_node_limit() const { return nodes_left() == 0; }

  // Requests of this rank to all ranks. Only the clock of rank 0 counts.
  std::uint64_t request_flags();

  // Global decisions. Every rank calls this with the same waves in the same order.
  void act_on(const Reduction& wave);
  [[nodiscard]] bool keeps_checkpoints() const;
  // true if an incumbent is to be checkpointed
  [[nodiscard]] bool is_worth_keeping(double objective) const;
  [[nodiscard]] bool checkpoint_due(const Reduction& wave) const;
  void note_stop(const Reduction& wave);
  [[nodiscard]] bool gap_closed(const Reduction& wave) const;

  // Called when all ranks pause and no message is in flight: sums and minima of this wave are
  // exact.
  void act_when_quiet(const Reduction& wave);
  void continue_search();
  void show(const Reduction& wave) const;

  // ---- checkpoints ------------------------------------------------------------------------------

  void expect_checkpoint_options() const;
  [[nodiscard]] Manifest manifest(const Reduction& wave) const;
  void write_checkpoint(const Reduction& wave);

  // Evaluates the wave after the parts were written: the checkpoint is valid if no rank failed.
  void finish_checkpoint(const Reduction& wave);
  void warn(const std::string& line) const;
  // @return number of ranks that begin with nodes
  int resume();

  // ---- the end ----------------------------------------------------------------------------------

  void finish();
  void send_report();
  void receive_report(ReportPart&& part);

  // ---- the trace --------------------------------------------------------------------------------

  // Starts the reduction before the search, by which clocks are compared (engine/trace.hpp).
  void begin_trace();
  void gather();
  void record(TraceEvent::Kind kind, int peer = nobody, std::uint64_t value = 0);
  void record_activity();
  [[nodiscard]] TraceEvent::Kind activity() const;
  void receive_trace(int from, const RankTrace& piece);

  // ---- pace -------------------------------------------------------------------------------------

  // Wait before the next poll: a hundredth of the time since the last event, or all of it if ranks
  // share cores; at most a millisecond. An answer is thus received at once, and a rank that waits
  // for long leaves the core to others.
  [[nodiscard]] Pace pace() const;

  static constexpr int nobody = -1;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  LocalSearch& local_;
  Transport& transport_;
  const Options& options_;

  unsigned stride_;
  bool worked_ = false;              // the last step opened nodes; its duration adapts the stride
  std::uint64_t opened_before_ = 0;  // nodes, by the step before
  bool exchanged_ = false;           // the last step received messages or gave nodes
  bool sent_many_ = false;           // a transfer of many messages since the last `serve` began
  double node_seconds_ = 0;          // of one node, a running mean
  double answer_seconds_ = 10e-6;    // from a request to its answer, a running mean
  const double share_waited_;        // of the time since the last event, before the next poll

  std::optional<Victims> victims_;
  Lifelines lifelines_;
  int asked_ = nobody;
  double asked_at_ = 0;
  std::uint64_t sent_ = 0;  // transfers and incumbents
  std::uint64_t received_ = 0;
  Stamp waves_joined_ = 0;
  bool crossed_ = false;  // received a counted message sent after a wave that is not joined yet

  Phase phase_ = Phase::searching;
  Status status_ = Status::solved;  // unless solved: reason of the stop
  bool joined_ = false;
  Reduction last_wave_;

  std::uint64_t epoch_ = 0;       // of the last checkpoint written, valid or not
  std::uint64_t good_epoch_ = 0;  // of the last valid checkpoint, as known to rank 0
  // objective of the incumbent in the last checkpoint, the same on all ranks
  double kept_objective_ = infinity;
  bool failed_ = false;  // this rank could not write its part
  bool saved_ = false;   // the last checkpoint is valid

  std::optional<TraceRecorder> trace_;
  std::vector<RankTrace> traces_;  // of all ranks, on rank 0

  ReportRelay reports_;

  double started_;
  double now_;
  double step_started_;
  double last_reduction_;
  double last_checkpoint_;
  double idle_since_;
  double quiet_since_;  // time of the last message, reduction or opened node
};

}  // namespace kusabi::engine
