// Certificates with bounds of a problem solved by hand.
#pragma once

#include <string>
#include <vector>

#include "searched.hpp"

namespace kusabi::verify {

/// Text of numbers as " 0x1p+0 …\n".
std::string numbers(const std::vector<double>& list);

/// Two candidates a and b with
///
///   u_na = r_na - r_tb,   u_nb = r_nb + r_tb,   u_tb = r_nb - r_na + 3 r_tb,
///
/// all other tangents being springs of stiffness 1. In contact a has r_na = r_tb, so u_nb >= r_nb;
/// one of them is zero, and so all is. b in contact has r_tb = -r_nb, and opens a by r_nb: a
/// pattern if mu > 1, which is proved by means of three bounds.
Draft two_candidates(double mu, int dimension = 2);

}  // namespace kusabi::verify
