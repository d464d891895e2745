// Contact candidates: nodes that may touch the obstacle, and their normals.
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>

#include "problems/files/draft/obstacle_normal.hpp"
#include "problems/files/draft/places_of_others.hpp"
#include "problems/files/sections/problem_sections.hpp"

namespace kusabi::problems {
namespace {

/// The opposite place of each node on another body; empty for a rigid obstacle.
std::vector<std::vector<WeightedNode>> against(const ProblemDraft& draft, const TomlTable& group,
                                               const std::vector<ListedNode>& nodes) {
  if (group.table->get("against") != nullptr)
    return places_of_others(draft, group, "against", nodes);
  if (const toml::node* gap = group.table->get("gap"); gap != nullptr) {
    draft.reader().fail(*gap, "gap without against; expected against, or no gap");
  }
  return std::vector<std::vector<WeightedNode>>(nodes.size());
}

/// The number that multiplies the coefficient of the call; null if there is none.
const toml::node* own_friction(const TomlReader& reader, const TomlTable& group) {
  const toml::node* const factor = group.table->get("friction_factor");
  const toml::node* const coefficient = group.table->get("friction_coefficient");
  const toml::node* const old = group.table->get("friction");
  if (factor != nullptr && coefficient != nullptr)
    reader.fail(*factor, "friction_factor and friction_coefficient in one group; expected one");
  const toml::node* const entry = factor != nullptr ? factor : coefficient;
  if (entry != nullptr && old != nullptr)
    reader.fail(*old,
                "friction, the former name of friction_factor, beside a number that replaces it; "
                "expected friction_factor or friction_coefficient only");
  return entry != nullptr ? entry : old;
}

/// A group without a coefficient, whose factor is 1, would have a coefficient of 1 among the others.
void check_coefficients(const TomlReader& reader, const std::vector<TomlTable>& groups) {
  const TomlTable* without = nullptr;
  const toml::node* with = nullptr;
  for (const auto& group : groups) {
    const auto* const entry = group.table->get("friction_coefficient");
    if (entry == nullptr && without == nullptr) without = &group;
    if (entry != nullptr && with == nullptr) with = entry;
  }
  if (with != nullptr && without != nullptr)
    reader.fail(*with,
                "friction_coefficient in some [[contact]] groups only; expected it in all of them, "
                "or friction_factor");
}

/// The former name `friction` is easily mistaken for a coefficient.
void warn_of_old_name(ProblemDraft& draft, const TomlReader& reader, const toml::node& entry,
                      std::size_t groups) {
  const double factor = reader.number(entry, "the friction factor");
  draft.structure().warnings.emplace_back(
      structure_error(
          draft.structure(), reader.position(entry),
          fmt::format(
              "friction = {0} is the former name of friction_factor: it multiplies --mu at these "
              "nodes{1}; expected friction_factor = {0} for a factor, or friction_coefficient = "
              "{0} and --mu 1",
              factor, groups > 1 ? fmt::format(" (one of {} such groups)", groups) : ""))
          .what());
}

/// The distance from the obstacle before any force acts; an interference is a negative one.
double clearance_in(const TomlReader& reader, const TomlTable& group) {
  const toml::node* const gap = group.table->get("clearance");
  const toml::node* const press = group.table->get("interference");
  if (gap != nullptr && press != nullptr)
    reader.fail(*press,
                "interference and clearance in one group; expected one, since each is "
                "minus the other");
  if (press != nullptr) return -reader.number(*press, "the interference");
  return gap == nullptr ? 0 : reader.number(*gap, "the clearance");
}

void contact_group(ProblemDraft& draft, const TomlTable& group, LazySurface& surface) {
  const TomlReader& reader = draft.reader();
  Structure& structure = draft.structure();
  reader.allow_only(
      group, {"nodes", "except", "every", "name", "against", "gap", "normal", "tangent",
              "friction_factor", "friction_coefficient", "friction", "clearance", "interference"});
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
  if (const toml::node* entry = own_friction(reader, group); entry != nullptr) {
    const bool coefficient = group.table->get("friction_coefficient") == entry;
    friction =
        reader.number(*entry, coefficient ? "the friction coefficient" : "the friction factor");
    friction_position = reader.position(*entry);
  }
  const double clearance = clearance_in(reader, group);
  std::string name;
  if (const toml::node* entry = group.table->get("name"); entry != nullptr)
    name = reader.text(*entry, "the name of the obstacle").text;
  const auto listed = draft.nodes_listed(group);
  const auto normal_position = reader.position(*group.table->get("normal"));
  auto places = against(draft, group, listed);
  FacetWarning facets{.position = normal_position, .factor = friction};
  for (std::size_t i = 0; i < listed.size(); ++i) {
    const Eigen::VectorXd direction = normal.at(listed[i]);
    if (normal.facets)
      std::apply([&](auto... angles) { facets.take(angles...); }, normal.facets(listed[i]));
    structure.contact.push_back({listed[i].node, direction.stableNormalized(), tangent, friction,
                                 direction, std::move(places[i]),
                                 name.empty() ? listed[i].group : name, clearance});
    structure.sources.contact.push_back(listed[i].position);
    structure.sources.normals.push_back(normal_position);
    structure.sources.tangents.push_back(tangent_position);
    structure.sources.frictions.push_back(friction_position);
  }
  draft.facets().push_back(facets);
  if (!normal.surfaces || body_elements(structure) == 0) return;
  if (const auto fault = place_fault(draft, surface.get(), *normal.surfaces, listed))
    structure.warnings.emplace_back(structure_error(structure, normal_position, *fault).what());
}

}  // namespace

void read_contact(ProblemDraft& draft) {
  const toml::node* section = draft.section("contact");
  if (section == nullptr) return;
  LazySurface surface(draft.structure());
  std::vector<const toml::node*> old_names;
  const auto groups = draft.reader().groups(*section, "contact");
  check_coefficients(draft.reader(), groups);
  for (const TomlTable& group : groups) {
    contact_group(draft, group, surface);
    if (const auto* const entry = group.table->get("friction"); entry != nullptr)
      old_names.push_back(entry);
  }
  if (!old_names.empty())
    warn_of_old_name(draft, draft.reader(), *old_names.front(), old_names.size());
}

}  // namespace kusabi::problems
