// Tree of losses of members, at a target of the load factor: is there a loss of up to K members
// after which the factor is below the target?
//
// A carrying stress state is in equilibrium at a factor not below the target, within the yield
// forces. A loss without any member of its support leaves that state, and so at least the target;
// hence a loss below the target has a member of the support of every state. A node has some members
// lost, some kept, and a number of further losses. It looks for states without the lost members:
// - none: the loss is a solution;
// - one whose support is kept, or more disjoint supports than further losses: the node is closed;
// - otherwise it branches on the members of one support, each kept in the branches after its own.
//
// The opening of a node depends on the node, the target and the pool, and not on an incumbent: the
// first solution in depth-first order is the same on any number of ranks.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <boost/serialization/vector.hpp>

#include "engine/expansion.hpp"
#include "nodes/limit/loss/loss_programs.hpp"
#include "nodes/limit/loss/loss_proof.hpp"
#include "support/index_set.hpp"

namespace kusabi::limit {

/// Question of one search for losses.
struct LossTarget {
  int most = 1;                ///< K
  double factor = 0;           ///< target, in the unit of the load factor
  support::IndexSet eligible;  ///< members that may be lost
};

/// Problem type of engine::search, for Goal::first.
class LossTree {
 public:
  struct Node {
    support::IndexSet lost;
    support::IndexSet kept;  ///< not lost below this node
    std::int32_t left = 0;   ///< number of further losses
    /// Supports of the states of the path, without lost members.
    std::vector<support::IndexSet> supports;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& lost& kept& left& supports;
    }
  };

  /// A loss after which no state was found.
  struct Solution {
    support::IndexSet lost;
    std::vector<support::IndexSet> supports;  ///< known at its node, for a pool

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& lost& supports;
    }
  };

  struct Tally {
    std::uint64_t programs = 0;
    std::uint64_t states = 0;
    /// Nodes left with a state that is not proved, or with a program that failed.
    std::uint64_t undecided = 0;

    Tally& operator+=(const Tally& other);
    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& programs& states& undecided;
    }
  };

  /// @param pool supports of states that carry the target
  /// @param stop ends the opening of a node, which stays open
  /// All arguments must outlive the tree.
  LossTree(const problems::LimitModel& model, LossProof& proof, const LossTarget& target,
           const std::vector<support::IndexSet>& pool, support::Stop stop = {});

  /// A copy has solvers of its own, and no counts.
  LossTree(const LossTree& other)
      : LossTree(other.model_, other.proof_, other.target_, other.pool_, other.stop_) {}
  LossTree& operator=(const LossTree&) = delete;
  ~LossTree() = default;

  Node root() const;
  void expand(Node&& node, engine::Expansion<LossTree>& out);
  [[nodiscard]] Tally tally() const { return tally_; }

  /// Opens a node outside of a search: the supports of the states found there.
  std::vector<support::IndexSet> supports_at(const Node& node);

 private:
  struct Opening;

  void open(Opening& here);
  void finish_last(Opening& here);
  void pack(Opening& here);
  bool find_state(Opening& here, const support::IndexSet& lost, const support::IndexSet& avoided);
  void report(Opening& here, const support::IndexSet& lost);
  std::optional<support::IndexSet> proved_support(const Node& node, const support::IndexSet& lost,
                                                  const CarryingState& state);

  const problems::LimitModel& model_;
  LossProof& proof_;
  const LossTarget& target_;
  const std::vector<support::IndexSet>& pool_;
  support::Stop stop_;
  StateProgram program_;
  RemainingFactor remaining_;
  Tally tally_;
};

}  // namespace kusabi::limit
