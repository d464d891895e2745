// Drawing of a scene, layer by layer.
#include "pictures/svg/scene_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "pictures/svg/convex_area.hpp"
#include "pictures/svg/friction_use.hpp"
#include "pictures/svg/support_drawing.hpp"

namespace kusabi::pictures {
namespace {

/// Maximum number of names; more would overlap.
constexpr std::size_t max_names = 32;

class SceneDrawing {
 public:
  SceneDrawing(Canvas& canvas, const Scene& scene, const PixelFrame& frame, const Detail& detail)
      : canvas_(canvas),
        scene_(scene),
        detail_(detail),
        scales_(scales_of(scene)),
        view_(scene.dimension, extent(scene, scales_), frame) {}

  void draw() {
    // The body hides what is on its far side.
    contact(Side::far);
    at_rest();
    if (scales_.displacement > 0) moved_bodies();
    draw_ties(canvas_, scene_, scales_, view_);
    draw_supports(canvas_, scene_, view_, detail_);
    loads();
    contact(Side::near);
  }

 private:
  [[nodiscard]] PixelPoint at(int node) const { return view_(scene_.positions.col(node)); }
  [[nodiscard]] PixelPoint at(const DrawnCandidate& candidate) const {
    return view_(contact_place(scene_, scales_, candidate));
  }
  [[nodiscard]] PixelPoint moved_at(int node) const { return view_(moved(scene_, scales_, node)); }

  template <class Place>
  static std::vector<PixelPoint> outline(const std::vector<int>& nodes, const Place& place) {
    std::vector<PixelPoint> points(nodes.size());
    std::ranges::transform(nodes, points.begin(), place);
    return points;
  }

  // The undeformed structure is drawn pale below the deformed one, which in space hides its faces.
  void at_rest() {
    const bool moves = scales_.displacement > 0;
    canvas_.begin_group(moves ? "rest" : "rest still");
    if (!moves || scene_.dimension == 2)
      faces([this](int node) { return scene_.positions.col(node); });
    for (const auto& bar : scene_.bars)
      canvas_.line(bar.state == BarState::lost ? "bar lost" : "bar", at(bar.nodes[0]),
                   at(bar.nodes[1]));
    canvas_.end_group();
  }

  void moved_bodies() {
    canvas_.begin_group("moved");
    faces([this](int node) { return moved(scene_, scales_, node); });
    for (const auto& bar : scene_.bars) {
      if (bar.state == BarState::lost) continue;
      const auto* const kind = bar.state == BarState::tension       ? "bar tension"
                               : bar.state == BarState::compression ? "bar compression"
                                                                    : "bar";
      canvas_.line(kind, moved_at(bar.nodes[0]), moved_at(bar.nodes[1]));
    }
    canvas_.end_group();
  }

  /// A face of a body that is seen.
  struct SeenFace {
    std::vector<PixelPoint> points;
    double nearness = 0;  ///< of its middle
    int shade = 0;
  };

  // In space the faces that look at the eye, the farthest first, since nearer ones hide them.
  template <class Place>
  void faces(const Place& place) {
    std::vector<SeenFace> seen;
    for (const auto& face : scene_.faces) {
      const auto points = outline(face, [&](int node) { return view_(place(node)); });
      if (scene_.dimension == 2) {
        seen.push_back({points});
        continue;
      }
      Eigen::Vector3d middle = Eigen::Vector3d::Zero();
      Eigen::Vector3d area = Eigen::Vector3d::Zero();
      const Eigen::Vector3d first = place(face.front());
      for (std::size_t i = 0; i < face.size(); ++i) {
        const Eigen::Vector3d here = place(face[i]);
        const Eigen::Vector3d next = place(face[(i + 1) % face.size()]);
        middle += here / static_cast<double>(face.size());
        area += (here - first).cross(next - first);
      }
      if (!(area.dot(view_.to_eye()) > 0)) continue;
      seen.push_back({points, view_.nearness(middle), shade_of(area.normalized())});
    }
    std::ranges::stable_sort(seen, {}, &SeenFace::nearness);
    for (const auto& face : seen) {
      canvas_.polygon(scene_.dimension == 2 ? "face" : fmt::format("face f{}", face.shade),
                      face.points);
    }
  }

