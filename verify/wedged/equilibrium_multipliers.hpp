// EquilibriumMultipliers: the multipliers of an infeasible node of an unconstrained body, changed
// by as little as possible so that forces of these sizes along the normals are in equilibrium.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "support/index_set.hpp"
#include "verify/wedged/block_model.hpp"

namespace kusabi::verify {

/// Forces along the normals; where u_n >= 0 they are not below the coefficients of the
/// inequalities.
struct Multipliers {
  ApproximateList near;
  Dyadic carried;  ///< norm of the spring forces that would bring them into equilibrium
};

class EquilibriumMultipliers {
 public:
  /// @param contact U
  /// @param multipliers y, m
  /// @param shares coefficients of u_n in the inequalities besides the multipliers, m
  /// @pre all arguments outlive this object
  EquilibriumMultipliers(const BlockModel& model, const support::IndexSet& contact,
                         std::span<const double> multipliers, std::span<const Dyadic> shares)
      : model_(model),
        block_(model.block()),
        contact_(contact),
        multipliers_(multipliers),
        shares_(shares) {}

  /// Multipliers exactly in equilibrium; nothing if there are none.
  /// @param small multipliers below this share of the largest are zero
  /// @param raised share of the largest by which nonnegative multipliers may be raised
  [[nodiscard]] std::optional<Multipliers> exact(double small, double raised) const;
  /// Multipliers in equilibrium up to rounding.
  [[nodiscard]] std::optional<Multipliers> nearly(double small) const;

 private:
  // Recorded multipliers divided by the lengths of normals, the rows of the normals, lower bounds
  // of the multipliers, and the unit of change of each.
  struct Recorded {
    std::vector<Rationals> rows;
    Rationals forces;
    Rationals minimum;  // where u_n >= 0
    std::vector<double> room;
  };
  [[nodiscard]] Recorded recorded_forces(double small, double raised) const;
  [[nodiscard]] mpq_class min_force(std::size_t k) const;
  [[nodiscard]] std::optional<Dyadic> carried_by_springs(const std::vector<Rationals>& rows,
                                                         const Rationals& forces) const;
  [[nodiscard]] ApproximateList along_normals(const Rationals& forces) const;

  const BlockModel& model_;
  const ContactBlock& block_;
  const support::IndexSet& contact_;
  std::span<const double> multipliers_;
  std::span<const Dyadic> shares_;
};

}  // namespace kusabi::verify
