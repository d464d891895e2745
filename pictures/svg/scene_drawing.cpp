// Layer by layer.
#include "pictures/svg/scene_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "pictures/svg/support_drawing.hpp"

namespace kusabi::pictures {
namespace {

/// More names than that would lie on each other.
constexpr std::size_t most_names = 32;

double turn(const Point& o, const Point& a, const Point& b) {
  return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

// The convex hull, by the monotone chain of Andrew.
std::vector<Point> hull(std::vector<Point> points) {
  std::ranges::sort(points, [](const Point& a, const Point& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  std::vector<Point> chain;
  for (int half = 0; half < 2; ++half) {
    const std::size_t start = chain.size();
    for (const Point& point : points) {
      while (chain.size() >= start + 2 && turn(chain[chain.size() - 2], chain.back(), point) <= 0)
        chain.pop_back();
      chain.push_back(point);
    }
    chain.pop_back();
    std::ranges::reverse(points);
  }
  return chain;
}

class SceneDrawing {
 public:
  SceneDrawing(Canvas& canvas, const Scene& scene, const Frame& frame, const Detail& detail)
      : canvas_(canvas),
        scene_(scene),
        detail_(detail),
        scales_(scales_of(scene)),
        view_(scene.dimension, extent(scene, scales_), frame) {}

  void draw() {
    at_rest();
    if (scales_.displacement > 0) moved_bodies();
    obstacles();
    draw_ties(canvas_, scene_, scales_, view_);
    draw_supports(canvas_, scene_, view_, detail_);
    cones();
    forces();
    candidates();
  }

 private:
  [[nodiscard]] Point at(int node) const { return view_(scene_.positions.col(node)); }
  [[nodiscard]] Point moved_at(int node) const { return view_(moved(scene_, scales_, node)); }

  template <class Place>
  static std::vector<Point> outline(const std::vector<int>& nodes, const Place& place) {
    std::vector<Point> points(nodes.size());
    std::ranges::transform(nodes, points.begin(), place);
    return points;
  }

  void at_rest() {
    // What nothing is drawn over is not to be pale.
    canvas_.begin_group(scales_.displacement > 0 ? "rest" : "rest still");
    for (const auto& face : scene_.faces) {
      canvas_.polygon("face", outline(face, [this](int node) { return at(node); }));
    }
    for (const auto& bar : scene_.bars) canvas_.line("bar", at(bar.nodes[0]), at(bar.nodes[1]));
    canvas_.end_group();
  }

  // In space the faces that are farther away first: those before hide them.
  void moved_bodies() {
    canvas_.begin_group("moved");
    std::vector<std::pair<double, const std::vector<int>*>> order;
    for (const auto& face : scene_.faces) {
      double nearness = 0;
      for (const int node : face) nearness += view_.nearness(moved(scene_, scales_, node));
      order.emplace_back(nearness / static_cast<double>(face.size()), &face);
    }
    if (scene_.dimension == 3)
      std::ranges::stable_sort(order, {}, [](auto& its) { return its.first; });
    for (const auto& [nearness, face] : order) {
      canvas_.polygon("face", outline(*face, [this](int node) { return moved_at(node); }));
    }
    for (const auto& bar : scene_.bars) {
      const auto* const kind = bar.yield == Yield::tension       ? "bar tension"
                               : bar.yield == Yield::compression ? "bar compression"
                                                                 : "bar";
      canvas_.line(kind, moved_at(bar.nodes[0]), moved_at(bar.nodes[1]));
    }
    canvas_.end_group();
  }

  // In the plane a piece of its surface with hatches behind it, in space a disc.
  void obstacles() {
    canvas_.begin_group("obstacle");
    for (const auto& candidate : scene_.candidates) {
      if (!candidate.rigid) continue;
      if (scene_.dimension == 2) {
        surface_piece(candidate);
      } else {
        disc(candidate);
      }
    }
    canvas_.end_group();
  }

  void surface_piece(const DrawnCandidate& candidate) {
    const Point middle = at(candidate.node);
    const Point out(candidate.normal.x(), -candidate.normal.y());
    const Point along(-out.y(), out.x());
    const double half = 4.8 * detail_.mark;
    canvas_.line("surface", middle - half * along, middle + half * along);
    if (!detail_.hatch) return;
    constexpr int hatches = 5;
    for (int i = 0; i < hatches; ++i) {
      const Point from = middle + half * (2.0 * (i + 0.5) / hatches - 1) * along;
      canvas_.line("hatch", from, from - 1.6 * detail_.mark * (out + 0.7 * along));
    }
  }

  void disc(const DrawnCandidate& candidate) {
    auto flat = candidate;
    flat.friction = 1;
    auto cone = friction_cone(scene_, scales_, flat);
    // The rim of a cone of half a right angle, moved back into the plane of its apex.
    const Eigen::Vector3d apex = cone.front();
    std::vector<Point> points;
    for (std::size_t i = 1; i < cone.size(); ++i) {
      const Eigen::Vector3d way = cone[i] - apex;
      points.push_back(view_(apex + 0.4 * (way - candidate.normal * candidate.normal.dot(way))));
    }
    canvas_.polygon("disc", points);
  }

  void cones() {
    canvas_.begin_group("cone");
    for (const auto& candidate : scene_.candidates) {
      if (candidate.state != ContactState::contact || candidate.friction <= 0) continue;
      std::vector<Point> points;
      for (const auto& point : friction_cone(scene_, scales_, candidate))
        points.push_back(view_(point));
      canvas_.polygon("cone", scene_.dimension == 2 ? points : hull(points));
    }
    canvas_.end_group();
  }

  void forces() {
    // Dead loads end at their node and reference loads begin there, so that both can be seen.
    for (const auto& load : scene_.loads) {
      const Eigen::Vector3d place = scene_.positions.col(load.node);
      const Eigen::Vector3d way = scale_of(load, scales_) * load.force;
      if (load.kind == DrawnLoad::Kind::dead) {
        canvas_.arrow("dead", view_(place - way), view_(place), detail_.head);
      } else {
        canvas_.arrow("reference", view_(place), view_(place + way), detail_.head);
      }
    }
    for (int node = 0; node < static_cast<int>(scene_.support_reactions.cols()); ++node) {
      const Eigen::Vector3d to = scene_.positions.col(node);
      const Point from = view_(to - scales_.force * scene_.support_reactions.col(node));
      if ((from - view_(to)).norm() > visible)
        canvas_.arrow("holding", from, view_(to), detail_.head);
    }
    for (const auto& candidate : scene_.candidates) {
      const Eigen::Vector3d from = scene_.positions.col(candidate.node);
      const Point to = view_(from + scales_.force * candidate.reaction);
      if ((to - view_(from)).norm() > visible)
        canvas_.arrow("reaction", view_(from), to, detail_.head);
    }
  }

  void candidates() {
    const bool names = detail_.names && scene_.candidates.size() <= most_names;
    for (const auto& candidate : scene_.candidates) {
      const Point place = at(candidate.node);
      canvas_.begin_group("candidate", candidate.name);
      canvas_.circle(state_class(candidate.state), place, detail_.mark);
      canvas_.end_group();
      if (names) name(candidate, place);
    }
  }

  static const char* state_class(ContactState state) {
    switch (state) {
      case ContactState::contact:
        return "contact";
      case ContactState::separated:
        return "separated";
      case ContactState::at_rest:
        return "idle";
      case ContactState::none:
        break;
    }
    return "other";
  }

  // On the side of the obstacle, where nothing else is.
  void name(const DrawnCandidate& candidate, const Point& place) {
    const Eigen::Vector3d from = scene_.positions.col(candidate.node);
    Point away = view_(from - scales_.size * candidate.normal) - view_(from);
    away = away.norm() > 0 ? Point(away.normalized()) : Point(0, 1);
    const Point middle = place + 4.2 * detail_.mark * away + Point(0, 4);
    const auto* const anchor = away.x() > 0.4 ? "start" : away.x() < -0.4 ? "end" : "middle";
    // A name that would lie on another is left out; the mark's title has it.
    const double across = name_letter * static_cast<double>(candidate.name.size());
    const double left = away.x() > 0.4 ? 0 : away.x() < -0.4 ? across : across / 2;
    const Box box{middle - Point(left, name_height), middle + Point(across - left, 0)};
    const auto on_it = [&](const Box& other) {
      return (box.from.array() < other.to.array()).all() &&
             (other.from.array() < box.to.array()).all();
    };
    if (std::ranges::any_of(named_, on_it)) return;
    named_.push_back(box);
    canvas_.words("name", middle, anchor, candidate.name);
  }

  /// Shorter arrows are no more than a point.
  static constexpr double visible = 0.5;
  /// What a name takes, more or less, pixels: its height, and the width of a letter.
  static constexpr double name_height = 12;
  static constexpr double name_letter = 6.5;

  struct Box {
    Point from;
    Point to;
  };

  Canvas& canvas_;
  const Scene& scene_;
  const Detail& detail_;
  Scales scales_;
  View view_;
  std::vector<Box> named_;  // where names are
};

}  // namespace

void draw_scene(Canvas& canvas, const Scene& scene, const Frame& frame, const Detail& detail) {
  SceneDrawing(canvas, scene, frame, detail).draw();
}

void draw_axes(Canvas& canvas, const Point& corner) {
  const std::vector<Eigen::Vector3d> ends{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  constexpr double size = 44;
  const View view(3, ends, {corner, Point(size, size)});
  constexpr const char* names[] = {"", "x", "y", "z"};
  for (std::size_t axis = 1; axis < ends.size(); ++axis) {
    const Point from = view(ends[0]);
    const Point to = view(ends[axis]);
    canvas.arrow("axis", from, to, 6);
    canvas.words("name", to + 9 * (to - from).normalized() + Point(0, 4), "middle", names[axis]);
  }
}

}  // namespace kusabi::pictures
