// Optimisation-based bound tightening: how far a linear form can go where it matters, that is among
// the points of the relaxation with an objective of at most that of a point known.
#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "nodes/zero_one/implied_bounds.hpp"
#include "solvers/linear/linear_program.hpp"
#include "solvers/linear/simplex.hpp"

namespace kusabi::zero_one {

/// A linear form lies in [lower, upper] at every point that matters; lower > upper: there is none.
struct FormRange {
  double lower = -linear::infinity;
  double upper = linear::infinity;
  /// Whether both ends hold in spite of rounding. If not, reduced costs that are zero but for the
  /// last of 30 digits were counted as zero.
  bool proved = true;
  /// Of the terms at the ends: the scale that rounding in the form has.
  double size = 0;
};

/// Ranges of linear forms over {x of the program, binaries relaxed : objective <= cutoff}.
class BoundTightening {
 public:
  /// @param cutoff infinity: all points matter
  /// @param stop asked within each program; one that is stopped says nothing
  BoundTightening(const linear::LinearProgram& program, double cutoff, support::Stop stop = {});

  /// From the basis of the last call. @throws std::invalid_argument if a term is no column
  FormRange range(std::span<const linear::LinearTerm> form);
  /// One end only: half the work.
  FormRange upper_end(std::span<const linear::LinearTerm> form);

  /// Bounds of a column from now on.
  void set_column_bounds(int column, double lower, double upper);

  [[nodiscard]] std::uint64_t programs() const { return simplex_.solves(); }

 private:
  FormRange end(std::span<const linear::LinearTerm> form, double sign);
  [[nodiscard]] double largest_term(std::span<const linear::LinearTerm> form) const;
  std::pair<double, bool> least_precisely();

  linear::LinearProgram program_;  // the costs are those of a form; the objective is the last row
  linear::Simplex simplex_;
  ColumnBounds implied_;
  support::Stop stop_;
};

}  // namespace kusabi::zero_one
