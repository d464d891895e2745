// Searches for states of one block under load: trees over ranges of load factors or coefficients,
// and bisection of both ends of the interval of a leaf.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "engine/collectives.hpp"
#include "nodes/wedged/hold/hold_search.hpp"
#include "nodes/wedged/hold/statics.hpp"

namespace kusabi::wedged {

/// Load factors and friction coefficients that one block holds, with their evidence.
class BlockHold {
 public:
  /// A bracket of the coefficient that is not divided by trees, and of a load factor that counts as
  /// decided, relative: a hundred times that of a leaf.
  static constexpr double close_enough = 1e-7;
  /// Load factors below this share of the ratio of both loads are zero to all digits of either.
  static constexpr double min_factor_share = 1e-12;

  /// @pre arguments outlive this object  @param recorded true: for record()
  BlockHold(engine::Analysis& analysis, const LoadedProblem& block,
            const HoldParameters& parameters, std::vector<HoldCost>& costs, bool recorded = false)
      : analysis_(analysis),
        block_(block),
        parameters_(parameters),
        costs_(costs),
        recorded_(recorded) {
    if (parameters.total) grip_ = GripRestriction{GripRestriction::Kind::equal, *parameters.total};
  }

  /// Factors of the reference load that are held with the dead load; without a dead part, alone.
  /// @param with_dead true: a dead load or a clearance acts on the block
  HeldFactors factors(double mu, bool with_dead);

  /// The interval of a pattern that has a state at the factor zero. On this rank alone.
  [[nodiscard]] HeldInterval ends_of(const LoadedPattern& pattern, double mu) {
    together_ = false;
    return interval(pattern, 0, mu, Standard::proved);
  }

  /// Answer for the dead load alone: all factors, or none.
  HeldFactors dead_alone(double mu);

  /// Bracket for the dead load with its clearances.
  HoldingFriction friction();

  /// Records the evidence of the last answer of factors() or dead_alone().
  /// @param block the same, at its coefficient
  void record(const RecordedBlock& block, HoldRecord& record) const;

  /// The tree without states at a lower bound of friction(); nothing if it is not proved.
  [[nodiscard]] std::optional<TreeEvidence> tree_at(double mu) const {
    if (trees_.empty() || trees_.back().mu != mu) return {};
    return trees_.back();
  }

  /// The state of a pattern under the dead load and a factor of the reference load. Nothing if
  /// neither a state nor its relative interior is known.
  [[nodiscard]] std::optional<HeldState> state(const std::optional<LoadedPattern>& pattern,
                                               double factor, double mu) const;

 private:
  /// Bisections of one end: more than the digits of a double.
  static constexpr int max_halvings = 70;

  /// Bracket of the point on a line at which a monotone answer changes: from `feasible`, where it
  /// is feasible, to `infeasible`.
  struct Ends {
    double feasible, infeasible;
    bool unbounded_by_limit = false;  ///< infinite, by a state of the reference load at a limit
    bool wide = false;                ///< undecided between them, over more than the usual width
  };
  struct FactorRange {
    double low, high;
    bool proved;

    friend bool operator==(const FactorRange&, const FactorRange&) = default;
  };
  /// States of a pattern for a certificate: at both ends, and at the finite factor `inside`.
  struct Piece {
    LoadedPattern pattern;
    double low, high, inside;
  };

  HoldOutcome search(std::span<const LoadShare> shares, double mu, double low, double high,
                     bool except_zero = false);
  // True if the dead load alone is held: its interval is then zero_.
  bool holds_zero(double mu);
  std::optional<HeldInterval> state_of_dead(const HoldOutcome& outcome, double low, double high);
  [[nodiscard]] bool may_end_at_zero(double held, double out) const;
  void join_zero(HeldFactors& found) const;
  [[nodiscard]] bool touches_with(const LoadedPattern& pattern) const;
  /// Conclusions that count: proved ones only, or also computed ones (relative interior at t* = 0).
  enum class Standard { proved, computed };
  static HoldResult by_standard(HoldResult result, Standard standard);

  [[nodiscard]] HoldResult at(const LoadedPattern& pattern, LoadShare share, double mu,
                              Standard standard) const;
  HeldFactors homogeneous_factors(double mu);
  bool wedges(double mu);
  /// The interval of a pattern that contains `from`.
  [[nodiscard]] HeldInterval interval(const LoadedPattern& pattern, double from, double mu,
                                      Standard standard) const;
  Ends extend(const LoadedPattern& pattern, double from, int direction, double mu,
              Standard standard) const;
  Ends approach(Ends ends, double expected, double floor,
                const std::function<HoldResult(double)>& result_at) const;
  Ends bisect(Ends ends, double floor, const std::function<HoldResult(double)>& result_at) const;
  void explore(HeldFactors& found, std::vector<FactorRange>& empty_ranges, double mu);
  void take(const LoadedLeaf& leaf, double low, double high, Standard standard, HeldFactors& found,
            std::vector<FactorRange>& unknown, double mu);
  bool take_limits(std::span<const LoadedLeaf> limits, double low, double high, HeldFactors& found,
                   std::vector<FactorRange>& unknown, double mu);
  static bool take_upper(HoldingFriction& found, const HoldOutcome& outcome, double mu);
  static void take_lower(HoldingFriction& found, const HoldOutcome& outcome, double mu);
  bool first_bracket(HoldingFriction& found);
  void follow(HoldingFriction& found, double minimum);
  void narrow(HoldingFriction& found);
  bool prove_lower(HoldingFriction& found, double max_infeasible);
  [[nodiscard]] double factor_scale() const;
  // A number, or nothing, by floating-point programs in which ranks may differ.
  template <class Make>
  auto by_first_rank(Make make) {
    using Value = typename std::invoke_result_t<Make, support::Stop>::value_type;
    const auto list = engine::from_first_rank(analysis_.transport(), [&] {
      const auto found = make(analysis_.budget().stop());
      return found ? std::vector<Value>{*found} : std::vector<Value>();
    });
    return list.empty() ? std::nullopt : std::optional<Value>(list.front());
  }
  // True on all ranks if the analysis is to end: long bisections then do so.
  [[nodiscard]] bool ended() const {
    ended_ = ended_ || (together_ && analysis_.ended());
    return ended_;
  }

  engine::Analysis& analysis_;
  const LoadedProblem& block_;
  const HoldParameters& parameters_;
  std::vector<HoldCost>& costs_;
  std::optional<GripRestriction> grip_{};
  std::optional<StaticRange>
      statics_{};                     // of the last coefficient: beside its ends bisection begins
  std::optional<double> expected_{};  // the coefficient that statics needs, likewise
  bool recorded_;
  bool together_ = true;        // every rank makes the same calls
  mutable bool ended_ = false;  // a bisection was left
  // Evidence of the last answer: the trees without states at the last coefficient with one.
  std::vector<TreeEvidence> trees_;
  std::vector<Piece> pieces_;
  std::optional<LoadedPattern> wedged_;
  // The factor 0, which is searched when a range beside it is undecided.
  bool zero_searched_ = false;
  std::optional<HeldInterval> zero_;
};

}  // namespace kusabi::wedged
