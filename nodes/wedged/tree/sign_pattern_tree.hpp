// Tree of sign patterns: Algorithm 5.1 of the wedged paper, or 5.8.
//
// A node is a pair (U, R) of disjoint sets of the contact candidates of one block: those fixed in
// contact, u_n = 0, and those fixed separated, r = 0. Its bound is the cone program of
// solvers/conic, whose optimal value t* decides whether a wedged configuration can exist below the
// node:
//
//   t* < 0   none can: the node is infeasible;
//   t* > 0   the relaxation is feasible: a leaf is a pattern, any other node is branched;
//   t* = 0   (within the tolerance) a degenerate node: there are configurations, but in all of
//            them some inequalities are equalities, which those in the relative interior
//            determine. If some candidate of U never has a reaction, the configurations are also
//            below the node that has it in R instead, and this one is closed. If no candidate is
//            left with both a reaction and a gap, all configurations of the node are those of one
//            cone D(Y) of (14), a flat one, and it is closed: found once, under any of its sign
//            patterns. Otherwise it is branched at such a candidate.
//
// If rounding leaves the sign of a leaf or the zeros of a degenerate node undecided, the leaf is
// reported as undecided or marginal: it neither counts as a pattern nor is it discarded.
//
// A structure with decoupled blocks has a tree for each block, all below one root.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/expansion.hpp"
#include "engine/path.hpp"
#include "engine/search_declaration.hpp"
#include "nodes/wedged/relaxation/block_relaxation.hpp"
#include "nodes/wedged/relaxation/pattern_options.hpp"
#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "nodes/wedged/tree/evidence.hpp"
#include "nodes/wedged/tree/node_interruption.hpp"
#include "nodes/wedged/tree/pattern_tally.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Problem type of engine::search.
class SignPatternTree {
 public:
  using Node = PatternNode;
  using Solution = Configuration;
  using Tally = SignPatternTally;

  /// Contact leaves a smaller subtree than separation: a quarter to a third of the size on space
  /// trusses of 20 to 40 candidates (docs/theory/wedged.md).
  static constexpr double work_of_first_child = 1.0 / 3;

  /// @param friction mu of each contact candidate, m numbers >= 0
  /// @throws std::invalid_argument if the sizes do not fit or a number is out of range
  SignPatternTree(const problems::WedgedProblem& problem, std::span<const double> friction,
                  SignPatternOptions options = {});

  /// Sets the branching rule of a block.
  void split_by(std::size_t block, Branching branching) { blocks_[block].rule.set(branching); }

  /// Sets bounds of a block's candidates.
  void tighten(std::size_t block, std::vector<CandidateBounds> bounds);

  Node root() const { return {.block = blocks_.size() == 1 ? 0 : Node::all_blocks, .pattern = {}}; }
  void expand(Node&& node, engine::Expansion<SignPatternTree>& out);
  /// Passes a feasible leaf to the recorder of `keep_found`, if there is one.
  bool emit(const engine::Path& path, Solution& leaf);
  Tally tally() const { return tally_; }

  /// Objective of engine::Order::best_first, which is breadth-first with it (Remark 5.2): the
  /// number of candidates with a sign in a leaf, which bounds that of the nodes above it.
  [[nodiscard]] double objective(const Solution& leaf) const;
  [[nodiscard]] double bound(const Node& node) const;

  /// Result of a node: infeasible (neither), branched, or a leaf that is not infeasible.
  struct NodeResult {
    std::vector<Node> children;
    std::optional<Configuration> leaf;
  };

  /// Opens a node, for `expand` and for other trees on the same nodes.
  /// @throws support::Stopped soon after the run is to stop
  NodeResult decide(const Node& node);

  /// The same within an expansion of another tree: nothing if the search is about to end and the
  /// node was put back.
  template <class Tree>
  std::optional<NodeResult> decide(const Node& node, engine::Expansion<Tree>& out) {
    return interruption_.within(out, node, [&] { return decide(node); });
  }

  /// Sets the stop condition of decide() outside of expansions.
  void end_when(support::Stop stop) { interruption_.end_when(std::move(stop)); }

  /// Sets the recorder of evidence of closed nodes. Branched nodes are not closed.
  void report_to(EvidenceRecorder recorder) { evidence_.report_to(std::move(recorder)); }

  /// Sets the recorder of feasible leaves, which are then counted, but are not in the outcome.
  void keep_found(LeafRecorder recorder) { keep_ = std::move(recorder); }

  /// Sets the exact test of evidence; refused claims are counted.
  /// @param binding true: refused claims are not used; a node with few free candidates is then
  /// branched, a leaf is undecided
  void test_with(ExactNodeTest test, bool binding) {
    evidence_.test_with(std::move(test), binding);
  }

 private:
  // Decision by bounds at a node that is not a leaf; nothing if the program without cuts is
  // required.
  std::optional<NodeResult> decide_with_cuts(const Node& node);
  NodeResult decide_undecided(const Node& node, const conic::ConicResult& answer);
  void note_tested(const Node& leaf, double polyhedral, const conic::ConicResult& answer);
  NodeResult branch(const Node& node, const support::IndexSet& undecided);
  NodeResult branch_feasible(const Node& node);
  int probed(const Node& node, std::span<const int> tried);
  conic::ConicResult probe(const Node& child);
  NodeResult split(const Node& node, int candidate);
  NodeResult prune(const Node& node, const Eigen::VectorXd& multipliers);
  std::optional<NodeResult> prune_by_cuts(
      const Node& node, const std::function<std::vector<double>(const BlockRelaxation&)>& numbers);
  bool closes(const Node& node, Evidence::Kind kind, std::span<const double> numbers);
  NodeResult branch_unproved(const Node& node);
  NodeResult close(const Node& node, Configuration leaf);
  void record_unclaimed(const Node& node);

  conic::Tolerances tolerances_;
  int probes_;
  bool thorough_;
  NodeInterruption interruption_;
  std::vector<BlockRelaxation> blocks_;
  EvidenceGate evidence_;
  LeafRecorder keep_;
  Tally tally_;
};

}  // namespace kusabi::wedged

extern template kusabi::engine::OutcomeOf<kusabi::wedged::SignPatternTree> kusabi::engine::search(
    kusabi::wedged::SignPatternTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
