// State of the structure: nodes and members in their order, reactions by the names of nodes.
#include "run/wedged/whole_state_json.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "answer/values.hpp"
#include "problems/structure/assembly/element_stress.hpp"
#include "run/output/values.hpp"
#include "run/pictures/structure_json.hpp"

namespace kusabi::run {

using nlohmann::ordered_json;

namespace {

// Inserted without a search for the name: names of nodes are unique, and a search would dominate
// the run time.
void append(ordered_json& object, const std::string& name, const std::vector<double>& values) {
  ordered_json::object_t::Container& members = object.get_ref<ordered_json::object_t&>();
  members.emplace_back(name, values);
}

// Six components per element.
ordered_json stresses_json(const problems::Stresses& stresses,
                           const std::vector<std::size_t>& places) {
  auto list = ordered_json::array();
  for (const auto place : places)
    list.push_back(numbers(stresses.col(static_cast<Eigen::Index>(place))));
  return list;
}

// Stress measures of the elements and, where a yield force is known, utilisation of the members.
void add_internal_forces(ordered_json& configuration, const problems::Structure& structure,
                         const problems::WholeState& state) {
  if (state.axial_forces.size() > 0) configuration["axial_forces"] = numbers(state.axial_forces);
  if (problems::has_yield_forces(structure)) {
    auto used = ordered_json::array();
    for (const double each : problems::utilisations(structure, state.axial_forces))
      used.push_back(answer::number_or_null(each));
    configuration["utilisation"] = std::move(used);
  }
  if (structure.elements.empty()) return;
  const auto stresses = problems::element_stresses(structure, state.displacements);
  const auto equivalent = problems::von_mises(stresses);
  const auto places = listed_elements(structure);
  configuration["stresses"] = stresses_json(stresses, places);
  auto list = ordered_json::array();
  for (const auto place : places) list.push_back(equivalent(static_cast<Eigen::Index>(place)));
  configuration["von_mises"] = std::move(list);
}

}  // namespace

void WholeStateJson::add_to(ordered_json& configuration, std::span<const double> reactions,
                            std::span<const double> displacements) const {
  const auto& names = states_.structure().node_names;
  const auto state = states_.whole().under(reactions, displacements);
  auto everywhere = ordered_json::array();
  auto supports = ordered_json::object();
  for (std::size_t node = 0; node < names.size(); ++node) {
    const auto column = static_cast<Eigen::Index>(node);
    everywhere.push_back(numbers(state.displacements.col(column)));
    if (states_.whole().is_supported(static_cast<int>(node))) {
      append(supports, names[node], numbers(state.reactions.col(column)));
    }
  }
  configuration["all_displacements"] = std::move(everywhere);
  configuration["support_reactions"] = std::move(supports);
  add_internal_forces(configuration, states_.structure(), state);
  configuration["imbalance"] = state.imbalance;
}

}  // namespace kusabi::run
