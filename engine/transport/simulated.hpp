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
#include <map>
#include <memory>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/transport/transport.hpp"

namespace kusabi::engine {

/// Parameters of the simulated machine. Times in seconds.
struct Weather {
  double latency = 2e-6;         ///< mean delay of a message (its distribution has a long tail)
  double bandwidth = 1e10;       ///< bytes per second
  double node = 1e-6;            ///< time to open a node, unless the problem is Timed
  double handling = 0;           ///< time that a rank spends on each message it sends or receives
  double stall = 1e-3;           ///< length of a stall
  double stall_probability = 0;  ///< probability of a stall at a step
};

class SimulatedTransport;

/// Network and clock of the simulation.
class SimulatedNetwork {
 public:
  SimulatedNetwork(int ranks, std::uint64_t seed, const Weather& weather);
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
  static constexpr double least_step = 0.1e-6;

  /// Information that is available to a rank from a moment on: a message, or a reduction's result.
  struct Notice {
    double time;
    int rank;
  };

  /// Notices since the last call.
  std::vector<Notice> take_notices() { return std::exchange(notices_, {}); }

  /// Messages not received plus reductions joined and not fetched; 0 after a correct search.
  [[nodiscard]] std::size_t in_flight() const;

  /// Size of the largest message sent, in bytes.
  [[nodiscard]] std::size_t largest_message() const { return largest_message_; }

 private:
  friend class SimulatedTransport;

  struct Delivery {
    double arrival;
    Message message;
  };
  struct Mailbox {
    std::vector<Delivery> deliveries;                           // unordered
    std::map<std::pair<int, MessageTag>, double> last_arrival;  // keeps each channel in order
    Reduction wave_result;
    double wave_done = -1;  // virtual time; -1: not complete yet
    bool joined = false;
    unsigned handled = 0;  // messages since the last step_duration
  };

  void send(int from, int to, MessageTag tag, Bytes body);
  std::optional<Message> receive(int rank);
  void join_reduction(int rank, const Reduction& own);
  std::optional<Reduction> reduction(int rank);
  double delay();

  Weather weather_;
  std::mt19937_64 random_;
  double now_ = 0;
  std::vector<Mailbox> ranks_;
  std::vector<std::unique_ptr<SimulatedTransport>> transports_;
  std::vector<Notice> notices_;
  Reduction wave_;
  std::size_t largest_message_ = 0;
};

}  // namespace kusabi::engine
