// The linear relaxation of a mixed zero-one program, (41) of the limit paper: solved for any
// fixings from any basis, with a lower bound that the tree can rely on.
//
// Where all columns have bounds (their own, or such as follow from the rows), the bound is that of
// Neumaier and Shcherbina: rounding cannot make it wrong. Where some have none it is the optimum as
// the simplex method found it, within its tolerances, and proves() says so.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "nodes/zero_one/fixings.hpp"
#include "nodes/zero_one/implied_bounds.hpp"
#include "solvers/linear/basis.hpp"
#include "solvers/linear/linear_program.hpp"
#include "solvers/linear/safe_bound.hpp"
#include "solvers/linear/simplex.hpp"

namespace kusabi::nodes {

/// Objectives closer than this, relative to the size of those of the root, are one: what a linear
/// program of GLPK's accuracy can tell apart. Ties are broken by the place in the tree.
inline constexpr double objective_tolerance = 1e-9;

/// A binary this close to 0 or 1 is at it. (The solution that is handed out has it there exactly.)
inline constexpr double integrality_tolerance = 1e-6;

class Relaxation {
 public:
  /// @throws std::invalid_argument if a binary is no column, occurs twice, or has bounds outside
  ///   [0, 1], or the program is none
  explicit Relaxation(problems::MixedProgram mixed);

  [[nodiscard]] const problems::MixedProgram& mixed() const { return mixed_; }
  [[nodiscard]] const problems::LinearProgram& program() const { return mixed_.program; }
  [[nodiscard]] std::size_t binaries() const { return mixed_.binaries.size(); }
  [[nodiscard]] int column(std::size_t binary) const { return mixed_.binaries[binary]; }
  [[nodiscard]] linear::Simplex& simplex() { return simplex_; }
  [[nodiscard]] const linear::Simplex& simplex() const { return simplex_; }

  /// The fixings that the bounds of the binaries say themselves.
  [[nodiscard]] Fixings root() const { return Fixings(binaries()); }

  /// A valid inequality; the basis stays good.
  void add_row(const problems::LinearRow& row, const std::vector<problems::LinearTerm>& terms);
  void drop_last_row();

  /// Only points with an objective of at most `cutoff` matter from now on: that may bound columns.
  void matters_below(double cutoff);

  /// Holds the binaries where `fixings` say, and solves from `basis` (an empty one: from slacks).
  linear::LinearStatus solve(const Fixings& fixings, const linear::Basis& basis,
                             const linear::SolveLimits& limits = {});
  /// The same from the present basis.
  linear::LinearStatus solve_on(const Fixings& fixings, const linear::SolveLimits& limits = {});

  /// A lower bound of alpha'x over all points that have `held` in `column`, by the multipliers
  /// `duals` of the rows: safe if bounds are proved, else less `give_way` relative to the size of
  /// its terms.
  [[nodiscard]] double least(const std::vector<double>& alpha, const std::vector<double>& duals,
                             int column, double held, double give_way) const;

  // ---- after a solve
  // -----------------------------------------------------------------------------

  /// A lower bound of all points with those fixings; of use after `optimal`, `cut_off`, `stopped`.
  [[nodiscard]] double bound() const { return bound_; }
  /// After `infeasible`: whether that is proved, whatever was rounded.
  [[nodiscard]] bool contradiction() const { return contradiction_; }
  /// The value of a binary.
  [[nodiscard]] double value(std::size_t binary) const { return simplex_.value(column(binary)); }
  /// The bound if `binary`, not fixed, were held at `at_one`, by the same multipliers.
  [[nodiscard]] double bound_if(std::size_t binary, bool at_one) const;

  /// Whether bounds hold in spite of rounding (see above).
  [[nodiscard]] bool proves() const { return proves_; }
  /// From now on bounds are what the simplex method finds: for programs whose columns have bounds
  /// so wide that the safe ones are of no use.
  void do_without_proof() { proves_ = false; }

  /// Linear programs solved here.
  [[nodiscard]] std::uint64_t programs() const { return simplex_.solves(); }

 private:
  void hold(const Fixings& fixings);
  void conclude();
  [[nodiscard]] bool all_bounded() const;

  problems::MixedProgram mixed_;
  linear::Simplex simplex_;
  ColumnBounds implied_;  // at the root
  ColumnBounds node_;     // with the fixings
  ColumnBounds held_;     // of the binaries, in the order of them, as the simplex method has them
  bool proves_ = false;
  linear::SafeBound safe_;
  double bound_ = -problems::infinity;
  bool contradiction_ = false;
};

}  // namespace kusabi::nodes
