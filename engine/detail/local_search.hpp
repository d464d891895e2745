// LocalSearch: interface of the local search to the protocol (engine/detail/protocol/rank.hpp),
// independent of the problem's type.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <streambuf>
#include <string>
#include <vector>

#include "engine/detail/incumbent.hpp"
#include "engine/statistics.hpp"
#include "engine/wire.hpp"

namespace kusabi::engine {

/// Nodes, solutions and reports of one rank. The protocol calls it a few times per step, never once
/// per node.
class LocalSearch {
 public:
  LocalSearch() = default;
  LocalSearch(const LocalSearch&) = delete;
  LocalSearch& operator=(const LocalSearch&) = delete;
  virtual ~LocalSearch() = default;

  // ---- nodes
  virtual void add_root() = 0;
  virtual void open_nodes(unsigned count) = 0;
  [[nodiscard]] virtual bool has_nodes() const = 0;
  /// True during a call of `expand`.
  [[nodiscard]] virtual bool expanding() const = 0;
  /// True while a node is expanded twice; its state must not change then.
  [[nodiscard]] virtual bool checking() const = 0;
  /// Number of open nodes, and their least bound.
  [[nodiscard]] virtual std::uint64_t open() const = 0;
  [[nodiscard]] virtual double bound() const = 0;
  /// Share of the tree closed on this rank.
  [[nodiscard]] virtual double closed() const = 0;
  [[nodiscard]] virtual RankStatistics& statistics() = 0;

  // ---- nodes given and taken
  struct PackedTransfer {
    Bytes body;
    std::uint64_t nodes = 0;
  };
  [[nodiscard]] virtual bool can_transfer() const = 0;
  /// Half of the nodes, in one or more pieces.
  /// @param limit of a piece, in bytes (Options::message_bytes)
  /// @param maximum approximate number of pieces
  /// @pre can_transfer()
  virtual std::vector<PackedTransfer> give(std::size_t limit, std::size_t maximum) = 0;
  /// @return number of nodes
  virtual std::uint64_t take(const Bytes& transfer) = 0;

  // ---- solutions
  [[nodiscard]] virtual std::uint64_t found() const = 0;
  [[nodiscard]] virtual const Incumbent& incumbent() const = 0;
  /// Least objective found on this rank.
  [[nodiscard]] virtual double objective() const = 0;
  /// An objective or bound in the user's sense.
  [[nodiscard]] virtual double oriented(double value) const = 0;
  /// True if this rank improved the incumbent since the last call.
  [[nodiscard]] virtual bool just_improved() = 0;
  /// @return true if `received` is better than the incumbent of this rank
  virtual bool learn(const Incumbent& received) = 0;

  // ---- checkpoints
  /// Mangled names of the types of nodes and solutions.
  [[nodiscard]] virtual std::string node_type() const = 0;
  [[nodiscard]] virtual std::string solution_type() const = 0;
  /// Writes the state for a checkpoint, the same bytes at each call. @pre no node is being expanded
  virtual void save(std::streambuf& target) = 0;
  /// Adds a state to that of this rank.
  virtual void restore(const Bytes& state) = 0;
  /// Nodes opened in the resumed runs, as far as this rank restored them, their mark sum, and the
  /// solutions found.
  struct Before {
    std::uint64_t opened = 0;
    std::uint64_t fingerprint = 0;
    std::uint64_t found = 0;
  };
  [[nodiscard]] virtual Before before() const = 0;

  // ---- the report to rank 0
  /// Sends the report in pieces of at most `limit` bytes (unless a single solution is larger).
  virtual void report(std::size_t limit, const std::function<void(Bytes)>& send) = 0;
  /// Receives a piece.
  virtual void receive_report(int from, const Bytes& piece) = 0;
};

}  // namespace kusabi::engine
