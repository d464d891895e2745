// The proofs of one block of contact candidates: that its K is positive definite but for the
// motions of bodies that nothing holds, that nothing is wedged below a dead node, and that a living
// leaf has a configuration; for every K that an enclosure holds. docs/theory/proofs.md has the same
// letters.
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
#include "verify/structure/held_stiffness.hpp"
#include "verify/wedged/proved_bounds.hpp"

namespace kusabi::verify {

/// What is to be proved something of. Candidates are numbered as in the block.
struct ContactBlock {
  std::size_t dimension = 0;       ///< d
  EnclosedMatrix stiffness;        ///< K, dm x dm; K G = 0 for the motions below
  std::vector<double> friction;    ///< mu, m, >= 0
  std::vector<std::string> names;  ///< m, for messages
  ContactMotions motions{};        ///< p of bodies that nothing holds; none: K is definite
  /// G as a certificate has it, dm x p, row by row: what its numbers are coefficients of.
  std::vector<double> recorded_motions{};
};

/// A configuration *moves far* if its displacements are more than so many times as large as what
/// is left of them without rigid motion: |u| > farthest_motion min_a |u - G a|. The directions of
/// a file have sixteen digits, so on a way that long nobody knows whether two walls are parallel.
inline constexpr double farthest_motion = 0x1p20;

/// What became of a claim.
struct Judgement {
  std::optional<std::string> refusal{};  ///< why it is not proved; nothing if it is
  bool but_for_far_motion = false;       ///< proved of all configurations that do not move far
  /// Of a marginal node: proved that its configurations are those of others with fewer contacts.
  bool unloaded = false;
};

class BlockProof {
 public:
  explicit BlockProof(ContactBlock block);

  /// A lower bound s > 0 of the least eigenvalue of every K, with a spring for each motion; nothing
  /// if it was not shown.
  [[nodiscard]] const std::optional<Dyadic>& least_eigenvalue() const { return least_; }

  [[nodiscard]] std::size_t motions() const { return block_.motions.count; }

  /// Whether nothing is wedged below the node (U, R).
  /// @param numbers m multipliers, and p coefficients of the mean motion of w
  /// @pre least_eigenvalue()
  [[nodiscard]] Judgement judge_dead(const support::IndexSet& contact,
                                     const support::IndexSet& separated,
                                     std::span<const double> numbers) const;

  /// The same by the cuts of what has been taken up.
  /// @param numbers as of judge_dead(), then m multipliers of cuts
  /// @pre least_eigenvalue()
  [[nodiscard]] Judgement judge_cut(const support::IndexSet& contact,
                                    const support::IndexSet& separated,
                                    std::span<const double> numbers) const;

  /// Proves a bound of a candidate, or that it is never on a side, by the cuts of those that were
  /// taken up before, and takes it up. @return why not
  /// @param most times sum_k r_nk: above r_n in contact, u_n separated; nothing: never
  /// @param numbers as of judge_cut(), and with `most` the multiplier of its opposite
  /// @pre least_eigenvalue()
  [[nodiscard]] std::optional<std::string> take_up(std::size_t candidate, Side side,
                                                   const std::optional<double>& most,
                                                   std::span<const double> numbers);

  /// Whether equilibrium leaves some contact of U without a reaction, whatever is below the node
  /// (U, R).
  [[nodiscard]] bool leaves_a_contact_unloaded(const support::IndexSet& contact,
                                               const support::IndexSet& separated) const;

  /// Whether the leaf (U, R) has a configuration in its interior. @return why not
  /// @param numbers tangential reactions of U, d - 1 each, and p coefficients of the mean motion
  /// @pre least_eigenvalue()
  [[nodiscard]] std::optional<std::string> refusal_of_alive(const support::IndexSet& contact,
                                                            const support::IndexSet& separated,
                                                            std::span<const double> numbers) const;

 private:
  // Springs that hold the motions, and the motions that leave all normal displacements of U alone,
  // or nearly so.
  struct Hold {
    std::vector<std::size_t> springs;
    std::vector<Rationals> sliding;
  };
  [[nodiscard]] Hold hold(const support::IndexSet& contact) const;
  // Demands rows of G, those of the largest products first, until what is left of them is no more
  // than a share of the first.
  void demand_largest(const std::vector<std::size_t>& rows, double negligible, Elimination& rest,
                      std::vector<std::size_t>& chosen) const;
  [[nodiscard]] const HeldStiffness& held(const std::vector<std::size_t>& springs) const;
  [[nodiscard]] const HeldStiffness* held_at_normals(const support::IndexSet& contact) const;

  // A leaf, and what is asked of it.
  struct Leaf {
    const support::IndexSet& contact;
    std::vector<std::size_t> unknowns;  // all displacements but the normal ones of U
    DyadicList right;                   // r there, given for the tangents of U
    Dyadic right_error;                 // what r may be off by, as a vector
    std::vector<Rationals> sliding;
    Dyadic lift;               // the size of their normal displacements on U, as a matrix
    Dyadic mend;               // and of tangential reactions that carry a load of 1 on each of them
    std::vector<double> mean;  // the motion that is meant, in own coefficients
  };
  [[nodiscard]] std::optional<std::string> read_leaf(std::span<const double> numbers,
                                                     Leaf& leaf) const;
  // Makes the tangential reactions of a leaf orthogonal to the motions that slide.
  [[nodiscard]] std::optional<std::string> balance_sliding(const std::vector<double>& room,
                                                           Leaf& leaf) const;
  // The size of normal displacements on a set, or more.
  [[nodiscard]] Dyadic normal_size(const NearList& displacements,
                                   const support::IndexSet& contact) const;
  // What the tangential reactions may be off by since sliding motions, one of which is part of the
  // displacements, lift U a little; nothing if it is too much. `pressures` is the size of r_n.
  [[nodiscard]] std::optional<Dyadic> error_of_lift(const HeldStiffness& held, const Leaf& leaf,
                                                    const NearList& shift,
                                                    const Dyadic& pressures) const;
  [[nodiscard]] std::optional<std::string> check_alive(const HeldStiffness& held, const Leaf& leaf,
                                                       const DyadicList& u, const DyadicList& r,
                                                       const Dyadic& unknown) const;

