// Messages of the protocol: requests, transfers, refusals, lifelines and incumbents.
#include <utility>

#include "engine/detail/contract.hpp"
#include "engine/detail/rank.hpp"
#include "engine/detail/relay.hpp"

namespace kusabi::engine {

void Rank::serve() {
  while (auto message = transport_.receive()) {
    quiet_since_ = now_;
    switch (message->tag) {
      case MessageTag::request:
        answer(message->from);
        break;
      case MessageTag::plea:
        if (!answer(message->from)) lifelines_.remember(message->from);
        break;
      case MessageTag::transfer:
        receive_transfer(*message);
        break;
      case MessageTag::refusal:
        receive_refusal(message->from);
        break;
      case MessageTag::lifeline_transfer:
        lifelines_.served_by(message->from);
        take_nodes(*message);
        break;
      case MessageTag::news:
        ++received_;
        if (local_.learn(unpack<Incumbent>(message->body))) broadcast_incumbent(message->from);
        break;
      case MessageTag::report:
        receive_report(*message);
        break;
    }
  }
  if (lifelines_.wanted() && can_give()) give(lifelines_.take(), MessageTag::lifeline_transfer);
}

void Rank::send(int to, MessageTag tag, Bytes body) {
  ++local_.statistics().messages_sent;
  transport_.send(to, tag, std::move(body));
}

bool Rank::can_give() const {
  return phase_ == Phase::searching && local_.can_give();
}

bool Rank::answer(int thief) {
  const bool can = can_give();
  can ? give(thief, MessageTag::transfer) : send(thief, MessageTag::refusal, {});
  return can;
}

void Rank::give(int thief, MessageTag tag) {
  auto [body, nodes] = local_.give(options_.message_bytes);
  auto& statistics = local_.statistics();
  ++statistics.transfers_sent;
  statistics.nodes_given += nodes;
  ++sent_;
  record(tag == MessageTag::transfer ? TraceEvent::Kind::transfer_sent
                                     : TraceEvent::Kind::lifeline_transfer_sent,
         thief, nodes);
  send(thief, tag, std::move(body));
}

void Rank::ask() {
  if (!victims_ || asked_ != nobody) return;
  const auto lifeline = victims_->in_vain() ? lifelines_.next() : std::nullopt;
  if (!lifeline && !victims_->due(now_)) return;
  pleaded_ = lifeline.has_value();
  asked_ = lifeline ? *lifeline : victims_->choose();
  ++local_.statistics().requests;
  record(TraceEvent::Kind::request_sent, asked_);
  send(asked_, pleaded_ ? MessageTag::plea : MessageTag::request, {});
}

void Rank::receive_transfer(const Message& message) {
  ensure(message.from == asked_, "a transfer comes from the rank that was asked");
  asked_ = nobody;
  take_nodes(message);
}

void Rank::receive_refusal(int victim) {
  ensure(victim == asked_, "a refusal comes from the rank that was asked");
  asked_ = nobody;
  record(TraceEvent::Kind::refusal_arrived, victim);
  if (pleaded_) {
    lifelines_.left_name_with(victim);
  } else {
    victims_->refused(victim, now_);
  }
}

void Rank::take_nodes(const Message& message) {
  ++received_;
  victims_->gave(message.from);
  auto& statistics = local_.statistics();
  if (idle()) {
    statistics.idle_seconds += now_ - idle_since_;
    if (statistics.opened == 0) statistics.ramp_up_seconds = now_ - idle_since_;
  }
  ++statistics.transfers_received;
  const auto open = trace_ ? local_.open() : 0;
  const auto nodes = local_.take(message.body);
  if (trace_) {
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
  const auto body = pack(local_.incumbent());
  for (const int neighbour : relay_neighbours(transport_.rank(), transport_.size())) {
    if (neighbour == source) continue;
    ++sent_;
    send(neighbour, MessageTag::news, body);
  }
}

}  // namespace kusabi::engine
