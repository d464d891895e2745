// What a rank needs of the world: messages, survey waves and a clock.
//
// The search protocol talks to this and never to MPI, so the same rank runs over MPI, alone in one
// process, or as one of thousands in a simulation.
#pragma once

#include <optional>
#include <string>

#include "engine/survey.hpp"
#include "engine/wire.hpp"

namespace kusabi::engine {

/// What a message is about.
enum class Tag : int {
  request,  ///< an idle rank asks for nodes; empty
  plea,     ///< the same, and not to be forgotten if there are none to spare now; empty
  gift,     ///< nodes (answers a request or a plea)
  refusal,  ///< none to spare (answers a request or a plea); empty
  parcel,   ///< nodes for a rank that once pleaded
  news,     ///< a better solution is known
  report,   ///< solutions and statistics on their way to rank 0 at the end
};

struct Message {
  int from = 0;
  Tag tag = Tag::request;
  Bytes body;
};

/// One rank's end of the wires. No call blocks but `broadcast`, which no search makes.
///
/// Guarantees: a message that was sent arrives once; two messages of one tag between the same two
/// ranks arrive in the order in which they were sent. Nothing is promised of any others.
class Transport {
 public:
  Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;
  virtual ~Transport() = default;

  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int size() const = 0;

  /// Seconds since some moment; never runs backwards.
  [[nodiscard]] virtual double now() const = 0;

  /// @pre to != rank()
  virtual void send(int to, Tag tag, Bytes body) = 0;

  /// The next message that has arrived, if any.
  virtual std::optional<Message> receive() = 0;

  /// Hands in this rank's part of the next survey wave. The wave is complete when every rank has.
  /// @pre the wave joined before, if any, has been fetched by `survey`
  virtual void join_survey(const Survey& own) = 0;

  /// The merged survey, once, when the wave that this rank joined is complete.
  virtual std::optional<Survey> survey() = 0;

  /// Gives every rank the bytes of rank 0; each makes the call, and waits in it. Not for use during
  /// a search, whose messages would wait as well.
  virtual void broadcast(Bytes& bytes) = 0;

  /// Called when the search cannot go on on this rank. Ends the other ranks if they run elsewhere
  /// (and then does not return); returns if the exception at hand can be thrown to the caller.
  virtual void abandon(const std::string& reason) = 0;
};

}  // namespace kusabi::engine