  // Five shades by the angle to the light, which comes from above the left shoulder of the eye.
  [[nodiscard]] int shade_of(const Eigen::Vector3d& normal) const {
    constexpr int shades = 5;
    const Eigen::Vector3d light = (view_.to_eye() + Eigen::Vector3d(-0.3, -0.5, 0.5)).normalized();
    return std::clamp(static_cast<int>(shades * normal.dot(light)), 0, shades - 1);
  }

  enum class Side { far, near };

  // Candidates whose obstacle is behind a body in space.
  [[nodiscard]] Side side_of(const DrawnCandidate& candidate) const {
    const bool hidden =
        scene_.dimension == 3 && !scene_.faces.empty() && candidate.normal.dot(view_.to_eye()) > 0;
    return hidden ? Side::far : Side::near;
  }

  void contact(Side side) {
    std::vector<const DrawnCandidate*> chosen;
    for (const auto& candidate : scene_.candidates) {
      if (side_of(candidate) == side) chosen.push_back(&candidate);
    }
    if (chosen.empty() && side == Side::far) return;
    if (side == Side::far) canvas_.begin_group("far");
    obstacles(chosen);
    cones(chosen);
    reactions(chosen);
    candidates(chosen, side == Side::near);
    if (side == Side::far) canvas_.end_group();
  }

  // In the plane a piece of the obstacle's surface with hatches behind it, in space a disc.
  void obstacles(const std::vector<const DrawnCandidate*>& chosen) {
    canvas_.begin_group("obstacle");
    for (const auto* const candidate : chosen) {
      if (!candidate->rigid) continue;
      if (scene_.dimension == 2) {
        surface_piece(*candidate);
      } else {
        disc(*candidate);
      }
    }
    canvas_.end_group();
  }

  void surface_piece(const DrawnCandidate& candidate) {
    const PixelPoint middle = at(candidate);
    const PixelPoint out(candidate.normal.x(), -candidate.normal.y());
    const PixelPoint along(-out.y(), out.x());
    const double half = 4.8 * detail_.mark;
    canvas_.line("surface", middle - half * along, middle + half * along);
    if (!detail_.hatch) return;
    constexpr int hatches = 5;
    for (int i = 0; i < hatches; ++i) {
      const PixelPoint from = middle + half * (2.0 * (i + 0.5) / hatches - 1) * along;
      canvas_.line("hatch", from, from - 1.6 * detail_.mark * (out + 0.7 * along));
    }
  }

  void disc(const DrawnCandidate& candidate) {
    auto flat = candidate;
    flat.friction = 1;
    auto cone = friction_cone(scene_, scales_, flat);
    // Rim of a cone with a half angle of 45 degrees, moved into the plane of its apex.
    const Eigen::Vector3d apex = cone.front();
    std::vector<PixelPoint> points;
    for (std::size_t i = 1; i < cone.size(); ++i) {
      const Eigen::Vector3d way = cone[i] - apex;
      points.push_back(view_(apex + 0.4 * (way - candidate.normal * candidate.normal.dot(way))));
    }
    canvas_.polygon("disc", points);
  }

  // Of loaded candidates, shaded by the share of the friction that the reaction needs.
  void cones(const std::vector<const DrawnCandidate*>& chosen) {
    canvas_.begin_group("cone");
    for (const auto* const candidate : chosen) {
      if (!is_loaded(*candidate, scales_) || candidate->friction <= 0) continue;
      std::vector<PixelPoint> points;
      for (const auto& point : friction_cone(scene_, scales_, *candidate))
        points.push_back(view_(point));
      canvas_.polygon(fmt::format("cone u{}", use_shade(friction_use(*candidate))),
                      scene_.dimension == 2 ? points : convex_hull(points));
    }
    canvas_.end_group();
  }

  // Dead loads end at their node and reference loads begin there, so that both are visible.
  void loads() {
    for (const auto& load : scene_.loads) {
      const Eigen::Vector3d place = scene_.positions.col(load.node);
      const Eigen::Vector3d way = scales_.force * load.force;
      if (load.kind == DrawnLoad::Kind::dead) {
        canvas_.arrow("dead", view_(place - way), view_(place), detail_.head);
      } else {
        canvas_.arrow("reference", view_(place), view_(place + way), detail_.head);
      }
    }
    for (int node = 0; node < static_cast<int>(scene_.support_reactions.cols()); ++node) {
      const Eigen::Vector3d to = scene_.positions.col(node);
      const PixelPoint from = view_(to - scales_.force * scene_.support_reactions.col(node));
      if ((from - view_(to)).norm() > visible)
        canvas_.arrow("holding", from, view_(to), detail_.head);
    }
  }

