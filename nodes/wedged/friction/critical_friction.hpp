// Friction coefficient at which a node (U, R) of the tree of sign patterns becomes feasible.
//
// t* of the node program (23) is nondecreasing in the coefficient, since the friction cones grow.
// The solution at one coefficient gives bounds for all others: its multipliers prove the node
// infeasible below a certain coefficient, its configuration proves it feasible from a certain one
// on, and both give the slope of t* for Newton's method (docs/theory/wedged.md, "Critical
// friction").
//
// All coefficients are factors of the candidates' own: mu_i = factor x phi_i.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "nodes/wedged/friction/friction_grid.hpp"
#include "nodes/wedged/relaxation/candidate_bounds.hpp"
#include "nodes/wedged/relaxation/contact_solver.hpp"
#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Result of one cone program.
struct FrictionProbe {
  conic::Sign sign = conic::Sign::unproved;  ///< at the requested coefficient
  bool degenerate = false;  ///< if undecided: the bracket of t* is within the tolerance
  /// Infeasible for every smaller coefficient, by the multipliers; 0: none.
  double infeasible_below = 0;
  /// Feasible from here on, by the configuration; at least the minimum of the range; infinity:
  /// nowhere.
  double feasible_from = 0;
  double newton = 0;  ///< zero of the tangent of t*; infinity if there is none
  double margin = 0;  ///< the middle of the bracket of t*
};

/// A bracket of a critical coefficient on the grid of multiples of a width: infeasible at the lower
/// bound and feasible at the upper one, both decided. A flat cone counts as feasible if the node is
/// a flat cone over a range (see CriticalFriction).
struct CriticalCell {
  static constexpr std::int64_t nowhere = INT64_MAX;

  std::int64_t infeasible = 0;      ///< x width
  std::int64_t feasible = nowhere;  ///< x width; `nowhere` if no feasible point is known

  friend bool operator==(const CriticalCell&, const CriticalCell&) = default;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& infeasible& feasible;
  }
};

/// State of a leaf at one coefficient. As friction grows a leaf passes these states in their order,
/// and flat cones of increasing size.
struct LeafStage {
  enum class Kind {
    infeasible,  ///< no configuration
    flat,        ///< t* = 0 throughout a range of coefficients
    solid,       ///< t* > 0
    unresolved,  ///< numerically undecided
  };
  Kind kind = Kind::infeasible;
  support::IndexSet loaded;  ///< of a flat cone S, candidates with a reaction; otherwise empty
  support::IndexSet moved;   ///< of a flat cone G, candidates with a gap

  friend bool operator==(const LeafStage&, const LeafStage&) = default;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& kind& loaded& moved;
  }
};

/// Method of finding a cell.
enum class CriticalMethod { bisection, newton };

/// Finds critical coefficients of nodes of one block. Each rank has its own object, with a
/// workspace. Results depend on the arguments only.
///
/// A cone with inactive candidates is flat: t* is zero from its critical coefficient on, and never
/// positive. It is feasible at a coefficient if the node is degenerate there and slightly above,
/// and if the problem without the inactive candidates is feasible, whose t* changes its sign. (A
/// pattern close to its own critical coefficient may also be degenerate, but it is solid above.)
class CriticalFriction {
 public:
  /// The coefficients for which the friction of all candidates is in the range of ContactSolver.
  struct Range {
    double minimum, maximum;
  };
  static Range range(const problems::WedgedProblem& problem);

  /// Near the critical coefficient t* is the distance from that coefficient times a slope, which
  /// may be as small as 1e-6, so a bracket of 1e-8 requires these tolerances. Errors due to
  /// directions with sixteen digits are smaller.
  static constexpr conic::Tolerances tolerances{.sign = 1e-14, .value = 1e-15, .iterations = 100};

  /// @param width of the grid, > 0
  /// @throws std::invalid_argument if a number is out of range
  CriticalFriction(const problems::WedgedProblem& problem, double width,
                   Precision precision = Precision::escalating);

  /// Makes all solutions throw support::Stopped soon after the run is to stop.
  void end_when(const support::Stop& stop) {
    stop_ = stop;
    solver_.end_when(stop);
  }

  /// Solves the node's program at one coefficient. @param factor > 0
  FrictionProbe probe(const SignPattern& node, double factor, conic::StopEarly stop = full);

  /// The cell of a pattern. The grid makes it independent of the method and the initial bounds. It
  /// is wider than the width only where signs on the grid are undecided.
  /// @param cell known bounds: infeasible at the lower one, feasible at the upper one unless
  ///        `nowhere`
  /// @param maximum limit of the search (x width) if no feasible point is known
  CriticalCell locate(const SignPattern& pattern, CriticalCell cell, CriticalMethod method,
                      std::int64_t maximum);

