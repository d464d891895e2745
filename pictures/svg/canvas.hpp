// Canvas: lines, areas and text of an SVG image. Classes determine the style (svg/style.hpp).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace kusabi::pictures {

using PixelPoint = Eigen::Vector2d;  ///< pixels, y downwards

/// Letters of a line that fill the width of a picture.
inline constexpr std::size_t longest_line = 122;

/// A text in lines of at most `longest` letters, broken at blanks; a longer word has its own line.
/// At least one line.
std::vector<std::string> lines_of(std::string_view text, std::size_t longest);

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
  /// A title and lines below it, longer ones in several. @param at start of the title
  /// @return y of the last line
  double head(const PixelPoint& at, const std::string& title,
              const std::vector<std::string>& lines);
  /// Begins a group with a common class, and a title that browsers show; `end_group` ends it.
  void begin_group(std::string_view kind, std::string_view title = {});
  void end_group();

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace kusabi::pictures
