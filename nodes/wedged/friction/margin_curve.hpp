// Estimate of the zero of t* of a node as a function of the coefficient, from values and slopes at
// solved points.
//
// Below its zero t* is piecewise smooth with long pieces. Above it is flat and has kinks, as
// between two vertices in the plane, and it may be zero throughout a range (a flat cone). Estimates
// therefore use points below as soon as there is one (docs/theory/wedged.md, "Critical friction").
#pragma once

#include <limits>
#include <optional>

namespace kusabi::wedged {

class MarginCurve {
 public:
  struct Estimate {
    double factor;
    bool settled;  ///< true if the error is far below the width
  };

  /// @param width required accuracy of the zero, > 0
  explicit MarginCurve(double width) : width_(width) {}

  /// Adds a solved point. @param newton zero of its tangent
  void add(double factor, double margin, double newton);
  /// Adds a point at which t* is zero within the tolerance.
  void add_degenerate(double factor);

  /// The least coefficient of a degenerate point; infinity: none.
  [[nodiscard]] double min_degenerate() const { return min_degenerate_; }

  /// The next estimate, in [floor, top).
  /// @param floor t* is negative there
  /// @param top t* is not negative there; infinity: no such coefficient is known
  [[nodiscard]] Estimate next(double floor, double top) const;

 private:
  struct Point {
    double factor = 0;
    double margin = 0;
    double newton = 0;

    [[nodiscard]] double slope() const { return margin / (factor - newton); }
  };

  [[nodiscard]] Estimate from_below(const Point& point, double floor) const;
  static double zero_between(const Point& one, const Point& other);

  double width_;
  // Of the points with t* < 0 the two with the largest coefficients; of those above the last.
  std::optional<Point> below_, further_below_, above_;
  double min_degenerate_ = std::numeric_limits<double>::infinity();
};

}  // namespace kusabi::wedged
