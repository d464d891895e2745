// What is known of the bracket while it is looked for: it only ever gets narrower, whatever finds
// what, and is shown as soon as it does.
#pragma once

#include <optional>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/tree/sign_pattern.hpp"

namespace kusabi::wedged {

/// The same on all ranks.
class CriticalBracket {
 public:
  CriticalBracket(engine::Analysis& analysis, double most) : analysis_(analysis), most_(most) {}

  /// Nothing wedges here, nor below.
  [[nodiscard]] double lower() const { return lower_; }
  /// A leaf is feasible here; nothing if none is known.
  [[nodiscard]] const std::optional<double>& upper() const { return upper_; }
  [[nodiscard]] double upper_or_infinity() const;
  /// It; of its block's own candidates.
  [[nodiscard]] const std::optional<PatternNode>& leaf() const { return leaf_; }
  [[nodiscard]] bool lower_proved() const { return lower_ == 0 || lower_proved_; }
  [[nodiscard]] bool upper_proved() const { return upper_proved_; }
  [[nodiscard]] bool is_one_cell(double width) const;

  /// Nothing wedges up to here. Of no effect if more is known.
  void raise(double lower);
  /// The leaf is feasible from here on. Likewise.
  void sink(double upper, const PatternNode& leaf);

  /// An end as it is now was put to the verifier's test and holds, or is where it does.
  void prove_lower(double lower);
  void prove_upper(double upper, const PatternNode& leaf);
  /// Where the end was thought to be it does not hold.
  void move_lower(double lower);
  void move_upper(std::optional<double> upper);
  void move_upper(double upper, const PatternNode& leaf);

  /// Shows what has changed since it was shown, at once if the run is not a short one.
  void show();

 private:
  engine::Analysis& analysis_;
  double most_;
  double lower_ = 0;
  std::optional<double> upper_;
  std::optional<PatternNode> leaf_;
  bool lower_proved_ = false, upper_proved_ = false;
  bool changed_ = false;
};

}  // namespace kusabi::wedged
