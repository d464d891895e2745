// Names of nodes and groups, and resolution of lists of names.
#include "problems/files/draft/problem_draft.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "support/nearest.hpp"

namespace kusabi::problems {
namespace {

/// Maximum value of `every`.
constexpr int max_every = 1'000'000;

/// Maximum number of groups of a mesh in an error message.
constexpr std::size_t max_groups_named = 12;

}  // namespace

std::string names_of_groups(std::vector<std::string> groups, std::string_view between) {
  for (std::string& group : groups) group = support::in_quotes(group);
  const std::size_t left_out = groups.size() - std::min(groups.size(), max_groups_named);
  groups.resize(groups.size() - left_out);
  const std::string more = left_out == 0 ? "" : fmt::format(" and {} more", left_out);
  return fmt::format("{}{}", fmt::join(groups, between), more);
}

ProblemDraft::ProblemDraft(std::string_view text, const std::string& file, MeshTexts meshes)
    : reader_(text, file), meshes_(std::move(meshes)) {
  structure_.sources.file = file;
}

const toml::node* ProblemDraft::section(std::string_view name) const {
  return reader_.root().table->get(name);
}

std::string ProblemDraft::node_name(int node) const {
  return quoted_name(structure_, node);
}

int ProblemDraft::add_node(const std::string& name, const Eigen::VectorXd& place,
                           support::SourcePosition position) {
  const int number = node_count();
  if (structure_.coordinates.cols() == number) {  // space for twice as many, truncated at the end
    structure_.coordinates.conservativeResize(Eigen::NoChange, 2 * number + 16);
  }
  structure_.coordinates.col(number) = place;
  structure_.fixed.push_back({false, false, false});
  structure_.node_names.push_back(name);
  structure_.sources.nodes.push_back(position);
  node_numbers_.emplace(name, number);
  return number;
}

void ProblemDraft::add_name(const std::string& name, int node) {
  node_numbers_.emplace(name, node);
  structure_.more_names.emplace(name, node);
}

void ProblemDraft::add_group(const std::string& name, NamedGroup group) {
  groups_.emplace(name, std::move(group));
}

const NamedGroup* ProblemDraft::group(const std::string& name) const {
  const auto found = groups_.find(name);
  return found == groups_.end() ? nullptr : &found->second;
}

const NamedMesh* ProblemDraft::mesh(const std::string& name) const {
  const auto found = meshes_named_.find(name);
  return found == meshes_named_.end() ? nullptr : &found->second;
}

int ProblemDraft::add_file(const std::string& name) {
  auto& files = structure_.sources.more_files;
  const auto known = std::ranges::find(files, name);
  const auto number = static_cast<int>(known - files.begin()) + 1;
  if (known == files.end()) files.push_back(name);
  return number;
}

int ProblemDraft::node(const TomlText& name) const {
  const auto found = node_numbers_.find(name.text);
  if (found != node_numbers_.end()) return found->second;
  reader_.fail(name.position, fmt::format("node {} does not exist; expected a name from [nodes]{}",
                                          support::in_quotes(name.text), names_instead(name.text)));
}

std::string ProblemDraft::names_instead(const std::string& name) const {
  std::vector<std::string_view> names(structure_.node_names.begin(), structure_.node_names.end());
  for (const auto& [group, nodes] : groups_) names.emplace_back(group);
  if (auto meant = support::did_you_mean(name, names); !meant.empty()) return meant;
  // A group named as in its mesh file, without the name of the mesh; or an unknown one of a mesh.
  const auto dot = name.find('.');
  const bool bare = dot == std::string::npos;
  std::vector<std::string> groups;
  for (const auto& [group, nodes] : groups_) {
    const bool likely =
        bare ? group.ends_with("." + name) : group.starts_with(name.substr(0, dot + 1));
    if (likely) groups.push_back(group);
  }
  if (groups.empty() && !bare && mesh(name.substr(0, dot)) != nullptr) {
    return fmt::format("; its mesh has no groups: in Gmsh a Physical {} makes one",
                       structure_.dimension == 2 ? "Curve" : "Surface");
  }
  if (groups.empty()) return "";
  return bare ? fmt::format("; did you mean {}?", names_of_groups(groups, " or "))
              : fmt::format("; its mesh has {}", names_of_groups(groups, ", "));
}

std::vector<int> ProblemDraft::nodes_named(const TomlText& name) const {
  if (const NamedGroup* named = group(name.text); named != nullptr) return named->nodes;
  return {node(name)};
}

std::vector<ListedNode> ProblemDraft::nodes_listed(const TomlTable& table) const {
  const auto& names = reader_.require(table, "nodes", "nodes = [\"a\", ...]");
  std::vector<ListedNode> listed;
  for (const TomlText& name : reader_.texts(names, "nodes")) {
    const std::string group = names_group(name.text) ? name.text : "";
    for (const int node : nodes_named(name)) listed.push_back({node, name.position, group});
  }
  if (const auto* entry = table.table->get("except"); entry != nullptr) {
    std::set<int> others;
    for (const TomlText& name : reader_.texts(*entry, "except")) {
      const auto nodes = nodes_named(name);
      others.insert(nodes.begin(), nodes.end());
    }
    std::erase_if(listed, [&](const ListedNode& one) { return others.contains(one.node); });
    if (listed.empty()) reader_.fail(*entry, "except leaves no nodes; expected one or more");
  }
  if (const auto* entry = table.table->get("every"); entry != nullptr) {
    const auto step = static_cast<std::size_t>(reader_.count(*entry, "every", max_every));
    std::size_t place = 0;
    std::erase_if(listed, [&](const ListedNode&) { return place++ % step != 0; });
  }
  return listed;
}

void ProblemDraft::support(const ListedNode& node, const std::array<bool, 3>& fixed) {
  const auto [before, is_new] = supported_.emplace(node.node, node.position);
  if (!is_new) {
    throw structure_error(structure_, node.position,
                          fmt::format("node {} is supported twice, first on line {}; expected once",
                                      node_name(node.node), before->second.line));
  }
  structure_.fixed[static_cast<std::size_t>(node.node)] = fixed;
}

Structure ProblemDraft::finished() && {
  structure_.coordinates.conservativeResize(Eigen::NoChange,
                                            static_cast<Eigen::Index>(node_count()));
  return std::move(structure_);
}

}  // namespace kusabi::problems
