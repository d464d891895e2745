// Messages of the protocol: requests, transfers, refusals, lifelines and incumbents.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "engine/detail/contract.hpp"
#include "engine/detail/protocol/rank.hpp"
#include "engine/detail/protocol/relay.hpp"

namespace kusabi::engine {

void Rank::serve() {
  constexpr int batch = 16;
  sent_many_ = false;
  for (int handled = 0; handled < batch;) {
    auto message = transport_.receive();
    if (!message) break;
    if (message->tag != MessageTag::piece) ++handled;
    quiet_since_ = now_;
    exchanged_ = true;
    handle(*std::move(message));
  }
  for (int given = 0; given < batch && lifelines_.has_registered() && can_transfer(); ++given) {
    exchanged_ = true;
    give(lifelines_.take(), MessageTag::lifeline_transfer);
  }
}

void Rank::handle(Message&& message) {
  switch (message.tag) {
    case MessageTag::request:
      answer(message.from);
      break;
    case MessageTag::lifeline_request:
      if (!answer(message.from)) lifelines_.remember(message.from);
      break;
    case MessageTag::transfer:
      receive_transfer(std::move(message));
      break;
    case MessageTag::refusal:
      receive_refusal(message.from);
      break;
    case MessageTag::lifeline_transfer:
      lifelines_.served_by(message.from);
      take_nodes(std::move(message));
      break;
    case MessageTag::piece:
      take_nodes(std::move(message));
      break;
    case MessageTag::incumbent:
      count_received(message);
      if (local_.learn(unpack<Incumbent>(message.body))) broadcast_incumbent(message.from);
      break;
    case MessageTag::report:
      reports_.relay(message.body, [this](ReportPart&& part) { receive_report(std::move(part)); });
      break;
  }
}

void Rank::send(int to, MessageTag tag, Bytes body) {
  ++local_.statistics().messages_sent;
  transport_.send(to, tag, std::move(body));
}

void Rank::send_counted(int to, MessageTag tag, Bytes body) {
  ++sent_;
  send(to, tag, stamped(std::move(body), waves_joined_));
}

void Rank::count_received(Message& message) {
  ++received_;
  if (take_stamp(message.body) > waves_joined_) crossed_ = true;
}

bool Rank::can_transfer() const {
  return phase_ == Phase::searching && local_.can_transfer();
}

bool Rank::answer(int requester) {
  const bool can = can_transfer();
  can ? give(requester, MessageTag::transfer) : send(requester, MessageTag::refusal, {});
  return can;
}

void Rank::give(int requester, MessageTag tag) {
  auto& statistics = local_.statistics();
  // To send a node takes a quarter of a microsecond; half of a large family is worth it only if its
  // nodes take longer, and once between two polls.
  constexpr double worth_sending = 5e-6;
  constexpr std::size_t few = 16;
  constexpr std::size_t many = 4096;
  const bool sends_many = node_seconds_ >= worth_sending && !sent_many_;
  auto pieces = local_.give(options_.message_bytes, sends_many ? many : few);
  sent_many_ = sent_many_ || pieces.size() > few;
  std::uint64_t given = 0;
  for (const auto& piece : pieces) given += piece.nodes;
  record(tag == MessageTag::transfer ? TraceEvent::Kind::transfer_sent
                                     : TraceEvent::Kind::lifeline_transfer_sent,
         requester, given);
  ++statistics.transfers_sent;
  statistics.nodes_given += given;
  for (auto& piece : pieces) {
    send_counted(requester, std::exchange(tag, MessageTag::piece), std::move(piece.body));
  }
}

void Rank::ask() {
  if (!victims_ || asking()) return;
  if (busy() && victims_->has_requested_early()) return;
  if (victims_->refused_often()) return request_from_lifelines();
  if (!victims_->due(now_)) return;
  asked_ = victims_->choose();
  asked_at_ = now_;
  ++local_.statistics().requests;
  record(TraceEvent::Kind::request_sent, asked_);
  send(asked_, MessageTag::request, {});
}

// Asks a few lifelines at first, in case they have nodes, and then twice as many each time.
void Rank::request_from_lifelines() {
  constexpr std::size_t min_asked = 4;
  for (auto count = std::max(min_asked, lifelines_.aware()); count > 0; --count) {
    const auto lifeline = lifelines_.ask_next();
    if (!lifeline) return;
    ++local_.statistics().requests;
    record(TraceEvent::Kind::request_sent, *lifeline);
    send(*lifeline, MessageTag::lifeline_request, {});
  }
}

void Rank::receive_transfer(Message&& message) {
  if (lifelines_.asking(message.from)) {
    lifelines_.given_by(message.from);
  } else {
    ensure(message.from == asked_, "a transfer comes from the rank that was asked");
    receive_answer();
  }
  take_nodes(std::move(message));
}

void Rank::receive_refusal(int victim) {
  record(TraceEvent::Kind::refusal_arrived, victim);
  if (lifelines_.asking(victim)) return lifelines_.refused_by(victim);
  ensure(victim == asked_, "a refusal comes from the rank that was asked");
  victims_->refused(victim, now_);
  receive_answer();
}

void Rank::receive_answer() {
  asked_ = nobody;
  take_mean(answer_seconds_, now_ - asked_at_);
}

void Rank::take_nodes(Message&& message) {
  count_received(message);
  victims_->sent(message.from);
  auto& statistics = local_.statistics();
  if (idle()) {
    statistics.idle_seconds += now_ - idle_since_;
    if (statistics.opened == 0) statistics.ramp_up_seconds = now_ - idle_since_;
  }
  if (message.tag != MessageTag::piece) ++statistics.transfers_received;
  const auto open = trace_ ? local_.open() : 0;
  const auto nodes = local_.take(message.body);
  if (trace_ && message.tag != MessageTag::piece) {
    trace_->record({.time = transport_.now(),
                    .value = nodes,
                    .open = open,
                    .peer = message.from,
                    .kind = message.tag == MessageTag::transfer
                                ? TraceEvent::Kind::transfer_arrived
                                : TraceEvent::Kind::lifeline_transfer_arrived});
  }
  record_activity();
}

void Rank::broadcast_incumbent(int source) {
  if (source == nobody) record(TraceEvent::Kind::improved);
  const auto neighbours = relay_neighbours(transport_.rank(), transport_.size());
  if (neighbours.empty()) return;
  const auto body = pack(local_.incumbent());
  for (const int neighbour : neighbours) {
    if (neighbour == source) continue;
    send_counted(neighbour, MessageTag::incumbent, body);
  }
}

}  // namespace kusabi::engine
