// LeafProof: a configuration in the interior of the cone of a sign pattern, or a state under a load
// with these signs (docs/theory/proofs.md, "Feasible leaf").
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "support/index_set.hpp"
#include "verify/wedged/block_model.hpp"

namespace kusabi::verify {

/// Bounds of the sum of the normal reactions of a state.
struct Grip {
  mpq_class minimum, maximum;
};

/// The proof of one leaf.
class LeafProof {
 public:
  /// @param contact U
  /// @param numbers tangential reactions of U, d - 1 each, and p coefficients of the mean motion;
  ///        under a load with displacements that are zero along the normals of U
  /// @param share the load of a state; nothing: a wedged configuration
  /// @param grip is set to the bounds; null: none are requested
  /// @pre model.min_eigenvalue(); with a share loads; all arguments outlive this object
  LeafProof(const BlockModel& model, const support::IndexSet& contact,
            std::span<const double> numbers, const std::optional<LoadShare>& share = {},
            Grip* grip = nullptr);

  /// The reason if it is not proved.
  [[nodiscard]] std::optional<std::string> refusal();

 private:
  // Adds the load, and the forces that would close the gaps of U.
  void add_load(LoadShare share);
  [[nodiscard]] std::optional<std::string> read_numbers();
  // Changes the tangential reactions such that none remain at displacements without a contact, and
  // without friction.
  [[nodiscard]] std::optional<std::string> balance(const std::vector<std::size_t>& unseen);
  // True for tangents of U with friction, unless held.
  [[nodiscard]] bool has_given_reaction(std::size_t row) const;
  // The forces that close the gaps of U, with the motion.
  void close_gaps(const RegularisedStiffness& stiffness);
  // Moves the body such that its mean motion becomes the recorded one.
  void add_motion(const RegularisedStiffness& stiffness, const std::vector<Rationals>& sliding);
  // The reaction at a row. @param r K u
  [[nodiscard]] Dyadic reaction(const DyadicList& r, std::size_t row) const {
    return r[row] - forces_[row];
  }
  [[nodiscard]] std::optional<std::string> check_feasible(const RegularisedStiffness& stiffness,
                                                          const DyadicList& u, const DyadicList& r,
                                                          const Dyadic& unknown) const;
  // Upper bound of |r_t| s. @param r K u  @param error of all reactions times s
  [[nodiscard]] Dyadic shear_above(const Dyadic& s, const DyadicList& r, const Dyadic& error,
                                   std::size_t candidate) const;

  const BlockModel& model_;
  const ContactBlock& block_;
  const support::IndexSet& contact_;
  std::span<const double> numbers_;
  Grip* grip_;
  std::vector<bool> held_;             // dm: displacements without a given reaction, except normals
  std::vector<std::size_t> unknowns_;  // all displacements except these and the normal ones of U
  DyadicList tangential_;              // given r of the tangents of U, else zero
  Dyadic tangential_error_;            // bound of the norm of their error
  std::vector<double> mean_;  // the recorded mean motion, in coefficients of the block's modes
  DyadicList closing_;        // dm: displacements at the normals of U and where held, else zero
  ApproximateList motion_;    // G a, added to all displacements
  DyadicList load_forces_;    // of the load, dm
  Dyadic load_error_;         // bound of the norm of their error
  DyadicList forces_;         // with those that close the gaps of U
  Dyadic force_error_;        // the same for these
  DyadicList right_;          // right-hand side: these forces and the tangential reactions
  DyadicList gaps_;           // u_n = -gap on U, m
  Rationals work_;            // of the load on the modes
};

}  // namespace kusabi::verify
