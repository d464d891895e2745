// The answer of a run as one value: bounds and counts with their standing. Headlines, reservations,
// statuses and exit codes are functions of it (words.hpp, ending.hpp, verdict_json.hpp), and
// nothing else makes them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "engine/statistics.hpp"
#include "support/exact_count.hpp"

namespace kusabi::run {

/// Of a bound or a list that is there; one that is absent is open.
enum class Standing {
  proved,    ///< holds in spite of rounding
  computed,  ///< in floating point, without a proof
};

/// Grounds of what is proved.
enum class Grounds {
  exact_arithmetic,  ///< the test of kusabi verify
  solver_bounds,     ///< bounds of the solver in floating point, with room for rounding
};

struct Bound {
  double value = 0;
  Standing standing = Standing::computed;
};

/// A number between two bounds; an absent one is open.
struct Bracket {
  std::optional<Bound> lower{}, upper{};
};

/// The remainder of an exact test of a list of patterns (`--prove`, or scales that are far apart).
struct ExactDoubt {
  double scale_ratio = 1;   ///< of the structure
  std::string why{};        ///< the list may be another one, a clause; empty: all but `nodes` holds
  std::uint64_t nodes = 0;  ///< closed ones of which the test says nothing
};

/// Wedged configurations at one friction coefficient: `patterns`, `rays`.
struct Sticking {
  std::string thing = "way";  ///< counted, in the singular
  double friction = 0;
  bool factor = false;                       ///< `friction` multiplies that of each candidate
  support::ExactCount count{};               ///< it may exceed any integer type
  std::uint64_t undecided = 0;               ///< sign patterns that are not counted
  Standing standing = Standing::proved;      ///< of the list
  Grounds grounds = Grounds::solver_bounds;  ///< of a proved one
  std::uint64_t degenerate = 0;  ///< closed nodes with a margin of zero of which nothing is proved
  bool ambiguous = false;        ///< numbers too near to zero to be told from it
  std::optional<ExactDoubt> doubt{};  ///< absent: no exact test was called for, or it leaves none
};

/// The critical friction coefficient: `critical`.
struct CriticalBracket {
  Bracket bracket{};    ///< it cannot stick at `lower` or below, and sticks at `upper`
  bool factor = false;  ///< coefficients multiply that of each candidate
  double most = 0;      ///< upper limit of the search
  double width = 0;     ///< of the bracket, as asked for
  bool wide = false;    ///< the bracket is wider
  /// The patterns that stick at `upper` were asked for, and are not known.
  bool patterns_open = false;
  Grounds grounds = Grounds::exact_arithmetic;  ///< of proved ends
};

/// Numbers of patterns over the friction coefficient: `sweep --mu`.
struct FrictionSteps {
  double most = 0;      ///< upper limit of the sweep
  bool factor = false;  ///< coefficients multiply that of each candidate
  /// It cannot stick up to here; absent: the patterns at `most` were not all found.
  std::optional<Bound> infeasible{};
  support::ExactCount count{};         ///< of patterns at `most`
  std::uint64_t open_at_most = 0;      ///< patterns that may be added to it
  std::uint64_t open_patterns = 0;     ///< without a coefficient from which on they stick
  std::uint64_t undecided_points = 0;  ///< of those asked for
  std::optional<ExactDoubt> doubt{};   ///< of the counts
};

/// Bounds of an uncertain dead load.
struct LoadRange {
  std::optional<double> half_width{};  ///< absent: each load has its own
  std::optional<std::string> force{};  ///< unit of it; absent: it is a number of times the loads
};

/// Load factors that are carried: `limit`. Of an uncertain dead load those that are carried under
/// every admissible one, from the greatest of the least factors to the least of the largest.
struct LoadInterval {
  std::optional<LoadRange> uncertain{};  ///< absent: the dead load is as given
  Bracket least{}, most{};               ///< the ends of the interval
  /// A dead load is carried at no factor of either sign.
  std::optional<Standing> carried_at_none{};
  /// `most` rests on the M of (29): its bounds hold if that is large enough.
  bool if_big_m = false;
  /// Not all that was asked for was computed, such as a curve.
  bool incomplete = false;
  std::uint64_t cases = 1;  ///< load cases, in all of which the factors are carried
};

/// Load factors over the uncertainty of the dead load: `sweep --alpha`.
struct LoadSteps {
  std::optional<Bound> nominal{};              ///< without uncertainty
  std::optional<Standing> nominal_at_none{};   ///< the nominal load is carried at no factor
  std::optional<double> half_width{};          ///< of the last point computed
  std::optional<std::string> force{};          ///< its unit, as in LoadRange
  Bracket worst{};                             ///< the least of the largest factors there
  Bracket least{};                             ///< the greatest of the least factors there
  std::optional<Standing> worst_at_none{};     ///< there a load is carried at no factor
  std::uint64_t points = 0, points_asked = 0;  ///< computed, and of how many
  bool open = false;                           ///< a point or a piece of the curve is not proved
};

/// The optimum of a mixed zero-one program: `mip`.
struct MixedOptimum {
  enum class State { optimal, feasible, infeasible, unbounded, unknown };
  State state = State::unknown;
  bool maximise = false;
  std::optional<double> objective{};  ///< of the best point
  std::optional<Bound> bound{};       ///< no point has a better objective
  double gap = 0;                     ///< between the two, relative
  std::uint64_t unproved = 0;         ///< nodes closed without a proof
};

/// The states as result files have them, in their order.
inline constexpr std::array<std::string_view, 5> mixed_states{"optimal", "feasible", "infeasible",
                                                              "unbounded", "unknown"};

/// A certificate put to the proof: `verify`.
struct CertificateCheck {
  /// A list of patterns.
  struct List {
    std::uint64_t patterns = 0;
    std::uint64_t nodes = 0;      ///< of which something is proved
    std::uint64_t undecided = 0;  ///< nodes of which nothing is claimed
    /// Nodes whose proof leaves out displacements over `far_motion` times the strains.
    std::uint64_t but_far_motions = 0;
    double far_motion = 0;
  };
  /// Load factors under all admissible loads.
  struct Factor {
    LoadRange loads{};
    std::uint64_t cases = 1;
    bool at_none = false;         ///< some load is carried at no factor: no more is known
    double lower = 0, upper = 0;  ///< bounds of the least of the largest factors
    /// Bounds of the greatest of the least factors; absent: nothing is proved of it.
    std::optional<std::pair<double, double>> least{};
  };
  /// Patterns that stick, of which each is an example; nothing is said of others.
  struct Example {
    std::uint64_t patterns = 0;
  };
  std::uint64_t refusals = 0;
  std::variant<std::monostate, List, Example, Factor> claim{};
};

/// A measurement, and whether it found what it was compared with: `bench`.
struct Measurement {
  bool agrees = true;
};

/// Absent: the command answers no question.
using AnyAnswer =
    std::variant<std::monostate, Sticking, CriticalBracket, FrictionSteps, LoadInterval, LoadSteps,
                 MixedOptimum, CertificateCheck, Measurement>;

struct Verdict {
  engine::Status ended = engine::Status::solved;  ///< of the searches
  std::uint64_t nodes_left = 0;                   ///< open ones, if it ended early
  AnyAnswer answer{};
  std::vector<std::string> details{};  ///< sentences that belong to the headline
  std::vector<std::string>
      missing{};  ///< asked for besides the answer, and not made: a sentence each
  std::vector<std::string> warnings{};  ///< of the input
};

}  // namespace kusabi::run
