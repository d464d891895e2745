// Stress states that carry every admissible load, in exact arithmetic.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <gmpxx.h>

#include "support/stop.hpp"
#include "verify/limit/exact_truss.hpp"
#include "verify/limit/truss_certificate.hpp"

namespace kusabi::verify {

/// An exact state near a recorded one.
struct CarriedFactor {
  mpq_class factor;                  ///< the least over all admissible loads
  std::vector<std::size_t> members;  ///< with forces, ascending
};

/// Limits of an elimination, which has no result beyond them.
struct EliminationLimits {
  support::Stop stop = {};
  /// Of the products of words in multiplications: the time depends on the sizes of numbers.
  std::uint64_t products = std::numeric_limits<std::uint64_t>::max();
};

/// A load factor that the members of the support carry under every admissible load: forces close to
/// those of the state are in exact equilibrium and within the yield forces. Nothing if there are
/// none. Forces of members outside the support are left out.
/// @pre indices are in range, forces are finite
std::optional<CarriedFactor> carried_factor(const ExactTruss& truss, const StressState& state,
                                            const EliminationLimits& limits = {});

}  // namespace kusabi::verify
