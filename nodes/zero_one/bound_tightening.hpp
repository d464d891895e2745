// Optimisation-based bound tightening: the range of a linear form over the points of the relaxation
// with an objective of at most that of a known point.
#pragma once

#include <cstdint>
#include <span>

#include "nodes/zero_one/implied_bounds.hpp"
#include "solvers/linear/linear_program.hpp"
#include "solvers/linear/simplex.hpp"

namespace kusabi::zero_one {

/// A linear form is in [lower, upper] at every relevant point, despite rounding; lower > upper:
/// there is none.
struct FormRange {
  double lower = -linear::infinity;
  double upper = linear::infinity;
  /// Of the terms at the bounds: the scale of rounding errors in the form.
  double size = 0;
};

/// Ranges of linear forms over {x of the program, binaries relaxed : objective <= cutoff}.
class BoundTightening {
 public:
  /// @param cutoff infinity: all points are relevant
  /// @param stop polled within each program; a stopped one has no result
  BoundTightening(const linear::LinearProgram& program, double cutoff, support::Stop stop = {});

  /// Starts from the basis of the last call.
  /// @throws std::invalid_argument if a term is not a column
  FormRange range(std::span<const linear::LinearTerm> form);
  /// One bound only: half the work.
  FormRange upper_end(std::span<const linear::LinearTerm> form);

  /// Sets the bounds of a column.
  void set_column_bounds(int column, double lower, double upper);

  [[nodiscard]] std::uint64_t programs() const { return simplex_.solves(); }

 private:
  FormRange end(std::span<const linear::LinearTerm> form, double sign);
  [[nodiscard]] double largest_term(std::span<const linear::LinearTerm> form) const;
  double minimise_exactly();

  linear::LinearProgram program_;  // the costs are those of a form; the objective is the last row
  linear::Simplex simplex_;
  ColumnBounds implied_;
  support::Stop stop_;
};

}  // namespace kusabi::zero_one
