// Simplex: linear programs by the simplex methods of GLPK, warm-started from any basis: the
// programs at the nodes of the zero-one tree (the limit paper, Algorithm 4.2 step 1), of the cuts,
// and of limit analysis.
//
// If the basis was given by set_basis() or use_slack_basis(), a result depends on the program and
// this basis alone, to the last bit, and not on earlier solves; a tree is therefore the same on any
// number of ranks.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "solvers/linear/basis.hpp"
#include "solvers/linear/linear_program.hpp"
#include "support/stop.hpp"

namespace kusabi::linear {

/// Result of a solve. The first four are claims of a floating-point method; safe_dual_bound() gives
/// their proof.
enum class LinearStatus {
  optimal,      ///< within the tolerances
  infeasible,   ///< no point satisfies all rows and bounds; farkas() gives multipliers
  unbounded,    ///< feasible, and the objective has no lower bound
  cut_off,      ///< dual simplex only: the optimum is above `SolveLimits::cutoff`
  stopped,      ///< `SolveLimits::iterations` was reached
  interrupted,  ///< by `SolveLimits::stop`
  failed,       ///< numerical failure of GLPK: a singular basis, lost accuracy
};

struct SolveLimits {
  double cutoff = std::numeric_limits<double>::infinity();  ///< of the objective
  int iterations = std::numeric_limits<int>::max();
  /// Called between pieces of a long solve, each a fraction of a second. If given, the solve is
  /// split into pieces even if the callback never returns true, so that the result of a completed
  /// solve does not depend on it.
  support::Stop stop = {};
};

class Simplex {
 public:
  /// Loads and scales.
  /// @throws std::invalid_argument if an entry is out of range, duplicate or not finite, or a bound
  ///   or cost is NaN
  explicit Simplex(const LinearProgram& program);
  Simplex(Simplex&& other) noexcept;
  Simplex& operator=(Simplex&& other) noexcept;
  ~Simplex();

  [[nodiscard]] int rows() const;
  [[nodiscard]] int columns() const;

  // ---- changes; the basis stays --------------------------------------------------------------
  // (bounds with lower > upper make the program infeasible)

  void set_column_bounds(int column, double lower, double upper);
  void set_row_bounds(int row, double lower, double upper);
  void set_cost(int column, double cost);
  void set_constant(double constant);
  /// The new row is basic. @return its index
  int add_row(double lower, double upper, std::span<const LinearTerm> terms);
  /// The new column is at a bound. @return its index
  int add_column(const LinearColumn& column, std::span<const LinearEntry> entries);
  /// Removes these rows; those after them move up. If they are not all basic the basis may be lost;
  /// the next solve then starts from the slack basis.
  /// @param rows ascending
  void drop_rows(std::span<const int> rows);
  /// Removes the rows from `first` on.
  void drop_rows_from(int first);
  /// Rescales, after rows or columns were added.
  void scale();
  /// Removes the scale factors: GLPK's tolerances then hold for the program as given.
  void unscale();

  // ---- solving ---------------------------------------------------------------------------------

  /// Starts from the current basis, which stays dual feasible under changes of bounds and new rows.
  LinearStatus solve_dual(const SolveLimits& limits = {});
  /// Starts from the current basis, which stays primal feasible under changes of costs and new
  /// columns.
  LinearStatus solve_primal(const SolveLimits& limits = {});
  /// As solve_dual; after a failure the primal method, then an advanced basis.
  LinearStatus solve_robustly(const SolveLimits& limits = {});

  [[nodiscard]] Basis basis() const;
  /// @throws std::invalid_argument if the size differs, except for rows added since, which become
  ///   basic
  void set_basis(const Basis& basis);
  void use_slack_basis();

  // ---- the last solve --------------------------------------------------------------------------

  [[nodiscard]] LinearStatus status() const { return status_; }
  [[nodiscard]] double objective() const;
  [[nodiscard]] double value(int column) const;
  /// Per unit of the row's bound: >= 0 if the lower bound is active, <= 0 for the upper one.
  [[nodiscard]] double dual(int row) const;
  /// c - A'dual
  [[nodiscard]] double reduced_cost(int column) const;
  [[nodiscard]] std::vector<double> values() const;
  [[nodiscard]] std::vector<double> duals() const;
  /// After `infeasible`: multipliers of the rows with which safe_dual_bound() of the program
  /// without its costs is above zero. Empty if GLPK gives none.
  [[nodiscard]] std::vector<double> farkas();

  // ---- the basis matrix, of the basic columns of (I | -A) --------------------------------------

  /// Basic variables in the order of the factorisation: rows as their index, columns as rows() plus
  /// theirs. Empty if there is no factorisation.
  [[nodiscard]] std::vector<int> basis_head();
  /// Replaces b by x with B x = b, in the order of basis_head(). False if there is no
  /// factorisation.
  bool solve_with_basis(std::vector<double>& b);
  /// Replaces b by x with B'x = b, one number per row.
  bool solve_with_transposed_basis(std::vector<double>& b);
  /// After `infeasible`: the position in basis_head() of the variable that cannot satisfy its
  /// bounds, and 1 if it is below, -1 if above. Position -1: GLPK gives none.
  [[nodiscard]] std::pair<int, double> contradicting();

  // ---- counts ----------------------------------------------------------------------------------

  [[nodiscard]] std::uint64_t iterations() const { return iterations_; }
  [[nodiscard]] std::uint64_t solves() const { return solves_; }

 private:
  struct Problem;  // keeps glpk.h out of this header

  [[nodiscard]] bool empty_bounds() const;
  [[nodiscard]] bool factorised();
  void refactorise();
  LinearStatus solve(int method, const SolveLimits& limits);
  [[nodiscard]] int steps_per_piece() const;

  std::unique_ptr<Problem> problem_;
  std::vector<bool> row_empty_;     // lower > upper, which GLPK does not accept
  std::vector<bool> column_empty_;  //
  LinearStatus status_ = LinearStatus::failed;
  std::uint64_t iterations_ = 0;
  std::uint64_t solves_ = 0;
};

}  // namespace kusabi::linear
