// Drawing of one scene in a frame of the paper.
#pragma once

#include "pictures/svg/canvas.hpp"
#include "pictures/svg/scales.hpp"
#include "pictures/svg/scene.hpp"
#include "pictures/svg/view.hpp"

namespace kusabi::pictures {

/// Sizes of marks that are not drawn to scale.
struct Detail {
  double mark = 4.5;  ///< radius of a candidate's mark, pixels
  double head = 11;   ///< of an arrow
  bool names = true;  ///< of candidates
  bool hatch = true;  ///< of obstacles
};

/// For a picture of one scene, and for one of many on a sheet.
inline constexpr Detail large_detail{};
inline constexpr Detail small_detail{.mark = 2.2, .head = 6, .names = false, .hatch = false};

/// Draws from back to front: undeformed structure, deformed structure, obstacles and supports,
/// friction cones, forces, candidates.
void draw_scene(Canvas& canvas, const Scene& scene, const PixelFrame& frame, const Detail& detail);

/// Directions of the axes in space: three short arrows with their names.
void draw_axes(Canvas& canvas, const PixelPoint& corner);

}  // namespace kusabi::pictures
