// Loads by node and axis.
#include "problems/files/abaqus/abaqus_loads.hpp"

#include <cstddef>
#include <string>

namespace kusabi::problems {

void AbaqusLoads::read(AbaqusText& text, const AbaqusCard& card, AbaqusModel& assembly) {
  const std::string* const operation = card.find("OP");
  const bool is_new = operation != nullptr && capitals(*operation) == "NEW";
  if (is_new && std::exchange(cleared_in_, step_) != step_) components_.clear();
  const bool follows = card.find("FOLLOWER") != nullptr;
  if (follows) text.warn("*CLOAD of a force that follows the structure is left out", card.at);
  while (text.next_data()) {
    if (follows) continue;
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

}  // namespace kusabi::problems
