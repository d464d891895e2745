// Proofs for one block of contact candidates, for every K within an enclosure: K is positive
// definite up to rigid-body modes, no configuration is wedged below an infeasible node, and a
// feasible leaf has a configuration. docs/theory/proofs.md derives them with the same letters.
#pragma once

#include <cstddef>
#include <list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "support/index_set.hpp"
#include "verify/arithmetic/exact.hpp"
#include "verify/structure/contact_motions.hpp"
#include "verify/structure/regularised_stiffness.hpp"
#include "verify/wedged/proved_bounds.hpp"

namespace kusabi::verify {

/// A load on a block, condensed, and its work on the modes of the block.
struct BlockLoad {
  DyadicList forces;  ///< dm
  Dyadic error;       ///< bound of the Euclidean norm of their error
  Rationals work;     ///< p
};

/// A combination of the loads of a block: `dead` times the dead load and the clearances, plus
/// `reference` times the reference load.
struct LoadShare {
  double dead = 0;
  double reference = 0;

  friend bool operator==(const LoadShare&, const LoadShare&) = default;
};

/// The sum of the normal reactions of the block is related to the dead load: sum r_n = total, or >=
/// (<=) with a multiplier that is not negative (not positive).
struct GripTerm {
  double total = 0;
  double multiplier = 0;
};

/// The problem of a block. Candidates are numbered within the block.
struct ContactBlock {
  std::size_t dimension = 0;       ///< d
  EnclosedMatrix stiffness;        ///< K, dm x dm; K G = 0 for the modes below
  std::vector<double> friction;    ///< mu, m, >= 0
  std::vector<std::string> names;  ///< m, for messages
  ContactMotions motions{};        ///< p modes of unconstrained bodies; none: K is definite
  /// G of the certificate, dm x p, by rows; recorded coefficients refer to it.
  std::vector<double> recorded_motions{};
  std::vector<BlockLoad> loads{};   ///< dead, reference; none: no states under load are proved
  std::vector<double> clearance{};  ///< g, m, with the loads
};

/// A configuration has *large displacements* if they exceed their part without rigid-body modes by
/// this factor: |u| > largest_displacement_ratio min_a |u - G a|. Directions in files have sixteen
/// digits, so over such distances nearly parallel walls cannot be distinguished from parallel ones.
inline constexpr double largest_displacement_ratio = 0x1p20;

/// The result of the check of a claim.
struct ProofResult {
  std::optional<std::string> refusal{};     ///< reason why it is not proved; nothing if it is
  bool except_large_displacements = false;  ///< proved for all others only
  /// Of an undecided node: its configurations are proved to be those of nodes with fewer contacts.
  bool unloaded = false;
};

/// Proofs of claims on one block. A refusal is the predicate or sentence of a message.
class BlockProof {
 public:
  explicit BlockProof(ContactBlock block);

  /// A lower bound s > 0 of the least eigenvalue of every K, with a spring for each rigid-body
  /// mode; nothing if none was proved.
  [[nodiscard]] const std::optional<Dyadic>& min_eigenvalue() const { return minimum_; }

  [[nodiscard]] std::size_t motions() const { return block_.motions.count; }

  /// Proves that no configuration is wedged below the node (U, R).
  /// @param numbers m multipliers, and p coefficients of the mean motion of w
  /// @pre min_eigenvalue()
  [[nodiscard]] ProofResult prove_infeasible(const support::IndexSet& contact,
                                             const support::IndexSet& separated,
                                             std::span<const double> numbers) const;

  /// The same with the cuts of all added bounds.
  /// @param numbers those of prove_infeasible(), then m multipliers of cuts
  /// @pre min_eigenvalue()
  [[nodiscard]] ProofResult prove_by_cuts(const support::IndexSet& contact,
                                          const support::IndexSet& separated,
                                          std::span<const double> numbers) const;

  /// Proves that no configuration of the block is wedged, by a quadratic form.
  /// @param numbers m^2 multipliers of products, (d - 1) m^2 of slips, m of squares and, with
  ///        motions, m^2 of products of displacements
  /// @pre min_eigenvalue()
  [[nodiscard]] ProofResult prove_by_form(std::span<const double> numbers) const;

