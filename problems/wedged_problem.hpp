// The wedged problem (WP), equation (6) of the paper, ready for the searches:
//
//   find (u, r):  K u = r,  u_n >= 0, r_n >= 0, u_n^T r_n = 0,  |r_ti| <= mu r_ni, i = 1, ..., m.
//
// This is the front door of the folder for everything that does not read files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "problems/structure.hpp"

namespace kusabi::problems {

/// Most contact candidates of a problem: a sign pattern is two sets of candidates, 64 bits each.
inline constexpr int most_contact_candidates = 64;

/// Bound on the largest entry of K F - I, and on the asymmetry of K and of F relative to their
/// largest entry. For a sound problem both are of the order of the condition of the whole stiffness
/// times 1e-16. Beyond 1e-6 the margins of the sign patterns would not be worth their digits.
inline constexpr double inverse_tolerance = 1e-6;

/// Least ratio of the smallest to the largest eigenvalue of K that counts as positive definite:
/// the eigenvalues carry rounding of about 1e-15 of the largest, for a hundred displacements.
inline constexpr double definite_tolerance = 1e-13;

/// (WP) without its friction coefficient.
struct WedgedProblem {
  std::string name;
  int dimension = 0;  ///< d: 2 or 3
  Units units;
  std::vector<std::string> contact_names;  ///< m names, in the order of the file
  std::vector<Eigen::MatrixXd> frames;     ///< m, each d x d: columns n, t1 and, in space, t2
  /// m, of the candidates relative to each other: the coefficient of a search times these is mu_i
  std::vector<double> friction;
  /// K of (6), dm x dm, force/length: candidate by candidate, each (n, t1[, t2]); exactly symmetric
  Eigen::MatrixXd stiffness;
  Eigen::MatrixXd compliance;  ///< F = K^-1, length/force, ordered as K; exactly symmetric
  int nodes = 0;               ///< of the structure, supported ones included
  int members = 0;             ///< of the structure
  int elements = 0;            ///< of the structure
  /// Hash of dimension, units, coordinates, members, EA, elements, supports, contact, friction and
  /// frames, in the order of the file. Names are not in it.
  std::uint64_t fingerprint = 0;
};

/// Whether all candidates have the same friction as the coefficient of a search.
bool uniform_friction(const WedgedProblem& problem);

/// The mean of the diagonal of F_nn, the normal block of the compliance: by it F is divided, so
/// that reactions and displacements can be compared (docs/theory.md, section 2). Length/force.
double mean_normal_compliance(const WedgedProblem& problem);

/// The fingerprint that the wedged problem of a structure has, without computing K and F.
std::uint64_t wedged_fingerprint(const Structure& structure);

/// Condenses a structure onto its contact candidates.
/// @throws InputError if `check_structure` does; if the structure is a mechanism (with the nodes
///         that move); if the stiffness is so ill-conditioned that K and F fail the bounds above
WedgedProblem wedged_problem(const Structure& structure);

}  // namespace kusabi::problems
