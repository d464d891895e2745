// Rigid-body modes of unconstrained bodies, restricted to contact degrees of freedom, in exact
// arithmetic (docs/theory/proofs.md, "Unconstrained bodies").
#pragma once

#include <cstddef>
#include <vector>

#include "verify/arithmetic/elimination.hpp"
#include "verify/arithmetic/exact.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// p independent rigid-body modes. G, their components along the unit vectors n, t1[, t2] of the
/// candidates, is irrational; before normalisation of the directions it is rational.
struct ContactMotions {
  std::size_t count = 0;        ///< p
  std::vector<Rationals> rows;  ///< l_k times row k of G, exactly; dm rows of p numbers
  std::vector<Dyadic> lengths;  ///< l_k > 0, rounded; dm
  Dyadic spread;                ///< bound of the relative error of each l_k
  std::vector<int>
      shifts{};  ///< p: column k was multiplied by 2^shifts[k]; empty for recorded_motions()

  /// G rounded to doubles, for approximate solutions: dm x p, by rows.
  [[nodiscard]] std::vector<double> nearest() const;
};

/// Dyadic approximations of numbers.
struct ApproximateList {
  DyadicList values;
  Dyadic error;  ///< bound of the error of each
};

/// l_k times rational numbers, for all k: components along the directions of the candidates.
ApproximateList times_lengths(const ContactMotions& motions, const Rationals& numbers);

/// G a: a rigid-body mode restricted to contact degrees of freedom.
ApproximateList restricted_to_candidates(const ContactMotions& motions,
                                         const Rationals& coefficients);

/// Rigid-body modes that supports, springs and constraints admit.
struct UnconstrainedModes {
  ContactMotions of_candidates;
  /// Grounding springs of stiffness 1 for modes that displace no candidate. Contact reactions in
  /// equilibrium cause no force in them.
  std::vector<GroundSpring> others;
};

UnconstrainedModes unconstrained_modes(const Structure& structure);

/// Z'f of a load: its work on the modes of `of_candidates`, and on those that displace no
/// candidate.
struct LoadWork {
  Rationals of_candidates;
  Rationals others;
  /// The same with the magnitudes of forces and displacements.
  std::vector<double> sizes_of_others;

  /// True if it is not zero on some mode that displaces no candidate: no reaction balances it.
  [[nodiscard]] bool is_unbalanced() const;
};

/// Exact work of loads on all modes. @param seen those of unconstrained_modes()
std::vector<LoadWork> works_of(const Structure& structure, const ContactMotions& seen,
                               const std::vector<std::vector<Force>>& loads);

/// Rigid-body modes given by doubles, which are taken as exact. @param values dm x p, by rows
ContactMotions recorded_motions(const std::vector<double>& values, std::size_t count);

/// The modes that are not zero at some displacements.
std::vector<std::size_t> columns_of(const ContactMotions& motions,
                                    const std::vector<std::size_t>& rows);

/// Restriction of the modes to some displacements: their rows, without columns that are zero there.
ContactMotions part_of(const ContactMotions& motions, const std::vector<std::size_t>& rows);

}  // namespace kusabi::verify