  /// Proves a bound of a candidate, or that it is never in contact (never separated), with the cuts
  /// of the bounds added before, and adds it. @return the reason if it is not proved
  /// @param maximum bound of r_n (side: contact) or u_n (separated) over sum_k r_nk; nothing: no
  ///        configuration has the candidate on this side
  /// @param numbers those of prove_by_cuts(), and with `maximum` the multiplier of its opposite
  /// @pre min_eigenvalue()
  [[nodiscard]] std::optional<std::string> add_bound(std::size_t candidate, Side side,
                                                     const std::optional<double>& maximum,
                                                     std::span<const double> numbers);

  /// True if equilibrium makes the reaction of a contact of U zero in all configurations below the
  /// node (U, R).
  [[nodiscard]] bool leaves_a_contact_unloaded(const support::IndexSet& contact,
                                               const support::IndexSet& separated) const;

  /// Proves that the leaf (U, R) has a configuration in its interior. @return the reason if not
  /// @param numbers tangential reactions of U, d - 1 each, and p coefficients of the mean motion
  /// @pre min_eigenvalue()
  [[nodiscard]] std::optional<std::string> refusal_of_feasible(
      const support::IndexSet& contact, const support::IndexSet& separated,
      std::span<const double> numbers) const;

  /// Proves that below the node (U, R) there is no state under any combination of the loads with
  /// amounts >= 0 of which one is positive; without loads, that there is no wedged configuration.
  /// @param numbers those of prove_infeasible()
  /// @param grip a restriction of the states; nothing: all states
  /// @pre min_eigenvalue(), loads
  [[nodiscard]] ProofResult prove_no_state(const support::IndexSet& contact,
                                           const support::IndexSet& separated,
                                           std::span<const LoadShare> shares,
                                           std::span<const double> numbers,
                                           const std::optional<GripTerm>& grip = {}) const;

  /// Bounds of the sum of the normal reactions of a state.
  struct Grip {
    mpq_class minimum, maximum;
  };

  /// Proves that the leaf (U, R) has a state under a load. @return the reason if not
  /// @param numbers those of refusal_of_feasible(), with displacements that are zero along the
  ///        normals of U
  /// @param grip the bounds are set; null: none are requested
  /// @pre min_eigenvalue(), loads
  [[nodiscard]] std::optional<std::string> refusal_of_held_state(const support::IndexSet& contact,
                                                                 const support::IndexSet& separated,
                                                                 LoadShare share,
                                                                 std::span<const double> numbers,
                                                                 Grip* grip = nullptr) const;

  /// True if the reactions of a set of candidates resist every rigid-body mode, so that a solid
  /// wedged configuration with these in contact holds every load.
  [[nodiscard]] bool resists_all_motions(const support::IndexSet& contact) const;

 private:
  // A load in a proof, with the clearances.
  struct ActingLoad {
    DyadicList forces;
    Dyadic error;
    Dyadic dead;      // the share of the clearances
    DyadicList gaps;  // g times that share, m
    Rationals work;   // on the modes, p
  };
  [[nodiscard]] ActingLoad acting(LoadShare share) const;
  [[nodiscard]] Rationals work_of(LoadShare share) const;

  // Grounding springs for the rigid-body modes, and the sliding modes: those that leave all normal
  // displacements of U zero up to nearly_sliding.
  struct Grounding {
    std::vector<std::size_t> springs;
    std::vector<Rationals> sliding;
  };
  [[nodiscard]] Grounding grounding(const support::IndexSet& contact) const;
  // Adds equations for rows of G, those of the largest products first, until the remaining products
  // are below a share of the first.
  void demand_largest(const std::vector<std::size_t>& rows, double negligible, Elimination& rest,
                      std::vector<std::size_t>& chosen) const;
  [[nodiscard]] const RegularisedStiffness& regularised(
      const std::vector<std::size_t>& springs) const;
  [[nodiscard]] const RegularisedStiffness* regularised_at_normals(
      const support::IndexSet& contact) const;

