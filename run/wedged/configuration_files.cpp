// States of the whole structure, rows of CSV, and grids.
#include "run/wedged/configuration_files.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "problems/structure/assembly/element_stress.hpp"
#include "run/output/values.hpp"
#include "run/pictures/structure_json.hpp"
#include "run/wedged/problem_summary.hpp"

namespace kusabi::run {

using nlohmann::ordered_json;
using pictures::ContactState;

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

const char* component_name(int dimension, int axis) {
  if (axis == 0) return "n";
  if (dimension == 2) return "t";
  return axis == 1 ? "t1" : "t2";
}

// Forces of bars, with their utilisation where a yield force is known; stress of elements at their
// centre.
void add_internal_forces(pictures::UnstructuredGrid& grid, const problems::Structure& structure,
                         const problems::WholeState& state) {
  if (!structure.members.empty()) {
    grid.cell_data.push_back(
        pictures::member_numbers(grid, "axial_force", numbers(state.axial_forces)));
  }
  if (problems::has_yield_forces(structure)) {
    grid.cell_data.push_back(pictures::member_numbers(
        grid, "utilisation", numbers(problems::utilisations(structure, state.axial_forces))));
  }
  if (structure.elements.empty()) return;
  const auto stresses = problems::element_stresses(structure, state.displacements);
  grid.cell_data.push_back(pictures::element_numbers(grid, structure, "stress", stresses));
  grid.cell_data.push_back(pictures::element_numbers(grid, structure, "von_mises",
                                                     problems::von_mises(stresses).transpose()));
}

// u_n of the separated candidates.
std::vector<double> gaps(const problems::WedgedProblem& problem, std::span<const double> motion,
                         std::span<const ContactState> contact) {
  const auto d = static_cast<std::size_t>(problem.dimension);
  std::vector<double> numbers(contact.size());
  for (std::size_t i = 0; i < contact.size(); ++i) {
    if (contact[i] == ContactState::separated) numbers[i] = motion[d * i];
  }
  return numbers;
}

// |r_t| / (mu r_n) of the candidates in contact; 0 without friction.
std::vector<double> uses(const problems::WedgedProblem& problem, double coefficient,
                         std::span<const double> reactions, std::span<const ContactState> contact) {
  const auto d = static_cast<std::size_t>(problem.dimension);
  std::vector<double> numbers(contact.size());
  for (std::size_t i = 0; i < contact.size(); ++i) {
    const int candidate = static_cast<int>(i);
    const double cone = coefficient * relative_friction(problem, candidate) * reactions[d * i];
    if (contact[i] == ContactState::contact && cone > 0)
      numbers[i] = tangential_reaction(problem, reactions, candidate) / cone;
  }
  return numbers;
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

void WholeStateJson::add_to(ordered_json& configuration, std::uint32_t block,
                            std::span<const double> reactions,
                            std::span<const double> displacements) const {
  const auto& problem = states_.problem();
  configuration["displacement"] = block_rows(problem, block, displacements);
  add_to(configuration, of_all_candidates(problem, block, reactions),
         of_all_candidates(problem, block, displacements));
}

void add_pattern_columns(CsvWriter& csv) {
  csv.word("block").word("contact").word("separated").word("inactive");
}

void add_pattern(CsvWriter& csv, const problems::WedgedProblem& problem, std::uint32_t block,
                 const wedged::SignPattern& pattern, const support::IndexSet& inactive) {
  csv.count(std::uint64_t{block} + 1);
  csv.names(candidate_names(problem, pattern.contact));
  csv.names(candidate_names(problem, pattern.separated));
  csv.names(candidate_names(problem, pattern.inactive | inactive));
}

void add_configuration_columns(CsvWriter& csv, const problems::WedgedProblem& problem) {
  for (const char* const what : {"r", "u"}) {
    for (int axis = 0; axis < problem.dimension; ++axis) {
      for (const auto& name : problem.contact_names)
        csv.text(fmt::format("{}_{} {}", what, component_name(problem.dimension, axis), name));
    }
  }
}

void add_configuration(CsvWriter& csv, const problems::WedgedProblem& problem,
                       std::span<const double> reactions, std::span<const double> displacements) {
  const auto d = static_cast<std::size_t>(problem.dimension);
  const std::size_t size = d * problem.contact_names.size();
  for (const auto& vector : {reactions, displacements}) {
    for (std::size_t axis = 0; axis < d; ++axis) {
      for (std::size_t at = axis; at < size; at += d) {
        if (vector.empty()) {
          csv.nothing();
        } else {
          csv.number(vector[at]);
        }
      }
    }
  }
}

pictures::UnstructuredGrid ConfigurationGrids::grid(const GridFacts& facts,
                                                    std::span<const double> reactions,
                                                    std::span<const double> displacements,
                                                    std::span<const ContactState> contact) const {
  const auto& structure = states_.structure();
  const auto state = states_.whole().under(reactions, displacements);
  auto grid = structure_;
  grid.remark = fmt::format("{}: {}; {} and {}", structure.name, facts.remark,
                            structure.units.length, structure.units.force);
  const auto& units = structure.units;
  const auto add = [&](pictures::Field field, const std::string& unit) {
    field.unit = unit;
    grid.point_data.push_back(std::move(field));
  };
  add(pictures::node_vectors("displacement", state.displacements), units.length);
  add(pictures::node_vectors("contact_reaction", states_.whole().contact_forces(reactions)),
      units.force);
  add(pictures::node_vectors("support_reaction", state.reactions), units.force);
  grid.point_data.push_back(pictures::contact_states(structure, contact));
  add(pictures::candidate_numbers(structure, "gap",
                                  gaps(states_.problem(), displacements, contact)),
      units.length);
  if (facts.friction) {
    add(pictures::candidate_numbers(structure, "friction_use",
                                    uses(states_.problem(), *facts.friction, reactions, contact)),
        {});
    grid.field_data.push_back(pictures::whole_number("mu", *facts.friction));
  }
  if (facts.margin) grid.field_data.push_back(pictures::whole_number("margin", *facts.margin));
  add_internal_forces(grid, structure, state);
  return grid;
}

pictures::UnstructuredGrid ConfigurationGrids::grid(const GridFacts& facts, std::uint32_t block,
                                                    const wedged::SignPattern& pattern,
                                                    const support::IndexSet& inactive,
                                                    std::span<const double> reactions,
                                                    std::span<const double> displacements) const {
  const auto& problem = states_.problem();
  std::vector<ContactState> contact(problem.contact_names.size(), ContactState::none);
  const auto set = [&](const support::IndexSet& candidates, ContactState state) {
    for (const int i : candidates) contact[static_cast<std::size_t>(i)] = state;
  };
  set(pattern.contact, ContactState::contact);
  set(pattern.separated, ContactState::separated);
  set(pattern.inactive | inactive, ContactState::inactive);
  return grid(facts, of_all_candidates(problem, block, reactions),
              of_all_candidates(problem, block, displacements), contact);
}

}  // namespace kusabi::run
