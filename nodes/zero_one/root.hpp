// Root of a mixed zero-one program, on every rank alike: the first relaxation, points for pruning,
// tighter coefficients, cuts.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "nodes/zero_one/incumbent_search.hpp"
#include "nodes/zero_one/relaxation.hpp"
#include "solvers/linear/basis.hpp"

namespace kusabi::zero_one {

enum class ZeroOneCuts {
  none,
  disjunctive,  ///< Algorithm 5.1 of the limit paper
};

struct ZeroOneRootOptions {
  ZeroOneCuts cuts = ZeroOneCuts::none;
  bool tighten = true;  ///< coefficients by optimisation (bound_tightening)
  bool dive = true;     ///< heuristics for points
  /// A known point, as values of all columns; it is used if it satisfies the program. Empty: none.
  std::vector<double> start = {};
  /// A point and an upper bound of its objective for pruning from the first node on: v^U of remark
  /// 4.5. It is not checked.
  std::optional<ZeroOnePoint> incumbent = {};
  /// True if nodes follow Algorithm 4.2 only, without rounding heuristics and reduced-cost fixing.
  bool as_printed = false;
  /// Polled during the work; ZeroOneRoot::interrupted records a stop. The tree polls it within long
  /// linear programs.
  support::Stop stop = {};
};

/// Counts of the root.
struct ZeroOneRootCounts {
  std::uint64_t programs = 0;      ///< all
  std::uint64_t cut_rounds = 0;    ///< rounds of Algorithm 5.1
  std::uint64_t cuts = 0;          ///< kept
  std::uint64_t cut_programs = 0;  ///< cut generating programs (51)
  std::uint64_t tightened = 0;     ///< coefficients made smaller
  std::uint64_t tighten_programs = 0;
  std::uint64_t fixed = 0;                 ///< binaries fixed because the other value is infeasible
  bool proved = true;                      ///< true if all cuts hold despite rounding
  double first_bound = -linear::infinity;  ///< of the given relaxation
  double last_bound = -linear::infinity;   ///< of the relaxation after all steps
};

struct ZeroOneRoot {
  Relaxation relaxation;
  linear::LinearStatus status = linear::LinearStatus::failed;  ///< of the relaxation
  linear::Basis basis = {};
  double bound = -linear::infinity;
  std::optional<ZeroOnePoint> point = {};
  bool as_printed = false;  ///< see the options
  /// The work was stopped: bound and point are valid, but may differ between ranks.
  bool interrupted = false;
  /// All points have an objective of program().constant plus a multiple of this; 0: no such number.
  double grid = 0;
  double grid_error = 0;  ///< rounding error of these, since doubles are not decimals
  ZeroOneRootCounts counts = {};
};

/// @pre of the search that follows: `interrupted` is false on all ranks
ZeroOneRoot prepare_root(linear::MixedProgram mixed, const ZeroOneRootOptions& options = {});

}  // namespace kusabi::zero_one
