// Big Ms made as small as they may be: an M larger than what its row can need makes the relaxation
// weak, and ranges of what a row can need come from linear programs (bound_tightening.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solvers/linear/linear_program.hpp"
#include "support/stop.hpp"

namespace kusabi::zero_one {

/// What one call of BigMs::tighten() did.
struct Tightening {
  bool changed = false;     ///< whether any coefficient or bound of a binary is another one now
  std::uint64_t fixed = 0;  ///< binaries fixed because the other value is infeasible
  std::uint64_t rounds = 0;
  std::uint64_t programs = 0;
  bool nothing_left = false;  ///< no point is as good as the cutoff
  bool proved = true;         ///< whether all of it holds in spite of rounding
};

/// The rows of the kind a'x + M tau <= b, with one binary and other columns besides, of a program
/// as it is given. Each new M is worked out from the M and b that were given, so that rounds come
/// to an end; it is 0 where the row holds whatever tau is.
class BigMs {
 public:
  explicit BigMs(const linear::MixedProgram& given);

  /// Makes each M as small as the points that matter allow, in rounds, until little changes. Points
  /// with an objective of at most `cutoff` stay; of others some may be lost.
  /// @param mixed the program given, or what earlier calls have made of it
  /// @param proofs_only whether to leave all as it is that is not proved
  Tightening tighten(linear::MixedProgram& mixed, double cutoff, bool proofs_only = false,
                     const support::Stop& stop = {});

  /// How many coefficients are smaller than they were given.
  [[nodiscard]] std::uint64_t smaller() const;

 private:
  class Round;

  struct Row {
    std::size_t row = 0;
    std::size_t entry = 0;  // of the binary, among those of the program
    int binary = 0;
    bool from_below = false;  // the row is lower <= a'x + m tau, here with all signs changed
    double m = 0;
    double upper = 0;
    std::vector<linear::LinearTerm> others = {};
    bool smaller = false;
  };

  std::vector<Row> rows_;
};

}  // namespace kusabi::zero_one
