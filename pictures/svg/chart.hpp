// Chart: curves, bars and areas over a number, for example a staircase or a decreasing load factor,
// with axes, grid and legend.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "pictures/svg/canvas.hpp"

namespace kusabi::pictures {

/// A marked point of a chart.
struct ChartMark {
  double x = 0, y = 0;
  std::string words;  ///< shown by browsers under the pointer
};

/// The convex hull of vertices, unbounded along rays.
struct ChartArea {
  std::vector<Eigen::Vector2d> vertices;
  std::vector<Eigen::Vector2d> rays{};
};

enum class Stroke { curve, dashed, bar };

/// In the units of the axes. A line with an infinite coordinate at an end, and an area with rays,
/// have no end there: they run to the frame, a line with an arrow.
struct ChartSeries {
  std::string name;  ///< in the legend; a series may consist of it alone
  std::vector<std::vector<Eigen::Vector2d>> lines{};
  Stroke stroke = Stroke::curve;
  std::vector<ChartMark> marks{};
  std::vector<ChartArea> areas{};
};

struct Chart {
  std::string title;
  std::string description;         ///< text alternative for readers who cannot see the chart
  std::vector<std::string> lines;  ///< below the title
  std::string x_name, y_name;
  bool whole_numbers = false;       ///< true if y is a count
  std::vector<ChartSeries> series;  ///< up to four have colours of their own
  /// The part of the plane that is shown; absent: all points.
  std::optional<Eigen::AlignedBox2d> shown{};
};

void write_chart(std::ostream& out, const Chart& chart);

/// A chart as a part of a page, like inline_picture.hpp: without the title and the lines below it.
/// @param id of the element
std::string inline_chart(const std::string& id, const Chart& chart);

}  // namespace kusabi::pictures
