// Data lines of *BOUNDARY: NODE OR SET, FIRST AXIS, LAST AXIS, VALUE; or NODE OR SET, NAME.
#include "problems/files/abaqus/abaqus_supports.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "support/input_error.hpp"

namespace kusabi::problems {
namespace {

constexpr std::array<std::pair<std::string_view, std::array<bool, 3>>, 8> named_supports{
    {{"ENCASTRE", {true, true, true}},
     {"PINNED", {true, true, true}},
     {"XSYMM", {true, false, false}},
     {"YSYMM", {false, true, false}},
     {"ZSYMM", {false, false, true}},
     {"XASYMM", {false, true, true}},
     {"YASYMM", {true, false, true}},
     {"ZASYMM", {true, true, false}}}};

/// The axes of a line that are fixed; nothing if it prescribes a displacement that is not zero.
/// Degrees of freedom beyond 3 (rotations, temperature) are none of a solid.
std::optional<std::array<bool, 3>> fixed_in(const MeshText& line) {
  const std::string name = line.fields() > 1 ? capitals(line.field(1)) : std::string();
  const auto known =
      std::ranges::find(named_supports, name,
                        [](const auto& entry) -> const std::string_view& { return entry.first; });
  if (known != named_supports.end()) return known->second;
  const int first = line.whole(1, "an axis", 1);
  const bool has_last = line.fields() > 2 && !line.field(2).empty();
  const int last = has_last ? line.whole(2, "the last axis", 1) : first;
  if (last < first) {
    line.fail(1, fmt::format("axes {} to {}; expected the smaller one first", first, last));
  }
  const bool has_value = line.fields() > 3 && !line.field(3).empty();
  if (has_value && line.real(3, "a displacement") != 0 && first <= 3) return std::nullopt;
  std::array<bool, 3> fixed{};
  for (int axis = first; axis <= std::min(last, 3); ++axis)
    fixed[static_cast<std::size_t>(axis) - 1] = true;
  return fixed;
}

}  // namespace

void AbaqusSupports::read_boundary(AbaqusText& text, const AbaqusCard& card, AbaqusModel& part) {
  allow_only(text, card, {"OP", "TYPE", "AMPLITUDE", "FIXED", "LOAD CASE"});
  const std::string* operation = card.find("OP");
  const bool is_new = operation != nullptr && capitals(*operation) == "NEW";
  if (is_new && !std::exchange(cleared_, true)) part.mesh.supports.clear();
  while (text.next_data()) {
    const auto nodes = part.groups.nodes(text.line(), 0);
    const auto fixed = fixed_in(text.line());
    if (!fixed) {
      text.warn(
          "*BOUNDARY of a displacement that is not zero is left out: the nodes are "
          "not supported by it",
          text.here());
      continue;
    }
    for (const int node : nodes) part.mesh.supports.push_back({node, *fixed, text.here()});
  }
}

void read_transform(AbaqusText& text, const AbaqusCard& card, AbaqusModel& part) {
  const std::string name = required(text, card, "NSET");
  for (const int node : part.groups.node_set(text, name).nodes)
    part.mesh.nodes[static_cast<std::size_t>(node)].turned = true;
  while (text.next_data()) continue;
}

void unite_supports(AbaqusText& text, MeshData& mesh) {
  std::map<int, MeshSupport> by_node;
  for (const MeshSupport& support : mesh.supports) {
    auto& one = by_node.try_emplace(support.node, support).first->second;
    for (std::size_t axis = 0; axis < 3; ++axis) one.fixed[axis] |= support.fixed[axis];
  }
  mesh.supports.clear();
  for (const auto& [node, support] : by_node) {
    const bool all = std::ranges::count(support.fixed, true) == 3;
    if (!all && mesh.nodes[static_cast<std::size_t>(node)].turned) {
      text.warn(
          "*BOUNDARY of an axis of *TRANSFORM is left out: give it as [[supports]] with a "
          "direction",
          support.at);
    } else {
      mesh.supports.push_back(support);
    }
  }
}

}  // namespace kusabi::problems
