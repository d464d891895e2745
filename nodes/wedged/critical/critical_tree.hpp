// Global minimum of the critical friction coefficient by one best-first search.
//
// The tree is that of the sign patterns of all blocks. The bound of a node is the smallest
// coefficient at which its relaxation is feasible, which is a lower bound for all patterns below
// it; a leaf has its own critical coefficient, bracketed on the grid. The best leaf also prunes
// nodes that can at best become feasible in the same cell of the grid, since only the bracket is
// required. (The tree of sign patterns at its upper bound finds other patterns in the cell on
// request.) The search needs no initial coefficient and opens about as many nodes as a proof of
// infeasibility below the answer.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

#include "engine/counts.hpp"
#include "engine/expansion.hpp"
#include "engine/search_declaration.hpp"
#include "nodes/wedged/friction/critical_friction.hpp"
#include "nodes/wedged/relaxation/branching.hpp"
#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "nodes/wedged/tree/node_interruption.hpp"

namespace kusabi::wedged {

/// Coefficients at which a node is solved.
enum class CriticalDirection {
  /// From zero friction up to the largest coefficient at which it is proved infeasible: several
  /// programs for each node, for best-first search, where the minimum over open nodes is a lower
  /// bound.
  up,
  /// At the lower bound of the best bracket so far: one program for each node, for depth-first
  /// search, which finds leaves early.
  down,
};

/// Problem type of engine::search, with Goal::best.
class CriticalTree {
 public:
  struct Node {
    PatternNode place;
    double bound = 0;  ///< infeasible below

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& place& bound;
    }
  };

  struct Solution {
    CriticalCell cell;
    PatternNode leaf;  ///< feasible at the upper bound of the cell

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& cell& leaf;
    }
  };

  struct Tally : engine::Counts<Tally> {
    std::uint64_t branched = 0;
    std::uint64_t infeasible = 0;  ///< proved infeasible up to the upper limit
    std::uint64_t leaves = 0;      ///< patterns with a bracketed critical coefficient
    /// Leaves with a cell wider than the width or without upper bound.
    std::uint64_t undecided = 0;
    /// The least coefficient from which on an undecided leaf is not known to be infeasible.
    engine::Least undecided_from;
    std::uint64_t programs = 0;  ///< cone programs solved

    static constexpr auto fields() {
      return std::tuple{field("branched", &Tally::branched),
                        field("infeasible", &Tally::infeasible),
                        field("leaves", &Tally::leaves),
                        field("undecided", &Tally::undecided),
                        field("undecided_from", &Tally::undecided_from),
                        field("programs", &Tally::programs)};
    }
  };

  /// @param width of the bracket  @param maximum upper limit of the search, x width
  /// @param known no configuration is wedged below
  CriticalTree(const problems::WedgedProblem& problem, double width, std::int64_t maximum,
               CriticalDirection direction = CriticalDirection::up, double known = 0,
               Precision precision = Precision::escalating);

  /// Sets the branching rule of a block.
  void split_by(std::size_t block, Branching branching) { blocks_[block].rule.set(branching); }

  /// Sets bounds of a block's candidates, valid at all coefficients of the search.
  /// @pre CriticalDirection::down
  void tighten(std::size_t block, std::vector<CandidateBounds> bounds) {
    blocks_[block].critical.tighten(std::move(bounds));
  }

  [[nodiscard]] Node root() const;
  void expand(Node&& node, engine::Expansion<CriticalTree>& out);
  [[nodiscard]] double objective(const Solution& solution) const {
    return grid_.at(solution.cell.feasible);
  }
  [[nodiscard]] double bound(const Node& node) const { return node.bound; }
  [[nodiscard]] Tally tally() const;

 private:
  struct Block {
    Block(const problems::WedgedProblem& problem, double width, Precision precision);

    CriticalFriction critical;
    support::IndexSet candidates;
    BranchingRule rule;
  };

  void open(const Node& node, engine::Expansion<CriticalTree>& out);
  /// The coefficient below which the node is infeasible; nothing if it is not worth branching.
  std::optional<double> bound_of(Block& block, const Node& node, double cutoff) const;
  void split(const Node& node, int candidate, engine::Expansion<CriticalTree>& out);
  void close_leaf(const Node& node, engine::Expansion<CriticalTree>& out);

  FrictionGrid grid_;
  std::int64_t maximum_;
  CriticalDirection direction_;
  double known_;
  NodeInterruption interruption_;
  std::vector<Block> blocks_;
  Tally tally_;
};

}  // namespace kusabi::wedged

extern template kusabi::engine::OutcomeOf<kusabi::wedged::CriticalTree> kusabi::engine::search(
    kusabi::wedged::CriticalTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
