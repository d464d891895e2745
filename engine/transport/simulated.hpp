// Simulated transport: many ranks in one process, in virtual time, under a schedule drawn from a
// seed.
//
// The simulation uses all freedom that MPI permits: it delays each message individually, lets
// messages of different senders or tags overtake one another, completes a reduction at each rank at
// a different moment, and stalls single ranks. A run depends on its seed alone, so a failure can be
// replayed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "engine/transport/recursive_doubling.hpp"
#include "engine/transport/transport.hpp"

namespace kusabi::engine {

/// Parameters of the simulated machine. Times in seconds.
struct MachineModel {
  double latency = 2e-6;         ///< mean delay of a message (its distribution has a long tail)
  double bandwidth = 1e10;       ///< bytes per second
  double node = 1e-6;            ///< time to open a node, unless the problem is Timed
  double handling = 0;           ///< time that a rank spends on each message it sends or receives
  double stall = 1e-3;           ///< length of a stall
  double stall_probability = 0;  ///< probability of a stall at a step
  int machine = 1;               ///< ranks on one machine
  double near_latency = 0.5e-6;  ///< mean delay of a message inside a machine
};

class SimulatedTransport;

/// Network and clock of the simulation.
class SimulatedNetwork {
 public:
  SimulatedNetwork(int ranks, std::uint64_t seed, const MachineModel& machine);
  SimulatedNetwork(const SimulatedNetwork&) = delete;
  SimulatedNetwork& operator=(const SimulatedNetwork&) = delete;
  ~SimulatedNetwork();

  [[nodiscard]] int size() const { return static_cast<int>(ranks_.size()); }
  [[nodiscard]] Transport& transport(int rank);

  [[nodiscard]] double now() const { return now_; }
  void advance(double time) { now_ = time; }

  /// Duration of a step of this rank that opened nodes for `work` seconds, including the messages
  /// handled since the last call.
  double step_duration(int rank, double work);

  /// Lower bound of the duration of a step.
  static constexpr double min_step = 0.1e-6;

  /// Information that is available to a rank from a moment on: a message, or a reduction's result.
  struct Notice {
    double time;
    int rank;
  };

  /// Notices since the last call.
  std::vector<Notice> take_notices() { return std::exchange(notices_, {}); }

  /// True if a rank that looks at this time finds a message, or a reduction advances.
  [[nodiscard]] bool has_arrived(int rank, double time) const;

  /// Messages not received plus reductions joined and not fetched; 0 after a correct search.
  [[nodiscard]] std::size_t in_flight() const;

  /// Size of the largest message sent, in bytes.
  [[nodiscard]] std::size_t largest_message() const { return largest_message_; }

 private:
  friend class SimulatedTransport;

  // Random numbers of one rank. Each rank has its own, so that they do not depend on the order in
  // which ranks are simulated.
  class Random {
   public:
    using result_type = std::uint64_t;
    explicit Random(std::uint64_t seed) : state_(seed) {}
    static constexpr result_type min() { return 0; }
    static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }
    result_type operator()();

   private:
    std::uint64_t state_;
  };

  struct Delivery {
    double arrival;
    Message message;

    friend bool operator<(const Delivery& one, const Delivery& other) {
      return one.arrival > other.arrival;  // the greatest is first in a heap
    }
  };
  struct Mailbox {
    explicit Mailbox(std::uint64_t seed) : random(seed) {}

    std::vector<Delivery> deliveries;  // a heap, earliest first
    // of the channels with a message in `deliveries`; keeps each channel in order
    std::map<std::pair<int, MessageTag>, double> last_arrival;
    unsigned handled = 0;  // messages since the last step_duration
    Random random;
  };

  void send(int from, int to, MessageTag tag, Bytes body);
  std::optional<Message> receive(int rank);
  void join_reduction(int rank, const Reduction& own);
  std::optional<Reduction> reduction(int rank);
  // Any look at the messages advances the reduction, too.
  void advance_reduction(int rank);
  double delay(int from, int to);
  [[nodiscard]] int machine_of(int rank) const { return rank / machine_.machine; }
  [[nodiscard]] std::vector<int> others_on_machine(int rank) const;
  [[nodiscard]] Mailbox& mailbox(int rank) { return ranks_[static_cast<std::size_t>(rank)]; }

  MachineModel machine_;
  double now_ = 0;
  std::vector<Mailbox> ranks_;
  std::vector<std::unique_ptr<SimulatedTransport>> transports_;
  std::vector<Notice> notices_;
  RecursiveDoubling reductions_;
  std::size_t largest_message_ = 0;
};

}  // namespace kusabi::engine
