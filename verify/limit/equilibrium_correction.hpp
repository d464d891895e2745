// Equilibrium correction: members with slack carry the equilibrium defect of rounded forces, about
// 1e-16 at a joint. docs/theory/proofs.md derives it.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "verify/arithmetic/exact.hpp"
#include "verify/limit/limit_truss.hpp"

namespace kusabi::verify {

/// The members of a truss: the columns of B and bounds of their errors.
struct MemberColumns {
  std::size_t displacements = 0;
  const std::vector<Sparse>& columns;
  const std::vector<Sparse>& errors;  ///< error bounds by member, rounded up; empty: exact
};

/// Forces t_i >= 0 such that for every motion u
///   sum_e defect_e |u_e| <= sum_i t_i |b_i'u|,
/// with t_i = 0 where the slack is zero. If no t_i exceeds the slack of its member, forces with
/// this defect prove the same bound as forces in equilibrium. Otherwise the reason why there are
/// none: no member with slack acts on a displacement with a defect.
/// @param slack of each member, >= 0, rounded down
/// @param defect of each displacement, >= 0, rounded up
std::variant<std::vector<double>, std::string> forces_against_defects(
    const MemberColumns& members, const std::vector<double>& slack,
    const std::vector<double>& defect);

/// Such forces for all defects that are nowhere larger than one, by all members with equal weights.
/// Multiples of them serve many states of a truss, where every member has slack. Empty: there are
/// none.
std::vector<double> forces_against_unit_defects(const MemberColumns& members);

/// A double close to the number and not below it. @pre value >= 0
double double_above(const Dyadic& value);

/// A double close to the number and not above it; zero if it is tiny. @pre value >= 0
double double_below(const Dyadic& value);

}  // namespace kusabi::verify
