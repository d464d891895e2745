// SimulatedNetwork: delays, and the order of arrival.
#include "engine/transport/simulated.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/detail/contract.hpp"

namespace kusabi::engine {

class SimulatedTransport final : public Transport {
 public:
  SimulatedTransport(SimulatedNetwork& network, int rank) : network_(network), rank_(rank) {}

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return network_.size(); }
  [[nodiscard]] double now() const override { return network_.now(); }
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

SimulatedNetwork::SimulatedNetwork(int ranks, std::uint64_t seed, const Weather& weather)
    : weather_(weather), random_(seed), ranks_(static_cast<std::size_t>(ranks)) {
  for (int rank = 0; rank < ranks; ++rank) {
    transports_.push_back(std::make_unique<SimulatedTransport>(*this, rank));
  }
}

SimulatedNetwork::~SimulatedNetwork() = default;

Transport& SimulatedNetwork::transport(int rank) {
  return *transports_[static_cast<std::size_t>(rank)];
}

// Every step takes some time, or an idle rank would stop the clock.
double SimulatedNetwork::step_duration(int rank, double work) {
  const auto handled = std::exchange(ranks_[static_cast<std::size_t>(rank)].handled, 0U);
  double duration = least_step + work + weather_.handling * handled;
  if (weather_.stall_probability > 0 &&
      std::bernoulli_distribution(weather_.stall_probability)(random_)) {
    duration += weather_.stall;
  }
  return duration;
}

// Log-normal distribution: one message in a thousand takes twenty times the mean.
double SimulatedNetwork::delay() {
  return weather_.latency * std::lognormal_distribution<double>(-0.5, 1.0)(random_);
}

void SimulatedNetwork::send(int from, int to, MessageTag tag, Bytes body) {
  ensure(from != to, "no rank sends to itself");
  largest_message_ = std::max(largest_message_, body.size());
  auto& mailbox = ranks_[static_cast<std::size_t>(to)];
  double arrival = now_ + delay() + static_cast<double>(body.size()) / weather_.bandwidth;
  auto& channel = mailbox.last_arrival[{from, tag}];
  arrival = std::max(arrival, std::nextafter(channel, HUGE_VAL));
  channel = arrival;
  mailbox.deliveries.push_back({arrival, {from, tag, std::move(body)}});
  notices_.push_back({arrival, to});
  ++ranks_[static_cast<std::size_t>(from)].handled;
}

std::optional<Message> SimulatedNetwork::receive(int rank) {
  auto& mine = ranks_[static_cast<std::size_t>(rank)];
  auto& deliveries = mine.deliveries;
  const auto first = std::min_element(deliveries.begin(), deliveries.end(),
                                      [](auto& a, auto& b) { return a.arrival < b.arrival; });
  if (first == deliveries.end() || first->arrival > now_) return std::nullopt;
  auto message = std::move(first->message);
  if (first != deliveries.end() - 1) *first = std::move(deliveries.back());
  deliveries.pop_back();
  ++mine.handled;
  return message;
}

void SimulatedNetwork::join_reduction(int rank, const Reduction& own) {
  auto& mine = ranks_[static_cast<std::size_t>(rank)];
  ensure(!mine.joined, "a rank joins a reduction only after it has fetched the one before");
  mine.joined = true;
  mine.wave_done = -1;
  wave_.merge(own);
  if (wave_.ranks < ranks_.size()) return;
  const double rounds = 1 + std::log2(static_cast<double>(ranks_.size()));
  for (std::size_t each = 0; each < ranks_.size(); ++each) {
    ranks_[each].wave_result = wave_;
    ranks_[each].wave_done = now_ + rounds * delay();
    notices_.push_back({ranks_[each].wave_done, static_cast<int>(each)});
  }
  wave_ = Reduction{};
}

std::optional<Reduction> SimulatedNetwork::reduction(int rank) {
  auto& mine = ranks_[static_cast<std::size_t>(rank)];
  if (!mine.joined || mine.wave_done < 0 || mine.wave_done > now_) return std::nullopt;
  mine.joined = false;
  return mine.wave_result;
}

std::size_t SimulatedNetwork::in_flight() const {
  std::size_t count = 0;
  for (const auto& mailbox : ranks_) count += mailbox.deliveries.size() + (mailbox.joined ? 1 : 0);
  return count;
}

}  // namespace kusabi::engine
