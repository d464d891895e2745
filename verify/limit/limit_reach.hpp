// What it takes to put forces right that are not quite in equilibrium: a defect of 1e-16 at a joint
// is carried off by members that have a little slack. docs/theory/proofs.md derives it.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "verify/arithmetic/exact.hpp"
#include "verify/limit/limit_certificate.hpp"

namespace kusabi::verify {

/// Places and the numbers there, exactly.
using SparseDyadic = std::vector<std::pair<std::size_t, Dyadic>>;

/// The members of a truss: B by columns, and how far it may be from the true one.
struct MemberColumns {
  std::size_t displacements = 0;
  const std::vector<Sparse>& columns;
  const std::vector<SparseDyadic>& errors;  ///< bounds of them, by member; empty: none
};

/// Forces t_i >= 0 such that for every motion u
///   sum_e defect_e |u_e| <= sum_i t_i |b_i'u|,
/// with t_i = 0 where the slack is zero: if t_i is no more than the slack of each member, any
/// forces with such a defect prove what forces in equilibrium would. Or why none were found: a
/// displacement with a defect that no member with slack reaches.
/// @param slack what each member has left, >= 0, rounded down
/// @param defect of each displacement, >= 0, rounded up
std::variant<std::vector<double>, std::string> forces_against_defects(
    const MemberColumns& members, const std::vector<double>& slack,
    const std::vector<double>& defect);

/// A double that is not below the number, and little above. @pre value >= 0
double double_above(const Dyadic& value);

/// A double that is not above the number, zero if it is tiny. @pre value >= 0
double double_below(const Dyadic& value);

}  // namespace kusabi::verify
