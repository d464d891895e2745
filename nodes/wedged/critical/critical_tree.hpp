// The global minimum of the critical friction coefficient, by one best-first search.
//
// The tree is that of the sign patterns, of all blocks. A node is bounded by the smallest
// coefficient at which its relaxation lives, which no pattern below it can undercut; a leaf has its
// own critical coefficient, bracketed on the grid. The best leaf prunes: also what can at best
// begin in the same cell of the grid, since the bracket is all that is asked for. (Which other
// patterns begin to live in it is found at its upper end, by the tree of sign patterns, if that is
// asked for.) No coefficient to
// start from is needed, and what is opened is about what a proof that nothing lives below the
// answer needs anyway.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

#include "engine/counts.hpp"
#include "engine/expansion.hpp"
#include "nodes/wedged/friction/critical_friction.hpp"
#include "nodes/wedged/tree/sign_pattern.hpp"

namespace kusabi::wedged {

/// Where a node is looked at.
enum class CriticalDirection {
  /// From no friction on, as far as it is proved dead: several programs a node, for a best-first
  /// search, whose nodes' least is a bound of what is looked for.
  up,
  /// At the lower end of the best bracket so far: one program a node, for a depth-first search,
  /// which soon comes upon leaves.
  down,
};

/// The problem type that engine::search searches, with Goal::best.
class CriticalTree {
 public:
  struct Node {
    PatternNode place;
    double bound = 0;  ///< dead below

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& place& bound;
    }
  };

  struct Solution {
    CriticalCell cell;
    PatternNode leaf;  ///< which is feasible at the upper end of the cell

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& cell& leaf;
    }
  };

  struct Tally : engine::Counts<Tally> {
    std::uint64_t branched = 0;
    std::uint64_t dead = 0;      ///< proved dead up to where nothing is of interest any more
    std::uint64_t leaves = 0;    ///< patterns whose critical coefficient was found
    std::uint64_t doubtful = 0;  ///< leaves whose cell is wider than the width, or open above
    /// The least coefficient from which on a doubtful leaf is not known to be dead.
    engine::Least doubt;
    std::uint64_t programs = 0;  ///< cone programs solved

    static constexpr auto fields() {
      return std::tuple{field("branched", &Tally::branched), field("dead", &Tally::dead),
                        field("leaves", &Tally::leaves),     field("doubtful", &Tally::doubtful),
                        field("doubt", &Tally::doubt),       field("programs", &Tally::programs)};
    }
  };

  /// @param width of the bracket  @param most no coefficient above most x width is of interest
  /// @param known nothing wedges below
  CriticalTree(const problems::WedgedProblem& problem, double width, std::int64_t most,
               CriticalDirection direction = CriticalDirection::up, double known = 0,
               Precision precision = Precision::escalating);

  /// From now on the nodes of this block are split by another rule.
  void split_by(std::size_t block, Branching branching) { blocks_[block].rule.set(branching); }

  /// From now on the nodes of this block know bounds that hold at all coefficients of interest.
  /// @pre CriticalDirection::down
  void tighten(std::size_t block, std::vector<CandidateBounds> bounds) {
    blocks_[block].critical.tighten(std::move(bounds));
  }

  [[nodiscard]] Node root() const;
  void expand(Node&& node, engine::Expansion<CriticalTree>& out);
  [[nodiscard]] double objective(const Solution& solution) const {
    return grid_.at(solution.cell.alive);
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
  /// Below what coefficient the node is dead, if it is worth branching.
  std::optional<double> worth(Block& block, const Node& node, double cutoff) const;
  void split(const Node& node, int candidate, engine::Expansion<CriticalTree>& out);
  void close_leaf(const Node& node, engine::Expansion<CriticalTree>& out);

  FrictionGrid grid_;
  std::int64_t most_;
  CriticalDirection direction_;
  double known_;
  Pollable pollable_;
  std::vector<Block> blocks_;
  Tally tally_;
};

}  // namespace kusabi::wedged
