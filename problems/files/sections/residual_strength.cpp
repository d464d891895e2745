// Members are found by the names of their nodes.
#include "problems/files/sections/residual_strength.hpp"

#include <cstddef>

#include "problems/files/draft/bar_group.hpp"
#include "problems/files/toml/toml_reader.hpp"

namespace kusabi::problems {

Eigen::VectorXd residual_strengths(std::string_view toml_text, const std::string& file_name,
                                   const Structure& structure) {
  const TomlReader reader(toml_text, file_name);
  const toml::node* const section = reader.root().table->get("members");
  Eigen::VectorXd strengths;
  if (section == nullptr) return strengths;
  for (const TomlTable& group : reader.groups(*section, "members")) {
    const auto residual = bars_in(reader, group).residual;
    if (!residual) continue;
    if (strengths.size() == 0) {
      strengths.resize(static_cast<Eigen::Index>(structure.members.size()));
      for (std::size_t i = 0; i < structure.members.size(); ++i)
        strengths(static_cast<Eigen::Index>(i)) =
            structure.members[i].yield.value_or(YieldForces{}).compression;
    }
    for (const toml::node* pair : reader.elements(*group.table->get("between"), "between")) {
      const auto ends = reader.texts(*pair, "a member");
      for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const auto& bar = structure.members[i];
        const auto& first = structure.node_names[static_cast<std::size_t>(bar.first)];
        const auto& second = structure.node_names[static_cast<std::size_t>(bar.second)];
        if (first == ends[0].text && second == ends[1].text)
          strengths(static_cast<Eigen::Index>(i)) =
              *residual * bar.yield.value_or(YieldForces{}).compression;
      }
    }
  }
  return strengths;
}

}  // namespace kusabi::problems
