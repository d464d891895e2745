// The buckling resistance of a bar in compression by EN 1993-1-1, 6.3.1.
#pragma once

#include <optional>
#include <string_view>

namespace kusabi::problems {

/// The imperfection factor of a buckling curve, "a0", "a", "b", "c" or "d" (table 6.1); nothing: no
/// curve has this name.
std::optional<double> imperfection_factor(std::string_view curve);

/// A bar of constant cross-section, of class 1 to 3; all numbers are positive, in consistent units.
struct CompressedBar {
  double modulus;       ///< E
  double area;          ///< A
  double yield_stress;  ///< f_y
  double radius;        ///< i, of gyration, about the axis of buckling
  double length;        ///< L_cr, the buckling length
  double imperfection;  ///< alpha
  double partial = 1;   ///< gamma_M1
};

/// N_b,Rd = chi A f_y / gamma_M1 (6.47) with chi by (6.49), rounded so that it is never above.
double buckling_resistance(const CompressedBar& bar);

}  // namespace kusabi::problems
