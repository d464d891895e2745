// Many ranks in one process, in virtual time, under a schedule drawn from a seed.
//
// The simulation does to messages whatever MPI does not forbid: it delays each by a time of its
// own, lets messages of different senders or tags overtake one another, completes a survey at each
// rank at a different moment, and makes single ranks stall. A run is a function of its seed alone,
// so a failure replays.
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

/// How the simulated machine behaves. Times in seconds.
struct Weather {
  double latency = 2e-6;         ///< mean delay of a message (its distribution has a long tail)
  double bandwidth = 1e10;       ///< bytes per second
  double node = 1e-6;            ///< time to open a node, unless the problem is Timed
  double handling = 0;           ///< time that a rank spends on a message it sends or receives
  double stall = 1e-3;           ///< length of a stall
  double stall_probability = 0;  ///< of a stall at a step
};

class SimulatedTransport;

/// The wires between the ranks, and the clock.
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

  /// How long a step of this rank lasts in which it opened nodes for `work` seconds; counts the
  /// messages that it handled since the last call.
  double step_duration(int rank, double work);

  /// No step is shorter.
  static constexpr double least_step = 0.1e-6;

  /// Something that a rank can know of from a moment on: a message, or a survey's result.
  struct Notice {
    double time;
    int rank;
  };

  /// The notices that came up since the last call.
  std::vector<Notice> take_notices() { return std::exchange(notices_, {}); }

  /// Messages sent and not received, and surveys joined and not fetched. 0 when all went well.
  [[nodiscard]] std::size_t in_flight() const;

  /// In bytes, of all that were sent.
  [[nodiscard]] std::size_t largest_message() const { return largest_message_; }

 private:
  friend class SimulatedTransport;

  struct Parcel {
    double arrival;
    Message message;
  };
  struct Mailbox {
    std::vector<Parcel> parcels;                         // in no order
    std::map<std::pair<int, Tag>, double> last_arrival;  // keeps each channel in order
    Survey wave_result;
    double wave_done = -1;  // virtual time, or -1: not known yet
    bool joined = false;
    unsigned handled = 0;  // messages since the last step_duration
  };

  void send(int from, int to, Tag tag, Bytes body);
  std::optional<Message> receive(int rank);
  void join_survey(int rank, const Survey& own);
  std::optional<Survey> survey(int rank);
  double delay();

  Weather weather_;
  std::mt19937_64 random_;
  double now_ = 0;
  std::vector<Mailbox> ranks_;
  std::vector<std::unique_ptr<SimulatedTransport>> transports_;
  std::vector<Notice> notices_;
  Survey wave_;
  std::size_t largest_message_ = 0;
};

}  // namespace kusabi::engine
