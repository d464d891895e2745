// Exact test of the claims about states under load, by the proofs of verify/: every tree and every
// state of the evidence is proved as it is recorded, and only their conclusions count as proved.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/transport/transport.hpp"
#include "nodes/wedged/hold/grip_search.hpp"
#include "nodes/wedged/hold/hold_record.hpp"
#include "nodes/wedged/hold/hold_search.hpp"
#include "nodes/wedged/hold/load_program.hpp"
#include "problems/structure/model/structure.hpp"
#include "verify/structure/enclosed_problem.hpp"
#include "verify/wedged/conclusion.hpp"

namespace kusabi::wedged {

/// Trees of more nodes and bounds are not proved on the way: an exact proof takes milliseconds for
/// each.
inline constexpr std::uint64_t max_nodes_of_evidence = 2000;

/// The enclosed structure, and the conclusions at each recorded coefficient. Every rank makes the
/// same calls.
class ExactHold {
 public:
  /// @param structure in one load case
  /// @param total sum of the normal reactions in all states
  /// @param of_any_size true: a large structure is enclosed, too
  ExactHold(engine::Transport& transport, const LoadedProblem& loaded,
            const problems::Structure& structure, std::optional<double> total, bool of_any_size,
            const support::LongWork& work = {});

  /// False if nothing is proved: the structure is too large to be enclosed on the way, or its
  /// enclosure fails.
  [[nodiscard]] bool can_prove() const { return enclosure_.has_value(); }

  /// Notes in the parameters which loads are out of equilibrium whatever the reactions.
  void note_statics(HoldParameters& parameters) const;

  /// A record that proves what it receives. At its end it also ends `further` if the claim is
  /// proved. @pre can_prove() @param further of the same evidence, or null
  std::unique_ptr<HoldRecord> record(HoldClaim claim, double mu,
                                     std::unique_ptr<HoldRecord> further);

  /// True if the last record of load factors proves anything.
  [[nodiscard]] bool proves_factors() const;

  /// Changes the standings of a result to those that the last record of this claim proves;
  /// `computed` if there was none, except for bodies that supports constrain.
  void set_standings(HeldFactors& found) const;
  void set_standings(GripRange& found) const;
  void set_standings(HoldingFriction& found) const;

 private:
  class Record;
  [[nodiscard]] const verify::HoldClaims* claims(HoldClaim claim) const;
  [[nodiscard]] bool any_modes() const { return !is_constrained(loaded_); }

  engine::Transport& transport_;
  const LoadedProblem& loaded_;
  verify::Certificate header_;  // without friction, theorems and states
  std::optional<verify::LoadedEnclosure> enclosure_;
  std::map<HoldClaim, verify::HoldClaims> proved_;
};

}  // namespace kusabi::wedged
