// Node by node, and the members in their order.
#include "run/wedged/whole_state_json.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "run/output/values.hpp"

namespace kusabi::run {

using nlohmann::ordered_json;

namespace {

// Without a look whether the name is there: nodes have names of their own, and to look for each
// among all others would take longer than everything else.
void append(ordered_json& object, const std::string& name, const std::vector<double>& values) {
  ordered_json::object_t::Container& members = object.get_ref<ordered_json::object_t&>();
  members.emplace_back(name, values);
}

}  // namespace

void WholeStateJson::add_to(ordered_json& configuration, std::span<const double> reactions,
                            std::span<const double> displacements) const {
  const auto& names = states_.structure().node_names;
  const auto state = states_.whole().under(reactions, displacements);
  auto everywhere = ordered_json::object();
  auto supports = ordered_json::object();
  for (std::size_t node = 0; node < names.size(); ++node) {
    const auto column = static_cast<Eigen::Index>(node);
    append(everywhere, names[node], numbers(state.displacements.col(column)));
    if (states_.whole().is_supported(static_cast<int>(node))) {
      append(supports, names[node], numbers(state.reactions.col(column)));
    }
  }
  configuration["all_displacements"] = std::move(everywhere);
  configuration["support_reactions"] = std::move(supports);
  if (state.axial_forces.size() > 0) configuration["axial_forces"] = numbers(state.axial_forces);
  configuration["imbalance"] = state.imbalance;
}

}  // namespace kusabi::run
