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

/// State of each candidate.
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
  /// The root of a structure with several blocks, whose children are the roots of these.
  static constexpr std::uint32_t all_blocks = UINT32_MAX;

  std::uint32_t block = 0;
  SignPattern pattern;  ///< of the block's own candidates, from 0 on

  friend bool operator==(const PatternNode&, const PatternNode&) = default;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& block& pattern;
  }
};

/// State of a leaf that is not infeasible.
enum class LeafState {
  alive,      ///< t* is above the tolerance: a solid cone
  flat,       ///< t* = 0 with known zeros: a flat cone
  marginal,   ///< |t*| is within the tolerance, and the zeros are numerically undecided
  undecided,  ///< neither feasibility nor infeasibility is proved
};

/// A leaf of the tree that is not infeasible, with a configuration.
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

/// The leaf of the block's own tree that contains the configuration; inactive candidates may count
/// as separated.
/// @param block its candidates, as the whole problem numbers them
SignPattern own_leaf(const Configuration& found, const support::IndexSet& block);

/// A leaf feasible with polyhedral friction cones: one of Y_1, ..., Y_k of Algorithm 5.8, with the
/// result of its step 2.
struct PolyhedralCandidate {
  std::uint32_t block = 0;
  SignPattern pattern;    ///< of the whole problem's candidates
  double polyhedral = 0;  ///< t of their program, of which only the sign is used
  double lower = 0;       ///< lower <= t* <= upper of (23); minus infinity if only the sign
  double upper = 0;       ///< of t* was requested

  /// t* < 0: no configuration of (WP) has this pattern.
  [[nodiscard]] bool discarded() const { return upper < 0; }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& block& pattern& polyhedral& lower& upper;
  }
};

/// Evidence of a closed node for a certificate (docs/certificates.md).
struct Evidence {
  enum class Kind {
    dead,   ///< numbers: the multipliers of the proof, one for each candidate of the block
    alive,  ///< a leaf; numbers: the tangential reactions of the candidates in U. For unconstrained
            ///< bodies both continue with the mean motion of w or u (mean_motion.hpp)
    cut,    ///< infeasible with cuts; numbers: those of `dead`, then one for the cut of each
            ///< candidate
    form,   ///< the whole block; numbers: QuadraticMultipliers::numbers() (quadratic_form.hpp)
    marginal,  ///< flat, marginal or undecided: no claim and no numbers
  };
  Kind kind = Kind::marginal;
  std::uint32_t block = 0;
  SignPattern node;                 ///< of the whole problem's candidates
  std::span<const double> numbers;  ///< valid during the call
};

/// Recorder of the evidence of every closed node.
using EvidenceRecorder = std::function<void(const Evidence&)>;

/// Exact test of the evidence of a node to be closed; for a node without claim, whether its
/// configurations are also those of others.
using Judge = std::function<bool(const Evidence&)>;

/// Counts of opened nodes by their result, and costs.
struct SignPatternTally : engine::Counts<SignPatternTally> {
  std::uint64_t branched = 0;  ///< both children added to the tree
  std::uint64_t dead = 0;      ///< pruned: no wedged configuration below
  std::uint64_t found = 0;     ///< feasible leaves
  std::uint64_t flat = 0;      ///< nodes closed as flat cones, maximal or not
  std::uint64_t faces = 0;     ///< degenerate nodes closed: another node has all of their solutions
  std::uint64_t marginal = 0;  ///< leaves that are marginal
  std::uint64_t undecided = 0;   ///< leaves that are undecided
  std::uint64_t doubtful = 0;    ///< nodes branched although they are marginal or undecided
  std::uint64_t escalated = 0;   ///< nodes solved at a higher precision level
  std::uint64_t probed = 0;      ///< children solved for strong branching
  std::uint64_t iterations = 0;  ///< interior-point iterations, over all nodes
  std::uint64_t candidates = 0;  ///< leaves to test of Algorithm 5.8
  std::vector<PolyhedralCandidate> tested;  ///< these leaves; not a count
  std::uint64_t proved = 0;                 ///< leaves proved feasible by the exact test
  std::uint64_t refused = 0;                ///< claims refused by it
  std::uint64_t doubted =
      0;  ///< nodes closed as infeasible although the test refuses their evidence
  std::uint64_t unproved = 0;  ///< closed nodes without claim and without proof

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
                      field("climbed", &SignPatternTally::escalated),
                      field("probed", &SignPatternTally::probed),
                      field("iterations", &SignPatternTally::iterations),
                      field("candidates", &SignPatternTally::candidates)};
  }
};

