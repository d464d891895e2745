// Verdict: the answer of a run as one value, bounds and counts with their standing. Headlines,
// reservations, statuses and exit codes are made from it alone (words.hpp, ending.hpp,
// verdict_json.hpp).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "answer/fields.hpp"
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

constexpr std::array<std::string_view, 2> names_of(Grounds /*type*/) {
  return {"exact-arithmetic", "solver-bounds"};
}

/// Remainder of an exact test of a list of patterns (`--prove`, or scales that are far apart).
struct ExactRemainder {
  static constexpr const char* title = "exact_remainder";
  double scale_ratio = 1;
  std::string why{};
  std::uint64_t nodes = 0;

  static constexpr auto fields() {
    return std::tuple{
        field("scale_ratio", &ExactRemainder::scale_ratio, "of the structure"),
        field("why", &ExactRemainder::why,
              "reason why the list may be incomplete, as a clause; empty: it is exact except for "
              "nodes"),
        field("nodes", &ExactRemainder::nodes, "closed nodes that the exact test does not cover")};
  }
};

/// Wedged configurations at one friction coefficient: `patterns`, `rays`.
struct Sticking {
  static constexpr const char* kind = "sticking";
  std::string thing = "way";
  double friction = 0;
  bool factor = false;
  support::ExactCount count{};
  std::uint64_t undecided = 0;
  Standing standing{};
  Grounds grounds = Grounds::solver_bounds;
  std::uint64_t degenerate = 0;
  bool ambiguous = false;
  std::optional<std::uint64_t> proved_cones{};
  std::optional<ExactRemainder> remainder{};
  std::optional<double> displacement_ratio{};
  bool example = false;

  static constexpr auto fields() {
    return std::tuple{
        field("thing", &Sticking::thing, "noun for the count, in the singular"),
        field("friction", &Sticking::friction),
        field("factor", &Sticking::factor, "friction multiplies the coefficients of the file"),
        field("count", &Sticking::count, "of patterns or rays"),
        field("not_counted", &Sticking::undecided, "sign patterns that are undecided"),
        field("standing", &Sticking::standing, "of the list"),
        field("grounds", &Sticking::grounds, "of a proved list"),
        field("degenerate", &Sticking::degenerate,
              "closed nodes with a margin of zero that are not proved"),
        if_any("proved_cones", &Sticking::proved_cones,
               "of rays: number of maximal cones, if exact arithmetic proves that there are no "
               "others"),
        field("exact_remainder", &Sticking::remainder,
              "what the exact test leaves open; null: nothing, or no test was requested"),
        field("displacement_ratio", &Sticking::displacement_ratio,
              "proved for displacements up to this many times the strains; null: for all"),
        if_any("example", &Sticking::example,
               "with --exists: one pattern is the answer, and the list is not complete")};
  }
};

/// The critical friction coefficient: `critical`.
struct CriticalBracket {
  static constexpr const char* kind = "critical";
  Bracket bracket{};
  bool factor = false;
  double maximum = 0;
  double width = 0;
  bool wide = false;
  bool patterns_open = false;
  Grounds grounds = Grounds::exact_arithmetic;
  std::optional<double> displacement_ratio{};

  static constexpr auto fields() {
    return std::tuple{
        field(
            "critical_friction", &CriticalBracket::bracket,
            "the structure cannot stick at the lower bound or below, and sticks at the upper one"),
        field("factor", &CriticalBracket::factor, "coefficients multiply those of the file"),
        field("maximum", &CriticalBracket::maximum, "upper limit of the search"),
        field("width", &CriticalBracket::width, "requested width of the bracket"),
        field("wide", &CriticalBracket::wide, "the bracket is wider"),
        field("patterns_open", &CriticalBracket::patterns_open,
              "patterns at the upper bound were requested and are not all known"),
        field("grounds", &CriticalBracket::grounds, "of proved bounds"),
        field("displacement_ratio", &CriticalBracket::displacement_ratio,
              "proved for displacements up to this many times the strains; null: for all")};
  }
};

/// Reason of an answer about loads that needs no search.
enum class HoldReason {
  searched,    ///< none: the tree was searched
  supports,    ///< supports constrain every body: every load is held
  wedging,     ///< a wedged configuration holds every load
  unbalanced,  ///< the load moves a body along a motion that no candidate resists
};

/// Names in files, in the order of the enumeration.
constexpr std::array<std::string_view, 4> names_of(HoldReason /*type*/) {
  return {"searched", "supports", "wedging", "unbalanced"};
}

