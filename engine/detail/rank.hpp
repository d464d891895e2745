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
// (engine/detail/termination.hpp) every open node lies on exactly one rank, and that is the state
// that a checkpoint keeps.
//
// Requests are always answered, also while closing; a rank leaves only after a last survey that
// every rank joins when its own last request has been answered. So no message is ever left behind.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/checkpoint.hpp"
#include "engine/detail/lifelines.hpp"
#include "engine/detail/local_search.hpp"
#include "engine/detail/termination.hpp"
#include "engine/detail/victims.hpp"
#include "engine/options.hpp"
#include "engine/statistics.hpp"
#include "engine/survey.hpp"
#include "engine/trace.hpp"
#include "engine/transport/transport.hpp"

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

/// The protocol of one rank, whatever it searches.
class Rank {
 public:
  /// All must outlive the rank. Rank 0 plants the root, unless the search goes on from a
  /// checkpoint.
  /// @throws CheckpointError if the checkpoint to go on from cannot be read or is of another
  ///   search, or if one that is there would be overwritten
  /// @throws std::invalid_argument if there is a checkpoint without the problem's fingerprint
  Rank(LocalSearch& local, Transport& transport, const Options& options);
  Rank(const Rank&) = delete;
  Rank& operator=(const Rank&) = delete;

  /// A bounded amount of work. @throws what opening nodes throws
  Pace step();

  /// To be called from inside a long expansion. @return whether the search ends early
  bool poll();

  /// A moment before which this rank, as long as it has nodes to open and nothing reaches it, sends
  /// nothing and joins no survey.
  [[nodiscard]] double quiet_until() const;

  /// What an Outcome says that does not depend on the problem's type.
  struct Ending {
    Status status = Status::solved;
    std::uint64_t open = 0;
    bool saved = false;
    double bound = -std::numeric_limits<double>::infinity();
    std::vector<RankTrace> traces;
  };
  /// @pre the last step said done
  Ending ending();

 private:
  enum class Phase { gathering, searching, pausing, writing, closing, reporting, done };

  // A piece of the report to rank 0: of the trace, or what the search on the rank has to say.
  struct ReportPart {
    RankTrace trace;
    Bytes body;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& trace& body;
    }
  };
  [[nodiscard]] bool busy() const { return local_.expanding() || local_.has_nodes(); }
  [[nodiscard]] bool idle() const { return !busy(); }
  // Opens no node, and will not before a gift arrives or all ranks go on together. (A survey may
  // say "pause" while a long expansion polls; that expansion comes to its end first.)
  [[nodiscard]] bool resting() const;
  void enter(Phase phase);

  // ---- opening nodes ----------------------------------------------------------------------------

  // After a step that opened nodes, for `elapsed` seconds.
  void take_stock(double elapsed);

  // Messages should be looked at every 10 to 20 microseconds: seldom enough not to be felt with the
  // cheapest nodes, often enough not to let a thief wait. A fixed number of nodes is wrong by a
  // factor of a thousand for one problem or another.
  void adapt_stride(double elapsed);

  // ---- messages ---------------------------------------------------------------------------------

  void serve();
  void send(int to, Tag tag, Bytes body);
  [[nodiscard]] bool can_give() const;

  // @return whether there was something to give
  bool answer(int thief);
  void give(int thief, Tag tag);

  // Asks around at first; when that was in vain, leaves its name with one lifeline after another,
  // and asks around again now and then.
  void ask();
  void receive_gift(const Message& message);
  void receive_refusal(int victim);
  void take_nodes(const Message& message);

  // Passes the incumbent on to the neighbours in the relay tree, but not back to where it is from.
  void tell(int source);

  // ---- surveys ----------------------------------------------------------------------------------

  void attend_survey();
  void join();
  [[nodiscard]] bool at_node_limit() const;  // by what this rank alone has opened

  // What this rank wants all to do. The clock of rank 0 counts.
  std::uint64_t wishes();

  // Every rank comes here with the same waves in the same order, and so to the same decisions.
  void act_on(const Survey& wave);
  [[nodiscard]] bool keeps_checkpoints() const;
  [[nodiscard]] bool is_worth_keeping(double objective) const;  // an incumbent, by itself
  [[nodiscard]] bool checkpoint_due(const Survey& wave) const;
  void note_stop(const Survey& wave);
  [[nodiscard]] bool gap_closed(const Survey& wave) const;

  // All ranks pause and nothing is in flight: sums and minima of this wave are exact.
  void act_at_rest(const Survey& wave);
  void go_on();
  void show(const Survey& wave) const;

  // ---- checkpoints ------------------------------------------------------------------------------

  void expect_checkpoint_options() const;
  [[nodiscard]] Manifest manifest(const Survey& wave) const;
  void write_checkpoint(const Survey& wave);

  // The wave after the parts were written: it counts if no rank failed.
  void finish_checkpoint(const Survey& wave);
  void warn(const std::string& line) const;
  void resume();

  // ---- the end ----------------------------------------------------------------------------------

  void start_closing();

  // The last survey is complete when no rank waits for an answer any more and none will ask again.
  void close();
  void send_report();
  void receive_report(const Message& message);

  // ---- the trace --------------------------------------------------------------------------------

  // A survey precedes the search, so that clocks can be compared (engine/trace.hpp).
  void begin_trace();
  void gather();
  void record(TraceEvent::Kind kind, int peer = nobody, std::uint64_t value = 0);
  void record_activity();
  [[nodiscard]] TraceEvent::Kind activity() const;
  void receive_trace(int from, const RankTrace& piece);

  // ---- pace -------------------------------------------------------------------------------------

  // A rank that waits looks again after as long as nothing has happened so far: an answer is met at
  // once, and in vain a rank looks ever less often. The core it sits on may have better things to
  // do, and a millisecond is not missed.
  [[nodiscard]] Pace pace() const;

  static constexpr int nobody = -1;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  LocalSearch& local_;
  Transport& transport_;
  const Options& options_;

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

  std::uint64_t epoch_ = 0;           // of the last checkpoint written, good or not
  std::uint64_t good_epoch_ = 0;      // the last that counts, as far as rank 0 knows
  double kept_objective_ = infinity;  // of the incumbent in the last, as all ranks know
  bool failed_ = false;               // to write the own part
  bool saved_ = false;                // the last one counts

  std::optional<TraceRecorder> trace_;
  std::vector<RankTrace> traces_;  // of all ranks, on rank 0

  int reports_in_ = 0;  // of the other ranks, on rank 0

  double started_;
  double now_;
  double step_started_;
  double last_survey_;
  double last_checkpoint_;
  double idle_since_;
  double quiet_since_;  // no message, no survey, no node opened
};

}  // namespace kusabi::engine
