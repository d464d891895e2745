// Verification of the lower and upper bound of the critical friction coefficient in exact
// arithmetic. At the lower bound the tree of sign patterns decides every node; at the upper bound
// one feasible leaf is sufficient. A bound that cannot be verified is relaxed until it can.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/critical/bound_decisions.hpp"
#include "nodes/wedged/critical/bound_record.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "nodes/wedged/critical/narrowing_bracket.hpp"
#include "nodes/wedged/quadratic/quadratic_bracket.hpp"
#include "nodes/wedged/relaxation/pattern_options.hpp"
#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "nodes/wedged/tree/evidence.hpp"
#include "problems/structure/checks/checked_structure.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Parameters of the verification.
struct BoundsParameters {
  CriticalGrid grid;
  Tightening tightening = Tightening::automatic;
  bool list = false;             ///< true if all patterns are listed
  std::uint64_t list_nodes = 0;  ///< see CriticalParameters
};

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

  /// Proves the bounds or widens the bracket. Stores the open points and the phase of a stop;
  /// patterns are stored on rank 0.
  void prove(CriticalFindings& findings);

 private:
  void set_known(std::vector<Configuration> found);
  [[nodiscard]] Evidence form_of(std::uint32_t block) const;
  [[nodiscard]] bool forms_are_the_bound() const {
    return forms_.factor > 0 && forms_.factor == bracket_.lower();
  }
  void record_forms();
  void record_proved_bounds();
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
  const problems::WedgedProblem& problem_;
  BoundsParameters parameters_;
  const BoundRecorder& recorder_;
  NarrowingBracket& bracket_;
  BoundDecisions decisions_;
  double proved_lower_ = 0;
  QuadraticForms forms_;                   ///< none, or proved at their coefficient
  bool forms_recorded_ = false;            ///< in a certificate
  std::vector<Configuration> known_;       ///< feasible at the upper bound
  std::optional<PatternNode> known_leaf_;  ///< leaf of the bracket at that time
};

}  // namespace kusabi::wedged
