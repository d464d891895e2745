// Transport: interface of the protocol to messages, reduction waves and a clock.
//
// The protocol does not call MPI itself, so that the same rank runs over MPI, alone in one process,
// or as one of thousands in a simulation.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/reduction.hpp"
#include "engine/wire.hpp"

namespace kusabi::engine {

/// Type of a message.
enum class MessageTag : int {
  request,  ///< an idle rank requests nodes; empty
  /// as request, and registers the sender with this lifeline if no nodes can be spared; empty
  lifeline_request,
  transfer,           ///< nodes (answers a request or a lifeline request)
  refusal,            ///< no nodes to spare (answers a request or a lifeline request); empty
  lifeline_transfer,  ///< nodes for a rank registered by an earlier lifeline request
  piece,              ///< further nodes of one of these two transfers
  incumbent,          ///< an improved incumbent
  report,             ///< solutions and statistics for rank 0 at the end
};

struct Message {
  int from = 0;
  MessageTag tag = MessageTag::request;
  Bytes body;
};

/// Transport of one rank. Only `broadcast` blocks; searches do not call it.
///
/// @post a message sent arrives once; two messages of one tag between the same two ranks arrive in
///     the order in which they were sent. The order of any others is undefined.
class Transport {
 public:
  Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;
  virtual ~Transport() = default;

  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int size() const = 0;

  /// Seconds since some moment; monotonic.
  [[nodiscard]] virtual double now() const = 0;

  /// Begins a search. Messages of ranks that have begun it already are received from now on, and
  /// not sooner.
  virtual void begin_search() {}

  /// True if more ranks run on this machine than it has cores: a rank that waits should sleep.
  [[nodiscard]] virtual bool oversubscribed() const { return false; }

  /// The other ranks on the machine of this rank, whose messages are the fastest; empty if unknown.
  [[nodiscard]] virtual std::vector<int> machine() const { return {}; }

  /// @pre to != rank()
  virtual void send(int to, MessageTag tag, Bytes body) = 0;

  /// The next message received, if any.
  virtual std::optional<Message> receive() = 0;

  /// Contributes to the next reduction wave. The wave is complete when every rank has joined it.
  /// @pre the result of the wave joined before, if any, has been fetched by `reduction`
  virtual void join_reduction(const Reduction& own) = 0;

  /// Result of the wave that this rank joined, once, when it is complete.
  virtual std::optional<Reduction> reduction() = 0;

  /// Broadcasts the bytes of rank 0. Blocks until every rank has called it. Not for use during a
  /// search, whose messages would not be answered.
  virtual void broadcast(Bytes& bytes) = 0;

  /// Called when the search cannot continue on this rank. Ends the other ranks if they run in other
  /// processes (and then does not return); otherwise returns, so that the exception reaches the
  /// caller.
  virtual void abandon(const std::string& reason) = 0;
};

}  // namespace kusabi::engine
