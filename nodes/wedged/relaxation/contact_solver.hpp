// Cone solver of a wedged problem, in the plane or in space, for trees of sign patterns.
//
// The compliance is divided by problems::margin_unit, with loads by the mean diagonal of its normal
// part: t compares reactions with displacements, so its size (not its sign) depends on the unit.
//
// A node is solved in doubles first. If its sign is undecided, or its value has fewer than three
// digits where that is required, the point is examined, and then the iteration goes on, in long double
// precision and in 104 bits, with an F of the same precision (docs/theory/wedged.md, "Precision
// levels"). All bounds hold for the F of the structure at any precision level.
#pragma once

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "problems/wedged/wedged_problem.hpp"
#include "solvers/conic/node_solver.hpp"
#include "support/stop.hpp"

namespace kusabi::wedged {

/// Positive friction: below this a friction cone is extremely narrow, above the maximum it is
/// almost a half-space.
inline constexpr double min_friction = 1e-6;
inline constexpr double max_friction = 1e6;

/// Escalation of programs undecided in doubles to higher precision levels, which take minutes
/// for hundreds of candidates.
enum class Precision { escalating, doubles };

/// conic::NodeSolver of the problem's dimension, with one for each higher precision level. The
/// result for a node depends on the arguments alone, to the last bit. No allocation
/// after construction except for escalation and rigid-body modes. Each rank has its own. References are valid until
/// the next solve().
class ContactSolver {
 public:
  /// @param friction mu of each contact candidate, m numbers: 0 or 1e-6 to 1e6
  /// @param loads number of loads: the last candidates of the problem, with zero friction, which
  ///        have a reaction and no row (nodes/wedged/hold/load_program.hpp)
  /// @param equation of the last column of the modes
  /// @throws std::invalid_argument if the sizes do not fit or a number is out of range
  ContactSolver(const problems::WedgedProblem& problem, std::span<const double> friction,
                conic::Tolerances tolerances, Precision precision = Precision::escalating,
                int loads = 0, conic::SideEquation equation = conic::SideEquation::none);

  /// Makes all solutions throw support::Stopped soon after the run is to stop.
  void end_when(const support::Stop& stop);

  /// Allocates memory for this many cuts in solve_with().
  void make_room(int max_cuts);

  /// Sets mu for the following calls of solve().
  void set_friction(std::span<const double> friction);

  /// The node's program with cuts, in doubles only: if it is undecided, the program without cuts is
  /// to be escalated instead. `stop` as for conic::NodeSolver::solve.
  /// @pre memory for this many cuts
  conic::ConicResult solve_with(std::span<const conic::Cut> cuts, const support::IndexSet& contact,
                                const support::IndexSet& separated, conic::StopEarly stop);
  /// w of the last such node, dm: the displacements of all multipliers together. Valid until the
  /// next call.
  [[nodiscard]] const Eigen::VectorXd& pull();
  /// Maximum of the left side of a cut at the last such node, see conic::NodeSolver.
  double max_of(std::size_t cut);
  /// Multiplier of a cut at the last such node. The terms of the cuts in u_n are part of
  /// multipliers().
  [[nodiscard]] double cut_multiplier(std::size_t cut) const;

  /// Bounds the node with the candidates `contact` in U and `separated` in R. The candidates of
  /// `ignored` have neither a reaction nor a row: r = 0, and u_n is free.
  /// @throws std::invalid_argument if the sets overlap or name a candidate that does not exist
  conic::ConicResult solve(const support::IndexSet& contact, const support::IndexSet& separated,
                           conic::StopEarly stop, const support::IndexSet& ignored = {});

  /// The candidates with a reaction and those with a gap, at a point of the relative interior of
  /// the solutions of a node whose t* is zero up to the tolerance:
  ///   X = {r : u_n = 0 on U, r = 0 on R, u_n >= 0, r in the friction cones, sum r_n = 1}.
  /// That point is then reaction() and displacement(); multipliers() are zero. Nothing if t* is not
  /// zero, if it is numerically undecided whether some reaction or gap vanishes, or if a higher
  /// precision level than allowed would be required.
  std::optional<conic::RelativeInterior> relative_interior(const support::IndexSet& contact,
                                                           const support::IndexSet& separated,
                                                           const support::IndexSet& ignored = {});

