// Cut: an inequality added to a node program. It holds for every wedged configuration below the
// node, though not for all points of its relaxation (docs/theory/wedged.md, "Bounds and cuts").
#pragma once

namespace kusabi::conic {

/// share (sum_k r_nk) - displacement u_ni - reaction r_ni >= level t, of candidate i. A common
/// factor of all four changes only the scale of the multiplier.
struct Cut {
  int candidate = 0;
  double share = 0;
  double displacement = 0;  ///< coefficient of the scaled u_ni
  double reaction = 0;
  double level = 0;  ///< > 0
};

}  // namespace kusabi::conic
