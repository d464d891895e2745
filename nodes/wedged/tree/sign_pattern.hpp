// The tree of sign patterns: Algorithm 5.1 of the wedged paper, or 5.8.
//
// A node is a pair (U, R) of disjoint sets of the contact candidates of one block: those held in
// contact, u_n = 0, and those held separated, r = 0. Its bound is the cone program of
// solvers/conic, whose optimal value t* tells whether a wedged configuration can exist below the
// node:
//
//   t* < 0   none can: the node is dead;
//   t* > 0   the relaxation is alive: a leaf is a pattern, any other node is branched;
//   t* = 0   (within the tolerance) a tie: there are configurations, but in all of them some
//            inequalities are equalities. Those in the relative interior say which. If a candidate
//            of U is never loaded, the configurations are also below the node that has it in R
//            instead, and this one is closed. If no candidate is left with both a reaction and a
//            gap, all configurations of the node are those of one cone D(Y) of (14), a flat one,
//            and it is closed: found once, however many sign patterns name it. Otherwise it is
//            branched at such a candidate.
//
// Should rounding leave the sign of a leaf or the zeros of a tie open, the leaf is reported as
// undecided or marginal: neither counted as a pattern nor thrown away.
//
// A structure that comes apart has a tree a block, all below one root.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/counts.hpp"
#include "engine/expansion.hpp"
#include "nodes/wedged/tree/branching.hpp"
#include "nodes/wedged/tree/candidate_bounds.hpp"
#include "nodes/wedged/tree/contact_solver.hpp"
#include "nodes/wedged/tree/facets.hpp"
#include "nodes/wedged/tree/mean_motion.hpp"
#include "nodes/wedged/tree/pollable.hpp"
#include "problems/wedged/problem_block.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "support/index_set.hpp"

namespace kusabi::wedged {

/// What is asked of each candidate.
struct SignPattern {
  support::IndexSet contact;    ///< U: u_n = 0
  support::IndexSet separated;  ///< R: r = 0
  support::IndexSet at_rest;    ///< both, throughout a flat cone; empty at the nodes of a tree

  friend bool operator==(const SignPattern&, const SignPattern&) = default;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& contact& separated& at_rest;
  }
};

/// A node of a tree of sign patterns.
struct PatternNode {
  /// The root of a structure in several blocks, whose children are the roots of these.
  static constexpr std::uint32_t all_blocks = UINT32_MAX;

  std::uint32_t block = 0;
  SignPattern pattern;  ///< of the block's own candidates, from 0 on

  friend bool operator==(const PatternNode&, const PatternNode&) = default;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& block& pattern;
  }
};

/// What is known of a leaf that is not dead.
enum class LeafState {
  alive,      ///< t* is above the tolerance: a solid cone
  flat,       ///< t* = 0, and it is known what is zero: a flat cone
  marginal,   ///< |t*| is within the tolerance, but what is zero cannot be told
  undecided,  ///< neither is proved
};

/// A leaf of the tree that is not dead, with a configuration that shows it.
struct Configuration {
  std::uint32_t block = 0;
  SignPattern pattern;  ///< of the whole problem's candidates
  LeafState state = LeafState::alive;
  double lower = 0;                  ///< lower <= t* <= upper, in scaled units (see ContactSolver);
  double upper = 0;                  ///< `lower` is the value of the configuration below
  std::vector<double> reaction;      ///< r of the block, force; sum of its normal parts 1
  std::vector<double> displacement;  ///< u = K^-1 r of the block, length

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& block& pattern& state& lower& upper& reaction& displacement;
  }
};

/// The leaf of the block's own tree whose cone a configuration's is: candidates at rest may be
/// called separated.
/// @param block its candidates, as the whole problem numbers them
SignPattern own_leaf(const Configuration& found, const support::IndexSet& block);

/// A leaf that polyhedral friction cones let live: one of Y_1, ..., Y_k of Algorithm 5.8, and what
/// its step 2 says of it.
struct PolyhedralCandidate {
  std::uint32_t block = 0;
  SignPattern pattern;    ///< of the whole problem's candidates
  double polyhedral = 0;  ///< t of their program, of which the sign counts
  double lower = 0;       ///< lower <= t* <= upper of (23); minus infinity where only the sign
  double upper = 0;       ///< of t* was wanted

  /// t* < 0: no configuration of (WP) has this pattern.
  [[nodiscard]] bool discarded() const { return upper < 0; }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& block& pattern& polyhedral& lower& upper;
  }
};

