// Model of one block of contact candidates, common to all proofs: K within an enclosure, with its
// regularised stiffnesses, rigid-body modes, friction and loads. docs/theory/proofs.md has the same
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
#include "verify/structure/regularised_stiffness.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::verify {

/// A load on a block, condensed, and its work on the modes of the block.
struct BlockLoad {
  DyadicList forces;  ///< dm
  Dyadic error;       ///< bound of the Euclidean norm of their error
  Rationals work;     ///< p
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

/// A load in a proof, with the clearances.
struct ActingLoad {
  DyadicList forces;
  Dyadic error;
  Dyadic dead;            ///< the share of the clearances
  DyadicList gaps;        ///< g times that share, m
  Rationals work;         ///< on the modes, p
  bool excepted = false;  ///< states under it alone do not count
  Dyadic weight{};        ///< c: its amount's share in the sum to which bounds refer
};

/// Grounding springs for the rigid-body modes: normal displacements of U as long as these are not
/// small beside all others, then tangential ones of U with friction, likewise, then others.
struct Grounding {
  std::vector<std::size_t> springs;  ///< p, in increasing order
  std::vector<std::size_t> held;     ///< those that are not normal displacements of U
  /// Of these, those where U has no reaction, for modes that no reaction of U resists.
  std::vector<std::size_t> unseen;
  /// Modes that leave all normal displacements of U zero, rounded.
  std::vector<Rationals> sliding;
};

class BlockModel {
 public:
  explicit BlockModel(ContactBlock block);

  [[nodiscard]] const ContactBlock& block() const { return block_; }
  [[nodiscard]] std::size_t candidates() const { return block_.names.size(); }
  [[nodiscard]] std::size_t motions() const { return block_.motions.count; }
  [[nodiscard]] const std::vector<Dyadic>& friction() const { return friction_; }  ///< mu, m
  /// Upper bound of the square root of 1 + the largest mu^2.
  [[nodiscard]] const Dyadic& steepest() const { return steepest_; }

  /// A lower bound s > 0 of the least eigenvalue of every K, with a spring for each rigid-body
  /// mode; nothing if none was proved.
  [[nodiscard]] const std::optional<Dyadic>& min_eigenvalue() const { return minimum_; }

  /// By elimination in floating point: that K with these springs is definite is proved afterwards.
  [[nodiscard]] Grounding grounding(const support::IndexSet& contact) const;
  [[nodiscard]] const RegularisedStiffness& regularised(
      const std::vector<std::size_t>& springs) const;
  /// One whose springs act on normal displacements of U only; null if none was computed.
  [[nodiscard]] const RegularisedStiffness* regularised_at_normals(
      const support::IndexSet& contact) const;
  /// The one of infeasible nodes. @pre min_eigenvalue()
  [[nodiscard]] const RegularisedStiffness& first_regularised() const {
    return regularised_.front();
  }

  /// Coefficients of a motion in the block's modes, from those in the recorded modes.
  [[nodiscard]] std::vector<double> own_coefficients(std::span<const double> recorded) const;
  /// Coefficients a of modes, combinations of the given ones, such that the mean motion of x + G a
  /// is `mean`.
  [[nodiscard]] Rationals missing_motion(const std::vector<double>& mean, const DyadicList& x,
                                         const std::vector<Rationals>& among) const;
  /// Displacements of the candidates by a motion in the block's modes, rounded, dm.
  [[nodiscard]] std::vector<double> displacements_by(const std::vector<double>& motion) const;
  /// |v_t|^2 of a candidate.
  [[nodiscard]] Dyadic tangential_square(const DyadicList& vector, std::size_t candidate) const;
  /// Upper bound of mu |w_t|, plus the error of w_n.
  [[nodiscard]] Dyadic slip_above(const DyadicList& w, std::size_t candidate,
                                  const Dyadic& error) const;

  /// @pre loads
  [[nodiscard]] ActingLoad acting(LoadShare share) const;
  /// True if the reactions of a set of candidates resist every rigid-body mode, so that a solid
  /// wedged configuration with these in contact holds every load.
  [[nodiscard]] bool resists_all_motions(const support::IndexSet& contact) const;

  /// True if rigid-body motions that leave the normal displacements of U zero give those of all
  /// other candidates any values.
  [[nodiscard]] bool closes_gaps(const support::IndexSet& contact) const;

 private:
  ContactBlock block_;
  std::vector<double> near_motions_;  // G, dm x p, rounded
  // p x p: coefficients of the recorded modes in the block's modes.
  std::vector<double> own_of_recorded_;
  std::vector<Dyadic> friction_;  // mu
  Dyadic steepest_;
  std::optional<Dyadic> minimum_;  // s
  // The first for infeasible nodes; others for leaves.
  mutable std::list<RegularisedStiffness> regularised_;
};

/// True if a candidate is in a set of them.
inline bool contains(const support::IndexSet& set, std::size_t candidate) {
  return set.contains(static_cast<int>(candidate));
}

}  // namespace kusabi::verify
