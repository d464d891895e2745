// Section [[ties]]: multi-point constraints, which connect meshes whose nodes do not coincide.
#include <utility>

#include "problems/files/draft/places_of_others.hpp"
#include "problems/files/sections/problem_sections.hpp"

namespace kusabi::problems {

void read_ties(ProblemDraft& draft) {
  const toml::node* section = draft.section("ties");
  if (section == nullptr) return;
  const TomlReader& reader = draft.reader();
  for (const TomlTable& group : reader.groups(*section, "ties")) {
    reader.allow_only(group, {"nodes", "except", "every", "to", "gap"});
    const auto listed = draft.nodes_listed(group);
    reader.require(group, "to", "to = \"an edge\", or a list of nodes");
    auto places = places_of_others(draft, group, "to", listed);
    for (std::size_t i = 0; i < listed.size(); ++i) {
      draft.structure().ties.push_back({listed[i].node, std::move(places[i])});
      draft.structure().sources.ties.push_back(listed[i].position);
    }
  }
}

}  // namespace kusabi::problems