/// Why a node was closed: what a certificate says of it (docs/certificates.md).
struct Evidence {
  enum class Kind {
    dead,   ///< numbers: the multipliers that prove it, one a candidate of the block
    alive,  ///< a leaf; numbers: the tangential reactions of the candidates in U. Of loose bodies
            ///< both go on with the mean motion of w, of u (mean_motion.hpp)
    cut,    ///< dead with cuts; numbers: as of dead, then one for the cut of each candidate
    marginal,  ///< flat, marginal or undecided: nothing is claimed; no numbers
  };
  Kind kind = Kind::marginal;
  std::uint32_t block = 0;
  SignPattern node;                 ///< of the whole problem's candidates
  std::span<const double> numbers;  ///< valid during the call
};

/// Told of every node that is closed.
using Witness = std::function<void(const Evidence&)>;

/// Whether an exact test accepts what is said of a node that is to be closed; of one of which
/// nothing is claimed, whether it has nothing that others do not have.
using Judge = std::function<bool(const Evidence&)>;

/// What became of the nodes that were opened, and what it cost.
struct SignPatternTally : engine::Counts<SignPatternTally> {
  std::uint64_t branched = 0;    ///< had both children put into the tree
  std::uint64_t dead = 0;        ///< pruned: no wedged configuration below
  std::uint64_t found = 0;       ///< leaves that are alive
  std::uint64_t flat = 0;        ///< nodes closed as flat cones, maximal or not
  std::uint64_t faces = 0;       ///< ties closed: another node has all of their solutions
  std::uint64_t marginal = 0;    ///< leaves that are marginal
  std::uint64_t undecided = 0;   ///< leaves that are undecided
  std::uint64_t doubtful = 0;    ///< nodes branched although they are marginal or undecided
  std::uint64_t climbed = 0;     ///< nodes that took more digits than a double has
  std::uint64_t probed = 0;      ///< children that were solved to choose which to split into
  std::uint64_t iterations = 0;  ///< interior-point iterations, over all nodes
  std::uint64_t candidates = 0;  ///< leaves to test of Algorithm 5.8
  std::vector<PolyhedralCandidate> tested;  ///< these; no count, and so not among the fields
  std::uint64_t proved = 0;                 ///< leaves whose life an exact test has accepted
  std::uint64_t refused = 0;                ///< claims that it has not
  std::uint64_t doubted = 0;                ///< nodes closed as dead although it refuses why
  std::uint64_t unproved = 0;  ///< closed nodes of which nothing is claimed, and no test proves it

  SignPatternTally& operator+=(const SignPatternTally& other) {
    Counts::operator+=(other);
    proved += other.proved;
    refused += other.refused;
    doubted += other.doubted;
    unproved += other.unproved;
    tested.insert(tested.end(), other.tested.begin(), other.tested.end());
    return *this;
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned version) {
    Counts::serialize(archive, version);
    archive& tested& proved& refused& doubted& unproved;
  }

  static constexpr auto fields() {
    return std::tuple{field("branched", &SignPatternTally::branched),
                      field("dead", &SignPatternTally::dead),
                      field("found", &SignPatternTally::found),
                      field("flat_nodes", &SignPatternTally::flat),
                      field("faces", &SignPatternTally::faces),
                      field("marginal_leaves", &SignPatternTally::marginal),
                      field("undecided_leaves", &SignPatternTally::undecided),
                      field("doubtful_branched", &SignPatternTally::doubtful),
                      field("climbed", &SignPatternTally::climbed),
                      field("probed", &SignPatternTally::probed),
                      field("iterations", &SignPatternTally::iterations),
                      field("candidates", &SignPatternTally::candidates)};
  }
};

/// Whether the candidates are bounded before the tree is searched (candidate_bounds.hpp).
enum class Tightening {
  automatic,  ///< where the tree is large: find_patterns looks at it
  never,
  always,  ///< by the cones themselves, that is
};

/// How the tree is searched. Whatever is chosen, the patterns are the same.
struct SignPatternOptions {
  conic::Tolerances tolerances;
  Branching branching = Branching::automatic;     ///< without a trial: find_patterns makes one
  Tightening tightening = Tightening::automatic;  ///< likewise
  /// Of how many candidates, the best by the rule of branching, both children are solved before a
  /// node is split: by one of which a child is dead, or else by the one whose children have least
  /// left. 0: none, the rule decides. Of polyhedral cones none are.
  int probes = 0;
  /// 0: a node is bounded with the friction cones themselves (Algorithm 5.1). Otherwise, in space,
  /// with polyhedral cones of so many facets around them, and each leaf that these let live is put
  /// to the test of the cones (Algorithm 5.8).
  int facets = 0;
  /// Whether ties that have nothing of their own are searched all the same: then each sign pattern
  /// below them is decided by itself, which a certificate needs. Up to 2^k times as many nodes
  /// where k candidates stay at rest.
  bool thorough = false;
  Precision precision = Precision::escalating;
};

/// The problem type that engine::search searches.
class SignPatternTree {
 public:
  using Node = PatternNode;
  using Solution = Configuration;
  using Tally = SignPatternTally;

