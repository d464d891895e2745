// Where t* of a node, as a function of the coefficient, passes zero: guessed from the points that
// were solved, by their values and slopes.
//
// Below its zero t* is smooth, and of one piece for long stretches. Above it is flat and has kinks,
// as between two vertices in the plane, and it may be zero throughout a range (a flat cone). So
// guesses come from below as soon as there is a point. docs/theory/wedged.md, "Critical friction".
#pragma once

#include <limits>
#include <optional>

namespace kusabi::wedged {

class LevelCurve {
 public:
  struct Guess {
    double factor;
    bool settled;  ///< whether it is off by much less than the width
  };

  /// @param width that the zero is asked for to, > 0
  explicit LevelCurve(double width) : width_(width) {}

  /// Takes what was solved at a coefficient. @param newton where its tangent vanishes
  void take(double factor, double level, double newton);
  /// Takes a point where t* is zero up to the tolerance.
  void take_tie(double factor);

  /// The least coefficient at which there was a tie; infinity: none.
  [[nodiscard]] double least_tie() const { return least_tie_; }

  /// Where to look next. @param floor, top where t* is known to be negative, and where it is known
  /// not to be: infinity if nowhere @return from floor on, and below top
  [[nodiscard]] Guess next(double floor, double top) const;

 private:
  struct Point {
    double factor = 0;
    double level = 0;
    double newton = 0;

    [[nodiscard]] double slope() const { return level / (factor - newton); }
  };

  [[nodiscard]] Guess from_below(const Point& point, double floor) const;
  static double zero_between(const Point& one, const Point& other);

  double width_;
  // Of those with t* < 0 the two with the largest coefficients; what came last of those above.
  std::optional<Point> below_, further_below_, above_;
  double least_tie_ = std::numeric_limits<double>::infinity();
};

}  // namespace kusabi::wedged
