// ReportRelay: the reports of all ranks on their way to rank 0, merged along the broadcast tree
// (engine/detail/protocol/relay.hpp). Rank 0 receives messages from 16 ranks, not from 65,535.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/trace.hpp"
#include "engine/wire.hpp"

namespace kusabi::engine {

/// A piece of the report of one rank: of its trace, or of its local search.
struct ReportPart {
  int rank = 0;
  RankTrace trace;
  Bytes body;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& rank& trace& body;
  }
};

/// The reports of a rank and of those below it in the tree. Pieces are passed on as they are, in
/// messages of at most `limit` bytes unless a single piece is larger.
class ReportRelay {
 public:
  using Send = std::function<void(int parent, Bytes message)>;

  ReportRelay(int rank, int ranks, std::size_t limit, Send send);

  /// Pieces of this rank. @pre this rank is not rank 0
  void put(ReportPart part);

  /// Ends the report of this rank.
  void finish_own() { finish_one(); }

  /// A message from a rank below. Rank 0 passes its pieces to `receive`, another rank to its
  /// parent.
  void relay(const Bytes& message, const std::function<void(ReportPart&&)>& receive);

  /// True if this rank and all below it have reported.
  [[nodiscard]] bool complete() const { return missing_ == 0; }

 private:
  struct Bundle {
    std::vector<ReportPart> parts;
    bool last = false;  // of this sender

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& parts& last;
    }
  };

  void finish_one();
  void flush();

  int rank_;
  std::size_t limit_;
  Send send_;
  std::size_t missing_;  // ranks directly below, and this one, that have not finished
  Bundle bundle_;
  std::size_t bytes_ = 0;  // of the bundle
};

}  // namespace kusabi::engine
