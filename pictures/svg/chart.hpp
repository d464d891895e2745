// Chart: curves over a number, for example a staircase or a decreasing load factor, with axes, grid
// and legend.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "pictures/svg/canvas.hpp"

namespace kusabi::pictures {

/// A marked point of a chart.
struct ChartMark {
  double x = 0, y = 0;
  std::string words;  ///< shown by browsers under the pointer
};

struct ChartSeries {
  std::string name;              ///< in the legend
  std::vector<PixelPoint> line;  ///< in the units of the axes; may be empty
  bool dashed = false;
  bool filled = false;  ///< the line is the boundary of an area
  std::vector<ChartMark> marks;
};

struct Chart {
  std::string title;
  std::string description;         ///< text alternative for readers who cannot see the chart
  std::vector<std::string> lines;  ///< below the title
  std::string x_name, y_name;
  bool whole_numbers = false;       ///< true if y is a count
  std::vector<ChartSeries> series;  ///< up to four have colours of their own
};

/// @pre some series has a point
void write_chart(std::ostream& out, const Chart& chart);

/// A chart as a part of a page, like inline_picture.hpp: without the title and the lines below it.
/// @param id of the element @pre as for write_chart
std::string inline_chart(const std::string& id, const Chart& chart);

}  // namespace kusabi::pictures
