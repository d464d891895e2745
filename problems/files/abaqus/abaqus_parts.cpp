// Instances: copies of a part and of the entries of their own block, moved as rigid bodies.
#include "problems/files/abaqus/abaqus_parts.hpp"

#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "support/input_error.hpp"

namespace kusabi::problems {
namespace {

/// Fields of a line as numbers, zero where they are missing.
template <int Count>
Eigen::Vector<double, Count> numbers_in(const MeshText& line, std::string_view called) {
  Eigen::Vector<double, Count> result = Eigen::Vector<double, Count>::Zero();
  if (line.fields() > Count) line.fail(Count, fmt::format("a field too many; expected {}", called));
  for (std::size_t i = 0; i < line.fields(); ++i) {
    if (!line.field(i).empty()) result(static_cast<Eigen::Index>(i)) = line.real(i, called);
  }
  return result;
}

/// cos and sin, exact for multiples of 90 degrees, so that turned coordinates stay aligned.
std::pair<double, double> cosine_and_sine(double degrees) {
  const double turns = degrees / 90;
  const double rest = turns - std::round(turns);
  const double angle = rest * std::numbers::pi / 2;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  switch (static_cast<int>(std::fmod(std::round(turns), 4.0) + 4) % 4) {
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    case 3:
      return {s, -c};
    default:
      return {c, s};
  }
}

/// Rotation about the axis from a to b: A_X, A_Y, A_Z, B_X, B_Y, B_Z, degrees.
Eigen::Isometry3d rotation(const MeshText& line) {
  const auto given = numbers_in<7>(line, "the axis and the angle of a rotation");
  const Eigen::Vector3d from = given.head<3>();
  const Eigen::Vector3d axis = given.segment<3>(3) - from;
  if (axis.isZero(0))
    line.fail(
        "the two points of a rotation axis are equal; expected different "
        "points");
  const Eigen::Vector3d unit = axis.normalized();
  const auto [c, s] = cosine_and_sine(given(6));
  Eigen::Matrix3d across;
  across << 0, -unit.z(), unit.y(), unit.z(), 0, -unit.x(), -unit.y(), unit.x(), 0;
  const Eigen::Matrix3d turn =
      c * Eigen::Matrix3d::Identity() + s * across + (1 - c) * unit * unit.transpose();
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = turn;
  result.translation() = from - turn * from;
  return result;
}

/// The data lines of *INSTANCE: a translation, then a rotation, applied in this order.
Eigen::Isometry3d motion(AbaqusText& text) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  if (!text.next_data()) return result;
  result.translation() = numbers_in<3>(text.line(), "a translation of three numbers");
  if (!text.next_data()) return result;
  result = rotation(text.line()) * result;
  if (text.next_data()) text.line().fail("a third line of *INSTANCE; expected two");
  return result;
}

/// Maximum number of nodes, elements and entries of groups of all instances.
constexpr std::size_t max_copies = 100'000'000;

std::size_t entries(const MeshData& mesh) {
  std::size_t count = mesh.nodes.size() + mesh.elements.size();
  for (const MeshGroup& group : mesh.groups)
    count += group.nodes.size() + group.elements.size() + group.faces.size();
  return count;
}

/// Adds the entries of a part to the assembly, in its current instance.
void add_copy(const AbaqusText& text, const AbaqusModel& part, AbaqusModel& assembly) {
  const auto nodes = static_cast<int>(assembly.mesh.nodes.size());
  const auto elements = static_cast<int>(assembly.mesh.elements.size());
  const auto moved = [](std::vector<int> numbers, int by) {
    for (int& number : numbers) number += by;
    return numbers;
  };
  const auto append = [](std::vector<int>& all, const std::vector<int>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  for (const MeshNode& node : part.mesh.nodes) assembly.index.add_node(text.line(), node);
  for (MeshElement element : part.mesh.elements) {
    element.nodes = moved(std::move(element.nodes), nodes);
    assembly.index.add_element(text.line(), std::move(element));
  }
  for (const int tag : part.index.elements_left_out()) assembly.index.leave_out_element(tag);
  for (const std::string& name : part.groups.analytical()) assembly.groups.add_analytical(name);
  for (const MeshGroup& group : part.mesh.groups) {
    MeshGroup& copy = assembly.groups.group(text, group.name, group.at);
    append(copy.nodes, moved(group.nodes, nodes));
    append(copy.elements, moved(group.elements, elements));
    for (const MeshFace& face : group.faces) {
      copy.faces.push_back({face.element + elements, face.face});
    }
  }
  for (MeshSection section : part.mesh.sections) {
    section.elements = moved(std::move(section.elements), elements);
    section.set = assembly.groups.full_name(section.set);
    assembly.mesh.sections.push_back(std::move(section));
  }
  for (MeshSupport support : part.mesh.supports) {
    support.node += nodes;
    assembly.mesh.supports.push_back(support);
  }
}

}  // namespace

bool AbaqusParts::read(AbaqusText& text, const AbaqusCard& card) {
  const std::string& keyword = card.keyword;
  const auto require = [&](bool condition, std::string_view expected) {
    if (!condition) text.line().fail(fmt::format("{} here; expected {}", keyword, expected));
  };
  if (keyword == "*PART") {
    require(part_ == nullptr && !in_instance_, "*END PART or *END INSTANCE before it");
    begin_part(text, card);
  } else if (keyword == "*END PART") {
    require(part_ != nullptr, "*PART before it");
    part_ = nullptr;
  } else if (keyword == "*INSTANCE") {
    require(part_ == nullptr && !in_instance_, "*END PART or *END INSTANCE before it");
    begin_instance(text, card);
  } else if (keyword == "*END INSTANCE") {
    require(in_instance_, "*INSTANCE before it");
    end_instance();
  } else if (keyword != "*ASSEMBLY" && keyword != "*END ASSEMBLY") {
    return false;
  }
  return true;
}

void AbaqusParts::finish(const AbaqusText& text) const {
  if (part_ != nullptr) text.line().fail("the file ends; expected *END PART");
  if (in_instance_) text.line().fail("the file ends; expected *END INSTANCE");
}

void AbaqusParts::begin_part(AbaqusText& text, const AbaqusCard& card) {
  const std::string& name = required(text, card, "NAME");
  auto& part = parts_[capitals(name)];
  if (part != nullptr) {
    text.line().fail(
        fmt::format("part {} is given twice; expected once", support::in_quotes(name)));
  }
  part = std::make_unique<AbaqusModel>();
  part_ = part.get();
}

void AbaqusParts::begin_instance(AbaqusText& text, const AbaqusCard& card) {
  allow_only(text, card, {"NAME", "PART"});
  const std::string& name = required(text, card, "NAME");
  const std::string& of = required(text, card, "PART");
  const auto part = parts_.find(capitals(of));
  if (part == parts_.end()) {
    text.line().fail(fmt::format("part {} does not exist; expected one that is given above",
                                 support::in_quotes(of)));
  }
  copies_ += entries(part->second->mesh);
  if (copies_ > max_copies)
    text.line().fail(fmt::format("the instances have more than {} entries", max_copies));
  first_node_ = assembly_.mesh.nodes.size();
  in_instance_ = true;
  assembly_.groups.begin_instance(text, name);
  add_copy(text, *part->second, assembly_);
  motion_ = motion(text);
}

void AbaqusParts::end_instance() {
  auto& nodes = assembly_.mesh.nodes;
  for (std::size_t i = first_node_; i < nodes.size(); ++i)
    nodes[i].place = motion_ * nodes[i].place;
  assembly_.groups.enter(0);
  in_instance_ = false;
}

}  // namespace kusabi::problems