/// The smallest friction coefficient at which the dead load can be held: `hold`.
struct HoldingBracket {
  static constexpr const char* kind = "holding-friction";
  struct OfCase {
    std::string name{};
    Bracket bracket{};
    HoldReason reason = HoldReason::searched;

    static constexpr auto fields() {
      return std::tuple{field("case", &OfCase::name), field("holding_friction", &OfCase::bracket),
                        field("reason", &OfCase::reason)};
    }
  };
  Bracket bracket{};
  bool factor = false;
  double maximum = 0;
  HoldReason reason = HoldReason::searched;
  std::string load_case{};
  std::vector<OfCase> cases{};

  static constexpr auto fields() {
    return std::tuple{
        field("holding_friction", &HoldingBracket::bracket,
              "the dead load, of each load case, can be held at the upper bound, and not at the "
              "lower one or below"),
        field("factor", &HoldingBracket::factor, "coefficients multiply those of the file"),
        field("maximum", &HoldingBracket::maximum, "upper limit of the search"),
        field("reason", &HoldingBracket::reason, "why no search was needed"),
        if_any("case", &HoldingBracket::load_case,
               "of several load cases: the one that needs most friction"),
        if_any("cases", &HoldingBracket::cases, "of several load cases: each of them")};
  }
};

/// The least and the largest sum of the normal reactions over all states under the dead load alone.
struct HoldingGrip {
  bool held = true;
  Standing standing{};
  Bracket minimum{};
  Bracket maximum{};
  bool unbounded = false;
  Standing unbounded_standing{};

  /// The proved or computed lower bound; zero if there is none, since no sum is negative.
  [[nodiscard]] Bound at_least() const {
    return minimum.lower.value_or(Bound{0, Standing::proved});
  }
  /// False if the least sum may be far above its lower bound.
  [[nodiscard]] bool has_least() const {
    constexpr double near = 1e-3;
    return minimum.upper && minimum.upper->value - at_least().value <= near * minimum.upper->value;
  }

  static constexpr auto fields() {
    return std::tuple{field("held", &HoldingGrip::held, "false: there is no state"),
                      field("standing", &HoldingGrip::standing, "of held"),
                      field("minimum", &HoldingGrip::minimum, "of the least sum"),
                      field("maximum", &HoldingGrip::maximum, "of the largest sum"),
                      field("unbounded", &HoldingGrip::unbounded, "there is no largest sum"),
                      field("unbounded_standing", &HoldingGrip::unbounded_standing)};
  }
};

/// What is proved of an interval of load factors that are held.
enum class IntervalStanding {
  computed,
  states_proved,  ///< states at both ends, but not that none is beyond them
  proved,         ///< states at both ends, and none beyond them up to the next interval
};

/// Names in files and tables, in the order of the enumeration.
constexpr std::array<std::string_view, 3> names_of(IntervalStanding /*type*/) {
  return {"computed", "states proved", "proved"};
}

/// Factors of the reference load that can be held at one coefficient: `hold --mu`.
struct HoldingFactors {
  static constexpr const char* kind = "holding-factors";
  static constexpr const char* title = kind;
  struct Interval {
    IntervalStanding standing{};
    Bracket below{};
    Bracket above{};

    /// @param states standing of those at both ends  @param below, above brackets of both ends
    static Interval from(Standing states, const Bracket& below, const Bracket& above) {
      const bool none_beyond =
          (!below.upper || is_proved(below.lower)) && (!above.lower || is_proved(above.upper));
      return {!is_proved(states) ? IntervalStanding::computed
              : none_beyond      ? IntervalStanding::proved
                                 : IntervalStanding::states_proved,
              below, above};
    }
    /// Of those at both ends.
    [[nodiscard]] Standing states() const {
      return support::proved_if(standing != IntervalStanding::computed);
    }

    /// The ends, which are held; infinite: there is none.
    [[nodiscard]] double low() const { return below.upper ? below.at_most() : -unbounded; }
    [[nodiscard]] double high() const { return above.lower ? above.at_least() : unbounded; }
    static constexpr double unbounded = std::numeric_limits<double>::infinity();