/// Bounding of candidates before the tree is searched (candidate_bounds.hpp).
enum class Tightening {
  automatic,  ///< if the tree is large, as decided by find_patterns
  never,
  always,  ///< only the bounds that follow from the cones themselves
};

/// Options of the search. The patterns do not depend on them.
struct SignPatternOptions {
  conic::Tolerances tolerances;
  Branching branching = Branching::automatic;     ///< without sampling; find_patterns samples
  Tightening tightening = Tightening::automatic;  ///< likewise
  /// Number of candidates for strong branching, the best by the branching rule: both children of
  /// each are solved, and the node is split by one with an infeasible child or by the one whose
  /// children are smallest. 0: none. Not used with polyhedral cones.
  int probes = 0;
  /// 0: nodes are bounded with the friction cones themselves (Algorithm 5.1). Otherwise, in space,
  /// the number of facets of circumscribed polyhedral cones; leaves feasible with these are tested
  /// with the cones themselves (Algorithm 5.8).
  int facets = 0;
  /// True if redundant degenerate nodes are also branched: then each sign pattern below them is
  /// decided by itself, which a certificate needs. Up to 2^k times as many nodes for k inactive
  /// candidates.
  bool thorough = false;
  Precision precision = Precision::escalating;
};

/// Largest |t*| that the sixteen digits of a file's coordinates and directions may leave of zero.
/// Above it t* is decided by its sign, although it is degenerate by the tolerance.
inline constexpr double rounding_of_files = 1e-14;

/// Tolerances that resolve signs down to `resolution`, unless a larger tolerance is requested.
inline conic::Tolerances resolving(conic::Tolerances tolerances, double resolution) {
  if (tolerances.sign <= conic::Tolerances{}.sign) tolerances.resolution = resolution;
  return tolerances;
}

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
  Tally tally() const { return tally_; }

  /// Objective of engine::Order::best_first, which is breadth-first with it (Remark 5.2): the
  /// number of candidates with a sign in a leaf, which bounds that of the nodes above it.
  [[nodiscard]] double objective(const Solution& leaf) const;
  [[nodiscard]] double bound(const Node& node) const;

  /// Result of a node: infeasible (neither), branched, or a leaf that is not infeasible.
  struct Fate {
    std::vector<Node> children;
    std::optional<Configuration> leaf;
  };

  /// Opens a node, for `expand` and for other trees on the same nodes.
  /// @throws support::Stopped soon after the run is to stop
  Fate decide(const Node& node);

  /// The same within an expansion of another tree: nothing if the search is about to end and the
  /// node was put back.
  template <class Tree>
  std::optional<Fate> decide(const Node& node, engine::Expansion<Tree>& out) {
    return pollable_.within(out, node, [&] { return decide(node); });
  }

  /// Sets the stop condition of decide() outside of expansions.
  void end_when(support::Stop stop) { pollable_.end_when(std::move(stop)); }

  /// Sets the recorder of evidence of closed nodes. Branched nodes are not closed.
  void report_to(EvidenceRecorder recorder) { recorder_ = std::move(recorder); }

  /// Sets the exact test of evidence; refused claims are counted.
  /// @param binding whether refused claims are not used: a node with few free candidates is then
  /// branched, a leaf is undecided
  void judge_by(Judge judge, bool binding) {
    judge_ = std::move(judge);
    binding_ = binding;
  }

 private:
  // Solver and bounds for the nodes of one block.
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

  // Decision by bounds at a node that is not a leaf; nothing if the program without cuts is
  // required.
  std::optional<Fate> decide_with_cuts(const Node& node);
  Fate decide_doubt(const Node& node, const conic::ConicResult& answer);
  void note_tested(const Node& leaf, double polyhedral, const conic::ConicResult& answer);
  // True if the leaf with these contacts is feasible.
  bool is_solid(Block& block, const SignPattern& cone);
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
  EvidenceRecorder recorder_;
  Judge judge_;
  bool binding_ = false;
};

}  // namespace kusabi::wedged
