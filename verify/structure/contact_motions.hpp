// The motions without strain of bodies that nothing holds, as their contact candidates see them,
// exactly: docs/theory/proofs.md, "Loose bodies".
#pragma once

#include <cstddef>
#include <vector>

#include "verify/arithmetic/elimination.hpp"
#include "verify/arithmetic/exact.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// p independent motions. G, what the directions n, t1[, t2] of the candidates see of them, is
/// irrational, for the directions are unit vectors; before they are made so it is rational.
struct ContactMotions {
  std::size_t count = 0;        ///< p
  std::vector<Rationals> rows;  ///< l_k times row k of G, exactly; dm of p numbers each
  std::vector<Dyadic> lengths;  ///< near l_k > 0; dm
  Dyadic spread;                ///< every l_k is within this share of the number above

  /// Near G, to guess with: dm x p, row by row.
  [[nodiscard]] std::vector<double> nearest() const;
};

/// Numbers near to some that are not dyadic.
struct NearList {
  DyadicList values;
  Dyadic error;  ///< none is off by more
};

/// l_k times rational numbers, for all k: components along the directions of the candidates.
NearList times_lengths(const ContactMotions& motions, const Rationals& numbers);

/// What the candidates see of a motion, G a.
NearList seen_of(const ContactMotions& motions, const Rationals& coefficients);

/// What supports and springs leave, as bars and elements connect the nodes.
struct LooseMotions {
  ContactMotions seen;
  /// Springs, of stiffness 1, that would hold what no candidate sees. No reaction in equilibrium
  /// makes a force in them.
  std::vector<GroundSpring> unseen;
};
LooseMotions loose_motions(const Structure& structure);

/// Motions whose doubles are meant exactly. @param values dm x p, row by row
ContactMotions recorded_motions(const std::vector<double>& values, std::size_t count);

/// The motions of some displacements: those rows, without the columns that are zero in them.
ContactMotions part_of(const ContactMotions& motions, const std::vector<std::size_t>& rows);

}  // namespace kusabi::verify