    static constexpr auto fields() {
      return std::tuple{
          field("standing", &Interval::standing,
                "proved: there are states at both ends, and none beyond them up to the next "
                "interval; states proved: only the former is"),
          field("below", &Interval::below,
                "of the lower end, from a factor that is not held to one that is; both open: no "
                "end"),
          field("above", &Interval::above,
                "of the upper end, from a factor that is held to one that is not; both open: no "
                "end")};
    }
  };
  struct OfCase {
    std::string name{};
    std::vector<Interval> intervals{};
    std::optional<Standing> outside{};
    bool open = false;
    HoldReason reason = HoldReason::searched;

    static constexpr auto fields() {
      return std::tuple{field("case", &OfCase::name), field("intervals", &OfCase::intervals),
                        field("outside", &OfCase::outside), field("open", &OfCase::open),
                        field("reason", &OfCase::reason)};
    }
  };
  double friction = 0;
  bool factor = false;
  bool of_reference = true;
  std::vector<Interval> intervals{};
  std::optional<Standing> outside{};
  bool open = false;
  HoldReason reason = HoldReason::searched;
  std::string load_case{};
  std::optional<double> total{};
  std::optional<HoldingGrip> grip{};
  std::vector<OfCase> cases{};

  [[nodiscard]] bool holds_all() const {
    return intervals.size() == 1 && intervals.front().low() == -Interval::unbounded &&
           intervals.front().high() == Interval::unbounded;
  }

  static constexpr auto fields() {
    return std::tuple{
        field("friction", &HoldingFactors::friction),
        field("factor", &HoldingFactors::factor,
              "friction multiplies the coefficients of the file"),
        field("of_reference", &HoldingFactors::of_reference,
              "false: the file has a dead load only, held or not"),
        field("intervals", &HoldingFactors::intervals,
              "factors of the reference load that can be held, in each load case"),
        field("outside", &HoldingFactors::outside,
              "standing of the claim that no other factor is held; null: others may be held, or "
              "all are"),
        field("open", &HoldingFactors::open, "factors may be missing"),
        field("reason", &HoldingFactors::reason, "why no search was needed"),
        if_any(
            "case", &HoldingFactors::load_case,
            "of several load cases: the one that bounds the factors from above, else from below"),
        if_any("total", &HoldingFactors::total, "with --total: the sum of the normal reactions"),
        if_any("grip", &HoldingFactors::grip,
               "with --grip: the range of the sum of the normal reactions"),
        if_any("cases", &HoldingFactors::cases, "of several load cases: each of them")};
  }
};

/// The same at several coefficients: `hold --mu` with more than one.
struct HoldingSweep {
  static constexpr const char* kind = "holding-sweep";
  std::uint64_t requested = 0;
  std::vector<HoldingFactors> points{};

  static constexpr auto fields() {
    return std::tuple{
        field("requested", &HoldingSweep::requested, "number of coefficients"),
        field("points", &HoldingSweep::points, "in their order; fewer if the search was stopped")};
  }
};

/// Pairs of factors of two reference loads that can be held at one coefficient: `hold --diagram`.
struct HoldingDiagram {
  static constexpr const char* kind = "holding-diagram";
  double friction = 0;
  bool factor = false;
  std::vector<std::string> cases{};
  std::uint64_t pieces = 0;
  bool everything = false;
  std::optional<Standing> outside{};
  bool open = false;
  std::uint64_t coarse = 0;

  static constexpr auto fields() {
    return std::tuple{field("friction", &HoldingDiagram::friction),
                      field("factor", &HoldingDiagram::factor,
                            "friction multiplies the coefficients of the file"),
                      field("cases", &HoldingDiagram::cases, "names of both reference loads"),
                      field("outside", &HoldingDiagram::outside,
                            "standing of the claim that no other pair is held; null: others may be "
                            "held, or all are"),
                      field("open", &HoldingDiagram::open, "pieces may be missing")};
  }
};

/// Numbers of patterns over the friction coefficient: `sweep --mu`.
struct FrictionSteps {
  static constexpr const char* kind = "friction-steps";
  double maximum = 0;
  bool factor = false;
  std::optional<Bound> infeasible{};
  support::ExactCount count{};
  std::uint64_t open_at_most = 0;
  std::uint64_t open_patterns = 0;
  std::uint64_t undecided_points = 0;
  std::optional<ExactRemainder> remainder{};
  std::optional<double> displacement_ratio{};

