// LeafProof: a configuration in the interior of the cone of a sign pattern, or a state under a load
// with these signs (docs/theory/proofs.md).
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
  // Makes the tangential reactions orthogonal to the sliding modes.
  [[nodiscard]] std::optional<std::string> balance_sliding(const std::vector<double>& room);
  // Adds the norms `lift_` and `correction_` of sliding modes that displace tangents of U.
  // @param rows products of the rows of G with these modes @return false if they are dependent
  [[nodiscard]] bool add_corrections(const std::vector<Rationals>& rows,
                                     const std::vector<std::size_t>& tangents,
                                     const std::vector<Rationals>& modes);
  // Upper bound of the norm of normal displacements on U.
  [[nodiscard]] Dyadic normal_size(const ApproximateList& displacements) const;
  // Bound of the error of the tangential reactions caused by the normal displacements of sliding
  // modes on U; nothing if it is too large. `pressures` is the norm of r_n.
  [[nodiscard]] std::optional<Dyadic> error_of_lift(const RegularisedStiffness& stiffness,
                                                    const ApproximateList& shift,
                                                    const Dyadic& pressures) const;
  [[nodiscard]] std::optional<std::string> check_feasible(const RegularisedStiffness& stiffness,
                                                          const DyadicList& u, const DyadicList& r,
                                                          const Dyadic& unknown) const;

  const BlockModel& model_;
  const ContactBlock& block_;
  const support::IndexSet& contact_;
  std::span<const double> numbers_;
  Grip* grip_;
  std::vector<std::size_t> unknowns_;  // all displacements except the normal ones of U
  DyadicList right_;                   // r at the unknowns, given for the tangents of U
  Dyadic right_error_;                 // bound of the error of r, as a vector
  std::vector<Rationals> sliding_;
  Dyadic lift_;               // norm of the matrix of their normal displacements on U
  Dyadic correction_;         // the same for tangential reactions with unit work on each mode
  std::vector<double> mean_;  // the recorded mean motion, in coefficients of the block's modes
  DyadicList tangential_;     // r of the tangents of U
  DyadicList forces_;         // of the load, with those that close the gaps of U; dm or none
  Dyadic force_error_;        // bound of the norm of their error
  DyadicList gaps_;           // u_n = -gap on U, m
  Rationals work_;            // of the load on the modes
};

}  // namespace kusabi::verify
