// VTK fields of a configuration.
#include "run/wedged/configuration_grid.hpp"

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

}  // namespace

pictures::UnstructuredGrid ConfigurationGrids::grid(const std::string& remark,
                                                    std::span<const double> reactions,
                                                    std::span<const double> displacements,
                                                    std::span<const ContactState> contact) const {
  const auto& structure = states_.structure();
  const auto state = states_.whole().under(reactions, displacements);
  auto grid = structure_;
  grid.remark = fmt::format("{}: {}; {} and {}", structure.name, remark, structure.units.length,
                            structure.units.force);
  grid.point_data.push_back(pictures::node_vectors("displacement", state.displacements));
  grid.point_data.push_back(
      pictures::node_vectors("contact_reaction", states_.whole().contact_forces(reactions)));
  grid.point_data.push_back(pictures::node_vectors("support_reaction", state.reactions));
  grid.point_data.push_back(pictures::contact_states(structure, contact));
  add_internal_forces(grid, structure, state);
  return grid;
}

pictures::UnstructuredGrid ConfigurationGrids::grid(const std::string& remark, std::uint32_t block,
                                                    const wedged::SignPattern& pattern,
                                                    const support::IndexSet& idle,
                                                    std::span<const double> reactions,
                                                    std::span<const double> displacements) const {
  const auto& problem = states_.problem();
  std::vector<ContactState> contact(problem.contact_names.size(), ContactState::none);
  const auto set = [&](const support::IndexSet& candidates, ContactState state) {
    for (const int i : candidates) contact[static_cast<std::size_t>(i)] = state;
  };
  set(pattern.contact, ContactState::contact);
  set(pattern.separated, ContactState::separated);
  set(pattern.at_rest | idle, ContactState::at_rest);
  return grid(remark, of_all_candidates(problem, block, reactions),
              of_all_candidates(problem, block, displacements), contact);
}

}  // namespace kusabi::run