  // A leaf and its conditions.
  struct Leaf {
    const support::IndexSet& contact;
    std::vector<std::size_t> unknowns;  // all displacements except the normal ones of U
    DyadicList right;                   // r at the unknowns, given for the tangents of U
    Dyadic right_error;                 // bound of the error of r, as a vector
    std::vector<Rationals> sliding;
    Dyadic lift;               // norm of the matrix of their normal displacements on U
    Dyadic correction;         // the same for tangential reactions with unit work on each mode
    std::vector<double> mean;  // the recorded mean motion, in coefficients of the block's modes
    DyadicList tangential{};   // r of the tangents of U
    DyadicList forces{};       // of the load, with those that close the gaps of U; dm or none
    Dyadic force_error{};      // bound of the norm of their error
    DyadicList gaps{};         // u_n = -gap on U, m
    Rationals work{};          // of the load on the modes
    Grip* grip = nullptr;
  };
  [[nodiscard]] std::optional<std::string> read_leaf(std::span<const double> numbers,
                                                     Leaf& leaf) const;
  // Makes the tangential reactions of a leaf orthogonal to the sliding modes.
  [[nodiscard]] std::optional<std::string> balance_sliding(const std::vector<double>& room,
                                                           Leaf& leaf) const;
  // Adds the norms `lift` and `correction` of sliding modes that displace tangents of U.
  // @param rows products of the rows of G with these modes @return false if they are dependent
  [[nodiscard]] bool add_corrections(const std::vector<Rationals>& rows,
                                     const std::vector<std::size_t>& tangents,
                                     const std::vector<Rationals>& modes, Leaf& leaf) const;
  // Adds the load to the forces of a leaf, and the forces that would close the gaps of U.
  void add_load(const ActingLoad& load, Leaf& leaf) const;
  [[nodiscard]] std::optional<std::string> refusal_of_leaf(Leaf leaf,
                                                           std::span<const double> numbers) const;
  // Upper bound of the norm of normal displacements on a set.
  [[nodiscard]] Dyadic normal_size(const ApproximateList& displacements,
                                   const support::IndexSet& contact) const;
  // Bound of the error of the tangential reactions caused by the normal displacements of sliding
  // modes on U; nothing if it is too large. `pressures` is the norm of r_n.
  [[nodiscard]] std::optional<Dyadic> error_of_lift(const RegularisedStiffness& regularised,
                                                    const Leaf& leaf, const ApproximateList& shift,
                                                    const Dyadic& pressures) const;
  [[nodiscard]] std::optional<std::string> check_feasible(const RegularisedStiffness& regularised,
                                                          const Leaf& leaf, const DyadicList& u,
                                                          const DyadicList& r,
                                                          const Dyadic& unknown) const;

  // The negation of a bound: r_ni, or u_ni, is at least beta sum_k r_nk.
  struct Opposite {
    std::size_t candidate;  // i
    Side side;
    Dyadic multiplier;  // theta
    Dyadic of_sum;      // theta beta
  };
  // Inequalities of all wedged configurations below a node (U, R), with multipliers.
  struct Combination {
    support::IndexSet contact;
    support::IndexSet separated;
    std::span<const double> multipliers;  // y, the target of K w
    std::span<const double> mean;         // the mean motion of w, for unconstrained bodies
    std::span<const double> of_cuts;      // eta; empty: no cuts
    std::optional<Opposite> opposite;
    std::vector<ActingLoad> loads{};
    std::optional<GripTerm> grip{};
  };
  // Upper bounds of the works of the loads: w'f + sum_k y_k g_k.
  [[nodiscard]] std::vector<Dyadic> works_above(const Combination& combination, const DyadicList& w,
                                                const Dyadic& w_error, const std::vector<Dyadic>& y,
                                                const Dyadic& y_error) const;
  // Proves that no configuration satisfies the inequalities, with all proved bounds.
  [[nodiscard]] ProofResult prove(const Combination& combination) const;
  [[nodiscard]] ProofResult prove_with_bounds(Combination combination) const;
  // Coefficients of u_nk besides the multipliers, and of r besides w.
  [[nodiscard]] Dyadic displacement_share(const Combination& combination, std::size_t k) const;
  [[nodiscard]] DyadicList reaction_shares(const Combination& combination) const;
  [[nodiscard]] std::optional<std::string> refusal_of_constrained(
      const Combination& combination) const;
  [[nodiscard]] std::optional<std::string> check_constrained(const Combination& combination,
                                                             const DyadicList& w,
                                                             const DyadicList& nu,
                                                             const Dyadic& off) const;

  // Proves by a rigid motion alone that no load of the combination is held, although there may be
  // wedged configurations.
  [[nodiscard]] std::optional<std::string> refusal_of_rigid_motion(
      Combination combination, const std::vector<double>& mean) const;

