// The cone solver of a wedged problem, in the plane or in space: every tree over its sign patterns
// has one.
//
// The compliance is scaled so that the mean diagonal of its normal part F_nn is 1: t compares
// reactions with displacements, so its size (not its sign) depends on the units.
//
// A node is solved in doubles first. Where they leave its sign open, or its value to fewer than
// three digits where that is asked for, the same program is solved again in long double precision
// and then in 104 bits, with an F that has as many digits (docs/theory/wedged.md, "More digits").
// All bounds hold for the F of the structure, whatever they were computed with.
#pragma once

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "problems/wedged/wedged_problem.hpp"
#include "solvers/conic/node_solver.hpp"
#include "solvers/conic/plain_solver.hpp"
#include "support/stop.hpp"

namespace kusabi::wedged {

/// Friction other than none: below, a cone is a needle, above, a half-space.
inline constexpr double least_friction = 1e-6;
inline constexpr double most_friction = 1e6;

/// Whether programs that doubles leave open are solved in more digits. These take minutes where
/// there are hundreds of candidates.
enum class Precision { escalating, doubles };

/// conic::NodeSolver of the problem's dimension, with conic::PlainSolver above it. What it says of
/// a node depends on the arguments alone, to the last bit. Allocates after construction only where
/// doubles do not suffice. Each rank has its own. The references hold until the next solve().
class ContactSolver {
 public:
  /// @param friction mu of each contact candidate, m numbers: 0 or 1e-6 to 1e6
  /// @throws std::invalid_argument if the sizes do not fit or a number is out of range
  ContactSolver(const problems::WedgedProblem& problem, std::span<const double> friction,
                conic::Tolerances tolerances, Precision precision = Precision::escalating);

  /// From now on whatever solves throws support::Stopped soon after an end is asked for.
  void end_when(const support::Stop& stop);

  /// From now on solve_with() has room for so many cuts.
  void make_room(int most_cuts);

  /// From the next solve() on, mu is this.
  void set_friction(std::span<const double> friction);

  /// The node's program with cuts, in doubles only: where it is marginal, more digits are for the
  /// one without. Solved to the end if `stop` says so.
  /// @pre room for so many cuts
  conic::ConicResult solve_with(std::span<const conic::Cut> cuts, const support::IndexSet& contact,
                                const support::IndexSet& separated, conic::StopEarly stop);
  /// w of the last such node, dm: what all multipliers together pull at reactions. Valid until the
  /// next call.
  [[nodiscard]] const Eigen::VectorXd& pull();
  /// What the left side of a cut of the last such node can be at most, see conic::NodeSolver.
  double most_of(std::size_t cut);
  /// Of the last such node, where multipliers() have taken in what the cuts say of u_n.
  [[nodiscard]] double cut_multiplier(std::size_t cut) const;

  /// Bounds the node with the candidates `contact` in U and `separated` in R. The candidates of
  /// `ignored` have neither a reaction nor a row: r = 0, and u_n is free.
  /// @throws std::invalid_argument if the sets overlap or name a candidate that does not exist
  conic::ConicResult solve(const support::IndexSet& contact, const support::IndexSet& separated,
                           conic::StopEarly stop, const support::IndexSet& ignored = {});

  /// Which candidates have a reaction, and which a gap, at a point of the relative interior of the
  /// solutions of a node whose t* is zero up to the tolerance:
  ///   X = {r : u_n = 0 on U, r = 0 on R, u_n >= 0, r in the friction cones, sum r_n = 1}.
  /// That point is then reaction() and displacement(); multipliers() are zero. Nothing if t* is
  /// not zero, if it cannot be told of each reaction and gap whether it vanishes, or if this asks
  /// for more digits than are allowed.
  std::optional<conic::RelativeInterior> relative_interior(const support::IndexSet& contact,
                                                           const support::IndexSet& separated,
                                                           const support::IndexSet& ignored = {});

