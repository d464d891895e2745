// The tree of sign patterns: Algorithm 5.1 of the wedged paper, or 5.8.
//
// A node is a pair (U, R) of disjoint sets of contact candidates: those held in contact, u_n = 0,
// and those held separated, r = 0. Its bound is the cone program of nodes/conic, whose optimal
// value t* tells whether a wedged configuration can exist below the node:
//
//   t* < 0   none can: the node is dead;
//   t* > 0   the relaxation is alive: a leaf is a pattern, any other node is branched;
//   |t*| within the tolerance   marginal: the node is branched like a living one, and a marginal
//            leaf is reported, but neither counted as a pattern nor thrown away.
//
// Should rounding end the solver while its bracket of t* still reaches beyond the tolerance on both
// sides, the node is undecided. It is treated as a marginal one, and reported under its own name.
//
// A marginal leaf is most often a face: t* = 0 exactly, its cone D(Y) of (14) has no interior point
// and belongs to another pattern's cone.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/search.hpp"
#include "nodes/branching.hpp"
#include "nodes/contact_solver.hpp"
#include "nodes/facets.hpp"
#include "problems/wedged_problem.hpp"

namespace kusabi::nodes {

/// U and R as bit sets; bit i is contact candidate i.
struct SignPattern {
  std::uint64_t contact = 0;    ///< U: u_n = 0
  std::uint64_t separated = 0;  ///< R: r = 0

  friend bool operator==(const SignPattern&, const SignPattern&) = default;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& contact& separated;
  }
};

/// What is known of a leaf that is not dead.
enum class LeafState {
  alive,      ///< t* is above the tolerance
  marginal,   ///< |t*| is within the tolerance
  undecided,  ///< neither is proved
};

/// A leaf of the tree that is not dead, with a configuration that shows it.
struct Configuration {
  SignPattern pattern;
  LeafState state = LeafState::alive;
  double lower = 0;                  ///< lower <= t* <= upper, in scaled units (see ContactSolver);
  double upper = 0;                  ///< `lower` is the value of the configuration below
  std::vector<double> reaction;      ///< r, dm, force; sum of its normal parts 1
  std::vector<double> displacement;  ///< u = K^-1 r, dm, length

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& pattern& state& lower& upper& reaction& displacement;
  }
};

/// Why a node was closed: what a certificate says of it (docs/certificates.md).
struct Evidence {
  enum class Kind {
    dead,      ///< numbers: the m multipliers that prove it
    alive,     ///< a leaf; numbers: the tangential reactions of the candidates in U
    marginal,  ///< a leaf that is marginal or undecided; no numbers
  };
  Kind kind = Kind::marginal;
  SignPattern node;
  std::span<const double> numbers;  ///< valid during the call
};

/// Told of every node that is closed.
using Witness = std::function<void(const Evidence&)>;

/// What became of the nodes that were opened, and what it cost.
struct SignPatternTally {
  std::uint64_t branched = 0;    ///< had both children put into the tree
  std::uint64_t dead = 0;        ///< pruned: no wedged configuration below
  std::uint64_t found = 0;       ///< leaves that are alive
  std::uint64_t marginal = 0;    ///< leaves that are marginal
  std::uint64_t undecided = 0;   ///< leaves that are undecided
  std::uint64_t doubtful = 0;    ///< nodes branched although they are marginal or undecided
  std::uint64_t iterations = 0;  ///< interior-point iterations, over all nodes
  std::uint64_t candidates = 0;  ///< leaves of Algorithm 5.8 that polyhedral friction lets live

  SignPatternTally& operator+=(const SignPatternTally& other);

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& branched& dead& found& marginal& undecided& doubtful& iterations& candidates;
  }
};

/// How the tree is searched. Whatever is chosen, the patterns are the same.
struct SignPatternOptions {
  conic::Tolerances tolerances;
  Branching branching = Branching::relative;
  /// 0: a node is bounded with the friction cones themselves (Algorithm 5.1). Otherwise, in space,
  /// with polyhedral cones of so many facets around them, and each leaf that these let live is put
  /// to the test of the cones (Algorithm 5.8).
  int facets = 0;
};

/// The problem type that engine::search searches.
class SignPatternTree {
 public:
  using Node = SignPattern;
  using Solution = Configuration;
  using Tally = SignPatternTally;

  /// Contact leaves less to search than separation: a quarter to a third of a subtree is below
  /// it, weighted by size, on space trusses of 20 to 40 candidates (docs/theory.md).
  static constexpr double work_of_first_child = 1.0 / 3;

  /// @param friction mu of each contact candidate, m numbers > 0
  /// @throws std::invalid_argument if the sizes do not fit or a number is out of range
  SignPatternTree(const problems::WedgedProblem& problem, std::span<const double> friction,
                  SignPatternOptions options = {});

  Node root() const { return {}; }
  void expand(Node&& node, engine::Expansion<SignPatternTree>& out);
  Tally tally() const { return tally_; }

  /// What becomes of a node: it is dead (neither), branched, or a leaf that is not dead.
  struct Fate {
    std::vector<Node> children;
    std::optional<Configuration> leaf;
  };

  /// Opens a node, for `expand` and for trees that make something else of the leaves.
  Fate decide(const Node& node);

  /// From now on `witness` is told why nodes are closed. A branched node is not closed.
  void report_to(Witness witness) { witness_ = std::move(witness); }

 private:
  void prune(const Node& node, const Eigen::VectorXd& multipliers);
  [[nodiscard]] std::uint64_t free_candidates(const Node& node) const {
    return candidates_ & ~(node.contact | node.separated);
  }
  /// u_n r_n of a candidate at the node that was solved last.
  [[nodiscard]] double violation(int candidate) const;
  [[nodiscard]] LeafState leaf_state(const conic::Answer& answer) const;
  [[nodiscard]] Configuration configuration(const Node& node, const conic::Answer& answer) const;
  void report_leaf(const Configuration& leaf) const;

  std::uint64_t candidates_;  // a bit for each
  conic::Tolerances tolerances_;
  std::vector<double> weight_;  // of u_n r_n when a node is split, by candidate
  ContactSolver solver_;
  std::optional<FacetBound> outer_;  // of Algorithm 5.8
  Tally tally_;
  Witness witness_;
};

}  // namespace kusabi::nodes
