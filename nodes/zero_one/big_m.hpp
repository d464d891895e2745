// Minimisation of big Ms: too large an M makes the relaxation weak, and the ranges of rows follow
// from linear programs (bound_tightening.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solvers/linear/linear_program.hpp"
#include "support/stop.hpp"

namespace kusabi::zero_one {

/// Result of one call of BigMs::tighten().
struct TighteningResult {
  bool changed = false;     ///< true if any coefficient or bound of a binary has changed
  std::uint64_t fixed = 0;  ///< binaries fixed because the other value is infeasible
  std::uint64_t rounds = 0;
  std::uint64_t programs = 0;
  bool nothing_left = false;  ///< no point is as good as the cutoff
};

/// The rows of the form a'x + M tau <= b, with one binary and other columns. Each new M is computed
/// from the given M and b, so that rounds end; it is 0 where the row holds for both values of
/// tau.
class BigMs {
 public:
  explicit BigMs(const linear::MixedProgram& given);

  /// Makes each M as small as the relevant points allow, in rounds, until little changes. Points
  /// with an objective of at most `cutoff` are kept; others may be lost. Changes hold despite
  /// rounding.
  /// @param mixed the given program, or the result of earlier calls
  TighteningResult tighten(linear::MixedProgram& mixed, double cutoff,
                           const support::Stop& stop = {});

  /// The number of coefficients that are smaller than given.
  [[nodiscard]] std::uint64_t smaller() const;

 private:
  class Round;

  struct Row {
    std::size_t row = 0;
    std::size_t entry = 0;  // of the binary, among those of the program
    int binary = 0;
    bool from_below = false;  // the row is lower <= a'x + m tau, stored with opposite signs
    double m = 0;
    double upper = 0;
    std::vector<linear::LinearTerm> others = {};
    bool smaller = false;
  };

  std::vector<Row> rows_;
};

}  // namespace kusabi::zero_one
