// Decisions at one friction coefficient, in exact arithmetic where K can be enclosed: whether all
// sign patterns are infeasible, whether one pattern is feasible.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/critical/bound_record.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "nodes/wedged/relaxation/pattern_options.hpp"
#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "nodes/wedged/tree/evidence.hpp"
#include "nodes/wedged/tree/evidence_check.hpp"
#include "nodes/wedged/tree/stiffness_enclosure.hpp"
#include "problems/structure/checks/checked_structure.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Result of the tree at one coefficient: its leaves, and counts of the exact test.
struct DecidedTree {
  engine::Status status = engine::Status::solved;
  std::vector<Configuration> leaves;  ///< maximal cones and undecided leaves
  std::uint64_t feasible = 0;         ///< leaves that the exact test proves feasible
  std::uint64_t unproved = 0;         ///< nodes whose evidence it refuses, or which are undecided
  bool except_large_displacements = false;  ///< some of its proofs leave these out

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& status& leaves& feasible& unproved& except_large_displacements;
  }

  [[nodiscard]] bool solved() const { return status == engine::Status::solved; }
  [[nodiscard]] bool all_infeasible() const { return leaves.empty(); }
  [[nodiscard]] bool is_proved_infeasible() const { return all_infeasible() && unproved == 0; }
  [[nodiscard]] bool has_cone() const {
    return std::ranges::any_of(leaves, &Configuration::is_cone);
  }
  /// Null: there is none.
  [[nodiscard]] const Configuration* first(LeafState state) const {
    const auto found = std::ranges::find(leaves, state, &Configuration::state);
    return found == leaves.end() ? nullptr : &*found;
  }
};

/// Result of one leaf at one coefficient.
struct DecidedLeaf {
  std::vector<Configuration> found;  ///< the leaf, if it is not infeasible
  bool holds = false;                ///< feasible by the exact test
  bool degenerate = false;           ///< t* = 0 within the tolerance: undecided

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& found& holds& degenerate;
  }

  [[nodiscard]] bool is(LeafState state) const {
    return !found.empty() && found.front().state == state;
  }
  [[nodiscard]] bool is_feasible() const { return is(LeafState::feasible) || is(LeafState::flat); }
};

/// Recording of the evidence of one leaf; `after_stop`: also if the run is to stop.
enum class LeafRecord { none, within_limits, after_stop };

/// Decisions on all ranks, which make the same calls. @pre arguments outlive this object
class BoundDecisions {
 public:
  BoundDecisions(engine::Analysis& analysis, const problems::CheckedStructure& structure,
                 const problems::WedgedProblem& problem, Precision precision, Tightening tightening,
                 const BoundRecorder& recorder, std::vector<CriticalCost>& costs);

  /// Encloses K, once. @return false if the run is to stop before
  bool enclose();
  /// True if K is enclosed, so that decisions are exact.
  [[nodiscard]] bool is_exact() const;
  /// True on the first rank if some proof so far leaves out large displacements.
  [[nodiscard]] bool leaves_out_large_displacements() const { return leaves_out_; }
  /// True if the error of the search may exceed the largest relaxation of a bound, while the exact
  /// test is available. @pre enclose()
  [[nodiscard]] bool needs_bisection() const;

  /// True if the root of every block is proved infeasible.
  bool roots_are_infeasible(double factor);
  /// True if each claim is proved. @pre enclose()
  bool are_proved(std::span<const Evidence> claims, double factor);
  /// One leaf, recorded as an upper bound. Adds the costs.
  DecidedLeaf leaf(const PatternNode& leaf, double factor, LeafRecord kind);
  /// All sign patterns. Adds the costs.
  /// @param wanted true for results to be recorded  @param nodes limit of the search
  DecidedTree tree(BracketSide side, double factor, CriticalPhase phase,
                   const BoundRecorder& recorder,
                   const std::function<bool(const DecidedTree&)>& wanted,
                   std::uint64_t nodes = engine::Limits{}.nodes);

 private:
  /// True if evidence proves its claim; notes proofs that leave out large displacements.
  std::function<bool(const Evidence&)> acceptance(std::shared_ptr<const EvidenceCheck> check);

  /// Exact test at one coefficient. Null: K cannot be enclosed.
  [[nodiscard]] std::shared_ptr<const EvidenceCheck> check(
      std::span<const double> friction, std::span<const ProvedBound> bounds = {}) const;
  /// The exact test; if it is null, the claims of the solver count as proved, unless badly_scaled_.
  [[nodiscard]] ExactNodeTest test(std::shared_ptr<const EvidenceCheck> check) const;
  [[nodiscard]] conic::Tolerances tolerances() const;

  engine::Analysis& analysis_;
  const problems::CheckedStructure& structure_;
  const problems::WedgedProblem& problem_;
  Precision precision_;
  Tightening tightening_;
  const BoundRecorder& recorder_;
  std::vector<CriticalCost>& costs_;
  bool leaves_out_ = false;
  /// Enclosure of K, or the reason why there is none; nothing before it is computed.
  std::optional<StiffnessEnclosure> stiffness_;
  bool badly_scaled_;  ///< unconstrained bodies with very different scales: results of the solver
                       ///< may be wrong
};

}  // namespace kusabi::wedged
