// Opening of nodes in the tree of losses, at a target of the load factor: is there a loss of up to
// K members after which the factor is below the target?
//
// A carrying stress state is in equilibrium at a factor not below the target, within the yield
// forces. A loss without any member of its support leaves that state, and so at least the target;
// hence a loss below the target has a member of the support of every state. A node has some members
// lost, some kept, and a number of further losses. Of the states without lost members it needs
// - one whose support is kept, or more disjoint supports than further losses: the node is closed;
// - otherwise it branches on the members of one support, each kept in the branches after its own.
// With one further loss, the members of all supports are tried one by one; branches share them if
// the loss is the only one.
// If there is no state without the lost members, the loss is a suspect.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include "nodes/limit/loss/loss_programs.hpp"
#include "nodes/limit/loss/loss_proof.hpp"
#include "support/index_set.hpp"

namespace kusabi::limit {

struct LossNode {
  support::IndexSet lost;
  support::IndexSet kept;  ///< not lost below this node
  std::int32_t left = 0;   ///< number of further losses
  /// Of one further loss: the members that may be lost below this node; empty: all.
  support::IndexSet share{};

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& lost& kept& left& share;
  }
};

/// Result of opening a node and some nodes below it.
struct LossPiece {
  std::vector<ProvedState> states;  ///< found here
  std::vector<LossNode> open;       ///< nodes that are left, in depth-first order
  /// A loss for which no state was found; its node is the first of `open`.
  support::IndexSet suspect;
  bool has_suspect = false;
  std::uint64_t nodes = 0;
  std::uint64_t programs = 0;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& states& open& has_suspect& suspect& nodes& programs;
  }
};

/// Knowledge of all losses; the same on every rank.
struct LossKnowledge {
  double target = 0;                         ///< in the unit of the load factor
  std::vector<support::IndexSet> supports;   ///< of states that carry the target
  std::vector<support::IndexSet> undecided;  ///< losses without a state, and none lower either
};

class LossOpener {
 public:
  /// Maximum number of nodes in a piece.
  static constexpr std::uint64_t nodes_of_a_piece = 400;

  /// @pre all but `stop` outlive this object
  LossOpener(StateProgram& program, const LossProof& proof, double factor_unit,
             const LossKnowledge& known, support::Stop stop)
      : program_(program),
        proof_(proof),
        factor_unit_(factor_unit),
        known_(known),
        stop_(std::move(stop)) {}

  /// Opens nodes in depth-first order from this one on, until a suspect is found or the piece is
  /// large. The result depends on the node, on `known` and on `most` alone, unless the search is
  /// stopped. @param most maximum number of nodes, at most nodes_of_a_piece
  LossPiece open(const LossNode& node, std::uint64_t most);

 private:
  struct Opening;
  enum class Found { state, none, undecided };

  bool open_one(const LossNode& node);
  Found find_state(Opening& here, const support::IndexSet& lost, const support::IndexSet& avoided);
  bool finish_last(Opening& here);
  void share(const LossNode& node, const support::IndexSet& members);
  bool pack(Opening& here);
  void branch(const Opening& here);

  StateProgram& program_;
  const LossProof& proof_;
  double factor_unit_;
  const LossKnowledge& known_;
  support::Stop stop_;
  LossPiece piece_;
  std::vector<LossNode> stack_;
};

}  // namespace kusabi::limit
