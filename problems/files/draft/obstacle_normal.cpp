// Normals of the shapes of obstacles.
#include "problems/files/draft/obstacle_normal.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <set>
#include <span>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace kusabi::problems {
namespace {

/// A node closer to the axis than this, relative to its distance from the point, has no radial
/// direction.
constexpr double on_the_axis = 1e-9;

constexpr std::string_view kinds_of_normal =
    "[...], \"surface\", { plane = [...] } or { point = [...], axis = [...], half_angle = ..., "
    "body = \"inside\" }";

/// Faces selected by a list of nodes: those of its groups of faces, and those whose vertices are
/// all in one of its groups of nodes or listed one by one. A face between two groups, such as the
/// end of a body between its sides, belongs to neither.
struct Patch {
  std::set<std::vector<int>> faces;
  std::vector<std::set<int>> groups;
  std::set<int> nodes;

  bool holds(const SurfaceFace& face) const {
    const std::span<const int> vertices(face.nodes.data(), static_cast<std::size_t>(face.vertices));
    const auto within = [&](const std::set<int>& group) {
      return std::ranges::all_of(
          vertices, [&](int node) { return group.contains(node) || nodes.contains(node); });
    };
    if (within(nodes) || std::ranges::any_of(groups, within)) return true;
    std::vector<int> key(vertices.begin(), vertices.end());
    std::ranges::sort(key);
    return faces.contains(key);
  }
};

/// Adds the faces of a name in a list.
void add(const ProblemDraft& draft, const TomlText& name, Patch& patch) {
  const NamedGroup* named = draft.group(name.text);
  if (named != nullptr && !named->faces.empty()) {
    patch.faces.insert(named->faces.begin(), named->faces.end());
    return;
  }
  const auto nodes = draft.nodes_named(name);
  if (draft.names_group(name.text)) {
    patch.groups.emplace_back(nodes.begin(), nodes.end());
  } else {
    patch.nodes.insert(nodes.begin(), nodes.end());
  }
}

/// The patch of a list, and of each group for nodes that are listed twice.
struct Patches {
  Patch all;
  std::map<std::string, Patch> of_groups;
  std::set<int> twice;

