// Wedged problem (WP), equation (6) of the paper, as the input of the searches:
//
//   find (u, r):  K u = r,  u_n >= 0, r_n >= 0, u_n^T r_n = 0,  |r_ti| <= mu r_ni, i = 1, ..., m.
//
// This is the main interface of the folder.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "problems/structure/checks/checked_structure.hpp"
#include "problems/structure/model/structure.hpp"
#include "support/index_set.hpp"
#include "support/numbers/precise.hpp"
#include "support/stop.hpp"

namespace kusabi::problems {

/// Maximum error of the precise F (EnclosedCompliance::error): the doubles of K and F are then
/// accurate to about their last digit.
inline constexpr double largest_compliance_error = 1e-15;

/// Description of an unconstrained body.
struct UnconstrainedBodyText {
  std::string node;     ///< the name of its first node
  int nodes = 0;        ///< number of its nodes
  std::string motions;  ///< "can move along x and y and turn"
};

/// Stiffness and compliance of the contact candidates, (6), with the errors of the compliance. By
/// candidates, each (n, t1[, t2]).
struct Compliance {
  /// K of (6), dm x dm, or no rows if dm > 600: see free_stiffness(). Force/length; symmetric. With
  /// unconstrained bodies it includes grounding springs (see `RigidModes`), and is definite.
  Eigen::MatrixXd stiffness;
  Eigen::MatrixXd matrix;  ///< F = K^-1, dm x dm, length/force; exactly symmetric
  /// |F - F*|_ij <= error sqrt(F*_ii F*_jj), where F* is the compliance of the structure with exact
  /// numbers. The bound also holds for the rows and columns of any subset of the candidates.
  double error = 0;
  /// F in 104 bits, of which K and F above are roundings; empty if the problem was made without a
  /// structure: its doubles then count as exact.
  numbers::PreciseMatrix precise;
  double precise_error = 0;  ///< the same bound for `precise`
  /// All free displacements under unit reactions, f x dm, length/force
  /// (EnclosedCompliance::response), of the whole structure and shared with the problems of its
  /// blocks; null without a structure.
  std::shared_ptr<const numbers::PreciseMatrix> response;
};

/// Rigid-body modes of unconstrained bodies (docs/theory/wedged.md, "Unconstrained bodies"). K is
/// then only positive semidefinite, K G = 0; reactions are in equilibrium, G'r = 0, and u = F r + G
/// alpha, where F is that of the structure with grounding springs.
struct RigidModes {
  /// G, dm x p, restricted to contact degrees of freedom, ordered as K, each column scaled to a
  /// largest entry near 1. No columns: all bodies are constrained.
  Eigen::MatrixXd matrix;
  numbers::PreciseMatrix precise;             ///< of which `matrix` is the rounding; or empty
  double error = 0;                           ///< bound of the error of an entry of `matrix`
  double precise_error = 0;                   ///< the same for `precise`
  std::vector<UnconstrainedBodyText> bodies;  ///< in the order of their first nodes
};

/// The structure of which a problem is made: names and numbers for answers.
struct Provenance {
  std::string name;
  Units units;
  int nodes = 0;  ///< including supported ones
  int members = 0;
  int elements = 0;
  /// Hash of dimension, units, coordinates, members, EA, elements, supports, springs, contact,
  /// friction and frames, in the order of the file, without names.
  std::uint64_t fingerprint = 0;
};

/// (WP) without its friction coefficient.
struct WedgedProblem {
  Provenance provenance;
  int dimension = 0;                       ///< d: 2 or 3
  std::vector<std::string> contact_names;  ///< m names, in the order of the file
  std::vector<Eigen::MatrixXd> frames;     ///< m, each d x d: columns n, t1 and, in space, t2
  /// m, relative friction of the candidates: mu_i is the coefficient of a search times this
  std::vector<double> friction;
  Compliance compliance;
  RigidModes modes;
  /// Decoupled blocks of candidates (contact_blocks.hpp): bit sets, a partition of all. K and F are
  /// zero between blocks. Empty: unknown, a single block.
  std::vector<support::IndexSet> blocks;
};

/// True if all candidates have relative friction one.
bool uniform_friction(const WedgedProblem& problem);

/// The mean of the diagonal of F_nn, the normal block of the compliance. F is divided by it, such
/// that reactions and displacements have comparable sizes (docs/theory/wedged.md, "F and its
/// error"). Length/force.
double mean_normal_compliance(const WedgedProblem& problem);

/// Unit of displacements per reaction in margins, length/force: the same mean of P F P, where P
/// projects orthogonally to the rigid-body modes. Reactions in equilibrium are in the range of P,
/// so it does not depend on the grounding springs in F, nor on axes and order of the file. It is
/// the mean of F_nn if the modes leave nothing of it; then no normal reactions are in equilibrium.
double margin_unit(const WedgedProblem& problem);

/// The fingerprint of the wedged problem of a structure, without computing K and F.
std::uint64_t wedged_fingerprint(const Structure& structure);

/// Loads condensed onto the contact candidates (docs/theory/loads.md); L columns.
struct LoadColumns {
  numbers::PreciseMatrix displacements;  ///< w, dm x L: those of the candidates under each load
  numbers::PreciseMatrix work;           ///< f_j'K^-1 f_k, L x L
  /// b, L x p: the work of each load on the rigid-body modes `RigidModes::matrix`, and on those
  /// that displace no candidate.
  numbers::PreciseMatrix motions, other_modes;
  Eigen::VectorXd sizes;  ///< sum of |f|, force
};

/// Condenses a structure onto its contact candidates.
/// @throws InputError if there are no candidates; if the structure is a mechanism (with the nodes
///         that move); if an unconstrained body has no contact candidate, or its modes are
///         numerically undecided; if the stiffness is so ill-conditioned that F fails the bound
///         above
/// @throws support::Stopped if the program is asked to stop
WedgedProblem wedged_problem(const CheckedStructure& structure, const support::LongWork& work = {});

/// The same, with loads.
/// @param forces on the nodes, d nodes x L, node by node; none of the loads acts on supported
///   displacements alone
/// @param loads receives their columns
WedgedProblem wedged_problem(const CheckedStructure& structure, const Eigen::MatrixXd& forces,
                             LoadColumns& loads, const support::LongWork& work = {});

}  // namespace kusabi::problems
