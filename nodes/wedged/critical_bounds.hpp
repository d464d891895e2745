// Verification of the lower and upper bound of the critical friction coefficient in exact
// arithmetic. At the lower bound the tree of sign patterns decides every node; at the upper bound
// one feasible leaf is sufficient. A bound that cannot be verified is relaxed until it can.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "nodes/wedged/critical/narrowing_bracket.hpp"
#include "nodes/wedged/quadratic/quadratic_bracket.hpp"
#include "nodes/wedged/relaxation/pattern_options.hpp"
#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "nodes/wedged/tree/evidence.hpp"
#include "nodes/wedged/tree/evidence_check.hpp"
#include "nodes/wedged/tree/stiffness_enclosure.hpp"
#include "problems/structure/checks/checked_structure.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

enum class BracketSide { lower, upper };

/// Claim of a record: all patterns, or one feasible pattern.
enum class BoundClaim { all_patterns, one_pattern };

/// Recorder of the evidence for one bound during its search, on one rank.
class BoundRecord {
 public:
  BoundRecord() = default;
  BoundRecord(const BoundRecord&) = delete;
  BoundRecord& operator=(const BoundRecord&) = delete;
  virtual ~BoundRecord() = default;

  virtual void add(const Evidence& evidence) = 0;

  /// Ends the record, on every rank alike. @param bounds used by the evidence
  /// @param holds true: the evidence proves the bound; false: the bound is relaxed and another
  /// record follows
  virtual void end(std::span<const ProvedBound> bounds, BoundClaim claim, bool holds) = 0;
};

/// Begins a record, on every rank alike. @param factor the friction coefficient @param friction
/// that of each candidate @return null: this bound is not recorded
using BoundRecorder = std::function<std::unique_ptr<BoundRecord>(BracketSide side, double factor,
                                                                 std::span<const double> friction)>;

/// Parameters of the verification.
struct BoundsParameters {
  CriticalGrid grid;
  Tightening tightening = Tightening::automatic;
  bool list = false;             ///< true if all patterns are listed
  std::uint64_t list_nodes = 0;  ///< see CriticalParameters
};

/// Result of the tree at one coefficient: its leaves, and counts of the exact test.
struct DecidedBound;

/// Verification on all ranks, which make the same calls. @pre arguments outlive this object
class CriticalBounds {
 public:
  CriticalBounds(engine::Analysis& analysis, const problems::CheckedStructure& structure,
                 const problems::WedgedProblem& problem, const BoundsParameters& parameters,
                 const BoundRecorder& recorder, NarrowingBracket& bracket,
                 std::vector<CriticalCost>& costs);

  /// Tests both bounds without relaxing them: the lower one by the roots alone, the upper one by
  /// its leaf.
  void prove_at_once();

  /// Raises the lower bound to the coefficient of the forms and tests them there. If they do not
  /// hold exactly, the bound stays.
  void prove_by_forms(QuadraticForms forms);

  /// Proves the bounds or widens the bracket. Stores the doubts and the phase of a stop; patterns
  /// are stored on rank 0.
  void prove(CriticalFindings& findings);

 private:
  struct DecidedLeaf;
  /// True if evidence proves its claim.
  using Test = std::function<bool(const Evidence&)>;

  bool enclose();
  void set_known(std::vector<Configuration> found);
  bool roots_are_infeasible(double factor);
  [[nodiscard]] Evidence form_of(std::uint32_t block) const;
  [[nodiscard]] bool forms_are_the_bound() const {
    return forms_.factor > 0 && forms_.factor == bracket_.lower();
  }
  void record_forms();
  void record_proved_bounds();
  /// Recording of the evidence of one leaf; `after_stop`: also if the run is to stop.
  enum class LeafRecord { none, within_limits, after_stop };
  DecidedLeaf decide_leaf(const PatternNode& leaf, double factor, LeafRecord kind);
  /// True if the error of the search may exceed the largest relaxation of a bound, while the exact
  /// test is available.
  [[nodiscard]] bool needs_bisection() const {
    return badly_scaled_ && parameters_.grid.precision == Precision::escalating &&
           std::holds_alternative<verify::EnclosedProblem>(*stiffness_);
  }
  /// Exact test at one coefficient. Null: K cannot be enclosed.
  [[nodiscard]] std::shared_ptr<const EvidenceCheck> check(
      std::span<const double> friction, std::span<const ProvedBound> bounds = {}) const;
  /// The exact test; if it is null, the claims of the solver count as proved, unless badly_scaled_.
  [[nodiscard]] Test test(std::shared_ptr<const EvidenceCheck> check) const;
  [[nodiscard]] conic::Tolerances tolerances() const;
  template <class Wanted>
  DecidedBound decide(BracketSide side, double factor, CriticalPhase phase,
                      const BoundRecorder& recorder, Wanted wanted, std::uint64_t nodes);
  engine::Status bisect();
  engine::Status prove_lower();
  engine::Status prove_upper();
  engine::Status prove_by_any(double factor);
  /// True if the upper bound is `factor` and a configuration of its pattern is known.
  [[nodiscard]] bool known_at(double factor) const {
    return !known_.empty() && bracket_.upper() == factor && known_leaf_ == bracket_.leaf();
  }
  engine::Status list(CriticalFindings& findings);
  void note_patterns(CriticalFindings& findings) const;
  void note_undecided(CriticalFindings& findings) const;

  engine::Analysis& analysis_;
  const problems::CheckedStructure& structure_;
  const problems::WedgedProblem& problem_;
  BoundsParameters parameters_;
  const BoundRecorder& recorder_;
  NarrowingBracket& bracket_;
  std::vector<CriticalCost>& costs_;
  /// Enclosure of K, or the reason why there is none; nothing before it is computed.
  std::optional<StiffnessEnclosure> stiffness_;
  bool badly_scaled_;  ///< unconstrained bodies with very different scales: results of the solver
                       ///< may be wrong
  double proved_lower_ = 0;
  QuadraticForms forms_;                   ///< none, or proved at their coefficient
  bool forms_recorded_ = false;            ///< in a certificate
  std::vector<Configuration> known_;       ///< feasible at the upper bound
  std::optional<PatternNode> known_leaf_;  ///< leaf of the bracket at that time
};

}  // namespace kusabi::wedged
