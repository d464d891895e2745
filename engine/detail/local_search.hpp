// What the protocol (engine/detail/rank.hpp) knows of the search on its rank: nothing of the
// problem's type.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "engine/detail/incumbent.hpp"
#include "engine/statistics.hpp"
#include "engine/wire.hpp"

namespace kusabi::engine {

/// The nodes, the solutions and the reports of one rank. The protocol calls it a few times in each
/// step, never once a node.
class LocalSearch {
 public:
  LocalSearch() = default;
  LocalSearch(const LocalSearch&) = delete;
  LocalSearch& operator=(const LocalSearch&) = delete;
  virtual ~LocalSearch() = default;

  // ---- nodes
  virtual void plant() = 0;
  virtual void open_nodes(unsigned count) = 0;
  [[nodiscard]] virtual bool has_nodes() const = 0;
  /// Whether this is called from inside an expansion, and
  [[nodiscard]] virtual bool expanding() const = 0;
  /// whether from one that nothing may change from outside.
  [[nodiscard]] virtual bool checking() const = 0;
  /// Nodes waiting, and their least bound.
  [[nodiscard]] virtual std::uint64_t open() const = 0;
  [[nodiscard]] virtual double bound() const = 0;
  /// Share of the tree that is done here.
  [[nodiscard]] virtual double closed() const = 0;
  [[nodiscard]] virtual RankStatistics& statistics() = 0;

  // ---- nodes given and taken
  struct Gift {
    Bytes body;
    std::uint64_t nodes = 0;
  };
  [[nodiscard]] virtual bool can_give() const = 0;
  /// @param limit in bytes, unless one node alone has more @pre can_give()
  virtual Gift give(std::size_t limit) = 0;
  /// @return how many nodes there were
  virtual std::uint64_t take(const Bytes& gift) = 0;

  // ---- solutions
  [[nodiscard]] virtual std::uint64_t found() const = 0;
  [[nodiscard]] virtual const Incumbent& incumbent() const = 0;
  /// Whether the incumbent was improved here since the last call.
  [[nodiscard]] virtual bool just_improved() = 0;
  /// @return whether the news are better than what is known here
  virtual bool learn(const Incumbent& news) = 0;

  // ---- checkpoints
  /// What the compiler calls the types of nodes and solutions.
  [[nodiscard]] virtual std::string node_type() const = 0;
  [[nodiscard]] virtual std::string solution_type() const = 0;
  /// All that is needed to go on, and what one more rank left.
  [[nodiscard]] virtual Bytes state() = 0;
  virtual void restore(const Bytes& state) = 0;
  /// Nodes opened in the runs that this one goes on from, as far as they are known here, and their
  /// mark sum.
  struct Before {
    std::uint64_t opened = 0;
    std::uint64_t fingerprint = 0;
  };
  [[nodiscard]] virtual Before before() const = 0;

  // ---- the report to rank 0
  /// Sends the solutions and what else there is in pieces of at most `limit` bytes (unless one
  /// solution alone has more).
  virtual void report(std::size_t limit, const std::function<void(Bytes)>& send) = 0;
  /// Takes a piece. @return whether it was the last of that rank
  virtual bool receive_report(int from, const Bytes& piece) = 0;
};

}  // namespace kusabi::engine