  /// One step of the bisection (Algorithm 6.1, step 2b): the half of the cell with the change, or
  /// the cell unchanged if it cannot be halved.
  CriticalCell halve(const SignPattern& pattern, CriticalCell cell);

  /// True if the pattern is proved infeasible at a grid point (x width).
  bool infeasible(const SignPattern& pattern, std::int64_t point);

  /// The state of the leaf at a grid point (x width).
  LeafStage stage(const SignPattern& leaf, std::int64_t point);

  /// Moves the cell's upper bound up, by steps that double, to a grid point that is proved
  /// feasible.
  /// @pre `maximum` is feasible
  CriticalCell feasible_from(const SignPattern& pattern, CriticalCell cell, std::int64_t maximum);

  /// A coefficient below which the node, and so all nodes below it, is proved infeasible; nearly
  /// the largest such.
  /// @param from known bound
  /// @param cutoff the search for a larger bound ends here
  double bound(const SignPattern& node, double from, double cutoff);

  /// A coefficient below which the node is proved infeasible, by one program: `factor` if it is
  /// infeasible there, otherwise the bound of its multipliers.
  double infeasible_below(const SignPattern& node, double factor);

  /// Sets bounds for infeasible_below(), valid at all coefficients of its calls.
  void tighten(std::vector<CandidateBounds> bounds);
  [[nodiscard]] const std::vector<CandidateBounds>& bounds() const { return bounds_; }

  /// The solver with its last solution.
  [[nodiscard]] ContactSolver& solver() { return solver_; }
  [[nodiscard]] double width() const { return grid_.width(); }
  [[nodiscard]] double min_factor() const { return range_.minimum; }
  [[nodiscard]] double at(std::int64_t multiple) const { return grid_.at(multiple); }

  [[nodiscard]] std::uint64_t programs() const { return programs_; }

 private:
  class Approach;

  static constexpr conic::StopEarly full{.when_infeasible = false, .when_feasible = false};
  static constexpr conic::StopEarly sign_only{.when_infeasible = true, .when_feasible = true};

  CriticalCell approach(const SignPattern& pattern, CriticalCell cell, std::int64_t maximum);
  CriticalCell bisect(const SignPattern& pattern, CriticalCell cell);
  // True if a degenerate leaf is a flat cone at this coefficient.
  bool is_flat(const SignPattern& pattern, double factor);
  bool feasible_without_inactive(const SignPattern& leaf, const conic::RelativeInterior& inside);
  // True if a degenerate leaf is also degenerate at a coefficient beside this one.
  bool lasts(const SignPattern& leaf, double factor, const conic::Tolerances& zero);
  bool is_degenerate(const SignPattern& leaf, double factor, const conic::Tolerances& zero);
  // True if these are feasible as the only candidates. Rigid-body modes that do not displace them
  // are left out.
  bool feasible_alone(const support::IndexSet& contact, const support::IndexSet& separated);
  void set_friction(double factor);
  // The least coefficient at which w_ni + mu_i |w_ti| is not negative for some i not in R.
  [[nodiscard]] double min_coefficient(const Eigen::VectorXd& pull, const SignPattern& node) const;
  // The coefficient from which on the configuration of the last program proves the node feasible;
  // infinity: none. The cost of its residual is the level of the configuration minus `lower`, the
  // lower bound of t*; it does not grow as friction does.
  [[nodiscard]] double coefficient_of_point(const SignPattern& node, double lower) const;
  // The bound of the program with cuts, if it proves one.
  std::optional<double> infeasible_below_with_cuts(const SignPattern& node, double factor);
  // Moves a bound of the cell to a point within it, if its sign is decided there. Points below the
  // range are undecided.
  bool decide(const SignPattern& pattern, CriticalCell& cell, std::int64_t point);
  void decide_around(const SignPattern& pattern, CriticalCell& cell, std::int64_t marginal);
  void narrow(CriticalCell& cell, const FrictionProbe& probe, std::int64_t maximum) const;

  FrictionGrid grid_;
  Range range_;
  std::vector<double> own_, friction_;  // phi_i; mu_i of the last probe
  Eigen::MatrixXd normal_compliance_;   // rows (n, i) of the scaled F, then G': (m + p) x dm
  double largest_ = 0;                  // of its entries
  ContactSolver solver_;
  support::Stop stop_;
  std::vector<CandidateBounds> bounds_;                   // empty: no cuts
  std::optional<problems::WedgedProblem> unconstrained_;  // problem of an unconstrained body
  Eigen::VectorXd pull_;                                  // w of the multipliers, dm
  std::uint64_t programs_ = 0;
};

}  // namespace kusabi::wedged