  void reactions(const std::vector<const DrawnCandidate*>& chosen) {
    for (const auto* const candidate : chosen) {
      const PixelPoint node = at(*candidate);
      const PixelPoint end = view_(reaction_end(scene_, scales_, *candidate));
      if (!((end - node).norm() > visible)) continue;
      if (sense_of(scene_, *candidate) > 0) {
        canvas_.arrow("reaction", node, end, detail_.head);
      } else {
        canvas_.arrow("reaction", end, node, detail_.head);
      }
    }
  }

  void candidates(const std::vector<const DrawnCandidate*>& chosen, bool with_names) {
    const bool names = with_names && detail_.names && scene_.candidates.size() <= max_names;
    for (const auto* const candidate : chosen) {
      const PixelPoint place = at(*candidate);
      canvas_.begin_group("candidate", candidate->name);
      canvas_.circle(state_class(candidate->state), place, mark_of(*candidate));
      canvas_.end_group();
      if (names) name(*candidate, place);
    }
  }

  // Loaded candidates are larger, by the square root of their reaction.
  [[nodiscard]] double mark_of(const DrawnCandidate& candidate) const {
    if (scales_.largest_reaction == 0) return detail_.mark;
    constexpr double minimum = 0.7;
    constexpr double growth = 0.6;
    return detail_.mark *
           (minimum + growth * std::sqrt(candidate.reaction.norm() / scales_.largest_reaction));
  }

  static const char* state_class(ContactState state) {
    switch (state) {
      case ContactState::contact:
        return "contact";
      case ContactState::separated:
        return "separated";
      case ContactState::inactive:
        return "idle";
      case ContactState::none:
        break;
    }
    return "other";
  }

  // Names are drawn on the side of the obstacle, which is empty.
  void name(const DrawnCandidate& candidate, const PixelPoint& place) {
    const Eigen::Vector3d from = scene_.positions.col(candidate.node);
    PixelPoint away = view_(from - scales_.size * candidate.normal) - view_(from);
    away = away.norm() > 0 ? PixelPoint(away.normalized()) : PixelPoint(0, 1);
    const PixelPoint middle = place + 4.2 * detail_.mark * away + PixelPoint(0, 4);
    const auto* const anchor = away.x() > 0.4 ? "start" : away.x() < -0.4 ? "end" : "middle";
    // A name that would overlap another is omitted; the title of the mark contains it.
    const double across = name_letter * static_cast<double>(candidate.name.size());
    const double left = away.x() > 0.4 ? 0 : away.x() < -0.4 ? across : across / 2;
    const Box box{middle - PixelPoint(left, name_height), middle + PixelPoint(across - left, 0)};
    const auto on_it = [&](const Box& other) {
      return (box.from.array() < other.to.array()).all() &&
             (other.from.array() < box.to.array()).all();
    };
    if (std::ranges::any_of(named_, on_it)) return;
    named_.push_back(box);
    canvas_.words("name", middle, anchor, candidate.name);
  }

  /// Shorter arrows would be points.
  static constexpr double visible = 0.5;
  /// Approximate size of a name, pixels: its height, and the width of a letter.
  static constexpr double name_height = 12;
  static constexpr double name_letter = 6.5;

  struct Box {
    PixelPoint from;
    PixelPoint to;
  };

  Canvas& canvas_;
  const Scene& scene_;
  const Detail& detail_;
  Scales scales_;
  View view_;
  std::vector<Box> named_;  // boxes of the names drawn so far
};

}  // namespace

void draw_scene(Canvas& canvas, const Scene& scene, const PixelFrame& frame, const Detail& detail) {
  SceneDrawing(canvas, scene, frame, detail).draw();
}

void draw_axes(Canvas& canvas, const PixelPoint& corner) {
  const std::vector<Eigen::Vector3d> ends{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  constexpr double size = 44;
  const View view(3, ends, {corner, PixelPoint(size, size)});
  constexpr const char* names[] = {"", "x", "y", "z"};
  for (std::size_t axis = 1; axis < ends.size(); ++axis) {
    const PixelPoint from = view(ends[0]);
    const PixelPoint to = view(ends[axis]);
    canvas.arrow("axis", from, to, 6);
    canvas.words("name", to + 9 * (to - from).normalized() + PixelPoint(0, 4), "middle",
                 names[axis]);
  }
}

}  // namespace kusabi::pictures
