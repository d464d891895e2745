// Structure from its JSON. Faces shared by two elements are inside and not drawn.
#include "run/results/drawn_structure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "problems/structure/geometry/element_faces.hpp"
#include "problems/structure/model/element_shape.hpp"

namespace kusabi::run {
namespace {

using Nodes = std::vector<int>;

// Vertices and midside nodes in the order of the outline.
Nodes around(const Nodes& corners_first, std::size_t vertices) {
  Nodes outline;
  for (std::size_t i = 0; i < vertices; ++i) {
    outline.push_back(corners_first[i]);
    if (corners_first.size() > vertices) outline.push_back(corners_first[vertices + i]);
  }
  return outline;
}

std::optional<problems::ElementShape> shape_named(const std::string& name) {
  for (int shape = 0; shape <= static_cast<int>(problems::ElementShape::pyramid5); ++shape) {
    const auto each = static_cast<problems::ElementShape>(shape);
    if (problems::shape_traits(each).name == name) return each;
  }
  return {};
}

// Faces by their vertices; one that occurs twice is inside. The others are turned outwards, also
// those of elements that are mirror images.
class Surface {
 public:
  explicit Surface(const Eigen::Matrix3Xd& positions) : positions_(positions) {}

  void add(problems::ElementShape shape, const Nodes& nodes) {
    const auto& traits = problems::shape_traits(shape);
    if (traits.dimension == 2) {
      outlines_.push_back(around(nodes, static_cast<std::size_t>(traits.vertices)));
      return;
    }
    for (const auto& places : problems::element_faces(shape)) {
      Nodes face;
      for (const int place : places) face.push_back(nodes[static_cast<std::size_t>(place)]);
      const auto vertices = traits.quadratic ? face.size() / 2 : face.size();
      Nodes key(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(vertices));
      std::ranges::sort(key);
      face = around(face, vertices);
      if (is_inwards(face, nodes)) std::ranges::reverse(face);
      const auto [at, is_new] = faces_.try_emplace(std::move(key), std::move(face));
      if (!is_new) at->second.clear();
    }
  }

  [[nodiscard]] std::vector<Nodes> faces() const {
    auto all = outlines_;
    for (const auto& [key, face] : faces_) {
      if (!face.empty()) all.push_back(face);
    }
    return all;
  }

 private:
  [[nodiscard]] Eigen::Vector3d middle(const Nodes& nodes) const {
    return positions_(Eigen::all, nodes).rowwise().mean();
  }
  // True if the face of an element, seen from outside, runs clockwise.
  [[nodiscard]] bool is_inwards(const Nodes& face, const Nodes& element) const {
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    const Eigen::Vector3d first = positions_.col(face.front());
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const Eigen::Vector3d here = positions_.col(face[i]);
      const Eigen::Vector3d next = positions_.col(face[i + 1]);
      area += (here - first).cross(next - first);
    }
    return area.dot(middle(face) - middle(element)) < 0;
  }

  const Eigen::Matrix3Xd& positions_;
  std::vector<Nodes> outlines_;
  std::map<Nodes, Nodes> faces_;
};

// Tolerance of the length of a normal, which is drawn only.
constexpr double unit_length = 0.01;

class StructureReader {
 public:
  explicit StructureReader(const ResultReader& reader)
      : reader_(reader),
        problem_(reader.at(reader.all(), "problem")),
        structure_(reader.at(problem_, "structure")) {}

  DrawnStructure read() {
    const double d = reader_.number(problem_, "d");
    if (d != 2 && d != 3) reader_.refuse("'d' is neither 2 nor 3");
    dimension_ = scene().dimension = static_cast<int>(d);
    read_nodes();
    read_members();
    Surface surface(scene().positions);
    for (const char* const key : {"elements", "outlines"}) read_elements(key, surface);
    scene().faces = surface.faces();
    read_supports();
    read_candidates();
    return std::move(drawn_);
  }

 private:
  pictures::Scene& scene() { return drawn_.scene; }
  [[nodiscard]] int node(const ResultJson& value) const { return reader_.index(value, count_); }

  void read_nodes() {
    const auto names = reader_.names(structure_, "node_names");
    count_ = names.size();
    if (count_ == 0) reader_.refuse("'node_names' is empty");
    const auto& positions = reader_.list(structure_, "positions", count_);
    scene().positions.resize(3, static_cast<Eigen::Index>(count_));
    for (std::size_t i = 0; i < count_; ++i) {
      drawn_.nodes[names[i]] = static_cast<int>(i);
      scene().positions.col(static_cast<Eigen::Index>(i)) =
          reader_.vector(positions[i], dimension_);
    }
  }

