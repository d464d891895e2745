// A wedged configuration as a grid of VTK: the whole structure with what moves, what presses and
// who touches.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "nodes/wedged/tree/sign_pattern.hpp"
#include "pictures/vtu/structure_grid.hpp"
#include "run/wedged/whole_states.hpp"

namespace kusabi::run {

class ConfigurationGrids {
 public:
  /// @param states must outlive it
  explicit ConfigurationGrids(const WholeStates& states)
      : states_(states), structure_(pictures::structure_grid(states.structure())) {}

  /// The structure with, at its points, `displacement`, `contact_reaction` (of the obstacle; of two
  /// bodies on each), `support_reaction`, all in global axes, and `state`; at its members
  /// `axial_force` and, if a yield force is known of any, `utilisation`; at its elements `stress`
  /// (xx, yy, zz, xy, yz, xz) and `von_mises`.
  /// @param remark what it is, for the head of the file
  /// @param reactions of all candidates, dm, in their frames
  /// @param displacements likewise
  /// @param contact one a candidate
  [[nodiscard]] pictures::UnstructuredGrid grid(
      const std::string& remark, std::span<const double> reactions,
      std::span<const double> displacements, std::span<const pictures::ContactState> contact) const;

  /// Of one block: its candidates as the pattern has them, and those that are idle.
  [[nodiscard]] pictures::UnstructuredGrid grid(const std::string& remark, std::uint32_t block,
                                                const wedged::SignPattern& pattern,
                                                const support::IndexSet& idle,
                                                std::span<const double> reactions,
                                                std::span<const double> displacements) const;

 private:
  const WholeStates& states_;
  pictures::UnstructuredGrid structure_;
};

}  // namespace kusabi::run
