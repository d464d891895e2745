// Tree of sign patterns under load: search for a state in which a load of the given shares acts.
// Nodes are those of sign_pattern_tree.hpp, with the loads as further columns (load_program.hpp).
//
//   t* < 0   no state below the node, and no wedged configuration either;
//   t* > 0   at a leaf: a state in which every load acts and all inequalities are strict;
//   t* = 0   (within the tolerance) states with equalities, which are those of one leaf, or only
//            unloaded configurations; the relative interior distinguishes them in floating point.
//
// The search ends with the first leaf with t* > 0 in depth-first order. Bounds of the candidates
// and cuts are those of the same loads; those of the unloaded problem are not valid under load.
#pragma once

#include <array>
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
#include "nodes/wedged/hold/load_program.hpp"
#include "nodes/wedged/relaxation/branching.hpp"
#include "nodes/wedged/relaxation/candidate_bounds.hpp"
#include "nodes/wedged/relaxation/contact_solver.hpp"
#include "nodes/wedged/relaxation/mean_motion.hpp"
#include "nodes/wedged/tree/node_interruption.hpp"
#include "support/index_set.hpp"

namespace kusabi::wedged {

/// Signs of the candidates of one block.
struct LoadedPattern {
  support::IndexSet contact;    ///< U: u_n + g = 0
  support::IndexSet separated;  ///< R: r = 0

  friend bool operator==(const LoadedPattern&, const LoadedPattern&) = default;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& contact& separated;
  }
};

/// A leaf with states.
struct LoadedLeaf {
  LoadedPattern pattern;
  std::vector<double> amounts;   ///< of each share, normalised with sum r_n; > 0
  std::vector<double> reaction;  ///< r of the block, force, per the same unit

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& pattern& amounts& reaction;
  }
};

/// A node without a state, with the numbers that prove it (docs/certificates.md).
struct ClosedNode {
  LoadedPattern pattern;
  std::vector<double> numbers;
  bool by_cuts = false;
};

/// Counts of opened nodes by their result.
struct HoldTally : engine::Counts<HoldTally> {
  std::uint64_t branched = 0;
  std::uint64_t infeasible = 0;       ///< no state, proved
  std::uint64_t computed = 0;         ///< no state by the relative interior, not proved
  std::uint64_t of_other_leaves = 0;  ///< all of whose states are those of other leaves, proved
  std::uint64_t undecided = 0;        ///< leaves of unknown sign
  /// Leaves of unknown sign whose contacts do not resist every rigid-body mode. Of two load factors
  /// such a pattern holds at most the pairs on a line.
  std::uint64_t undecided_on_line = 0;
  std::uint64_t iterations = 0;
  std::vector<LoadedLeaf> limits{};  ///< leaves with states at a limit, computed; not a count

  [[nodiscard]] std::uint64_t unresolved() const { return undecided + undecided_on_line; }

  HoldTally& operator+=(const HoldTally& other) {
    Counts::operator+=(other);
    limits.insert(limits.end(), other.limits.begin(), other.limits.end());
    return *this;
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned version) {
    Counts::serialize(archive, version);
    archive& limits;
  }

  static constexpr auto fields() {
    return std::tuple{
        field("branched", &HoldTally::branched),    field("infeasible", &HoldTally::infeasible),
        field("computed", &HoldTally::computed),    field("others", &HoldTally::of_other_leaves),
        field("undecided", &HoldTally::undecided),  field("thin", &HoldTally::undecided_on_line),
        field("iterations", &HoldTally::iterations)};
  }
};

/// True if the candidates of U resist every rigid-body mode.
bool resists_all(const problems::WedgedProblem& problem, const support::IndexSet& contact,
                 double mu);

/// Answer for one node.
enum class HoldResult { infeasible, feasible, at_limit, face, unloaded, unresolved };

/// The node programs of one block under given loads.
class HoldNodes {
 public:
  /// @param shares the loads that act, each with an amount of its own; none: wedging
  HoldNodes(const LoadedProblem& loaded, std::span<const LoadShare> shares, double mu,
            Precision precision = Precision::escalating,
            const std::optional<GripRestriction>& grip = {});

  void end_when(const support::Stop& stop) { solver_.end_when(stop); }
  /// Keeps what closed() needs.
  void keep_evidence() { wants_evidence_ = true; }
  /// States of the dead load alone do not count. @pre another share
  void except_dead();
  /// @pre no bounds
  void set_friction(double mu);

  /// The programs for bounds of the candidates under these loads.
  [[nodiscard]] CandidateBounding bounding() const;
  /// Uses these bounds in the following programs.
  void tighten(std::vector<CandidateBounds> bounds);

  /// `at_limit`: states at a limit, in which a load acts, all of the leaf limit(); `face`: a leaf
  /// with such states, in all of which some candidate of U has no reaction, so that they are states
  /// of other leaves; `unloaded`: t* = 0 and no load acts; `unresolved`: neither is known, or a
  /// candidate remains to be decided.
  HoldResult solve(const LoadedPattern& node);

  /// True if equilibrium alone proves that all reactions and loads of the last node vanish, except
  /// those in its relative interior. The multipliers are then those of this proof.
  /// @pre the result of `node` was `at_limit`, `face` or `unloaded`
  bool is_contradiction(const LoadedPattern& node);

