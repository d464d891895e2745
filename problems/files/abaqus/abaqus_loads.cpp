// Loads by node and axis, gravity by set.
#include "problems/files/abaqus/abaqus_loads.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace kusabi::problems {

namespace {

/// True in the first card of a step that removes the loads of earlier ones.
bool clears(const AbaqusCard& card, int step, int& cleared_in) {
  const std::string* const operation = card.find("OP");
  if (operation == nullptr || capitals(*operation) != "NEW") return false;
  return std::exchange(cleared_in, step) != step;
}

// The kind of a load that is no static force in global axes; empty: it is one.
std::string_view other_load(const AbaqusCard& card) {
  if (card.find("FOLLOWER") != nullptr) return "a force that follows the structure";
  const std::string* const load_case = card.find("LOAD CASE");
  if (card.find("IMAGINARY") != nullptr || (load_case != nullptr && *load_case == "2"))
    return "an imaginary part";
  if (card.find("SUBMODEL") != nullptr || card.find("SECTOR") != nullptr)
    return "a submodel or a sector";
  return {};
}

}  // namespace

void AbaqusLoads::read(AbaqusText& text, const AbaqusCard& card, AbaqusModel& assembly) {
  if (clears(card, step_, cleared_in_)) components_.clear();
  const auto other = other_load(card);
  if (!other.empty()) text.warn(fmt::format("*CLOAD of {} is left out", other), card.at);
  while (text.next_data()) {
    if (!other.empty()) continue;
    const auto nodes = assembly.groups.nodes(text.line(), 0);
    const int axis = text.line().whole(1, "an axis", 1);
    const double force = text.line().real(2, "a force");
    if (axis > 3) {
      text.warn("*CLOAD beyond axis 3, such as a moment, is left out", text.here());
      continue;
    }
    for (const int node : nodes) {
      auto& own = components_[{node, axis - 1}];
      own = {own.step == step_ ? own.force + force : force, step_, text.here()};
    }
  }
}

void AbaqusLoads::finish(AbaqusText& text, MeshData& mesh) const {
  for (const auto& [place, component] : components_) {
    const auto [node, axis] = place;
    if (mesh.nodes[static_cast<std::size_t>(node)].turned) {
      text.warn("*CLOAD along an axis of *TRANSFORM is left out", component.at);
      continue;
    }
    if (component.force == 0) continue;
    auto& loads = mesh.loads;
    if (loads.empty() || loads.back().node != node)
      loads.push_back({node, Eigen::Vector3d::Zero(), component.at});
    loads.back().force(axis) = component.force;
  }
}

void AbaqusGravity::read(AbaqusText& text, const AbaqusCard& card, AbaqusModel& assembly) {
  if (clears(card, step_, cleared_in_)) loads_.clear();
  while (text.next_data()) {
    const MeshText& line = text.line();
    if (line.fields() < 2 || capitals(line.field(1)) != "GRAV") {
      text.warn("*DLOAD other than GRAV is left out", text.here());
      continue;
    }
    const bool all = line.field(0).empty();
    if (!all && number_in(line.field(0))) {
      text.warn("*DLOAD GRAV of a single element is left out", text.here());
      continue;
    }
    const double magnitude = line.real(2, "an acceleration");
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    for (std::size_t axis = 0; axis < 3 && axis + 3 < line.fields(); ++axis)
      direction(static_cast<Eigen::Index>(axis)) = line.real(axis + 3, "a direction");
    if (direction.isZero(0))
      line.fail("gravity without a direction; expected SET, GRAV, g, x, y, z");
    const std::string set =
        all ? "" : assembly.groups.element_set(text, std::string(line.field(0))).name;
    auto& own = loads_[set];
    if (own.step != step_) own.acceleration.setZero();
    own.acceleration += magnitude * direction.normalized();
    own.step = step_;
    own.at = text.here();
  }
}

void AbaqusGravity::finish(MeshData& mesh) const {
  for (const auto& [set, load] : loads_)
    if (!load.acceleration.isZero(0)) mesh.gravity.push_back({set, load.acceleration, load.at});
}

}  // namespace kusabi::problems
