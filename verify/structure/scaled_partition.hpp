// K^0 in integers, partitioned into the displacements of the candidates and all others.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include <gmpxx.h>

#include "verify/arithmetic/exact.hpp"
#include "verify/structure/candidate_rows.hpp"

namespace kusabi::verify {

/// K is in multiples of 2^stiffness_grid.
inline constexpr long stiffness_grid = -300;

inline constexpr const char* too_ill_conditioned =
    "the stiffness is not proved to be positive definite: the structure is a mechanism, or too "
    "ill-conditioned for a factor in double precision";

/// An entry of a row, on the grid.
struct GridEntry {
  std::size_t column;
  mpz_class value;
};
/// Sparse rows.
using GridRows = std::vector<std::vector<GridEntry>>;

/// K^0, scaled by powers of two, rounded to the grid and partitioned as in equation (2).
struct PartitionedStiffness {
  std::size_t contact = 0;   ///< c
  std::size_t rest = 0;      ///< n
  GridRows contact_contact;  ///< by rows, as all parts; columns of N in the order of N
  GridRows rest_contact;
  GridRows rest_rest;
  Dyadic error_square;  ///< of the distance from the exact K^0, scaled alike, in the Frobenius norm
  long contact_scale = 0;  ///< displacements of C are multiplied by 2^this, forces divided
};

/// The partition; otherwise a sentence with the reason why there is none.
std::variant<PartitionedStiffness, std::string> scaled_partition(const CandidateRows& rows);

}  // namespace kusabi::verify
