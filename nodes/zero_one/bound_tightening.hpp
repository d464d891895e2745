// Optimisation-based bound tightening: how far a linear form can go where it matters, that is among
// the points of the relaxation with an objective of at most that of a point known. And what follows
// for big-M rows: an M larger than what its row can need makes the relaxation weak.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "nodes/zero_one/implied_bounds.hpp"
#include "solvers/linear/basis.hpp"
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
  std::pair<double, bool> least_precisely();

  linear::LinearProgram program_;  // the costs are those of a form; the objective is the last row
  linear::Simplex simplex_;
  ColumnBounds implied_;
  support::Stop stop_;
};

/// What tighten_big_m() did.
struct Tightening {
  std::uint64_t coefficients = 0;  ///< made smaller, over all rounds
  std::uint64_t fixed = 0;         ///< binaries fixed because the other value is infeasible
  std::uint64_t rounds = 0;
  std::uint64_t programs = 0;
  bool nothing_left = false;  ///< no point is as good as the cutoff
  bool proved = true;         ///< whether all of it holds in spite of rounding
};

/// Makes the coefficient of the binary in every row of the kind a'x + M tau <= b (one binary, other
/// columns besides) as small as the points that matter allow, in rounds, until little changes.
/// Points with an objective of at most `cutoff` stay; of others some may be lost.
/// @param proofs_only whether to leave all as it is that is not proved
Tightening tighten_big_m(linear::MixedProgram& mixed, double cutoff, bool proofs_only = false,
                         const support::Stop& stop = {});

}  // namespace kusabi::zero_one
