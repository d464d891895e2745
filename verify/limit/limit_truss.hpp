// LimitTruss: the truss of a proof, with its loads and bounds of its rounding.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "verify/arithmetic/exact.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// Indices and numbers; all others are zero.
using Sparse = std::vector<std::pair<std::size_t, double>>;

/// A number within `error` of `value`.
struct Approximate {
  Dyadic value;
  Dyadic error;
};

/// Nonzero entries of a column of B.
using TrussColumn = std::vector<std::pair<std::size_t, Approximate>>;

/// Yield forces, one of each for each member.
struct Strengths {
  std::vector<double> tension;      ///< q^t
  std::vector<double> compression;  ///< q^c
};

/// Direction cosines are roots, enclosed with a hundred digits; loads are exact.
struct LimitTruss {
  std::vector<TrussColumn> columns;  ///< B, by member
  std::vector<Dyadic> dead;          ///< f_D
  std::vector<Dyadic> reference;     ///< f_R
  std::vector<Sparse> uncertain;     ///< T, by column
  std::vector<double> alpha;         ///< half-width of each column
  Strengths below, above;            ///< divided by the dynamic factor, rounded down and up
  std::vector<std::string> names;    ///< of the members

  /// Strengths above, those of lost members being zero.
  [[nodiscard]] Strengths remaining(const std::vector<std::size_t>& lost) const;

  [[nodiscard]] std::size_t displacements() const { return dead.size(); }
  [[nodiscard]] std::size_t members() const { return columns.size(); }
};

/// @param structure bars, with uncertain loads and their half-widths
/// @param sudden dynamic factor of a loss
/// @return nothing if a direction is undefined: a bar of length almost zero
std::optional<LimitTruss> limit_truss(const Structure& structure, double sudden = 1);

/// b'u of a member, with the nearest values of b.
Dyadic elongation_of(const TrussColumn& column, const std::vector<Dyadic>& motion);

}  // namespace kusabi::verify
