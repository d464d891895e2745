// Bundles of report pieces, sent when they are full and when all below have reported.
#include "engine/detail/protocol/report_relay.hpp"

#include <algorithm>
#include <utility>

#include "engine/detail/contract.hpp"
#include "engine/detail/protocol/relay.hpp"

namespace kusabi::engine {
namespace {

std::size_t size_of(const ReportPart& part) {
  return sizeof(ReportPart) + part.body.size() + part.trace.events.size() * sizeof(TraceEvent);
}

}  // namespace

ReportRelay::ReportRelay(int rank, int ranks, std::size_t limit, Send send)
    : rank_(rank),
      limit_(limit),
      send_(std::move(send)),
      missing_(relay_neighbours(rank, ranks).size() + (rank == 0 ? 1 : 0)) {}

void ReportRelay::put(ReportPart part) {
  ensure(rank_ != 0, "rank 0 relays no reports");
  const auto bytes = size_of(part);
  if (bytes_ + bytes > limit_ && !bundle_.parts.empty()) flush();
  bytes_ += bytes;
  bundle_.parts.push_back(std::move(part));
}

void ReportRelay::relay(const Bytes& message, const std::function<void(ReportPart&&)>& receive) {
  auto bundle = unpack<Bundle>(message);
  for (auto& part : bundle.parts) rank_ == 0 ? receive(std::move(part)) : put(std::move(part));
  if (bundle.last) finish_one();
}

void ReportRelay::finish_one() {
  ensure(missing_ > 0, "each rank reports once");
  --missing_;
  if (missing_ > 0 || rank_ == 0) return;
  bundle_.last = true;
  flush();
}

void ReportRelay::flush() {
  send_(relay_parent(rank_), pack(bundle_));
  bundle_ = {};
  bytes_ = 0;
}

}  // namespace kusabi::engine
