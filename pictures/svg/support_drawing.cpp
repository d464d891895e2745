// Drawing of supports with marks of fixed size; only their directions are to scale.
#include "pictures/svg/support_drawing.hpp"

#include <vector>

namespace kusabi::pictures {
namespace {

/// Projected length below which a direction points at the eye.
constexpr double seen_end_on = 0.15;

class SupportDrawing {
 public:
  SupportDrawing(Canvas& canvas, const Scene& scene, const View& view, const Detail& detail)
      : canvas_(canvas),
        scene_(scene),
        view_(view),
        size_(2.2 * detail.mark),
        middle_((scene.positions.rowwise().maxCoeff() + scene.positions.rowwise().minCoeff()) / 2) {
  }

  void supports() {
    for (const auto& [node, fixed] : scene_.supports) {
      if (scene_.dimension == 3) {
        square(node);
      } else if (fixed[0] && fixed[1]) {
        const PixelPoint tip = at(node);
        canvas_.polygon("held",
                        {tip, tip + size_ * PixelPoint(0.6, 1), tip + size_ * PixelPoint(-0.6, 1)});
      } else {  // below a node fixed along y, beside one fixed along x alone
        draw_roller(canvas_, at(node), fixed[1] ? PixelPoint(0, 1) : PixelPoint(-1, 0), size_);
      }
    }
    for (const auto& [node, direction] : scene_.inclined) {
      const auto way = seen(node, direction.normalized());
      if (way.norm() > seen_end_on) {
        draw_roller(canvas_, at(node), way.normalized(), size_);
      } else {
        square(node);
      }
    }
    for (const auto& [node, axis] : scene_.springs) {
      const auto way = seen(node, Eigen::Vector3d::Unit(axis));
      draw_spring(canvas_, at(node), way.normalized(), 2.4 * size_);
    }
  }

 private:
  [[nodiscard]] PixelPoint at(int node) const { return view_(scene_.positions.col(node)); }

  void square(int node) {
    canvas_.rectangle("held", at(node) - PixelPoint(size_, size_) / 2, PixelPoint(size_, size_));
  }

  // Projection of a direction or its opposite, whichever points out of the structure's box.
  [[nodiscard]] PixelPoint seen(int node, Eigen::Vector3d direction) const {
    const Eigen::Vector3d place = scene_.positions.col(node);
    if (direction.dot(place - middle_) < 0) direction = -direction;
    return (view_(place + direction) - view_(place)) / view_.scale();
  }

  Canvas& canvas_;
  const Scene& scene_;
  const View& view_;
  double size_;
  Eigen::Vector3d middle_;
};

void ground(Canvas& canvas, const PixelPoint& middle, const PixelPoint& side, double half) {
  canvas.line("ground", middle + half * side, middle - half * side);
}

}  // namespace

void draw_roller(Canvas& canvas, const PixelPoint& node, const PixelPoint& back, double size) {
  const PixelPoint side(back.y(), -back.x());
  canvas.polygon("rolling", {node, node + size * back + 0.6 * size * side,
                             node + size * back - 0.6 * size * side});
  ground(canvas, node + 1.3 * size * back, side, 0.8 * size);
}

void draw_spring(Canvas& canvas, const PixelPoint& node, const PixelPoint& back, double length) {
  constexpr int turns = 6;
  const PixelPoint side(back.y(), -back.x());
  const double half = length / 6;
  std::vector<PixelPoint> points{node, node + 0.15 * length * back};
  for (int turn = 0; turn < turns; ++turn) {
    const double along = 0.15 + 0.7 * (turn + 0.5) / turns;
    points.emplace_back(node + along * length * back + (turn % 2 == 0 ? half : -half) * side);
  }
  points.emplace_back(node + 0.85 * length * back);
  points.emplace_back(node + length * back);
  canvas.polyline("spring", points);
  ground(canvas, points.back(), side, 1.6 * half);
}

void draw_supports(Canvas& canvas, const Scene& scene, const View& view, const Detail& detail) {
  canvas.begin_group("support");
  SupportDrawing(canvas, scene, view, detail).supports();
  canvas.end_group();
}

void draw_ties(Canvas& canvas, const Scene& scene, const Scales& scales, const View& view) {
  canvas.begin_group("support");
  for (const auto& [node, masters] : scene.ties) {
    const PixelPoint from = view(moved(scene, scales, node));
    for (const int other : masters) {
      const PixelPoint to = view(moved(scene, scales, other));
      if (from != to) canvas.line("tie", from, to);
    }
  }
  canvas.end_group();
}

}  // namespace kusabi::pictures
