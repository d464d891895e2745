// Choice between static cuts and corners by predicted work, so that the smaller one is not exceeded
// by far. Work is counted in iterations of program (5), not in seconds: the choice is the same on
// every machine and on all ranks. docs/theory/limit.md has the measured reasons.
#pragma once

namespace kusabi::limit {

class CornerChoice {
 public:
  /// @param loads uncertain ones of nonzero half-width
  /// @param first iterations of (5) for the nominal load, from the slack basis
  /// @param next mean iterations of (5) for another load, from the basis of the nominal one
  CornerChoice(int loads, double first, double next);

  /// True if there is one corner only, or if all take less work than one round of cuts, which has a program like (5) from
  /// the slack basis for each load.
  [[nodiscard]] bool is_less_than_a_round() const;

  /// True if all corners take less work than this.
  [[nodiscard]] bool is_less_than(double work) const { return work_for(loads_) < work; }

  /// The largest number of undecided signs for which the corners of a node of the tree of signs
  /// take at most the work of its bound.
  [[nodiscard]] int signs_within(double work) const;

  [[nodiscard]] int loads() const { return loads_; }

 private:
  [[nodiscard]] double work_for(int signs) const;

  int loads_;
  double first_;
  double next_;
};

}  // namespace kusabi::limit
