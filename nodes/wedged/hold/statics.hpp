// Statics alone: reactions within the friction cones that balance the loads on the rigid-body modes,
// whatever the stiffness. Each state under load has such reactions, so that nothing is held beyond
// the ends of statics; where the bodies are statically determined they are the ends themselves
// (docs/theory/loads.md). In the plane they are optima of linear programs, which take far less time
// than one node program. They are no proof: bisections of node programs begin beside them.
#pragma once

#include <optional>

#include "nodes/wedged/hold/load_program.hpp"
#include "support/stop.hpp"

namespace kusabi::wedged {

/// The ends of the factors of the reference load that statics finds; infinite: there is none.
struct StaticRange {
  double low = 0, high = 0;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& low& high;
  }
};

/// Nothing in space, without a reference load that moves a body, or if the programs have no
/// numerical answer. @param total of the normal reactions, if it is given
std::optional<StaticRange> static_range(const LoadedProblem& block, double mu,
                                        std::optional<double> total = {},
                                        const support::Stop& stop = {});

/// The smallest friction coefficient at which statics balances the dead load. Nothing in space, or if
/// statics does so at `low` or does not at `high`.
std::optional<double> static_friction(const LoadedProblem& block, double low, double high,
                                      const support::Stop& stop = {});

/// Coefficients of the rigid-body modes of a motion on which the load does positive work while each
/// candidate opens at least mu times as fast as it slides, so that no reaction within the friction
/// cones does negative work (Farkas): the one whose candidates open least. Nothing in space, if
/// statics balances the load, or if the program has no numerical answer.
/// @param load its works on the modes
std::optional<Eigen::VectorXd> static_motion(const LoadedProblem& block,
                                             const Eigen::VectorXd& load, double mu,
                                             const support::Stop& stop = {});

}  // namespace kusabi::wedged
