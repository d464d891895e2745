// Members of [[members]] follow those of meshes in the structure, in the order of the file. Names of
// their nodes would not do: a node may have several.
#include "problems/files/sections/residual_strength.hpp"

#include <cstddef>

#include "problems/files/draft/bar_group.hpp"
#include "problems/files/toml/toml_reader.hpp"

namespace kusabi::problems {

Eigen::VectorXd residual_strengths(std::string_view toml_text, const std::string& file_name,
                                   const Structure& structure) {
  const TomlReader reader(toml_text, file_name);
  const toml::node* const section = reader.root().table->get("members");
  if (section == nullptr) return {};
  const auto count = static_cast<Eigen::Index>(structure.members.size());
  Eigen::VectorXd strengths(count);
  for (Eigen::Index i = 0; i < count; ++i)
    strengths(i) =
        structure.members[static_cast<std::size_t>(i)].yield.value_or(YieldForces{}).compression;
  const auto groups = reader.groups(*section, "members");
  const auto pairs = [&](const TomlTable& group) {
    return static_cast<Eigen::Index>(
        reader.elements(*group.table->get("between"), "between").size());
  };
  Eigen::Index first = count;
  for (const TomlTable& group : groups) first -= pairs(group);
  bool struts = false;
  for (const TomlTable& group : groups) {
    const auto residual = bars_in(reader, group).residual;
    if (residual) {
      strengths.segment(first, pairs(group)) *= *residual;
      struts = true;
    }
    first += pairs(group);
  }
  return struts ? strengths : Eigen::VectorXd();
}

}  // namespace kusabi::problems