  const Patch& at(const ListedNode& listed) const {
    const auto own = of_groups.find(listed.group);
    return twice.contains(listed.node) && own != of_groups.end() ? own->second : all;
  }
};

Patches patches(const ProblemDraft& draft, const TomlTable& group) {
  Patches result;
  for (const TomlText& name : draft.reader().texts(*group.table->get("nodes"), "nodes")) {
    add(draft, name, result.all);
    if (draft.names_group(name.text)) add(draft, name, result.of_groups[name.text]);
  }
  std::set<int> once;
  for (const ListedNode& listed : draft.nodes_listed(group)) {
    if (!once.insert(listed.node).second) result.twice.insert(listed.node);
  }
  return result;
}

double degrees_between(const Eigen::VectorXd& first, const Eigen::VectorXd& second) {
  return 2 * std::asin(std::min(1.0, (first - second).norm() / 2)) * 180 / std::numbers::pi;
}

/// The largest angles between two `wanted` faces at a node, and between one and a direction.
std::pair<double, double> angles_of_facets(const Surface& body, int node,
                                           const Eigen::VectorXd& direction,
                                           const std::function<bool(const SurfaceFace&)>& wanted) {
  std::vector<Eigen::VectorXd> normals;
  std::pair<double, double> angles{0, 0};
  for (const int face : body.faces_at(node)) {
    if (!wanted(body.faces()[static_cast<std::size_t>(face)])) continue;
    const Eigen::VectorXd own = body.normal(face, node).normalized();
    for (const auto& other : normals)
      angles.first = std::max(angles.first, degrees_between(own, other));
    angles.second = std::max(angles.second, degrees_between(own, direction));
    normals.push_back(own);
  }
  return angles;
}

ObstacleNormal of_surface(const ProblemDraft& draft, const TomlTable& group, LazySurface& surface) {
  const auto faces = std::make_shared<const Patches>(patches(draft, group));
  const auto facets = [&surface, faces](const ListedNode& listed) {
    const Surface& body = surface.get();
    const Patch& own = faces->at(listed);
    for (const bool all : {false, true}) {
      const auto wanted = [&](const SurfaceFace& face) { return all || own.holds(face); };
      const auto normal = body.mean_normal(listed.node, wanted);
      if (normal) return angles_of_facets(body, listed.node, *normal, wanted);
    }
    return std::pair(0.0, 0.0);
  };
  const auto at = [&draft, &surface, faces](const ListedNode& listed) -> Eigen::VectorXd {
    const Surface& body = surface.get();
    const Patch& own = faces->at(listed);
    auto normal =
        body.mean_normal(listed.node, [&](const SurfaceFace& face) { return own.holds(face); });
    // A node outside such faces: all faces at the node.
    if (!normal) normal = body.mean_normal(listed.node, [](const SurfaceFace&) { return true; });
    if (!normal) {
      draft.reader().fail(listed.position,
                          fmt::format("the body has no surface at {}, or two opposite faces "
                                      "there; expected a normal [...]",
                                      draft.node_name(listed.node)));
    }
    return -*normal;
  };
  return {.at = at, .surfaces = {}, .facets = facets};
}

Eigen::VectorXd direction(const ProblemDraft& draft, const toml::node& entry,
                          const std::string& called) {
  const Eigen::VectorXd result = draft.reader().vector(entry, called, draft.structure().dimension);
  if (result.isZero(0.0)) {
    draft.reader().fail(
        entry,
        fmt::format("{} is zero; expected {}", called,
                    called == "the normal" ? "the outward normal of the obstacle" : "a direction"));
  }
  return result;
}

/// { plane = [...] }: the normal of the plane, on either side of the body.
ObstacleNormal of_plane(const ProblemDraft& draft, const toml::node& entry, LazySurface& surface) {
  const Eigen::VectorXd normal = direction(draft, entry, "the normal of the plane");
  const auto at = [&draft, &surface, normal](const ListedNode& listed) -> Eigen::VectorXd {
    const auto outward =
        surface.get().mean_normal(listed.node, [](const SurfaceFace&) { return true; });
    if (!outward) {
      draft.reader().fail(listed.position,
                          fmt::format("the body has no surface at {}, so its side of the plane is "
                                      "undetermined; expected a normal [...]",
                                      draft.node_name(listed.node)));
    }
    return outward->dot(normal) > 0 ? Eigen::VectorXd(-normal) : normal;
  };
  const auto offset = [&draft, unit = Eigen::VectorXd(normal.stableNormalized())](int node) {
    return unit.dot(draft.structure().coordinates.col(node));
  };
  return {
      .at = at, .surfaces = ParallelSurfaces{"plane with this normal", offset, at}, .facets = {}};
}

/// A cylinder (half angle 0) or a cone about an axis; in the plane a circle about a point.
struct Revolution {
  Eigen::VectorXd point;
  Eigen::VectorXd axis;   ///< unit, in the direction in which the cone widens; unused in the plane
  double half_angle = 0;  ///< radian
  bool body_is_inside = true;
};

Revolution revolution(const ProblemDraft& draft, const TomlTable& table) {
  const TomlReader& reader = draft.reader();
  const int dimension = draft.structure().dimension;
  reader.allow_only(table, {"point", "axis", "half_angle", "body"});
  Revolution result;
  result.point = reader.vector(reader.require(table, "point", "point = [...], on the axis"),
                               "the point", dimension);
  if (dimension == 3) {
    const auto& axis = reader.require(table, "axis",
                                      "axis = [...], the direction in which a cone "
                                      "widens");
    result.axis = direction(draft, axis, "the axis").stableNormalized();
  } else if (const auto* axis = table.table->get("axis"); axis != nullptr) {
    reader.fail(*axis, "an axis in the plane; expected the point only, the centre of a circle");
  }
  if (const auto* angle = table.table->get("half_angle"); angle != nullptr) {
    const double degrees = reader.number(*angle, "half_angle");
    if (!(degrees >= 0 && degrees < 90) || dimension == 2) {
      reader.fail(
          *angle,
          "half_angle is not that of a cone; expected degrees from 0 to below 90, in space");
    }
    result.half_angle = degrees * std::numbers::pi / 180;
  }
  const TomlText body = reader.text(
      reader.require(table, "body", "body = \"inside\" (a hole) or \"outside\" (a shaft)"), "body");
  if (body.text != "inside" && body.text != "outside") {
    reader.fail(body.position, fmt::format("body is {}; expected \"inside\" or \"outside\" of the "
                                           "obstacle's surface",
                                           support::in_quotes(body.text)));
  }
  result.body_is_inside = body.text == "inside";
  return result;
}

/// The distance from the axis minus the widening of the cone.
double offset_of(const Revolution& shape, const Eigen::VectorXd& place) {
  Eigen::VectorXd away = place - shape.point;
  if (shape.axis.size() == 0) return away.norm();
  const double along = shape.axis.dot(away);
  away -= along * shape.axis;
  return std::cos(shape.half_angle) * away.norm() - std::sin(shape.half_angle) * along;
}

ObstacleNormal of_revolution(const ProblemDraft& draft, const TomlTable& table) {
  const auto shape = revolution(draft, table);
  const auto at = [&draft, shape](const ListedNode& listed) -> Eigen::VectorXd {
    Eigen::VectorXd away = draft.structure().coordinates.col(listed.node) - shape.point;
    const double distance = away.norm();
    if (shape.axis.size() > 0) away -= shape.axis.dot(away) * shape.axis;
    if (!(away.norm() > on_the_axis * distance)) {
      draft.reader().fail(listed.position,
                          fmt::format("node {} is on the axis of the obstacle; expected a node on "
                                      "its surface",
                                      draft.node_name(listed.node)));
    }
    Eigen::VectorXd normal = away.normalized();
    if (shape.half_angle > 0) {
      normal = std::cos(shape.half_angle) * normal - std::sin(shape.half_angle) * shape.axis;
    }
    return shape.body_is_inside ? Eigen::VectorXd(-normal) : normal;
  };
  const auto* const called = shape.half_angle > 0    ? "cone with this axis and half_angle"
                             : shape.axis.size() > 0 ? "cylinder about this axis"
                                                     : "circle about this point";
  const auto offset = [&draft, shape](int node) {
    return offset_of(shape, draft.structure().coordinates.col(node));
  };
  return {.at = at, .surfaces = ParallelSurfaces{called, offset, at}, .facets = {}};
}

}  // namespace

ObstacleNormal obstacle_normal(const ProblemDraft& draft, const TomlTable& group,
                               LazySurface& surface) {
  const TomlReader& reader = draft.reader();
  const auto& entry = reader.require(
      group, "normal", "normal = [...], the outward normal of the obstacle, or \"surface\"");
  if (entry.is_string()) {
    const TomlText text = reader.text(entry, "the normal");
    if (text.text == "surface") return of_surface(draft, group, surface);
    reader.fail(entry, fmt::format("the normal is {}; expected {}", support::in_quotes(text.text),
                                   kinds_of_normal));
  }
  if (entry.is_table()) {
    const TomlTable table = reader.table(entry, "the normal");
    if (!table.table->contains("plane")) return of_revolution(draft, table);
    reader.allow_only(table, {"plane"});
    return of_plane(draft, *table.table->get("plane"), surface);
  }
  return {
      .at = [normal = direction(draft, entry, "the normal")](const ListedNode&) { return normal; },
      .surfaces = {},
      .facets = {}};
}

}  // namespace kusabi::problems
