// Canvas: lines, areas and text of an SVG image. Classes determine the style (svg/style.hpp).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace kusabi::pictures {

using PixelPoint = Eigen::Vector2d;  ///< pixels, y downwards

class Canvas {
 public:
  void line(std::string_view kind, const PixelPoint& from, const PixelPoint& to);
  void polyline(std::string_view kind, const std::vector<PixelPoint>& points);
  void polygon(std::string_view kind, const std::vector<PixelPoint>& points);
  void circle(std::string_view kind, const PixelPoint& centre, double radius);
  void rectangle(std::string_view kind, const PixelPoint& corner, const PixelPoint& size);
  /// A line with a head at its end, no longer than a third of the line; nothing if the line has no
  /// length.
  void arrow(std::string_view kind, const PixelPoint& from, const PixelPoint& to, double head);
  /// @param anchor "start", "middle" or "end"
  void words(std::string_view kind, const PixelPoint& at, std::string_view anchor,
             std::string_view text);
  /// Begins a group with a common class, and a title that browsers show; `end_group` ends it.
  void begin_group(std::string_view kind, std::string_view title = {});
  void end_group();

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace kusabi::pictures