  [[nodiscard]] const support::IndexSet& all() const { return all_; }
  [[nodiscard]] const problems::WedgedProblem& problem() const { return loaded_->problem; }
  [[nodiscard]] double friction() const { return mu_; }
  /// The candidate by which a node is split, after solve().
  int candidate(const support::IndexSet& free) {
    return one_sided_ ? *one_sided_ : rule_.candidate(free, solver_);
  }
  /// Leaves that the point of the last node suggests: candidates with a reaction are in contact. None
  /// with bounds.
  [[nodiscard]] std::vector<LoadedPattern> suggested(const LoadedPattern& node) const;
  /// The leaf of all states of the last node, whose result is `at_limit`.
  [[nodiscard]] const LoadedPattern& limit() const { return limit_; }
  /// The state of the last node.
  [[nodiscard]] LoadedLeaf leaf(const LoadedPattern& pattern) const;
  /// Evidence that the last node is infeasible: multipliers of the normal displacements, the mean
  /// motion of w, the multiplier of the sum of a restriction, and those of cuts.
  [[nodiscard]] ClosedNode closed(const LoadedPattern& node) const;
  /// c_j: s = sum_k r_nk + sum_j c_j tau_j, to which the bounds of candidates refer.
  [[nodiscard]] const std::vector<double>& weights() const { return scales_; }
  /// Evidence of the state of the last node, which is feasible: tangential reactions of U and the
  /// mean motion of the displacements, u_n being zero on U, under the load once.
  [[nodiscard]] std::vector<double> state_numbers(const LoadedPattern& pattern) const;
  /// Works of the dead load with the clearances, of the reference load and of the second one on the
  /// displacement of the multipliers of the last node, which is infeasible. For every state of the
  /// node, with tau = 1, L_0 + L_1 lambda_1 + L_2 lambda_2 >= 0.
  [[nodiscard]] std::array<double, 3> works() const;
  [[nodiscard]] std::uint64_t iterations() const { return iterations_; }
  [[nodiscard]] std::uint64_t programs() const { return programs_; }

 private:
  [[nodiscard]] LoadPart load_part() const {
    return {static_cast<int>(loads_), equation_, grip_unit_};
  }
  std::optional<HoldResult> solve_with_cuts(const LoadedPattern& node);
  HoldResult degenerate(const LoadedPattern& node, double upper);

  support::IndexSet all_;
  std::vector<double> scales_;  // of the loads
  std::vector<LoadShare> shares_;
  std::size_t loads_;  // with the difference of a restriction
  conic::SideEquation equation_;
  support::IndexSet acting_;  // the loads of which one must act in a state, after the candidates
  support::IndexSet besides_dead_;  // the same, if states of the dead load alone do not count
  LoadedProblem const* loaded_;
  double mu_;
  Precision precision_;
  problems::WedgedProblem problem_;
  BranchingRule rule_;
  ContactSolver solver_;
  MeanMotion mean_motion_;
  double grip_unit_ = 1;                 // of the equation of a restriction
  std::vector<CandidateBounds> bounds_;  // empty: none
  std::optional<int> one_sided_;         // candidate of the last node, decided by its bounds
  // Evidence of the last node, if it is infeasible by cuts, or empty by the bounds alone.
  std::optional<std::vector<double>> by_cuts_;
  bool wants_evidence_ = false;
  LoadedPattern limit_;
  support::IndexSet limited_to_;  // candidates and loads of the relative interior of the last node
  Eigen::VectorXd multipliers_;   // of the last node
  std::uint64_t iterations_ = 0, programs_ = 0;
};

/// Problem type of engine::search, with Goal::first.
class HoldTree {
 public:
  using Node = LoadedPattern;
  using Solution = LoadedLeaf;
  using Tally = HoldTally;

  /// @pre `loaded` outlives this object
  HoldTree(const LoadedProblem& loaded, std::span<const LoadShare> shares, double mu,
           Precision precision = Precision::escalating,
           const std::optional<GripRestriction>& grip = {})
      : nodes_(loaded, shares, mu, precision, grip) {
    nodes_.end_when(interruption_.stop());
  }

  /// Receives the evidence of each infeasible node.
  using Reporter = std::function<void(ClosedNode)>;
  void report_to(Reporter reporter) {
    reporter_ = std::move(reporter);
    nodes_.keep_evidence();
  }

  [[nodiscard]] CandidateBounding bounding() const { return nodes_.bounding(); }
  void tighten(std::vector<CandidateBounds> bounds) { nodes_.tighten(std::move(bounds)); }
  [[nodiscard]] const std::vector<double>& weights() const { return nodes_.weights(); }
  /// States of the dead load alone do not count. @pre another share
  void except_dead() { nodes_.except_dead(); }
  /// Tries the leaves that the point of the root suggests, and no other if one has a state. @pre the
  /// search ends with the first leaf that has one
  void try_suggested() { tries_suggested_ = true; }

  [[nodiscard]] Node root() const { return {}; }
  void expand(Node&& node, engine::Expansion<HoldTree>& out);
  [[nodiscard]] Tally tally() const {
    Tally tally = tally_;
    tally.iterations = nodes_.iterations();
    return tally;
  }

 private:
  void open(const Node& node, engine::Expansion<HoldTree>& out);
  void take_limit(const Node& node, engine::Expansion<HoldTree>& out);
  bool take_suggested(const Node& node, engine::Expansion<HoldTree>& out);

  HoldNodes nodes_;
  bool tries_suggested_ = false;
  Reporter reporter_;
  NodeInterruption interruption_;
  Tally tally_;
};

}  // namespace kusabi::wedged
