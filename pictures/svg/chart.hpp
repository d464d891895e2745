// Curves over a number: a staircase, a load factor that falls. Axes, grid, legend.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "pictures/svg/canvas.hpp"

namespace kusabi::pictures {

/// A place on a chart that is pointed out.
struct ChartMark {
  double x = 0, y = 0;
  std::string words;  ///< shown by browsers under the pointer
};

struct ChartSeries {
  std::string name;         ///< in the legend
  std::vector<Point> line;  ///< in the units of the axes; may be empty
  bool dashed = false;
  std::vector<ChartMark> marks;
};

struct Chart {
  std::string title;
  std::string description;         ///< what is to be seen, for those who do not see it
  std::vector<std::string> lines;  ///< below the title
  std::string x_name, y_name;
  bool whole_numbers = false;       ///< whether y counts something
  std::vector<ChartSeries> series;  ///< up to four of them have colours of their own
};

/// @pre some series has a point
void write_chart(std::ostream& out, const Chart& chart);

/// As a part of a page, like inline_picture.hpp: without the title and the lines below it.
/// @param id of the element @pre as above
std::string inline_chart(const std::string& id, const Chart& chart);

}  // namespace kusabi::pictures
