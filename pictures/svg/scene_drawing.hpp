// One scene in a frame of the paper.
#pragma once

#include "pictures/svg/canvas.hpp"
#include "pictures/svg/scales.hpp"
#include "pictures/svg/scene.hpp"
#include "pictures/svg/view.hpp"

namespace kusabi::pictures {

/// How much room there is for what is not drawn to scale.
struct Detail {
  double mark = 4.5;  ///< radius of a candidate's mark, pixels
  double head = 11;   ///< of an arrow
  bool names = true;  ///< of candidates
  bool hatch = true;  ///< of obstacles
};

/// For a picture of its own, and for one of many on a sheet.
inline constexpr Detail large_detail{};
inline constexpr Detail small_detail{.mark = 2.2, .head = 6, .names = false, .hatch = false};

/// Draws from the back to the front: the structure at rest, moved, obstacles and supports, friction
/// cones, forces, candidates.
void draw_scene(Canvas& canvas, const Scene& scene, const Frame& frame, const Detail& detail);

/// What the axes of space look like from here: three short arrows with their names.
void draw_axes(Canvas& canvas, const Point& corner);

}  // namespace kusabi::pictures
