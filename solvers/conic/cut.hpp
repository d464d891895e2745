// A further row of a node program: an inequality that holds for every wedged configuration below
// the node, though not for all of its relaxation (docs/theory/wedged.md, "Cuts").
#pragma once

namespace kusabi::conic {

/// share (sum_k r_nk) - displacement u_ni - reaction r_ni >= level t, of candidate i. A factor
/// common to all four changes nothing but the scale of its multiplier.
struct Cut {
  int candidate = 0;
  double share = 0;
  double displacement = 0;  ///< of the scaled u_ni
  double reaction = 0;
  double level = 0;  ///< > 0
};

}  // namespace kusabi::conic
