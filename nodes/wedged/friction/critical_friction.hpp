// The friction coefficient at which a node (U, R) of the tree of sign patterns begins to live.
//
// t* of the node program (23) does not fall when friction grows, since the cones grow. What the
// cone solver leaves behind at one coefficient says something of all others: its multipliers prove
// the node dead below a certain coefficient, its configuration proves it alive from a certain one
// on, and both together give the slope of t*, hence Newton's method. docs/theory/wedged.md,
// "Critical friction".
//
// All coefficients here are factors of the candidates' own: mu_i = factor x phi_i.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "nodes/wedged/friction/friction_grid.hpp"
#include "nodes/wedged/tree/contact_solver.hpp"
#include "nodes/wedged/tree/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// What one cone program says.
struct FrictionProbe {
  conic::Sign sign = conic::Sign::marginal;  ///< at the coefficient asked for
  bool tie = false;       ///< of a marginal one: its bracket lies within the tolerance
  double dead_below = 0;  ///< dead for every coefficient below, by the multipliers; 0: none
  double alive_from = 0;  ///< alive from here on, by the configuration; infinity: nowhere
  double newton = 0;      ///< where the tangent of t* vanishes; infinity where there is none
  double level = 0;       ///< the middle of the bracket of t*
};

/// A bracket of a critical coefficient on the grid of multiples of a width: dead at the lower end
/// and alive at the upper one, both decided. A flat cone counts as alive where it is nothing but
/// that (see CriticalFriction).
struct CriticalCell {
  static constexpr std::int64_t nowhere = INT64_MAX;

  std::int64_t dead = 0;         ///< x width
  std::int64_t alive = nowhere;  ///< x width; `nowhere` if nothing is known to be alive

  friend bool operator==(const CriticalCell&, const CriticalCell&) = default;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& dead& alive;
  }
};

/// What becomes of a leaf at one coefficient. As friction grows it goes through these in their
/// order, and through flat cones each within the next.
struct LeafStage {
  enum class Kind {
    dead,   ///< no configuration
    flat,   ///< t* = 0, throughout a range of coefficients
    solid,  ///< t* > 0
    open,   ///< which of these cannot be told
  };
  Kind kind = Kind::dead;
  support::IndexSet loaded;  ///< of a flat cone S, those with a reaction; else empty
  support::IndexSet moved;   ///< and G, those with a gap

  friend bool operator==(const LeafStage&, const LeafStage&) = default;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& kind& loaded& moved;
  }
};

/// How a cell is found.
enum class CriticalMethod { bisection, newton };

/// Finds critical coefficients, one node after another, of the problem of one block. Owns its
/// workspace; each rank has one. Results depend on the arguments only.
///
/// A cone with candidates at rest is flat: t* is zero from its critical coefficient on, and never
/// positive. It lives at a coefficient if the node is a tie there and a little above, and if what
/// is left without the candidates at rest is alive, whose t* changes its sign. (A pattern close to
/// its own critical coefficient can be a tie, too, but above it is solid.)
class CriticalFriction {
 public:
  /// The coefficients for which the friction of all candidates is in the range of ContactSolver.
  struct Range {
    double least, most;
  };
  static Range range(const problems::WedgedProblem& problem);

  /// t* near the critical coefficient is its distance from it times a slope, which may be as low as
  /// 1e-6: a bracket of 1e-8 asks for that many digits. What directions in sixteen digits leave of
  /// a tie is below.
  static constexpr conic::Tolerances tolerances{.sign = 1e-14, .value = 1e-15, .iterations = 100};

  /// @param width of the grid, > 0
  /// @throws std::invalid_argument if a number is out of range
  CriticalFriction(const problems::WedgedProblem& problem, double width,
                   Precision precision = Precision::escalating);

  /// From now on whatever solves throws support::Stopped soon after an end is asked for.
  void end_when(const support::Stop& stop) { solver_.end_when(stop); }

  /// Solves the node's program at one coefficient. @param factor > 0
  FrictionProbe probe(const SignPattern& node, double factor, conic::StopEarly stop = full);

