// Detection of gaps between joined meshes.
#include "problems/files/draft/mesh_plan.hpp"

#include <fmt/format.h>

#include "problems/structure/geometry/mesh_joints.hpp"

namespace kusabi::problems {

bool truth_of(const TomlReader& reader, const TomlTable& group, std::string_view key) {
  const auto* entry = group.table->get(key);
  if (entry == nullptr) return true;
  if (!entry->is_boolean())
    reader.fail(*entry, fmt::format("{} is neither true nor false; expected one", key));
  return entry->value_or(true);
}

void refuse_gapes(const ProblemDraft& draft, int first_new, const MeshPlan& plan) {
  const Structure& all = draft.structure();
  const auto gap = find_mesh_gap(all, first_new, plan.joined);
  if (!gap) return;
  throw structure_error(
      all, position_of(all.sources.elements, gap->element),
      fmt::format("a face of this element lies on another where their nodes do not meet, at node "
                  "{}; expected meshes that match, a gap, or join = false",
                  draft.node_name(gap->node)));
}

}  // namespace kusabi::problems
