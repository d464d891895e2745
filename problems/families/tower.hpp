// Braced square towers of any size under four uncertain loads, for measurements of limit analysis.
#pragma once

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

struct TowerSize {
  int storeys = 10;
  double height = 3;  ///< of a storey, m
  double base = 6;    ///< width at the supports, m
  double top = 2;     ///< width at the top, m
};

/// Maximum number of storeys.
inline constexpr int max_storeys = 1000;

/// A tower with four legs, crossed diagonals in each face, and a horizontal bar in each face and a
/// diagonal in each floor. Node k = 0 ... 3 of floor s, counted from the supports, has the name
/// "s.k". The reference load is 1 kN along x at each node of the top; the dead load is -2 kN along z
/// at each free node. Four uncertain loads of half-width alpha: at each free node "wind x" and "wind
/// y", from 0.05 kN at the supports to 0.2 kN at the top, and -0.3 kN along z ("ice"); and -4 kN along
/// z at two nodes of the top ("crane"). Legs yield at 200 kN and 10 kN more for each storey above
/// them, other bars at 60 kN, in compression at half of this.
/// @throws std::invalid_argument if the size is not positive or there are too many storeys
Structure tower(const TowerSize& size);

}  // namespace kusabi::problems
