// Domes of any size under four uncertain loads, for measurements of limit analysis. The kinds are
// those of public examples: single-layer domes with an apex, domes with a lantern above an open eye,
// and double-layer domes.
#pragma once

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

enum class DomeKind {
  ring,          ///< an apex and rings, triangulated
  lantern,       ///< rings around an open eye, with a second ring below the first one
  double_layer,  ///< two layers of rings around an open eye, the lower one half a sector further
};

struct DomeSize {
  DomeKind kind = DomeKind::ring;
  int rings = 4;       ///< of the upper layer; the outermost one is supported
  int sectors = 16;    ///< nodes of a ring
  double radius = 15;  ///< of the outermost ring, m
  double rise = 5;     ///< of the apex above the outermost ring, m
};

/// Maximum number of rings and of sectors.
inline constexpr int max_rings = 100;
inline constexpr int max_sectors = 1000;

/// The upper nodes are on the paraboloid of this rise. Node k of ring r has the name "r.k"; ring 1 is
/// the innermost one. The apex is "c", the lower ring below a lantern "h.k", the lower layer "l<r>.k".
/// Each free node of the upper layer has the reference load -10 kN along z (snow) and the dead load
/// -1 kN. Four uncertain loads of half-width alpha: 0.3 kN a node along x ("wind x") and along y
/// ("wind y"), 0.3 kN upwards on the windward half ("suction"), and 0.3 kN downwards on the other
/// half ("drift"). Bars yield at 240 kN, in compression at 120 kN.
/// With rings 7 and sectors 30, a double-layer dome has 390 nodes and 1,410 bars.
/// @throws std::invalid_argument if there are fewer than 2 rings or 3 sectors, more than the maxima,
///         or a radius or rise that is not positive
Structure dome(const DomeSize& size);

}  // namespace kusabi::problems