  // Recorded multipliers divided by the lengths of normals, the rows of the normals, lower bounds
  // of the multipliers, and the unit of change of each.
  struct Recorded {
    std::vector<Rationals> rows;
    Rationals forces;
    Rationals minimum;  // where u_n >= 0
    std::vector<double> room;
  };
  [[nodiscard]] Recorded recorded_forces(const Combination& combination, double small,
                                         double raised) const;
  [[nodiscard]] mpq_class min_force(const Combination& combination, std::size_t k) const;
  // Forces along the normals; where u_n >= 0 they are not below the coefficients of the
  // inequalities.
  struct Multipliers {
    ApproximateList near;
    Dyadic carried;  // norm of the spring forces that would bring them into equilibrium
  };
  // Multipliers in exact equilibrium; nothing if there are none.
  [[nodiscard]] std::optional<Multipliers> multipliers(const Combination& combination, double small,
                                                       double raised) const;
  // Multipliers in equilibrium up to rounding.
  [[nodiscard]] std::optional<Multipliers> near_multipliers(const Combination& combination,
                                                            double small) const;
  [[nodiscard]] std::optional<Dyadic> carried_by_springs(const std::vector<Rationals>& rows,
                                                         const Rationals& forces) const;
  [[nodiscard]] ApproximateList along_normals(const Rationals& forces) const;
  [[nodiscard]] ProofResult prove_unconstrained(const Combination& combination) const;
  [[nodiscard]] std::optional<std::string> check_unconstrained(
      const Combination& combination, const Multipliers& y, const std::vector<double>& mean,
      const DyadicList& w, const DyadicList& nu, const Dyadic& off) const;
  // @param works upper bounds, by load
  [[nodiscard]] std::optional<std::string> check_margins(const Combination& combination,
                                                         const DyadicList& w, const Dyadic& error,
                                                         const Dyadic& epsilon,
                                                         const std::vector<Dyadic>& works) const;

  // Rigid-body motions in a form, for springs on as many normals as possible.
  struct MotionsOfForm {
    std::vector<ApproximateList> lifting;  // those of springs on normals
    Dyadic lifted_by_sliding;  // bound of the normal displacements by the others, over |u| s / |r|
  };
  [[nodiscard]] std::optional<MotionsOfForm> motions_of_form(
      const RegularisedStiffness& regularised) const;

  // True if the reactions of all candidates displaced by a mode do negative work on it or on its
  // opposite, and at least one of them is in U.
  [[nodiscard]] bool all_work_against(const Rationals& motion,
                                      const std::vector<std::size_t>& carrying,
                                      const support::IndexSet& contact) const;
  // Upper bound of mu |w_t|, plus the error of w_n.
  [[nodiscard]] Dyadic slip_above(const DyadicList& w, std::size_t candidate,
                                  const Dyadic& error) const;

  [[nodiscard]] std::vector<double> own_coefficients(std::span<const double> recorded) const;
  // Coefficients a of modes, combinations of the given ones, such that the mean motion of x + G a
  // is `mean`.
  [[nodiscard]] Rationals missing(const std::vector<double>& mean, const DyadicList& x,
                                  const std::vector<Rationals>& among) const;
  [[nodiscard]] Dyadic tangential_square(const DyadicList& vector, std::size_t candidate) const;
  [[nodiscard]] std::size_t candidates() const { return block_.names.size(); }

  ContactBlock block_;
  std::vector<double> near_motions_;  // G, dm x p, rounded
  std::vector<double>
      own_of_recorded_;            // p x p: coefficients of the recorded modes in the block's modes
  std::vector<Dyadic> friction_;   // mu
  Dyadic steepest_;                // upper bound of the square root of 1 + the largest mu^2
  std::optional<Dyadic> minimum_;  // s
  ProvedBounds bounds_;
  bool bounds_except_large_ = false;  // some bounds hold except for large displacements
  mutable std::list<RegularisedStiffness>
      regularised_;  // the first for infeasible nodes; others for leaves
};

/// True if a candidate is in a set of them.
inline bool contains(const support::IndexSet& set, std::size_t candidate) {
  return set.contains(static_cast<int>(candidate));
}

}  // namespace kusabi::verify