  /// r, dm, of the precision level with the better lower bound; see conic::NodeSolver.
  [[nodiscard]] const Eigen::VectorXd& reaction() const { return reaction_; }
  /// u = F r with the scaled F, dm; for an unconstrained body plus G alpha.
  [[nodiscard]] const Eigen::VectorXd& displacement() const { return displacement_; }
  /// y, m, and for an unconstrained body beta of its p modes: w = sum_i y_i (row (n, i) of F) + G
  /// beta.
  [[nodiscard]] const Eigen::VectorXd& multipliers() const { return multipliers_; }
  /// Those of the rigid-body modes: the last p of these.
  [[nodiscard]] auto motion_multipliers() const { return multipliers_.tail(motions_.count()); }
  /// alpha, p numbers: displacement() is F r + G alpha.
  [[nodiscard]] Eigen::VectorXd motion() const;

  [[nodiscard]] double normal_reaction(int candidate) const {
    return reaction()[normal(candidate)];
  }
  [[nodiscard]] double normal_displacement(int candidate) const {
    return displacement()[normal(candidate)];
  }
  /// u_n r_n: the violation of complementarity of the candidate.
  [[nodiscard]] double violation(int candidate) const {
    return normal_displacement(candidate) * normal_reaction(candidate);
  }

  /// Distances from the centre of the relaxation to the faces of both signs of each candidate
  /// (conic::FaceDistances): zero for candidates with a sign. Nothing if the last node was not
  /// proved feasible in doubles only, and for unconstrained bodies. The references above are not
  /// changed.
  std::span<const conic::FaceDistances> face_distances();

  [[nodiscard]] int dimension() const { return dimension_; }
  /// m.
  [[nodiscard]] int candidates() const { return static_cast<int>(friction_.size()); }
  /// Unit of the compliance, length/force.
  [[nodiscard]] double unit() const { return unit_; }
  /// Index of the normal component of a candidate in r and u.
  [[nodiscard]] Eigen::Index normal(int candidate) const {
    return Eigen::Index{dimension_} * candidate;
  }

 private:
  template <class Real>
  using Level =
      std::variant<std::monostate, conic::NodeSolver<2, Real>, conic::NodeSolver<3, Real>>;

  /// G, combined as the solvers require, with the precision of Real.
  template <class Real>
  [[nodiscard]] conic::Motions<Real> motions() const;
  /// y and beta of the modes in the given basis.
  template <class Vector>
  [[nodiscard]] Eigen::VectorXd given(const Vector& multipliers) const;
  /// The scaled F with the precision of Real, and its error.
  template <class Real>
  [[nodiscard]] Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> scaled_compliance() const;
  template <class Real>
  [[nodiscard]] double scaled_error() const;
  /// The solver of a precision level, constructed at its first use.
  template <class Real>
  Level<Real>& made(Level<Real>& level);
  /// The intersection of both brackets, which are valid.
  /// @param solver whose bracket is `again`
  template <class Solver>
  void take(const Solver& solver, const conic::ConicResult& again, conic::ConicResult& answer);
  /// Examines the point in doubles with longer numbers; then solves the node with these, from the last
  /// iterate with shorter ones, and if that is undecided from the beginning.
  template <int D>
  void escalate(const support::IndexSet& contact, const support::IndexSet& separated,
                const support::IndexSet& ignored, conic::StopEarly stop,
                conic::ConicResult& answer);
  /// The candidates displaced by the reactions of these.
  [[nodiscard]] support::IndexSet moved_by(const support::IndexSet& loaded) const;
  [[nodiscard]] bool is_unresolved(const conic::ConicResult& answer, conic::StopEarly stop) const;
  [[nodiscard]] bool has_centre(const conic::ConicResult& answer, conic::StopEarly stop) const;

  int dimension_;
  double unit_;
  conic::Tolerances tolerances_;
  Precision precision_;
  int loads_;
  support::Stop stop_;
  std::vector<double> friction_;
  Eigen::MatrixXd compliance_;                 // unscaled, as is the precise one
  numbers::PreciseMatrix precise_compliance_;  // empty: the doubles are exact
  double compliance_error_, precise_error_;
  conic::Motions<numbers::Precise> motions_;  // combined
  std::variant<conic::NodeSolver<2>, conic::NodeSolver<3>> solver_;
  Level<long double> long_level_;
  Level<numbers::Precise> precise_level_;
  Eigen::VectorXd reaction_, displacement_, multipliers_;
  Eigen::VectorXd motion_;   // of the combined modes, those with normal displacements
  bool has_centre_ = false;  // of the last solved node
};

}  // namespace kusabi::wedged
