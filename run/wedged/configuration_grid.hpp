// Wedged configuration as a VTK grid: the whole structure with displacements, reactions and contact
// states.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "pictures/vtu/structure_grid.hpp"
#include "run/wedged/whole_states.hpp"

namespace kusabi::run {

/// The answer to which a configuration belongs.
struct GridFacts {
  std::string remark;              ///< text in the head of the file
  std::optional<double> friction;  ///< coefficient of the search
  std::optional<double> margin{};  ///< t*
};

class ConfigurationGrids {
 public:
  /// @param states must outlive it
  explicit ConfigurationGrids(const WholeStates& states)
      : states_(states), structure_(pictures::structure_grid(states.structure())) {}

  /// The structure with point data `displacement`, `contact_reaction` (of the obstacle; for two
  /// bodies on both), `support_reaction`, all in global axes, `state`, `gap` (u_n of separated
  /// candidates) and, if a friction coefficient is known, `friction_use`, |r_t|/(mu r_n); field
  /// data `mu` and `margin`, units as VTK's UNITS_LABEL; cell data of members `axial_force` and, if
  /// a yield force is known for any, `utilisation`; of elements `stress` (xx, yy, zz, xy, yz, xz)
  /// and `von_mises`.
  /// @param reactions of all candidates, dm, in their frames
  /// @param displacements likewise
  /// @param contact one per candidate
  [[nodiscard]] pictures::UnstructuredGrid grid(
      const GridFacts& facts, std::span<const double> reactions,
      std::span<const double> displacements, std::span<const pictures::ContactState> contact) const;

  /// Configuration of one block; candidates of other blocks are inactive.
  [[nodiscard]] pictures::UnstructuredGrid grid(const GridFacts& facts, std::uint32_t block,
                                                const wedged::SignPattern& pattern,
                                                const support::IndexSet& inactive,
                                                std::span<const double> reactions,
                                                std::span<const double> displacements) const;

 private:
  const WholeStates& states_;
  pictures::UnstructuredGrid structure_;
};

}  // namespace kusabi::run