  /// Contact leaves less to search than separation: a quarter to a third of a subtree is below it,
  /// weighted by size, on space trusses of 20 to 40 candidates (docs/theory/wedged.md).
  static constexpr double work_of_first_child = 1.0 / 3;

  /// @param friction mu of each contact candidate, m numbers >= 0
  /// @throws std::invalid_argument if the sizes do not fit or a number is out of range
  SignPatternTree(const problems::WedgedProblem& problem, std::span<const double> friction,
                  SignPatternOptions options = {});

  /// From now on the nodes of this block are split by another rule.
  void split_by(std::size_t block, Branching branching) { blocks_[block].rule.set(branching); }

  /// From now on the nodes of this block know these bounds of its candidates.
  void tighten(std::size_t block, std::vector<CandidateBounds> bounds);

  Node root() const { return {.block = blocks_.size() == 1 ? 0 : Node::all_blocks, .pattern = {}}; }
  void expand(Node&& node, engine::Expansion<SignPatternTree>& out);
  Tally tally() const { return tally_; }

  /// For engine::Order::best_first, which is breadth-first by these (Remark 5.2): how many
  /// candidates have a sign in a leaf, and so at most how many above it.
  [[nodiscard]] double objective(const Solution& leaf) const;
  [[nodiscard]] double bound(const Node& node) const;

  /// What becomes of a node: it is dead (neither), branched, or a leaf that is not dead.
  struct Fate {
    std::vector<Node> children;
    std::optional<Configuration> leaf;
  };

  /// Opens a node, for `expand` and for trees that make something else of the leaves.
  /// @throws support::Stopped soon after an end is asked for
  Fate decide(const Node& node);

  /// The same within an expansion of another tree: nothing if the search is about to end and the
  /// node was put back.
  template <class Tree>
  std::optional<Fate> decide(const Node& node, engine::Expansion<Tree>& out) {
    return pollable_.within(out, node, [&] { return decide(node); });
  }

  /// From now on decide() ends when this is asked for, outside of expansions.
  void end_when(support::Stop stop) { pollable_.end_when(std::move(stop)); }

  /// From now on `witness` is told why nodes are closed. A branched node is not closed.
  void report_to(Witness witness) { witness_ = std::move(witness); }

  /// From now on what is said of a node is put to this test, and what it refuses is counted.
  /// @param binding whether it is not said then: a node is branched that few candidates are free
  /// at, a leaf is undecided
  void judge_by(Judge judge, bool binding) {
    judge_ = std::move(judge);
    binding_ = binding;
  }

 private:
  // What it takes to bound the nodes of one block.
  struct Block {
    /// @param problem of the block alone  @param within_whole its candidates in the whole
    Block(const problems::WedgedProblem& problem, support::IndexSet within_whole,
          std::span<const double> friction, const SignPatternOptions& options);

    [[nodiscard]] support::IndexSet free(const SignPattern& node) const {
      return all - (node.contact | node.separated);
    }

    support::IndexSet candidates;  // as the whole problem numbers them
    support::IndexSet all;         // the same as the block does
    BranchingRule rule;
    ContactSolver solver;
    MeanMotion mean_motion;
    std::vector<CandidateBounds> bounds;  // empty: no cuts
    std::optional<FacetBound> outer;      // of Algorithm 5.8
  };

  // What bounds say of a node that is no leaf; nothing if the program without cuts must be asked.
  std::optional<Fate> decide_with_cuts(const Node& node);
  Fate decide_doubt(const Node& node, const conic::ConicResult& answer);
  void note_tested(const Node& leaf, double polyhedral, const conic::ConicResult& answer);
  Fate branch(const Node& node, const support::IndexSet& open);
  Fate branch_living(const Node& node);
  int probed(const Node& node, std::span<const int> tried);
  conic::ConicResult probe(const Node& child);
  Fate split(const Node& node, int candidate);
  Fate prune(const Node& node, const Eigen::VectorXd& multipliers);
  std::optional<Fate> prune_with(std::span<const conic::Cut> cuts, const Node& node);
  std::optional<Fate> prune_by_bounds(const Node& node);
  bool closes(const Node& node, Evidence::Kind kind, std::span<const double> numbers);
  Fate doubt(const Node& node);
  Fate close(const Node& node, Configuration leaf);
  [[nodiscard]] Configuration configuration(const Node& node, LeafState state,
                                            const conic::ConicResult& answer) const;
  [[nodiscard]] std::vector<double> evidence_of(const Node& node, const Configuration& leaf) const;
  void report_open(const Node& node);

  conic::Tolerances tolerances_;
  int probes_;
  bool thorough_;
  Pollable pollable_;
  std::vector<Block> blocks_;
  Tally tally_;
  Witness witness_;
  Judge judge_;
  bool binding_ = false;
};

}  // namespace kusabi::wedged
