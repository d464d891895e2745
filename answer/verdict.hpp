// Verdict: the answer of a run as one value, bounds and counts with their standing. Headlines,
// reservations, statuses and exit codes are made from it alone (words.hpp, ending.hpp,
// verdict_json.hpp).
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
#include "support/bracket.hpp"
#include "support/exact_count.hpp"

namespace kusabi::answer {

using support::Bound;
using support::Bracket;
using support::Standing;

/// Evidence for proved results.
enum class Grounds {
  exact_arithmetic,  ///< the test of kusabi verify
  solver_bounds,     ///< bounds of the solver in floating point, with room for rounding
};

/// Remainder of an exact test of a list of patterns (`--prove`, or scales that are far apart).
struct ExactRemainder {
  double scale_ratio = 1;  ///< of the structure
  std::string why{};  ///< clause: the list may be incomplete; empty: it is exact except for `nodes`
  std::uint64_t nodes = 0;  ///< closed nodes that the test does not cover
};

/// Wedged configurations at one friction coefficient: `patterns`, `rays`.
struct Sticking {
  std::string thing = "way";  ///< noun for the count, in the singular
  double friction = 0;
  bool factor = false;          ///< `friction` multiplies the coefficient of each candidate
  support::ExactCount count{};  ///< may exceed any integer type
  std::uint64_t undecided = 0;  ///< sign patterns not counted
  Standing standing{};          ///< of the list
  Grounds grounds = Grounds::solver_bounds;  ///< of a proved list
  std::uint64_t degenerate = 0;  ///< closed nodes with a margin of zero that are not proved
  bool ambiguous = false;        ///< numbers that cannot be distinguished from zero
  /// Absent: no exact test was requested, or nothing remains.
  std::optional<ExactRemainder> remainder{};
  /// Proved for displacements up to this many times the strains only; absent: for all.
  std::optional<double> displacement_ratio{};
  /// `--exists`: one pattern is the answer, and the list is not complete.
  bool example = false;
};

/// The critical friction coefficient: `critical`.
struct CriticalBracket {
  Bracket bracket{};    ///< the structure cannot stick at `lower` or below, and sticks at `upper`
  bool factor = false;  ///< coefficients multiply that of each candidate
  double maximum = 0;   ///< upper limit of the search
  double width = 0;     ///< requested width of the bracket
  bool wide = false;    ///< the bracket is wider
  /// The patterns that stick at `upper` were requested, and are not known.
  bool patterns_open = false;
  Grounds grounds = Grounds::exact_arithmetic;  ///< of proved ends
  std::optional<double> displacement_ratio{};   ///< as in Sticking
};

/// Reason of an answer about loads that needs no search.
enum class HoldReason {
  searched,    ///< none: the tree was searched
  supports,    ///< supports constrain every body: every load is held
  wedging,     ///< a wedged configuration holds every load
  unbalanced,  ///< the load moves a body along a motion that no candidate resists
};

/// Names in result files, in the order of the enumeration.
inline constexpr std::array<std::string_view, 4> hold_reasons{"searched", "supports", "wedging",
                                                              "unbalanced"};

/// The smallest friction coefficient at which the dead load can be held: `hold`.
struct HoldingBracket {
  Bracket bracket{};    ///< it cannot be held at `lower` or below, and can at `upper`
  bool factor = false;  ///< coefficients multiply that of each candidate
  double maximum = 0;   ///< upper limit of the search
  HoldReason reason = HoldReason::searched;
  std::string load_case{};  ///< empty: the file has none
};

/// The least and the largest sum of the normal reactions over all states under the dead load.
struct HoldingGrip {
  bool held = true;              ///< false: there is no state
  Standing held_standing{};      ///< of this answer
  Bracket minimum{}, maximum{};  ///< of each end
  bool unbounded = false;        ///< there is no largest sum
  Standing unbounded_standing{};
};

/// Factors of the reference load that can be held at one coefficient: `hold --mu`.
struct HoldingFactors {
  /// Both ends are held; infinite: no end.
  struct Interval {
    double low = 0, high = 0;
    Standing standing{};       ///< of the states at the ends
    Bracket below{}, above{};  ///< of each end: held, and not held; absent if there is no end
  };
  double friction = 0;
  bool factor = false;
  bool of_reference = true;  ///< false: the file has a dead load only, held or not
  std::vector<Interval> intervals{};
  Standing outside{};  ///< of the claim that no other factor is held
  bool open = false;   ///< factors may be missing
  HoldReason reason = HoldReason::searched;
  std::string load_case{};            ///< empty: the file has none
  std::optional<double> total{};      ///< sum of the normal reactions in all these states
  std::optional<HoldingGrip> grip{};  ///< if it was requested
};

/// The same at several coefficients: `hold --mu` with more than one.
struct HoldingSweep {
  std::uint64_t requested = 0;           ///< number of coefficients
  std::vector<HoldingFactors> points{};  ///< in their order; fewer if the search was stopped
};

/// Pairs of factors of two reference loads that can be held at one coefficient: `hold --diagram`.
struct HoldingDiagram {
  double friction = 0;
  bool factor = false;
  std::vector<std::string> cases{};  ///< names of both loads
  std::uint64_t pieces = 0;          ///< convex ones, each of a sign pattern
  bool everything = false;           ///< one of them contains all pairs
  Standing outside{};                ///< of the claim that no other pair is held
  bool open = false;                 ///< pieces may be missing
  std::uint64_t coarse = 0;  ///< pieces that contain more pairs than their vertices and rays do
};

/// Numbers of patterns over the friction coefficient: `sweep --mu`.
struct FrictionSteps {
  double maximum = 0;   ///< upper limit of the sweep
  bool factor = false;  ///< coefficients multiply that of each candidate
  /// It cannot stick up to here; absent: not all patterns at `maximum` were found.
  std::optional<Bound> infeasible{};
  support::ExactCount count{};         ///< of patterns at `maximum`
  std::uint64_t open_at_most = 0;      ///< patterns that may be added to the count
  std::uint64_t open_patterns = 0;     ///< patterns without a coefficient at which they become
                                       ///< feasible
  std::uint64_t undecided_points = 0;  ///< of the requested points
  std::optional<ExactRemainder> remainder{};  ///< of the counts
};

/// Bounds of an uncertain dead load.
struct LoadRange {
  std::optional<double> half_width{};  ///< absent: each load has its own
  std::optional<std::string> force{};  ///< unit of half_width; absent: a multiple of the loads
};

/// Load factors that are carried: `limit`. For an uncertain dead load, factors carried under every
/// admissible load: from the greatest of the least factors to the least of the largest.
struct LoadInterval {
  std::optional<LoadRange> uncertain{};  ///< absent: the dead load is fixed
  Bracket minimum{}, maximum{};          ///< the ends of the interval
  /// A dead load is carried at no factor of either sign.
  std::optional<Standing> carried_at_none{};
  /// Bounds of `maximum` hold only if the M of (29) is large enough.
  bool if_big_m = false;
  /// Part of the request, such as a curve, was not computed.
  bool incomplete = false;
  std::uint64_t cases = 1;  ///< load cases; the factors are carried in all of them
  /// The action that the load factor multiplies, in combinations of actions; empty: other loads.
  std::string reference_action{};
  /// Factors are carried while no strut falls below its residual strength; the outer bounds are
  /// those of full strength.
  bool struts = false;
};

/// Load factors after the loss of members: `limit --lose`.
struct MemberLoss {
  std::uint64_t maximum = 1;  ///< K: number of members that may be lost together
  Bracket factor{};           ///< the least of the largest factors that remain
  /// After the worst loss known the dead load is carried at no factor of either sign.
  std::optional<Standing> fatal{};
  std::vector<std::string> lost{};  ///< members of the worst loss known; empty: it lowers nothing
  std::optional<double> target{};   ///< the required factor; absent: the least one
  std::optional<bool> reached{};    ///< true if the target remains after each loss; absent: open
  std::uint64_t cases = 1;          ///< load cases
  bool uncertain = false;           ///< over all admissible loads
  std::vector<std::string> kept{};  ///< members that are not lost
  bool struts = false;              ///< as in LoadInterval
  double sudden = 1;                ///< dynamic factor; 1: the loss is not sudden
};

/// Load factors over the uncertainty of the dead load: `sweep --alpha`.
struct LoadSteps {
  std::optional<Bound> nominal{};              ///< without uncertainty
  std::optional<Standing> nominal_at_none{};   ///< the nominal load is not carried at any factor
  std::optional<double> half_width{};          ///< of the last point computed
  std::optional<std::string> force{};          ///< its unit, as in LoadRange
  Bracket worst{};                             ///< the least of the largest factors there
  Bracket minimum{};                           ///< the greatest of the least factors there
  std::optional<Standing> worst_at_none{};     ///< some load is not carried at any factor
  std::uint64_t points = 0, points_asked = 0;  ///< points computed, points requested
  bool open = false;                           ///< a point or a piece of the curve is not proved
};

/// The optimum of a mixed zero-one program: `mip`.
struct MixedOptimum {
  enum class State { optimal, feasible, infeasible, unbounded, unknown };
  State state = State::unknown;
  /// Of the point, or of the infeasible or unbounded program.
  Standing standing{};
  bool maximise = false;
  std::optional<double> objective{};  ///< value of the best point
  std::optional<Bound> bound{};       ///< no point has a better objective
  double gap = 0;                     ///< relative
  std::uint64_t unproved = 0;         ///< nodes closed without a proof
};

/// States in result files, in the order of the enumeration.
inline constexpr std::array<std::string_view, 5> mixed_states{"optimal", "feasible", "infeasible",
                                                              "unbounded", "unknown"};

/// Result of the verification of a certificate: `verify`.
struct CertificateCheck {
  /// A list of patterns.
  struct List {
    std::uint64_t patterns = 0;
    std::uint64_t nodes = 0;      ///< nodes with a proved claim
    std::uint64_t undecided = 0;  ///< nodes without a claim
    /// Nodes whose proof leaves out displacements over `displacement_ratio` times the strains.
    std::uint64_t except_large_displacements = 0;
    double displacement_ratio = 0;
  };
  /// Load factors under all admissible loads.
  struct Factor {
    LoadRange loads{};
    std::uint64_t cases = 1;
    bool at_none = false;         ///< some load is not carried at any factor; nothing else is known
    double lower = 0, upper = 0;  ///< bounds of the least of the largest factors
    bool struts = false;          ///< as in LoadInterval; a bound that is not proved is infinite
    /// Bounds of the greatest of the least factors; absent: none is proved.
    std::optional<std::pair<double, double>> minimum{};
  };
  /// Patterns that stick, one example each; others are not covered.
  struct Example {
    std::uint64_t patterns = 0;
  };
  /// Factors of the reference load; infinite: no end.
  struct Range {
    double low = 0, high = 0;
  };
  /// Bounds of the sum of the normal reactions in all states under the dead load.
  struct GripBounds {
    double below = 0;
    std::optional<double> above{};  ///< absent: none is proved
    std::optional<Range> states{};  ///< sums of two states
    [[nodiscard]] bool says_something() const { return below > 0 || above || states; }
  };
  /// States under load.
  struct Held {
    double friction = 0;
    std::string load_case{};        ///< empty: the file has none
    bool of_reference = true;       ///< false: the file has a dead load only
    std::optional<double> total{};  ///< sum of the normal reactions in these states
    std::vector<Range> held{};      ///< each factor has a state
    std::vector<Range> none{};      ///< no factor has one
    std::optional<GripBounds> grip{};
    bool except_large_displacements = false;  ///< proofs leave out displacements over
                                              ///< `displacement_ratio` times the strains
    double displacement_ratio = 0;
  };
  /// Least load factor over all losses of some members.
  struct Loss {
    std::uint64_t maximum = 1, cases = 1;
    std::string load_case{};          ///< the only one; empty: there are several, or none
    bool uncertain = false;           ///< over all admissible loads
    LoadRange loads{};                ///< the admissible loads; absent half-width: they differ
    bool as_given = false;            ///< the dead load as given; in the file it is uncertain
    std::vector<std::string> kept{};  ///< members that are not lost
    std::vector<std::string> lost{};  ///< the worst loss
    bool fatal = false;               ///< no factor remains after it
    std::optional<double> lower{};    ///< absent: only the upper bound is proved
    double upper = 0;
    bool struts = false;  ///< as in LoadInterval
    double sudden = 1;    ///< as in MemberLoss
  };
  std::uint64_t refusals = 0;
  std::variant<std::monostate, List, Example, Factor, Loss, Held> claim{};
};

/// A measurement, and its agreement with the reference: `bench`.
struct Measurement {
  bool agrees = true;
};

/// Absent: the command has no answer.
using AnyAnswer =
    std::variant<std::monostate, Sticking, CriticalBracket, HoldingBracket, HoldingFactors,
                 HoldingSweep, HoldingDiagram, FrictionSteps, LoadInterval, MemberLoss, LoadSteps,
                 MixedOptimum, CertificateCheck, Measurement>;

struct Verdict {
  engine::Status ended = engine::Status::solved;  ///< of the searches
  std::uint64_t nodes_left = 0;                   ///< open nodes, if the search ended early
  AnyAnswer answer{};
  std::vector<std::string> details{};   ///< sentences that belong to the headline
  std::vector<std::string> missing{};   ///< requested outputs that were not made: one sentence each
  std::vector<std::string> warnings{};  ///< about the input
};

}  // namespace kusabi::answer
