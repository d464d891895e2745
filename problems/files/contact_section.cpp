// Which nodes may touch the obstacle, and in which direction.
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "problems/files/obstacle_normal.hpp"
#include "problems/files/places_of_others.hpp"
#include "problems/files/problem_sections.hpp"

namespace kusabi::problems {
namespace {

/// Where each node touches another body; of a rigid obstacle nothing.
std::vector<std::vector<Share>> against(const ProblemDraft& draft, const TomlTable& group,
                                        const std::vector<ListedNode>& nodes) {
  if (group.table->get("against") != nullptr)
    return places_of_others(draft, group, "against", nodes);
  if (const toml::node* gap = group.table->get("gap"); gap != nullptr) {
    draft.reader().fail(*gap, "gap without against; expected both, or neither");
  }
  return std::vector<std::vector<Share>>(nodes.size());
}

void contact_group(ProblemDraft& draft, const TomlTable& group, LazySurface& surface) {
  const TomlReader& reader = draft.reader();
  Structure& structure = draft.structure();
  reader.allow_only(group, {"nodes", "except", "every", "name", "against", "gap", "normal",
                            "tangent", "friction"});
  reader.require(group, "nodes", "nodes = [\"a\", ...]");
  const ObstacleNormal normal = obstacle_normal(draft, group, surface);
  const toml::node* tangent_entry = group.table->get("tangent");
  std::optional<Eigen::VectorXd> tangent;
  support::SourcePosition tangent_position;
  if (tangent_entry != nullptr) {
    tangent = reader.vector(*tangent_entry, "the tangent", structure.dimension);
    tangent_position = reader.position(*tangent_entry);
  }
  double friction = 1;
  support::SourcePosition friction_position;
  if (const toml::node* entry = group.table->get("friction"); entry != nullptr) {
    friction = reader.number(*entry, "friction");
    friction_position = reader.position(*entry);
  }
  std::string name;
  if (const toml::node* entry = group.table->get("name"); entry != nullptr)
    name = reader.text(*entry, "the name of what is touched").text;
  const auto listed = draft.nodes_listed(group);
  auto places = against(draft, group, listed);
  for (std::size_t i = 0; i < listed.size(); ++i) {
    const Eigen::VectorXd direction = normal(listed[i]);
    structure.contact.push_back({listed[i].node, direction.stableNormalized(), tangent, friction,
                                 direction, std::move(places[i]),
                                 name.empty() ? listed[i].group : name});
    structure.sources.contact.push_back(listed[i].position);
    structure.sources.normals.push_back(reader.position(*group.table->get("normal")));
    structure.sources.tangents.push_back(tangent_position);
    structure.sources.frictions.push_back(friction_position);
  }
}

}  // namespace

void read_contact(ProblemDraft& draft) {
  const toml::node* section = draft.section("contact");
  if (section == nullptr) return;
  LazySurface surface(draft.structure());
  for (const TomlTable& group : draft.reader().groups(*section, "contact")) {
    contact_group(draft, group, surface);
  }
}

}  // namespace kusabi::problems
