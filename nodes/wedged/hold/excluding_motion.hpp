// The motion by which statics alone excludes a load: rigid bodies move such that each contact opens
// at least mu times as fast as it slides, and the load does work. Then no reaction within the friction
// cones resists, and none balances the load, whatever the stiffness (docs/theory/loads.md, "Why a
// load cannot be held").
#pragma once

#include <cstdint>
#include <optional>

#include "nodes/wedged/hold/load_program.hpp"
#include "problems/structure/checks/checked_structure.hpp"
#include "problems/wedged/body_motion.hpp"
#include "support/index_set.hpp"
#include "support/stop.hpp"

namespace kusabi::wedged {

/// A load that cannot be held, just beyond an answer.
struct ExcludedLoad {
  enum class Side : std::int8_t {
    less_friction,  ///< the dead load below the smallest coefficient
    less,           ///< below the smallest factor that is held
    more,           ///< above the largest factor
    alone,          ///< nothing is held: the dead load alone
  };
  double friction = 0;  ///< coefficient of the call, or the largest one that does not hold it
  LoadShare share{};
  Side side = Side::alone;
};

struct ExcludingMotion {
  ExcludedLoad load{};
  problems::BodyMotion bodies{};
  support::IndexSet sliding{};  ///< candidates with friction that open only as sliding demands
  support::IndexSet opening{};  ///< candidates that open faster
  bool opens_all = false;       ///< all of the subproblem do
};

/// The motion, in floating point: in the plane the one on which the candidates open least. Nothing if
/// there is none, if that is numerically undecided, or if the load also moves a body where no candidate
/// resists. In space there is none either for more than 200 candidates, and where no motion has a margin
/// at every candidate, as if reactions within the friction cones balance each other.
/// @param whole of the structure, in its load case
std::optional<ExcludingMotion> excluding_motion(const problems::CheckedStructure& structure,
                                                const LoadedProblem& whole, ExcludedLoad load,
                                                const support::Stop& stop = {});

}  // namespace kusabi::wedged
