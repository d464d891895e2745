// Lines, areas and words of an SVG image. How they look is told by classes (svg/style.hpp).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace kusabi::pictures {

using Point = Eigen::Vector2d;  ///< in pixels, y downwards

class Canvas {
 public:
  void line(std::string_view kind, const Point& from, const Point& to);
  void polyline(std::string_view kind, const std::vector<Point>& points);
  void polygon(std::string_view kind, const std::vector<Point>& points);
  void circle(std::string_view kind, const Point& centre, double radius);
  void rectangle(std::string_view kind, const Point& corner, const Point& size);
  /// A line with a head at its end, no longer than a third of it; nothing if it has no length.
  void arrow(std::string_view kind, const Point& from, const Point& to, double head);
  /// @param anchor "start", "middle" or "end"
  void words(std::string_view kind, const Point& at, std::string_view anchor,
             std::string_view text);
  /// What is drawn until `end_group` has a class in common, and a title that browsers show.
  void begin_group(std::string_view kind, std::string_view title = {});
  void end_group();

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace kusabi::pictures
