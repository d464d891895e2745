// Linear relaxation of a mixed zero-one program, (41) of the limit paper, for any fixings from any
// basis, with a safe lower bound for the tree.
//
// The bound is that of Neumaier and Shcherbina, which holds despite rounding if all columns have
// bounds (their own, or implied by the rows). If it is not tight, or an answer of the simplex method
// has no proof, the program is solved in rational numbers (linear/exact_simplex.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "nodes/zero_one/fixings.hpp"
#include "nodes/zero_one/implied_bounds.hpp"
#include "solvers/linear/basis.hpp"
#include "solvers/linear/exact_simplex.hpp"
#include "solvers/linear/linear_program.hpp"
#include "solvers/linear/safe_bound.hpp"
#include "solvers/linear/simplex.hpp"
#include "support/stop.hpp"

namespace kusabi::zero_one {

/// A binary this close to 0 or 1 is at it. (The returned solution has it there exactly.)
inline constexpr double integrality_tolerance = 1e-6;

class Relaxation {
 public:
  /// @throws std::invalid_argument if a binary is no column, occurs twice, or has bounds outside
  ///   [0, 1], or the program is invalid
  explicit Relaxation(linear::MixedProgram mixed);

  [[nodiscard]] const linear::MixedProgram& mixed() const { return mixed_; }
  [[nodiscard]] const linear::LinearProgram& program() const { return mixed_.program; }
  [[nodiscard]] std::size_t binaries() const { return mixed_.binaries.size(); }
  [[nodiscard]] int column(std::size_t binary) const { return mixed_.binaries[binary]; }

  /// Sets the stop condition of long solves, which then end as `interrupted`.
  void end_when(support::Stop stop) { stop_ = std::move(stop); }
  [[nodiscard]] const support::Stop& stop() const { return stop_; }

  /// The fixings implied by the bounds of the binaries.
  [[nodiscard]] Fixings root() const { return Fixings(binaries()); }

  /// Adds a valid inequality (a cut); the basis remains valid.
  void add_row(const linear::LinearRow& row, const std::vector<linear::LinearTerm>& terms);
  void drop_last_row();

  /// Restricts the relevant points to an objective of at most `cutoff`, which may bound columns.
  void limit_objective(double cutoff);

  /// Fixes binaries by `fixings`, and solves from `basis` (an empty one: from slacks).
  linear::LinearStatus solve(const Fixings& fixings, const linear::Basis& basis,
                             const linear::SolveLimits& limits = {});
  /// A lower bound of alpha'x over all points with `held` in `column`, by the multipliers
  /// `duals` of the rows: safe if all columns have bounds, otherwise reduced by `relaxation_share`
  /// relative to the size of its terms.
  [[nodiscard]] double minimum(const std::vector<double>& alpha, const std::vector<double>& duals,
                               int column, double held, double relaxation_share) const;

  // ---- after a solve ---------------------------------------------------------------------------

  [[nodiscard]] linear::LinearStatus status() const { return status_; }
  /// A lower bound of all points with those fixings; valid after `optimal`, `cut_off`, `stopped`,
  /// `interrupted`.
  [[nodiscard]] double bound() const { return bound_; }
  /// After `infeasible`: whether that is proved.
  [[nodiscard]] bool contradiction() const { return contradiction_; }
  /// Of the optimum.
  [[nodiscard]] double objective() const;
  [[nodiscard]] const linear::Basis& basis() const { return basis_; }
  [[nodiscard]] const std::vector<double>& values() const { return values_; }
  /// The value of a binary.
  [[nodiscard]] double value(std::size_t binary) const {
    return values_[static_cast<std::size_t>(column(binary))];
  }
  /// After `optimal`: the optimum of the program without added rows, which a point need not
  /// satisfy, in rational numbers; `failed` if that is too much work. It may raise bound(). If it
  /// shows that there is no point, status() becomes `infeasible`.
  linear::ExactSolution exact_point();
  /// The bound if the free `binary` were fixed at `at_one`, by the same multipliers.
  [[nodiscard]] double bound_if(std::size_t binary, bool at_one) const;

  /// True if bounds hold despite rounding.
  [[nodiscard]] bool proves() const { return proves_; }
  /// Makes the bounds those of the simplex method, for programs that are too large for rational
  /// numbers and whose columns have no bounds, or so wide ones that the safe bounds are useless.
  void use_unproved_bounds() { proves_ = false; }
  /// True if all columns have bounds, of their own or implied.
  [[nodiscard]] bool all_bounded() const;

  /// Number of linear programs solved.
  [[nodiscard]] std::uint64_t programs() const { return simplex_.solves() + exact_programs_; }
  [[nodiscard]] std::uint64_t iterations() const { return simplex_.iterations(); }

 private:
  void fix(const Fixings& fixings);
  void conclude();
  void conclude_in_doubles();
  void conclude_exactly();
  bool conclude_from(const linear::ExactSolution& solution);
  linear::ExactSolution solve_exactly(std::size_t rows);
  void raise_bound(const linear::ExactSolution& solution);
  [[nodiscard]] bool is_tight(double objective) const;
  [[nodiscard]] double left_out() const;

  linear::MixedProgram mixed_;
  std::size_t given_rows_;
  linear::Simplex simplex_;
  ColumnBounds implied_;  // at the root
  ColumnBounds node_;     // with the fixings
  ColumnBounds fixed_;    // of the binaries, in their order, in the simplex method
  support::Stop stop_;
  bool proves_ = true;
  linear::LinearStatus status_ = linear::LinearStatus::failed;
  std::vector<double> values_;
  linear::Basis basis_;
  std::optional<linear::ExactSolution> exact_;
  // The last program solved exactly, which is often the next one as well: its rows, its bounds and
  // the start of the simplex method.
  struct LastExact {
    std::size_t rows;
    ColumnBounds fixed;
    linear::Basis start;
    linear::ExactSolution solution;
  };
  std::optional<LastExact> last_exact_;
  std::uint64_t exact_programs_ = 0;
  linear::SafeBound safe_;
  double bound_ = -linear::infinity;
  bool contradiction_ = false;
};

}  // namespace kusabi::zero_one