  /// r, dm, of the rung that gave the better lower bound; see conic::NodeSolver.
  [[nodiscard]] const Eigen::VectorXd& reaction() const { return reaction_; }
  /// u = F r with the scaled F, dm; of a loose body with G alpha.
  [[nodiscard]] const Eigen::VectorXd& displacement() const { return displacement_; }
  /// y, m, and of a loose body beta of its p motions: w = sum_i y_i (row (n, i) of F) + G beta.
  [[nodiscard]] const Eigen::VectorXd& multipliers() const { return multipliers_; }
  /// Those of the motions: the last p of these.
  [[nodiscard]] auto motion_multipliers() const { return multipliers_.tail(motions_.count()); }
  /// alpha, p numbers: displacement() is F r + G alpha.
  [[nodiscard]] Eigen::VectorXd motion() const;

  [[nodiscard]] double normal_reaction(int candidate) const {
    return reaction()[normal(candidate)];
  }
  [[nodiscard]] double normal_displacement(int candidate) const {
    return displacement()[normal(candidate)];
  }
  /// u_n r_n: by how much the candidate violates complementarity.
  [[nodiscard]] double violation(int candidate) const {
    return normal_displacement(candidate) * normal_reaction(candidate);
  }

  /// How far the centre of the relaxation is from what either sign of a candidate would leave of it
  /// (conic::FaceDistances): by candidate, zero for those that have a sign. Nothing if the last
  /// node was not proved alive in doubles and left at that, and for loose bodies. The references
  /// above stay as they are.
  std::span<const conic::FaceDistances> face_distances();

  [[nodiscard]] int dimension() const { return dimension_; }
  /// m.
  [[nodiscard]] int candidates() const { return static_cast<int>(friction_.size()); }
  /// By what the compliance is divided, length/force.
  [[nodiscard]] double unit() const { return unit_; }
  /// Where the normal part of a candidate stands in r and u.
  [[nodiscard]] Eigen::Index normal(int candidate) const {
    return Eigen::Index{dimension_} * candidate;
  }

 private:
  template <class Real>
  using Rung =
      std::variant<std::monostate, conic::PlainSolver<2, Real>, conic::PlainSolver<3, Real>>;

  /// G, combined as the solvers want it, with the digits of Real.
  template <class Real>
  [[nodiscard]] conic::Motions<Real> motions() const;
  /// y and beta of the motions as they were given.
  template <class Vector>
  [[nodiscard]] Eigen::VectorXd given(const Vector& multipliers) const;
  /// The scaled F with the digits of Real, and its error.
  template <class Real>
  [[nodiscard]] Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> scaled_compliance() const;
  template <class Real>
  [[nodiscard]] double scaled_error() const;
  /// The rung, made when it is first climbed.
  template <class Real>
  Rung<Real>& made(Rung<Real>& rung);
  template <class Real>
  void climb(Rung<Real>& rung, int number, const support::IndexSet& contact,
             const support::IndexSet& separated, const support::IndexSet& ignored,
             conic::StopEarly stop, conic::ConicResult& answer);
  /// Which candidates move if these have reactions and no others.
  [[nodiscard]] support::IndexSet moved_by(const support::IndexSet& loaded) const;
  [[nodiscard]] bool is_open(const conic::ConicResult& answer, conic::StopEarly stop) const;
  [[nodiscard]] bool has_centre(const conic::ConicResult& answer, conic::StopEarly stop) const;

  int dimension_;
  double unit_;
  conic::Tolerances tolerances_;
  Precision precision_;
  support::Stop stop_;
  std::vector<double> friction_;
  Eigen::MatrixXd compliance_;                 // unscaled, like the next
  numbers::PreciseMatrix precise_compliance_;  // empty: the doubles are exact
  double compliance_error_, precise_error_;
  conic::Motions<numbers::Precise> motions_;  // combined
  std::variant<conic::NodeSolver<2>, conic::NodeSolver<3>> solver_;
  Rung<long double> long_rung_;
  Rung<numbers::Precise> precise_rung_;
  Eigen::VectorXd reaction_, displacement_, multipliers_;
  Eigen::VectorXd motion_;   // of the combined motions, those that lift
  bool has_centre_ = false;  // of the node that was solved last
};

}  // namespace kusabi::wedged
