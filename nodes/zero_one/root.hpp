// What is done with a mixed zero-one program before the search, on every rank alike: the first
// relaxation, points to prune with, tighter coefficients, cuts.
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
  bool dive = true;     ///< look for points
  /// A point known beforehand, as values of all columns; it is used if the program agrees that it
  /// is one. Empty: none.
  std::vector<double> start = {};
  /// A point and an upper bound of its objective, to prune with from the first node on: v^U of
  /// remark 4.5. It is taken as it is.
  std::optional<ZeroOnePoint> incumbent = {};
  /// Nodes do what Algorithm 4.2 says and no more: they round nothing and fix nothing by its cost.
  bool as_printed = false;
  /// Asked within the work; ZeroOneRoot::interrupted says whether it was heeded. The tree asks it
  /// within long linear programs.
  support::Stop stop = {};
};

/// What was done at the root.
struct ZeroOneRootCounts {
  std::uint64_t programs = 0;      ///< all
  std::uint64_t cut_rounds = 0;    ///< times round Algorithm 5.1
  std::uint64_t cuts = 0;          ///< kept
  std::uint64_t cut_programs = 0;  ///< cut generating programs (51)
  std::uint64_t tightened = 0;     ///< coefficients made smaller
  std::uint64_t tighten_programs = 0;
  std::uint64_t fixed = 0;                 ///< binaries fixed because the other value is infeasible
  bool proved = true;                      ///< whether the tightening holds in spite of rounding
  double first_bound = -linear::infinity;  ///< of the relaxation as given
  double last_bound = -linear::infinity;   ///< of the relaxation as the tree gets it
};

struct ZeroOneRoot {
  Relaxation relaxation;
  linear::LinearStatus status = linear::LinearStatus::failed;  ///< of the relaxation
  linear::Basis basis = {};
  double bound = -linear::infinity;
  std::optional<ZeroOnePoint> point = {};
  bool as_printed = false;  ///< see the options
  /// The work was ended early: bound and point are valid, but may differ from rank to rank.
  bool interrupted = false;
  /// All points have an objective of program().constant plus a multiple of this; 0: no such number.
  double grid = 0;
  double grid_error = 0;  ///< but for this much: doubles are not 0.1
  ZeroOneRootCounts counts = {};
};

/// @pre of the search that follows: `interrupted` is false on all ranks
ZeroOneRoot prepare_root(linear::MixedProgram mixed, const ZeroOneRootOptions& options = {});

}  // namespace kusabi::zero_one
