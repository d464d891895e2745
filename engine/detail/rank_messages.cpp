// How ranks share work: what each message means, and whom an idle rank asks.
#include <utility>

#include "engine/detail/contract.hpp"
#include "engine/detail/rank.hpp"
#include "engine/detail/relay.hpp"

namespace kusabi::engine {

void Rank::serve() {
  while (auto message = transport_.receive()) {
    quiet_since_ = now_;
    switch (message->tag) {
      case Tag::request:
        answer(message->from);
        break;
      case Tag::plea:
        if (!answer(message->from)) lifelines_.remember(message->from);
        break;
      case Tag::gift:
        receive_gift(*message);
        break;
      case Tag::refusal:
        receive_refusal(message->from);
        break;
      case Tag::parcel:
        lifelines_.served_by(message->from);
        take_nodes(*message);
        break;
      case Tag::news:
        ++received_;
        if (local_.learn(unpack<Incumbent>(message->body))) tell(message->from);
        break;
      case Tag::report:
        receive_report(*message);
        break;
    }
  }
  if (lifelines_.wanted() && can_give()) give(lifelines_.take(), Tag::parcel);
}

void Rank::send(int to, Tag tag, Bytes body) {
  ++local_.statistics().messages_sent;
  transport_.send(to, tag, std::move(body));
}

bool Rank::can_give() const {
  return phase_ == Phase::searching && local_.can_give();
}

bool Rank::answer(int thief) {
  const bool can = can_give();
  can ? give(thief, Tag::gift) : send(thief, Tag::refusal, {});
  return can;
}

void Rank::give(int thief, Tag tag) {
  auto [body, nodes] = local_.give(options_.message_bytes);
  auto& statistics = local_.statistics();
  ++statistics.gifts_sent;
  statistics.nodes_given += nodes;
  ++sent_;
  record(tag == Tag::gift ? TraceEvent::Kind::gift_sent : TraceEvent::Kind::parcel_sent, thief,
         nodes);
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
  send(asked_, pleaded_ ? Tag::plea : Tag::request, {});
}

void Rank::receive_gift(const Message& message) {
  ensure(message.from == asked_, "a gift comes from the rank that was asked");
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
  ++statistics.gifts_received;
  const auto open = trace_ ? local_.open() : 0;
  const auto nodes = local_.take(message.body);
  if (trace_) {
    trace_->record({.time = transport_.now(),
                    .value = nodes,
                    .open = open,
                    .peer = message.from,
                    .kind = message.tag == Tag::gift ? TraceEvent::Kind::gift_arrived
                                                     : TraceEvent::Kind::parcel_arrived});
  }
  record_activity();
}

void Rank::tell(int source) {
  if (source == nobody) record(TraceEvent::Kind::improved);
  const auto body = pack(local_.incumbent());
  for (const int neighbour : relay_neighbours(transport_.rank(), transport_.size())) {
    if (neighbour == source) continue;
    ++sent_;
    send(neighbour, Tag::news, body);
  }
}

}  // namespace kusabi::engine