  static constexpr auto fields() {
    return std::tuple{
        field("maximum", &FrictionSteps::maximum, "upper limit of the sweep"),
        field("factor", &FrictionSteps::factor, "coefficients multiply those of the file"),
        field(
            "infeasible", &FrictionSteps::infeasible,
            "it cannot stick up to here; proved: as are the counts at the requested coefficients, "
            "at the maximum and at both bounds of each step; null: not all patterns at the "
            "maximum were found"),
        field("undecided_points", &FrictionSteps::undecided_points,
              "of the requested coefficients"),
        field("exact_remainder", &FrictionSteps::remainder,
              "what the exact test of the counts leaves open"),
        if_any("displacement_ratio", &FrictionSteps::displacement_ratio,
               "proved for displacements up to this many times the strains; absent: for all")};
  }
};

/// Bounds of an uncertain dead load.
struct LoadRange {
  std::optional<double> half_width{};
  std::optional<std::string> force{};

  static constexpr auto fields() {
    return std::tuple{
        field("half_width", &LoadRange::half_width, "null: each load has its own"),
        field("force", &LoadRange::force, "unit of half_width; null: a multiple of the loads")};
  }
};

/// Load factors that are carried: `limit`. For an uncertain dead load, factors carried under every
/// admissible load: from the greatest of the least factors to the least of the largest.
struct LoadInterval {
  static constexpr const char* kind = "load-interval";
  std::optional<LoadRange> uncertain{};
  Bracket minimum{};
  Bracket maximum{};
  std::optional<Standing> carried_at_none{};
  bool if_big_m = false;
  bool incomplete = false;
  std::uint64_t cases = 1;
  std::string reference_action{};
  std::optional<double> reference_factor{};
  bool struts = false;

  static constexpr auto fields() {
    return std::tuple{
        field("uncertain", &LoadInterval::uncertain, "bounds of the dead load; null: it is fixed"),
        field("minimum", &LoadInterval::minimum,
              "of the least factor that is carried, under every admissible load"),
        field("maximum", &LoadInterval::maximum,
              "of the largest factor that is carried, under every admissible load"),
        field("carried_at_none", &LoadInterval::carried_at_none,
              "standing of the claim that some admissible dead load, of some load case, is carried "
              "at no factor of either sign; null: none is known to be"),
        field("if_big_m", &LoadInterval::if_big_m,
              "the bounds of the maximum hold only if the M of (29) is large enough"),
        field("incomplete", &LoadInterval::incomplete,
              "part of the request, such as a curve, was not computed"),
        if_any("reference_action", &LoadInterval::reference_action,
               "the action that the load factor multiplies"),
        if_any("reference_factor", &LoadInterval::reference_factor,
               "factor of that action; absent: it differs between the combinations")};
  }
};

/// Load factors after the loss of members: `limit --lose`.
struct MemberLoss {
  static constexpr const char* kind = "member-loss";
  std::uint64_t maximum = 1;
  Bracket factor{};
  std::optional<Standing> fatal{};
  std::vector<std::string> lost{};
  std::optional<double> target{};
  std::optional<bool> reached{};
  std::uint64_t cases = 1;
  bool uncertain = false;
  std::vector<std::string> kept{};
  bool struts = false;
  double sudden = 1;

  static constexpr auto fields() {
    return std::tuple{
        field("lost_at_most", &MemberLoss::maximum, "K: members that may be lost together"),
        field("factor", &MemberLoss::factor, "of the least of the largest factors that remain"),
        field("fatal", &MemberLoss::fatal,
              "after the worst loss known the dead load is carried at no factor of either sign; "
              "null: it is"),
        field("lost", &MemberLoss::lost,
              "members of the worst loss known; empty: no loss is known that lowers the factor"),
        field("target", &MemberLoss::target,
              "the required factor; null: the least one was requested"),
        field("reached", &MemberLoss::reached, "the target remains after each loss; null: open"),
        field("uncertain", &MemberLoss::uncertain, "over all admissible loads"),
        if_any("kept", &MemberLoss::kept, "members that are not lost"),
        field("sudden", &MemberLoss::sudden, "dynamic factor; 1: the loss is not sudden")};
  }
};

/// Load factors over the uncertainty of the dead load: `sweep --alpha`.
struct LoadSteps {
  static constexpr const char* kind = "load-steps";
  std::optional<Bound> nominal{};
  std::optional<Standing> nominal_at_none{};
  std::optional<double> half_width{};
  std::optional<std::string> force{};
  Bracket worst{};
  Bracket minimum{};
  std::optional<Standing> worst_at_none{};
  std::uint64_t points = 0;
  std::uint64_t points_asked = 0;
  bool open = false;

