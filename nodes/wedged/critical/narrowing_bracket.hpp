// Current bracket of the critical friction coefficient. Searches make it narrower; verification may
// widen it (move_lower, move_upper). Each change is shown in the progress output.
#pragma once

#include <optional>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "support/bracket.hpp"

namespace kusabi::wedged {

/// The bracket, equal on all ranks.
class NarrowingBracket {
 public:
  /// @param minimum of the coefficients that have programs; what sticks below it sticks there, too
  /// @param maximum of the search
  NarrowingBracket(engine::Analysis& analysis, double minimum, double maximum)
      : analysis_(analysis), minimum_(minimum), maximum_(maximum) {}

  [[nodiscard]] double minimum() const { return minimum_; }

  /// No configuration is wedged at this coefficient or below.
  [[nodiscard]] double lower() const { return bracket_.at_least(); }
  /// A leaf is feasible at this coefficient; nothing if none is known.
  [[nodiscard]] std::optional<double> upper() const;
  [[nodiscard]] double upper_or_infinity() const { return bracket_.at_most(); }
  /// Both bounds with their standing.
  [[nodiscard]] const support::Bracket& bracket() const { return bracket_; }
  /// The leaf of upper(), with the candidates of its block.
  [[nodiscard]] const std::optional<PatternNode>& leaf() const { return leaf_; }
  [[nodiscard]] bool lower_proved() const { return is_proved(bracket_.lower); }
  [[nodiscard]] bool upper_proved() const { return is_proved(bracket_.upper); }
  [[nodiscard]] bool is_one_cell(double width) const;

  /// Raises the lower bound; without effect if a better one is known.
  void raise_lower(double lower);
  /// Decreases the upper bound, at which the leaf is feasible; without effect if a better one is
  /// known.
  void reduce_upper(double upper, const PatternNode& leaf);

  /// Records that the lower bound was verified, possibly at a smaller coefficient.
  void prove_lower(double lower);
  /// Records that the upper bound was verified, possibly with another leaf at a larger coefficient.
  void prove_upper(double upper, const PatternNode& leaf);
  /// Replaces a lower bound that cannot be verified.
  void move_lower(double lower);
  /// Replaces an upper bound that cannot be verified. @param upper nothing: none is known
  void move_upper(std::optional<double> upper);
  /// The same with another leaf.
  void move_upper(double upper, const PatternNode& leaf);

  /// Reports changes since the last call, unless the run is still short.
  void show();

 private:
  engine::Analysis& analysis_;
  double minimum_, maximum_;
  // Nothing sticks without friction.
  support::Bracket bracket_{.lower = support::Bound{0, support::Standing::proved}};
  std::optional<PatternNode> leaf_;
  bool changed_ = false;
};

}  // namespace kusabi::wedged
