// SimulatedNetwork: delays, and the order of arrival.
#include "engine/transport/simulated.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "engine/detail/contract.hpp"
#include "engine/path.hpp"

namespace kusabi::engine {

class SimulatedTransport final : public Transport {
 public:
  SimulatedTransport(SimulatedNetwork& network, int rank) : network_(network), rank_(rank) {}

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return network_.size(); }
  [[nodiscard]] double now() const override { return network_.now(); }
  [[nodiscard]] std::vector<int> machine() const override {
    return network_.others_on_machine(rank_);
  }
  void send(int to, MessageTag tag, Bytes body) override {
    network_.send(rank_, to, tag, std::move(body));
  }
  std::optional<Message> receive() override { return network_.receive(rank_); }
  void join_reduction(const Reduction& own) override { network_.join_reduction(rank_, own); }
  std::optional<Reduction> reduction() override { return network_.reduction(rank_); }
  void broadcast(Bytes& /*bytes*/) override {
    ensure(false, "simulated ranks only search: all of them run in one thread");
  }
  void abandon(const std::string& /*reason*/) override {}

 private:
  SimulatedNetwork& network_;
  int rank_;
};

SimulatedNetwork::Random::result_type SimulatedNetwork::Random::operator()() {
  state_ = branch_hash(state_, 0);
  return state_;
}

SimulatedNetwork::SimulatedNetwork(int ranks, std::uint64_t seed, const MachineModel& machine)
    : machine_(machine), reductions_(ranks) {
  ranks_.reserve(static_cast<std::size_t>(ranks));
  for (int rank = 0; rank < ranks; ++rank) {
    ranks_.emplace_back(branch_hash(seed, static_cast<std::uint32_t>(rank)));
    transports_.push_back(std::make_unique<SimulatedTransport>(*this, rank));
  }
}

SimulatedNetwork::~SimulatedNetwork() = default;

Transport& SimulatedNetwork::transport(int rank) {
  return *transports_[static_cast<std::size_t>(rank)];
}

// Every step takes some time, or an idle rank would stop the clock.
double SimulatedNetwork::step_duration(int rank, double work) {
  auto& mine = mailbox(rank);
  double duration = min_step + work + machine_.handling * std::exchange(mine.handled, 0U);
  if (machine_.stall_probability > 0 &&
      std::bernoulli_distribution(machine_.stall_probability)(mine.random)) {
    duration += machine_.stall;
  }
  return duration;
}

// Log-normal distribution: one message in a thousand takes twenty times the mean.
double SimulatedNetwork::delay(int from, int to) {
  auto& random = mailbox(from).random;
  const bool near = machine_of(from) == machine_of(to);
  const double mean = near ? machine_.near_latency : machine_.latency;
  return mean * std::lognormal_distribution<double>(-0.5, 1.0)(random);
}

std::vector<int> SimulatedNetwork::others_on_machine(int rank) const {
  std::vector<int> others;
  const int first = machine_of(rank) * machine_.machine;
  for (int other = first; other < std::min(size(), first + machine_.machine); ++other) {
    if (other != rank) others.push_back(other);
  }
  return others;
}

void SimulatedNetwork::send(int from, int to, MessageTag tag, Bytes body) {
  ensure(from != to, "no rank sends to itself");
  largest_message_ = std::max(largest_message_, body.size());
  auto& target = mailbox(to);
  const double transmission = static_cast<double>(body.size()) / machine_.bandwidth;
  auto& channel = target.last_arrival[{from, tag}];
  const double arrival = std::max({now_ + delay(from, to) + transmission, channel + transmission,
                                   std::nextafter(channel, HUGE_VAL)});
  channel = arrival;
  target.deliveries.push_back({arrival, {from, tag, std::move(body)}});
  std::push_heap(target.deliveries.begin(), target.deliveries.end());
  notices_.push_back({arrival, to});
  ++mailbox(from).handled;
}

std::optional<Message> SimulatedNetwork::receive(int rank) {
  advance_reduction(rank);
  auto& mine = mailbox(rank);
  if (mine.deliveries.empty() || mine.deliveries.front().arrival > now_) return std::nullopt;
  std::pop_heap(mine.deliveries.begin(), mine.deliveries.end());
  auto delivery = std::move(mine.deliveries.back());
  mine.deliveries.pop_back();
  const auto channel = mine.last_arrival.find({delivery.message.from, delivery.message.tag});
  if (channel->second == delivery.arrival) mine.last_arrival.erase(channel);
  ++mine.handled;
  return std::move(delivery.message);
}

void SimulatedNetwork::join_reduction(int rank, const Reduction& own) {
  reductions_.join(rank, own);
  advance_reduction(rank);
}

std::optional<Reduction> SimulatedNetwork::reduction(int rank) {
  advance_reduction(rank);
  return reductions_.take(rank);
}

void SimulatedNetwork::advance_reduction(int rank) {
  if (!reductions_.joined(rank)) return;
  const auto received = reductions_.advance(rank, now_, [&](int to) {
    const double arrival = now_ + delay(rank, to);
    notices_.push_back({arrival, to});
    ++mailbox(rank).handled;
    return arrival;
  });
  mailbox(rank).handled += received;
}

bool SimulatedNetwork::has_arrived(int rank, double time) const {
  const auto& mine = ranks_[static_cast<std::size_t>(rank)];
  if (!mine.deliveries.empty() && mine.deliveries.front().arrival <= time) return true;
  return reductions_.has_arrived(rank, time);
}

std::size_t SimulatedNetwork::in_flight() const {
  std::size_t count = 0;
  for (int rank = 0; rank < size(); ++rank) {
    count += ranks_[static_cast<std::size_t>(rank)].deliveries.size();
    count += reductions_.joined(rank) ? 1 : 0;
  }
  return count;
}

}  // namespace kusabi::engine
