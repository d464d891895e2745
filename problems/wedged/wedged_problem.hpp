// The wedged problem (WP), equation (6) of the paper, ready for the searches:
//
//   find (u, r):  K u = r,  u_n >= 0, r_n >= 0, u_n^T r_n = 0,  |r_ti| <= mu r_ni, i = 1, ..., m.
//
// This is the front door of the folder for everything that does not read files.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"
#include "support/index_set.hpp"
#include "support/numbers/precise.hpp"
#include "support/stop.hpp"

namespace kusabi::problems {

/// Largest error of the precise F (EnclosedCompliance::error) that a problem is accepted with: the
/// doubles of K and F are then right to their last digit or so.
inline constexpr double largest_compliance_error = 1e-15;

/// A body that nothing holds, for people to read.
struct LooseBodyText {
  std::string node;     ///< the name of its first node
  int nodes = 0;        ///< how many it has
  std::string motions;  ///< "can move along x and y and turn"
};

/// (WP) without its friction coefficient.
struct WedgedProblem {
  std::string name;
  int dimension = 0;  ///< d: 2 or 3
  Units units;
  std::vector<std::string> contact_names;  ///< m names, in the order of the file
  std::vector<Eigen::MatrixXd> frames;     ///< m, each d x d: columns n, t1 and, in space, t2
  /// m, of the candidates relative to each other: the coefficient of a search times these is mu_i
  std::vector<double> friction;
  /// K of (6), dm x dm, force/length: candidate by candidate, each (n, t1[, t2]); exactly
  /// symmetric. Of loose bodies with their temporary springs (see `motions`): the inverse of F,
  /// definite.
  Eigen::MatrixXd stiffness;
  Eigen::MatrixXd compliance;  ///< F = K^-1, length/force, ordered as K; exactly symmetric
  /// The candidates in blocks that nothing connects (contact_blocks.hpp): bit sets, a partition of
  /// all. K and F are zero between two blocks. Empty: not known, one block.
  std::vector<support::IndexSet> blocks;
  /// |F - F*|_ij <= compliance_error sqrt(F*_ii F*_jj), F* the compliance of the structure with its
  /// numbers meant exactly. The same bound holds for the rows and columns of a subset of the
  /// candidates.
  double compliance_error = 0;
  /// F with 104 bits, of which K and F above are the roundings; empty if the problem was made
  /// without a structure: its doubles then count as exact.
  numbers::PreciseMatrix precise_compliance;
  double precise_error = 0;  ///< the like of compliance_error for precise_compliance
  /// All free displacements under unit reactions, f x dm (EnclosedCompliance::response): of the
  /// whole structure, and shared with the problems of its blocks; null if there was no structure.
  std::shared_ptr<const numbers::PreciseMatrix> response;
  /// Bodies that nothing holds: G, dm x p, the motions without strain as the candidates see them,
  /// ordered as K, each column scaled to a largest entry near 1. Then K is only positive
  /// semidefinite, K G = 0; reactions are in equilibrium, G'r = 0, and u = F r + G alpha, where F
  /// is that of the structure held by temporary springs (docs/theory/wedged.md, "Loose bodies"). No
  /// columns: the supports hold everything.
  Eigen::MatrixXd motions;
  numbers::PreciseMatrix precise_motions;  ///< of which `motions` are the roundings; or empty
  /// What an entry of `motions` and of `precise_motions` may be wrong by.
  double motion_error = 0;
  double precise_motion_error = 0;
  std::vector<LooseBodyText> loose_bodies;  ///< in the order of their first nodes
  int nodes = 0;                            ///< of the structure, supported ones included
  int members = 0;                          ///< of the structure
  int elements = 0;                         ///< of the structure
  /// Hash of dimension, units, coordinates, members, EA, elements, supports, springs, contact,
  /// friction and frames, in the order of the file. Names are not in it.
  std::uint64_t fingerprint = 0;
};

/// Whether all candidates have the same friction as the coefficient of a search.
bool uniform_friction(const WedgedProblem& problem);

/// The mean of the diagonal of F_nn, the normal block of the compliance: by it F is divided, so
/// that reactions and displacements can be compared (docs/theory/wedged.md, "F and its error").
/// Length/force.
double mean_normal_compliance(const WedgedProblem& problem);

/// The fingerprint that the wedged problem of a structure has, without computing K and F.
std::uint64_t wedged_fingerprint(const Structure& structure);

/// Condenses a structure onto its contact candidates.
/// @throws InputError if `check_structure` does; if the structure is a mechanism (with the nodes
///         that move); if a loose body has no contact candidate, or it can't be told how it is
///         held; if the stiffness is so ill-conditioned that F fails the bound above
/// @throws support::Stopped if an end is asked for
WedgedProblem wedged_problem(const Structure& structure, const support::LongWork& work = {});

}  // namespace kusabi::problems
