// Legend: meaning and scale of the marks of a picture.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pictures/svg/canvas.hpp"
#include "pictures/svg/scene.hpp"

namespace kusabi::pictures {

struct LegendEntry {
  /// Draws a sample 30 pixels wide, centred at a point.
  std::function<void(Canvas&, const PixelPoint&)> sample;
  std::string text;
};

/// Legend of one scene, with its numbers.
std::vector<LegendEntry> legend(const Scene& scene, const UnitNames& units);

/// Legend of several scenes on a sheet: all marks that occur, without numbers.
std::vector<LegendEntry> common_legend(const std::vector<Scene>& scenes);

/// Draws the legend column by column; longer texts take several rows. @param corner top left
/// @return its height
double draw_legend(Canvas& canvas, const std::vector<LegendEntry>& entries,
                   const PixelPoint& corner, double width, int columns);

}  // namespace kusabi::pictures
