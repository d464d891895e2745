// What holds a structure, as engineers draw it: triangles, rollers, springs, ties.
#pragma once

#include "pictures/svg/canvas.hpp"
#include "pictures/svg/scales.hpp"
#include "pictures/svg/scene.hpp"
#include "pictures/svg/scene_drawing.hpp"
#include "pictures/svg/view.hpp"

namespace kusabi::pictures {

/// Supports, inclined ones in their direction, and springs, all on the side of their node where the
/// structure is not, at rest.
void draw_supports(Canvas& canvas, const Scene& scene, const View& view, const Detail& detail);

/// A dashed line from each tied node to each node that it follows, where they have moved.
void draw_ties(Canvas& canvas, const Scene& scene, const Scales& scales, const View& view);

/// A roller that holds along a direction. @param back from the node to the ground, of length 1
void draw_roller(Canvas& canvas, const Point& node, const Point& back, double size);

/// A spring and the ground that it stands on. @param length from the node to the ground
void draw_spring(Canvas& canvas, const Point& node, const Point& back, double length);

}  // namespace kusabi::pictures
