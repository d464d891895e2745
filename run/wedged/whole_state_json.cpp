// Node by node.
#include "run/wedged/whole_state_json.hpp"

#include <cstddef>
#include <utility>

#include "run/output/values.hpp"

namespace kusabi::run {

using nlohmann::ordered_json;

void WholeStateJson::add_to(ordered_json& configuration, std::span<const double> reactions,
                            std::span<const double> displacements) const {
  const auto state = structure_.under(reactions, displacements);
  auto everywhere = ordered_json::object();
  auto supports = ordered_json::object();
  for (std::size_t node = 0; node < names_.size(); ++node) {
    const auto column = static_cast<Eigen::Index>(node);
    everywhere[names_[node]] = numbers(state.displacements.col(column));
    if (structure_.is_supported(static_cast<int>(node))) {
      supports[names_[node]] = numbers(state.reactions.col(column));
    }
  }
  configuration["all_displacements"] = std::move(everywhere);
  configuration["support_reactions"] = std::move(supports);
  configuration["imbalance"] = state.imbalance;
}

}  // namespace kusabi::run
