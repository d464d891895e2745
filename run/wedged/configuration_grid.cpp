// VTK fields of a configuration.
#include "run/wedged/configuration_grid.hpp"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "problems/structure/assembly/element_stress.hpp"
#include "run/output/values.hpp"
#include "run/wedged/problem_summary.hpp"

namespace kusabi::run {

using pictures::ContactState;

namespace {

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
    const double factor = problem.friction.empty() ? 1 : problem.friction[i];
    const double cone = coefficient * factor * reactions[d * i];
    const double across = d == 2 ? std::abs(reactions[d * i + 1])
                                 : std::hypot(reactions[d * i + 1], reactions[d * i + 2]);
    if (contact[i] == ContactState::contact && cone > 0) numbers[i] = across / cone;
  }
  return numbers;
}

}  // namespace

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
