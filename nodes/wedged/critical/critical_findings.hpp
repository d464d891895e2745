// Input and result of the search for the critical friction coefficient of a structure.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "engine/outcome.hpp"
#include "nodes/wedged/critical/critical_tree.hpp"
#include "nodes/wedged/friction/critical_pattern_tree.hpp"
#include "nodes/wedged/relaxation/pattern_options.hpp"
#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "support/bracket.hpp"

namespace kusabi::wedged {

enum class CriticalStrategy {
  automatic,  ///< global within a limit of nodes, then descent for larger trees
  descent,    ///< depth-first search for the smallest coefficient, from the largest one down
  global,     ///< best-first search for the smallest coefficient, from small ones up
  newton,     ///< all patterns that are feasible at the largest coefficient, by Newton's method
  bisection,  ///< the same by bisection, as in the paper
};

/// True if the search is for the smallest coefficient only, instead of one for each pattern.
constexpr bool finds_smallest_only(CriticalStrategy strategy) {
  return strategy == CriticalStrategy::automatic || strategy == CriticalStrategy::descent ||
         strategy == CriticalStrategy::global;
}

/// Default upper limit of the search; physical obstacles have smaller coefficients.
inline constexpr double default_max_friction = 1000;

/// Maximum multiple of the width that is represented exactly by a double.
inline constexpr double max_multiples = 1e15;

/// Blocks with at least this many candidates are solved in doubles only, with wider brackets by
/// default, since higher precision levels take minutes for each program.
inline constexpr int min_candidates_for_doubles = 101;
inline constexpr double default_width = 1e-8;
inline constexpr double default_width_in_doubles = 1e-6;

struct CriticalParameters {
  CriticalStrategy strategy = CriticalStrategy::automatic;
  /// Upper limit of the search, mu^0 of the paper; methods that treat each pattern require it.
  /// Nothing: default_max_friction, or the largest possible coefficient.
  std::optional<double> maximum{};
  /// Width of the brackets. Nothing: default_width, or default_width_in_doubles.
  std::optional<double> width{};
  /// Bounding of candidates during the descent and for the verification of the bracket.
  Tightening tightening = Tightening::automatic;
  /// Maximum number of nodes of the global search of `automatic` before descent; nothing: by the
  /// number of candidates.
  std::optional<std::uint64_t> trial_nodes{};
  /// Listing of all patterns feasible at the upper bound, and the limit of nodes for that.
  bool list = false;
  std::uint64_t list_nodes = std::numeric_limits<std::uint64_t>::max();
};

/// Parameters of the computation.
struct CriticalGrid {
  double width = default_width;
  double maximum = default_max_friction;
  Precision precision = Precision::escalating;
};

/// @throws std::invalid_argument if a coefficient or the width is out of range
CriticalGrid grid_of(const problems::WedgedProblem& problem, const CriticalParameters& parameters);

/// A pattern that becomes feasible within a bracket of the friction coefficient.
struct CriticalEntry {
  std::uint32_t block = 0;
  SignPattern pattern;
  double lower = 0;                  ///< infeasible here
  std::optional<double> upper;       ///< feasible here; nothing: at no known coefficient
  std::vector<double> reaction;      ///< of the block at `upper`; empty if not requested
  std::vector<double> displacement;  ///< likewise
};

/// Reasons why a bracket is incomplete.
enum class OpenPoint {
  no_upper_bound,     ///< above the lower bound it is undecided whether a configuration is wedged
  wide_bracket,       ///< feasibility is numerically undecided within the bracket
  lower_not_proved,   ///< infeasibility at the lower bound is not proved in exact arithmetic
  list_not_complete,  ///< the patterns were requested and not all are found
};

/// A phase of the computation.
enum class CriticalPhase {
  start,         ///< root relaxation and single leaves, without a tree
  primal,        ///< search for patterns that stick at little friction, without a tree
  form,          ///< lower bound by a quadratic form, without a tree
  trial,         ///< global search for the smallest coefficient within a limit of nodes
  dive,          ///< search for a feasible leaf, then for one with a smaller coefficient
  coarse,        ///< search for the smallest coefficient from above, to few digits
  fine,          ///< search for the smallest coefficient, to full accuracy
  patterns,      ///< patterns that are feasible at the largest coefficient
  coefficients,  ///< critical coefficients of these patterns
  lower_bound,   ///< proof of infeasibility at the lower bound
  upper_bound,   ///< proof of feasibility at the upper bound
  list,          ///< all patterns that are feasible at the upper bound
};

/// Costs of a phase, over all ranks. Counts may depend on the number of ranks.
struct CriticalCost {
  CriticalPhase phase = CriticalPhase::fine;
  double friction = 0;         ///< initial or only coefficient
  std::uint64_t opened = 0;    ///< nodes
  std::uint64_t programs = 0;  ///< cone programs; for trees of sign patterns one for each node
};

/// The result, on rank 0.
struct CriticalFindings {
  engine::Status status = engine::Status::solved;  ///< of the searches
  /// The phase in which a limit or signal stopped the run; nothing if the answer was found before.
  std::optional<CriticalPhase> stopped_in;
  /// In increasing order. For the smallest coefficient: the known patterns that are feasible at the
  /// upper bound, first the one that proves it, and all if requested.
  std::vector<CriticalEntry> patterns;
  /// No leaf is feasible at `lower` or below; one is at `upper`, if that is not open.
  support::Bracket bracket{.lower = support::Bound{0, support::Standing::proved}};
  bool exact = false;  ///< proved in exact arithmetic; otherwise by the solver's bounds
  /// Proved for displacements up to this many times the strains only; absent: for all.
  std::optional<double> displacement_ratio;
  bool lower_recorded = false;  ///< there is a certificate of `lower`
  bool upper_recorded = false;  ///< there is a certificate of `upper`
  std::vector<OpenPoint> open_points;
  std::vector<CriticalCost> costs;  ///< of all phases, in their order
  /// Costs of the last search for the bracket by ranks: of the global search, or of that for each
  /// pattern.
  std::vector<engine::RankReport<CriticalTree>> global_ranks;
  std::vector<engine::RankReport<CriticalPatternTree>> bisection_ranks;

  /// Sorts the patterns and derives the bracket from them.
  /// @param infeasible bound below which all other patterns are infeasible
  void conclude(double infeasible);

  [[nodiscard]] bool answered() const {
    return status == engine::Status::solved && open_points.empty();
  }
};

}  // namespace kusabi::wedged
