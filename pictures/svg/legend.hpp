// What the marks of a picture mean, and how large what they stand for is.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pictures/svg/canvas.hpp"
#include "pictures/svg/scene.hpp"

namespace kusabi::pictures {

struct LegendEntry {
  /// Draws a sample of 30 pixels' width with its middle at a point.
  std::function<void(Canvas&, const Point&)> sample;
  std::string text;
};

/// Of one scene, with its numbers.
std::vector<LegendEntry> legend(const Scene& scene, const Units& units);

/// Of several on a sheet: all marks that one of them has, without numbers.
std::vector<LegendEntry> common_legend(const std::vector<Scene>& scenes);

inline constexpr double legend_row = 24;  ///< height, pixels

/// How high it is in so many columns.
double legend_height(const std::vector<LegendEntry>& entries, int columns);

/// Draws it column by column. @param corner top left
void draw_legend(Canvas& canvas, const std::vector<LegendEntry>& entries, const Point& corner,
                 double width, int columns);

}  // namespace kusabi::pictures
