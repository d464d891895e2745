// The critical friction coefficient of a structure: what is asked, and what is found.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "engine/outcome.hpp"
#include "nodes/wedged/critical/critical_tree.hpp"
#include "nodes/wedged/friction/bisection.hpp"
#include "nodes/wedged/tree/sign_pattern.hpp"

namespace kusabi::wedged {

enum class CriticalWay {
  automatic,  ///< global for as many nodes as a descent would waste on a small tree, then descent
  descent,    ///< one depth-first search for the smallest, from the largest coefficient down
  global,     ///< one best-first search for it, from the smallest coefficient up
  newton,     ///< of every pattern that lives at the largest coefficient, by Newton's method
  bisection,  ///< the same by bisection, as the paper does it
};

/// Of one coefficient, or of one for each pattern?
constexpr bool looks_for_smallest(CriticalWay way) {
  return way == CriticalWay::automatic || way == CriticalWay::descent || way == CriticalWay::global;
}

/// How far a search for the smallest looks unless told: obstacles are not rougher.
inline constexpr double usual_most = 1000;

/// Points of the grid of brackets are multiples of the width: up to so many are exact in a double.
inline constexpr double most_multiples = 1e15;

/// From so many candidates in a block on programs are solved in doubles only, and brackets are
/// wider, unless their width was asked for: more digits take minutes a program.
inline constexpr int fewest_for_doubles = 101;
inline constexpr double usual_width = 1e-8;
inline constexpr double usual_width_in_doubles = 1e-6;

struct CriticalQuestion {
  CriticalWay way = CriticalWay::automatic;
  /// No larger coefficient is of interest; mu^0 of the paper, which the ways pattern by pattern
  /// need. Nothing: usual_most, or as far as can be computed with.
  std::optional<double> most{};
  /// Of the brackets. Nothing: usual_width, or usual_width_in_doubles.
  std::optional<double> width{};
  /// Whether candidates are bounded on the way down, and where ends are proved.
  Tightening tightening = Tightening::automatic;
  /// How many nodes `automatic` opens from below before it goes down; nothing: as many as pay.
  std::optional<std::uint64_t> trial_nodes{};
  /// Whether all patterns are listed that are feasible at the upper end, and for how many nodes.
  bool list = false;
  std::uint64_t list_nodes = std::numeric_limits<std::uint64_t>::max();
};

/// What is computed with.
struct CriticalGrid {
  double width = usual_width;
  double most = usual_most;
  Precision precision = Precision::escalating;
};

/// @throws std::invalid_argument if a coefficient or the width is out of range
CriticalGrid grid_of(const problems::WedgedProblem& problem, const CriticalQuestion& question);

/// A pattern that begins to live within a bracket of the friction coefficient.
struct CriticalEntry {
  std::uint32_t block = 0;
  SignPattern pattern;
  double lower = 0;                  ///< dead here
  std::optional<double> upper;       ///< alive here; nothing: not known to be anywhere
  std::vector<double> reaction;      ///< of the block at `upper`; empty if it was not asked for
  std::vector<double> displacement;  ///< likewise
};

/// What a bracket leaves open.
enum class CriticalDoubt {
  no_upper_end,       ///< above the lower end it could not be told whether anything can wedge
  wide_bracket,       ///< within it, what can wedge could not be told from what just cannot
  lower_not_proved,   ///< that nothing wedges at the lower end is not proved in exact arithmetic
  list_not_complete,  ///< the patterns were asked for, and not all are found
};

/// One of the searches that an answer takes.
enum class CriticalPhase {
  start,         ///< the root relaxation and single leaves, without a tree
  primal,        ///< for patterns that stick at little friction, without a tree
  trial,         ///< for the smallest, from zero up, for so many nodes
  dive,          ///< for one leaf, then for one that lives farther down
  coarse,        ///< for the smallest, down from some coefficient, to a few digits
  fine,          ///< for the smallest, to all digits
  patterns,      ///< the patterns that live at the largest coefficient
  coefficients,  ///< the critical coefficients of these
  lower_end,     ///< that nothing wedges at the lower end
  upper_end,     ///< what wedges at the upper end
  list,          ///< all patterns that are feasible at the upper end
};

/// What it took, over all ranks. Counts may depend on how many these are.
struct CriticalCost {
  CriticalPhase phase = CriticalPhase::fine;
  double friction = 0;         ///< from where on, or at which coefficient
  std::uint64_t opened = 0;    ///< nodes
  std::uint64_t programs = 0;  ///< cone programs; of the trees of sign patterns one a node
};

/// What was found, on rank 0.
struct CriticalFindings {
  engine::Status status = engine::Status::solved;  ///< of the searches
  /// In which phase the limit or signal came; nothing if it was answered before.
  std::optional<CriticalPhase> stopped_in;
  /// Smallest first. Of a search for the smallest: those known that are feasible at the upper end,
  /// first the one that proves it, and all if they were asked for.
  std::vector<CriticalEntry> patterns;
  double lower = 0;             ///< nothing lives here, nor below
  std::optional<double> upper;  ///< something does; nothing: not up to the largest
  bool lower_proved = false;    ///< every sign pattern was proved dead at `lower`
  bool upper_proved = false;    ///< a solid cone was proved to live at `upper`
  std::vector<CriticalDoubt> open;
  std::vector<CriticalCost> costs;  ///< of all searches, in their order
  /// What the last search for the bracket has cost, rank by rank: of the global one, or of that of
  /// each pattern.
  std::vector<engine::RankReport<CriticalTree>> global_ranks;
  std::vector<engine::RankReport<PatternBisection>> bisection_ranks;

  /// Sorts the patterns and reads the bracket from them and from what is known beside.
  /// @param dead nothing lives below, but for the patterns
  void conclude(double dead);

  [[nodiscard]] bool answered() const { return status == engine::Status::solved && open.empty(); }
};

}  // namespace kusabi::wedged