  // The opposite of a bound: r_ni, or u_ni, is no less than beta sum_k r_nk.
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
    std::span<const double> multipliers;  // y, what is asked of K w
    std::span<const double> mean;         // of a loose body, the mean motion of w
    std::span<const double> of_cuts;      // eta; empty: no cuts
    std::optional<Opposite> opposite;
  };
  // Whether they leave nothing; with all that is known of sides.
  [[nodiscard]] Judgement judge(const Combination& combination) const;
  [[nodiscard]] Judgement judge_with_bounds(Combination combination) const;
  // What they give for u_nk beside the multipliers, and for r beside w.
  [[nodiscard]] Dyadic displacement_share(const Combination& combination, std::size_t k) const;
  [[nodiscard]] DyadicList reaction_shares(const Combination& combination) const;
  [[nodiscard]] std::optional<std::string> refusal_of_held(const Combination& combination) const;
  [[nodiscard]] std::optional<std::string> check_held(const Combination& combination,
                                                      const DyadicList& w, const DyadicList& nu,
                                                      const Dyadic& off) const;

  // Multipliers as they were recorded, over the lengths of normals, with the rows of their normals,
  // what they must not be below, and by how much each may change.
  struct Recorded {
    std::vector<Rationals> rows;
    Rationals forces;
    Rationals least;  // where u_n >= 0
    std::vector<double> room;
  };
  [[nodiscard]] Recorded recorded_forces(const Combination& combination, double small,
                                         double raised) const;
  [[nodiscard]] mpq_class least_force(const Combination& combination, std::size_t k) const;
  // Forces along the normals, where u_n >= 0 not below what the inequalities give.
  struct Multipliers {
    NearList near;
    Dyadic carried;  // the size of forces at the springs that would bring them into equilibrium
  };
  // In exact equilibrium; nothing if there are none.
  [[nodiscard]] std::optional<Multipliers> multipliers(const Combination& combination, double small,
                                                       double raised) const;
  // In equilibrium but for rounding.
  [[nodiscard]] std::optional<Multipliers> near_multipliers(const Combination& combination,
                                                            double small) const;
  [[nodiscard]] std::optional<Dyadic> carried_by_springs(const std::vector<Rationals>& rows,
                                                         const Rationals& forces) const;
  [[nodiscard]] NearList along_normals(const Rationals& forces) const;
  [[nodiscard]] Judgement judge_loose(const Combination& combination) const;
  [[nodiscard]] std::optional<std::string> check_loose(const Combination& combination,
                                                       const Multipliers& y,
                                                       const std::vector<double>& mean,
                                                       const DyadicList& w, const DyadicList& nu,
                                                       const Dyadic& off) const;
  [[nodiscard]] std::optional<std::string> check_margins(const support::IndexSet& separated,
                                                         const DyadicList& w, const Dyadic& error,
                                                         const Dyadic& epsilon) const;

  // Whether the reactions of all candidates that a motion moves work against it, one way or the
  // other, and one of U is among these.
  [[nodiscard]] bool all_work_against(const Rationals& motion,
                                      const std::vector<std::size_t>& carrying,
                                      const support::IndexSet& contact) const;
  // mu |w_t| or more, and what w_n may be off by.
  [[nodiscard]] Dyadic slip_above(const DyadicList& w, std::size_t candidate,
                                  const Dyadic& error) const;

  [[nodiscard]] std::vector<double> own_coefficients(std::span<const double> recorded) const;
  // The coefficients of motions, a combination of given ones, which make the mean motion of x + G a
  // what it should be.
  [[nodiscard]] Rationals missing(const std::vector<double>& mean, const DyadicList& x,
                                  const std::vector<Rationals>& among) const;
  [[nodiscard]] Dyadic tangential_square(const DyadicList& vector, std::size_t candidate) const;
  [[nodiscard]] std::size_t candidates() const { return block_.names.size(); }

  ContactBlock block_;
  std::vector<double> near_motions_;     // G, dm x p, to guess with
  std::vector<double> own_of_recorded_;  // p x p: own coefficients of the recorded motions
  std::vector<Dyadic> friction_;         // mu
  Dyadic steepest_;                      // the root of 1 + the largest mu^2, or more
  std::optional<Dyadic> least_;          // s
  ProvedBounds bounds_;
  bool far_bounds_ = false;                // some hold of configurations that do not move far only
  mutable std::list<HeldStiffness> held_;  // the first for dead nodes; others for leaves
};

/// Whether a candidate is in a set of them.
inline bool holds(const support::IndexSet& set, std::size_t candidate) {
  return set.contains(static_cast<int>(candidate));
}

}  // namespace kusabi::verify