  static constexpr auto fields() {
    return std::tuple{
        field("nominal", &LoadSteps::nominal,
              "lower bound of the largest factor without uncertainty"),
        field("nominal_at_none", &LoadSteps::nominal_at_none,
              "the nominal load is carried at no factor"),
        field("force", &LoadSteps::force, "unit of alpha; null: it is a multiple of the loads"),
        field("worst_at_none", &LoadSteps::worst_at_none,
              "at the last point some load is carried at no factor"),
        field("requested", &LoadSteps::points_asked, "number of points"),
        field("open", &LoadSteps::open, "a point or a piece of the curve is not proved")};
  }
};

/// The optimum of a mixed zero-one program: `mip`.
struct MixedOptimum {
  static constexpr const char* kind = "mixed-optimum";
  enum class State { optimal, feasible, infeasible, unbounded, unknown };
  friend constexpr std::array<std::string_view, 5> names_of(State /*type*/) {
    return {"optimal", "feasible", "infeasible", "unbounded", "unknown"};
  }
  State state = State::unknown;
  Standing standing{};
  bool maximise = false;
  std::optional<double> objective{};
  std::optional<Bound> bound{};
  std::optional<double> gap{};
  std::uint64_t unproved = 0;

  static constexpr auto fields() {
    return std::tuple{
        field("state", &MixedOptimum::state),
        field("standing", &MixedOptimum::standing,
              "of the point, or of the infeasible or unbounded program"),
        field("maximise", &MixedOptimum::maximise),
        field("objective", &MixedOptimum::objective, "value of the best point"),
        field("bound", &MixedOptimum::bound, "no point has a better objective"),
        field("gap", &MixedOptimum::gap, "relative; null: no bound is known"),
        field("unproved", &MixedOptimum::unproved, "nodes that were closed without a proof")};
  }
};

/// Result of the verification of a certificate: `verify`.
struct CertificateCheck {
  /// A list of patterns.
  struct List {
    std::uint64_t patterns = 0;
    std::uint64_t nodes = 0;                     ///< nodes with a proved claim
    std::uint64_t undecided = 0;                 ///< nodes without a claim
    std::optional<double> displacement_ratio{};  ///< as in Sticking
  };
  /// Load factors under all admissible loads.
  struct Factor {
    LoadRange loads{};
    std::uint64_t cases = 1;
    bool at_none = false;  ///< some load is not carried at any factor; nothing else is known
    Bracket largest{};     ///< of the least of the largest factors
    Bracket minimum{};     ///< of the greatest of the least factors
    bool struts = false;   ///< as in LoadInterval
  };
  /// Patterns that stick, one example each; others are not covered.
  struct Example {
    std::uint64_t patterns = 0;
  };
  /// The sum of the normal reactions in all states under the dead load.
  struct Grip {
    Bracket sum{};
    std::optional<Bracket> states{};  ///< sums of two states
    [[nodiscard]] bool says_something() const { return sum.lower || sum.upper || states; }
  };
  /// States under load.
  struct Held {
    std::optional<double> friction{};  ///< of all candidates; absent: they differ
    std::string load_case{};           ///< empty: the file has none
    bool of_reference = true;          ///< false: the file has a dead load only
    std::optional<double> total{};     ///< sum of the normal reactions in these states
    std::vector<Bracket> held{};       ///< each factor between the bounds has a state
    std::vector<Bracket> none{};       ///< no factor has one
    std::optional<Grip> grip{};
    std::optional<double> displacement_ratio{};  ///< as in Sticking
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
    Bracket factor{};                 ///< open on both sides if the loss is fatal
    bool struts = false;              ///< as in LoadInterval
    double sudden = 1;                ///< as in MemberLoss
  };
  /// An infinite bound is open.
  static std::optional<Bound> proved_at(double value) {
    if (std::isinf(value)) return {};
    return Bound{value, Standing::proved};
  }
  static Bracket proved_between(double low, double high) {
    return {proved_at(low), proved_at(high)};
  }

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
  std::optional<std::uint64_t> nodes_left{};      ///< open nodes of a search that ended early
  AnyAnswer answer{};
  std::vector<std::string> details{};   ///< sentences that belong to the headline
  std::vector<std::string> missing{};   ///< requested outputs that were not made: one sentence each
  std::vector<std::string> warnings{};  ///< about the input
};

}  // namespace kusabi::answer
