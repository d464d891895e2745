// State of the whole structure in a configuration, for the result file: (4) and (5) of the wedged
// paper.
#pragma once

#include <cstddef>
#include <span>

#include <nlohmann/json.hpp>

#include "run/wedged/whole_states.hpp"

namespace kusabi::run {

/// Configurations of a list, from the first, whose whole state is in the result file unless
/// `--whole` requests all: enough for pictures and tables, and a few MB for large structures.
constexpr std::size_t whole_unless_requested = 100;

class WholeStateJson {
 public:
  /// @param states must outlive it
  explicit WholeStateJson(const WholeStates& states) : states_(states) {}

  [[nodiscard]] const problems::Structure& structure() const { return states_.structure(); }

  /// Adds `all_displacements`, of the nodes in their order, and `support_reactions`, by the names
  /// of nodes, both in global axes; `axial_forces` if there are members, `utilisation` if a yield
  /// force is known for any, `stresses` and `von_mises` if there are elements, and `imbalance`.
  /// @param reactions of all candidates, dm
  /// @param displacements likewise
  void add_to(nlohmann::ordered_json& configuration, std::span<const double> reactions,
              std::span<const double> displacements) const;

 private:
  const WholeStates& states_;
};

}  // namespace kusabi::run
