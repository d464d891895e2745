// CheckedSimplex: a linear program that is solved repeatedly, each answer being checked
// (checked_answer.hpp). An answer that fails the check is not returned: the program is solved again
// from the slack basis, then in rational numbers, and if no answer passes it is not determined.
//
// As for Simplex, a result depends on the program and the basis alone if the basis was given by
// set_basis() or use_slack_basis().
#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "solvers/linear/basis.hpp"
#include "solvers/linear/checked_answer.hpp"
#include "solvers/linear/linear_program.hpp"
#include "solvers/linear/simplex.hpp"
#include "support/stop.hpp"

namespace kusabi::linear {

/// No answer has passed the check.
struct NotDetermined {
  bool interrupted = false;  ///< by the stop
};

/// An unbounded program is not determined: no check of a ray is needed, since all programs solved
/// here are bounded.
using CheckedAnswer = std::variant<NotDetermined, CheckedOptimum, CheckedInfeasibility>;

class CheckedSimplex {
 public:
  /// @param program scaled to the order of one
  /// @throws std::invalid_argument as Simplex
  explicit CheckedSimplex(LinearProgram program);

  [[nodiscard]] int rows() const { return simplex_.rows(); }
  [[nodiscard]] int columns() const { return simplex_.columns(); }

  // Changes as those of Simplex; the basis stays.

  void set_column_bounds(int column, double lower, double upper);
  void set_row_bounds(int row, double lower, double upper);
  void set_cost(int column, double cost);
  /// @return the index of the row
  int add_row(double lower, double upper, std::span<const LinearTerm> terms);
  /// Removes the rows from `first` on.
  void drop_rows_from(int first);

  [[nodiscard]] Basis basis() const { return simplex_.basis(); }
  void set_basis(const Basis& basis) { simplex_.set_basis(basis); }
  void use_slack_basis() { simplex_.use_slack_basis(); }

  /// Solves from the current basis, by the dual method first.
  const CheckedAnswer& solve(const support::Stop& stop = {});

  /// Answer of the last solve.
  [[nodiscard]] const CheckedAnswer& answer() const { return answer_; }
  /// @pre the last answer is an optimum
  [[nodiscard]] const CheckedOptimum& optimum() const { return std::get<CheckedOptimum>(answer_); }

  [[nodiscard]] std::uint64_t solves() const { return simplex_.solves(); }
  [[nodiscard]] std::uint64_t iterations() const { return simplex_.iterations(); }

 private:
  bool take(LinearStatus status, const support::Stop& stop);
  void solve_in_rational_numbers(const support::Stop& stop);

  LinearProgram program_;  // as loaded in simplex_
  Simplex simplex_;
  CheckedAnswer answer_;
};

}  // namespace kusabi::linear