  /// The cell of a pattern. The grid makes it the same whatever the method and the ends. It is
  /// wider than the width only where signs on the grid are marginal.
  /// @param cell what is known: dead at its lower end, alive at its upper one unless `nowhere`
  /// @param most if nothing is known to be alive, the search goes up to here (x width)
  CriticalCell locate(const SignPattern& pattern, CriticalCell cell, CriticalMethod method,
                      std::int64_t most);

  /// One step of the bisection (Algorithm 6.1, step 2b): the half of the cell that holds the
  /// change, or the cell as it is if it cannot be halved.
  CriticalCell halve(const SignPattern& pattern, CriticalCell cell);

  /// Whether the pattern is proved dead at a point of the grid (x width).
  bool dead(const SignPattern& pattern, std::int64_t point);

  /// What the leaf is at a point of the grid (x width).
  LeafStage stage(const SignPattern& leaf, std::int64_t point);

  /// Moves the cell's upper end up, by steps that double, to a grid point that is proved alive.
  /// @pre `most` is alive
  CriticalCell alive_from(const SignPattern& pattern, CriticalCell cell, std::int64_t most);

  /// A coefficient below which the node, and so all nodes below it, is proved dead; nearly the
  /// largest such. @param from a bound known already @param cutoff the search for a larger bound
  /// ends here
  double bound(const SignPattern& node, double from, double cutoff);

  /// A coefficient below which the node is proved dead, by one program: `factor` if it is dead
  /// there, otherwise what its multipliers say.
  double dead_below(const SignPattern& node, double factor);

  /// From now on dead_below() knows bounds that hold at any coefficient it is asked for.
  void tighten(std::vector<CandidateBounds> bounds);
  [[nodiscard]] const std::vector<CandidateBounds>& bounds() const { return bounds_; }

  /// What was solved last.
  [[nodiscard]] ContactSolver& solver() { return solver_; }
  [[nodiscard]] double width() const { return grid_.width(); }
  [[nodiscard]] double at(std::int64_t multiple) const { return grid_.at(multiple); }

  [[nodiscard]] std::uint64_t programs() const { return programs_; }

 private:
  static constexpr conic::StopEarly full{.when_dead = false, .when_alive = false};
  static constexpr conic::StopEarly sign_only{.when_dead = true, .when_alive = true};

  CriticalCell approach(const SignPattern& pattern, CriticalCell cell, std::int64_t most);
  CriticalCell bisect(const SignPattern& pattern, CriticalCell cell);
  // Whether a leaf is a flat cone at this coefficient, where it is a tie.
  bool is_flat(const SignPattern& pattern, double factor);
  bool lives_at_rest(const SignPattern& leaf, const conic::RelativeInterior& inside);
  // Whether it is a tie beside this coefficient as well, where it is one.
  bool lasts(const SignPattern& leaf, double factor, const conic::Tolerances& tie);
  bool is_tie(const SignPattern& leaf, double factor, const conic::Tolerances& tie);
  // Whether these are alive as the only candidates. Of a loose body they may not see all motions.
  bool lives_alone(const support::IndexSet& contact, const support::IndexSet& separated);
  void set_friction(double factor);
  // The least coefficient at which w_ni + mu_i |w_ti| is no longer negative for some i not in R.
  [[nodiscard]] double reach_of(const Eigen::VectorXd& pull, const SignPattern& node) const;
  // What the program with cuts says, if it says anything.
  std::optional<double> dead_below_with_cuts(const SignPattern& node, double factor);
  // Moves the end of the cell to a point within it, if its sign is decided there.
  bool decide(const SignPattern& pattern, CriticalCell& cell, std::int64_t point);
  void surround(const SignPattern& pattern, CriticalCell& cell, std::int64_t marginal);
  void narrow(CriticalCell& cell, const FrictionProbe& probe, std::int64_t most) const;

  FrictionGrid grid_;
  Range range_;
  std::vector<double> own_, friction_;  // phi_i; mu_i of the last probe
  Eigen::MatrixXd normal_compliance_;   // rows (n, i) of the scaled F, then G': (m + p) x dm
  double largest_ = 0;                  // of its entries
  ContactSolver solver_;
  std::vector<CandidateBounds> bounds_;           // empty: no cuts
  std::optional<problems::WedgedProblem> loose_;  // of a body that nothing holds
  Eigen::VectorXd pull_;                          // w of the multipliers, dm
  std::uint64_t programs_ = 0;
};

}  // namespace kusabi::wedged
