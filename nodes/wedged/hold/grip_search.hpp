// Grip range: the least and the largest sum of the normal reactions over all states under the dead
// load at one friction coefficient (docs/theory/loads.md, "Sum of the normal reactions"). It
// contains the sum of every state that a history of loading leads to.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/hold/hold_search.hpp"

namespace kusabi::wedged {

/// An end of the range. There is a state with `held`, and none beyond `out`.
struct GripEnd {
  support::Bound held{};
  support::Bound out{};
  bool known = true;       ///< false: `held` is not known, and of a maximum `out` neither
  bool unbounded = false;  ///< no end: a wedged configuration may be added in any multiple
  std::optional<LoadedPattern> pattern{};  ///< of the block, at `held`
};

/// The range of one block.
struct GripOfBlock {
  std::uint32_t block = 0;
  GripEnd minimum{}, maximum{};  ///< of both: zero, proved, if nothing presses on the block
};

/// The range of the sum over all candidates.
struct GripRange {
  engine::Status status = engine::Status::solved;
  bool held = true;  ///< false: there is no state
  support::Standing
      standing{};  ///< of `held`; computed: it is not decided whether there is a state
  GripEnd minimum{}, maximum{};
  std::vector<GripOfBlock> blocks{};  ///< those on which a load acts or that can be wedged
  std::vector<HoldCost> costs{};
};

/// Range of the sum of the normal reactions under the dead load at one coefficient. Every rank
/// makes the same call and gets the same result. At a limit `status` names it, and the result has
/// what is known.
/// @param mu friction coefficient, which multiplies the own one of each candidate
/// @param record of the certificate, or null
GripRange grip_range(engine::Analysis& analysis, const LoadedProblem& loaded, double mu,
                     const HoldParameters& parameters = {}, HoldRecord* record = nullptr);

}  // namespace kusabi::wedged