  void read_members() {
    if (ResultReader::find(structure_, "members") == nullptr) return;
    for (const auto& member : reader_.list(structure_, "members")) {
      if (!member.is_array() || member.size() != 2)
        reader_.refuse("a member does not have two nodes");
      scene().bars.push_back({{node(member[0]), node(member[1])}});
    }
  }

  void read_elements(const char* key, Surface& surface) {
    if (ResultReader::find(structure_, key) == nullptr) return;
    for (const auto& group : reader_.list(structure_, key)) {
      const auto name = reader_.text(group, "shape");
      const auto shape = shape_named(name);
      if (!shape || problems::shape_traits(*shape).dimension != dimension_)
        reader_.refuse(fmt::format("'{}' is not a shape of elements", name));
      for (const auto& element : reader_.list(group, "nodes")) {
        Nodes nodes;
        for (const auto& each : element) nodes.push_back(node(each));
        if (nodes.size() != problems::shape_traits(*shape).nodes.size())
          reader_.refuse(fmt::format("a {} has {} nodes", name, nodes.size()));
        surface.add(*shape, nodes);
      }
    }
  }

  void read_supports() {
    std::map<int, std::array<bool, 3>> held;
    if (const auto* const fixed = ResultReader::find(structure_, "fixed")) {
      constexpr const char* axes[] = {"x", "y", "z"};
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
        if (ResultReader::find(*fixed, axes[axis]) == nullptr) continue;
        for (const auto& each : reader_.list(*fixed, axes[axis])) held[node(each)][axis] = true;
      }
    }
    for (const auto& [number, axes] : held) scene().supports.push_back({number, axes});
    for (const auto& each : all("inclined_supports")) {
      const auto direction = reader_.vector(reader_.at(each, "direction"), dimension_);
      if (direction.isZero(0)) reader_.refuse("'direction' is zero");
      scene().inclined.push_back({node(reader_.at(each, "node")), direction});
    }
    for (const auto& each : all("springs")) {
      const auto name = reader_.text(each, "axis");
      int axis = 0;
      while (axis < dimension_ && problems::axis_name(axis) != name) ++axis;
      if (axis == dimension_) reader_.refuse(fmt::format("'{}' is not an axis", name));
      scene().springs.push_back({node(reader_.at(each, "node")), axis});
    }
    for (const auto& each : all("ties")) {
      pictures::DrawnTie tie{node(reader_.at(each, "node")), {}};
      for (const auto& share : reader_.list(each, "to"))
        tie.masters.push_back(node(reader_.at(share, "node")));
      scene().ties.push_back(std::move(tie));
    }
  }

  // A list of the structure; empty if there is none.
  [[nodiscard]] const ResultJson& all(const char* key) const {
    static const auto none = ResultJson::array();
    return ResultReader::find(structure_, key) == nullptr ? none : reader_.list(structure_, key);
  }

  void read_candidates() {
    if (ResultReader::find(problem_, "contact") == nullptr) return;
    const auto& contact = reader_.list(problem_, "contact");
    const auto& nodes = reader_.list(structure_, "candidates", contact.size());
    const auto* const against = ResultReader::find(structure_, "against") == nullptr
                                    ? nullptr
                                    : &reader_.list(structure_, "against", contact.size());
    for (std::size_t i = 0; i < contact.size(); ++i) {
      Eigen::Matrix3d frame = Eigen::Matrix3d::Zero();
      constexpr const char* axes[] = {"n", "t1", "t2"};
      for (int axis = 0; axis < dimension_; ++axis)
        frame.col(axis) = reader_.vector(reader_.at(contact[i], axes[axis]), dimension_);
      if (!(std::abs(frame.col(0).norm() - 1) < unit_length))
        reader_.refuse("'n' is not of length 1");
      pictures::DrawnCandidate candidate;
      candidate.node = node(nodes[i]);
      candidate.name = reader_.text(contact[i], "node");
      candidate.normal = frame.col(0);
      candidate.friction = reader_.number(contact[i], "friction");
      candidate.rigid = against == nullptr || (*against)[i].empty();
      drawn_.candidates[candidate.name] = i;
      drawn_.frames.push_back(frame);
      scene().candidates.push_back(std::move(candidate));
    }
  }

  const ResultReader& reader_;
  const ResultJson& problem_;
  const ResultJson& structure_;
  DrawnStructure drawn_;
  int dimension_ = 2;
  std::size_t count_ = 0;
};

}  // namespace

DrawnStructure drawn_structure(const ResultReader& reader) {
  return StructureReader(reader).read();
}

}  // namespace kusabi::run
