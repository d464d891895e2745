// States under load: load factors that can be held at a friction coefficient, and the smallest
// coefficient at which the dead load can be held (docs/theory/loads.md). Analysis of `kusabi hold`.
//
// Load factors: a range is one node program with both of its ends as loads. Its tree is infeasible,
// or contains a pattern with a state. The states of one pattern are convex, so the ends of its load
// factors are found by bisection at that leaf; the rest of the range is searched again.
// Coefficient: in the same way, since the set of states grows with friction.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/hold/hold_record.hpp"
#include "nodes/wedged/hold/hold_tree.hpp"
#include "nodes/wedged/hold/load_program.hpp"
#include "nodes/wedged/relaxation/pattern_options.hpp"
#include "support/bracket.hpp"

namespace kusabi::wedged {

/// End of an unbounded interval.
inline constexpr double unbounded_end = std::numeric_limits<double>::infinity();

/// Reactions of a state that is held.
struct HeldState {
  double factor = 0;             ///< of the reference load
  std::vector<double> reaction;  ///< r of the block, force, dm
};

/// Factors of the reference load that can be held, from `low` to `high`; infinite: unbounded.
struct HeldInterval {
  support::Bound low_out;  ///< no state at low_out and below it, up to the next interval
  double low = 0;          ///< with a state: the end is between low_out and low
  double high = 0;         ///< likewise
  support::Bound high_out;
  support::Standing standing{};  ///< of the states at the ends

  /// With equal standing of states and of what is outside.
  static HeldInterval from(double low, double high, support::Standing standing) {
    return {{low, standing}, low, high, {high, standing}, standing};
  }

  std::uint32_t block = 0;
  std::optional<LoadedPattern> pattern{};  ///< of the block, with a state at `high` or inside
  std::optional<HeldState> state{};        ///< of the pattern, at an end that is not infinite
};

/// One search of a tree.
struct HoldCost {
  double friction = 0;
  double low = 0, high = 0;  ///< range of load factors
  std::uint64_t opened = 0, programs = 0;
};

/// The set of factors at one friction coefficient.
struct HeldFactors {
  engine::Status status = engine::Status::solved;
  std::vector<HeldInterval> intervals{};  ///< in ascending order
  support::Standing outside{};            ///< of the claim that there is no state outside of them
  bool unresolved = false;                ///< leaves are undecided: factors may be missing
  bool any_by_supports = false;           ///< all bodies are constrained: every load is held
  bool any_by_wedging = false;            ///< a wedged configuration holds every load
  bool not_in_equilibrium = false;        ///< at every factor the load moves a body where no
                                          ///< candidate resists
  std::vector<HoldCost> costs{};
};

/// Bracket of the smallest friction coefficient at which the dead load can be held.
struct HoldingFriction {
  engine::Status status = engine::Status::solved;
  /// The load cannot be held at `lower`, and can at `upper`.
  support::Bracket bracket{};
  bool any_by_supports = false;
  bool not_in_equilibrium = false;
  double maximum = 0;       ///< upper limit of the search
  std::uint32_t block = 0;  ///< the decisive one
  std::optional<LoadedPattern> pattern{};
  std::optional<HeldState> state{};  ///< of the pattern, at `upper`
  std::vector<HoldCost> costs{};
};

struct HoldParameters {
  double maximum = 1000;  ///< upper limit of the search
  double width = 1e-9;    ///< of the brackets, relative
  Precision precision = Precision::escalating;
  Tightening tightening = Tightening::automatic;
  /// Sum of the normal reactions of all states; of factors only, and of a problem of one block.
  std::optional<double> total{};
  HoldRecorder recorder{};  ///< of the evidence at a coefficient; empty: none
  /// Largest number of nodes and bounds of a tree whose evidence is recorded. Nothing: any number.
  std::optional<std::uint64_t> nodes_of_evidence{};
  /// Proved by the loads alone: the dead load, or every factor, moves a body in a direction that no
  /// candidate resists.
  bool dead_out_of_equilibrium = false;
  bool never_in_equilibrium = false;
};

/// True if the dead load moves a body in a direction that no candidate resists.
bool is_dead_unbalanced(const LoadedProblem& loaded, const HoldParameters& parameters);

/// A block for its evidence at a coefficient.
/// @param number in the whole problem  @param candidates likewise
RecordedBlock recorded_block(const LoadedProblem& block, const support::IndexSet& candidates,
                             std::uint32_t number, double mu, const HoldParameters& parameters);

/// Load factors that are held at one coefficient, as intervals with their standing. Every rank
/// makes the same call and gets the same result. At a limit `status` names it, and the result has
/// what is known.
/// @param mu friction coefficient, which multiplies the own one of each candidate
/// @param record of the certificate, or null
HeldFactors held_factors(engine::Analysis& analysis, const LoadedProblem& loaded, double mu,
                         const HoldParameters& parameters = {}, HoldRecord* record = nullptr);

/// Restricts the factors that are known to be held to those that another part of the structure, or
/// the structure in another load case, holds too. Costs are not added.
void restrict_to(HeldFactors& found, const HeldFactors& other);

/// Raises a bracket to that of another part or load case. @return true if it needs more friction
bool raise_to(support::Bracket& found, const support::Bracket& other);

/// Bracket of the smallest coefficient at which the dead load is held. Every rank makes the same
/// call and gets the same result. At a limit `status` names it, and the result has what is known.
HoldingFriction holding_friction(engine::Analysis& analysis, const LoadedProblem& loaded,
                                 const HoldParameters& parameters = {});

}  // namespace kusabi::wedged
