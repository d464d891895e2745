// Drawing of supports and multi-point constraints with the usual symbols: triangles, rollers,
// springs, dashed lines.
#pragma once

#include "pictures/svg/canvas.hpp"
#include "pictures/svg/scales.hpp"
#include "pictures/svg/scene.hpp"
#include "pictures/svg/scene_drawing.hpp"
#include "pictures/svg/view.hpp"

namespace kusabi::pictures {

/// Draws supports, inclined ones in their direction, and springs at the undeformed position, on the
/// outer side of their node.
void draw_supports(Canvas& canvas, const Scene& scene, const View& view, const Detail& detail);

/// Draws a dashed line from each dependent node to each of its master nodes, at their displaced
/// positions.
void draw_ties(Canvas& canvas, const Scene& scene, const Scales& scales, const View& view);

/// A roller along a direction. @param back from the node to the ground, of length 1
void draw_roller(Canvas& canvas, const PixelPoint& node, const PixelPoint& back, double size);

/// A spring and its ground. @param length from the node to the ground
void draw_spring(Canvas& canvas, const PixelPoint& node, const PixelPoint& back, double length);

}  // namespace kusabi::pictures
