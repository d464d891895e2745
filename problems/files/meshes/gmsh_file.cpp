// Reader of MSH files by sections; the two versions differ in the place of an element's groups.
#include "problems/files/meshes/gmsh_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "problems/files/meshes/gmsh_binary.hpp"
#include "problems/files/meshes/gmsh_elements.hpp"
#include "problems/files/meshes/gmsh_sections.hpp"
#include "problems/files/meshes/mesh_index.hpp"
#include "problems/files/meshes/mesh_text.hpp"
#include "support/input_error.hpp"

namespace kusabi::problems {
namespace {

/// A group, or a part of the geometry: its dimension and its tag.
using Tag = std::pair<int, int>;

class GmshFile {
 public:
  GmshFile(std::string_view text, const std::string& file) : text_(text, file, " ") {
    mesh_.files.push_back(file);
  }

  MeshData read() &&;
  /// Of a binary file.
  void leave_out_lines() { text_.leave_out_lines(); }

 private:
  void section(const std::string& name);

  void physical_names();
  void entities();
  void nodes_2();
  void nodes_4();
  void elements_2();
  void elements_4();
  void node(int tag, std::size_t first, MeshPlace at);
  std::vector<int> node_tags(int count);
  MeshShape shape(int type, std::size_t field) const;
  void element(MeshShape shape, std::size_t first, const std::vector<int>& groups);
  /// The previous element, if this one is its copy for another group.
  int copied(const MeshElement& element, const std::vector<int>& groups) const;
  void add_to_groups(int element, int dimension, const std::vector<int>& groups);
  void make_groups();
  MeshPlace here() const { return {0, text_.number()}; }

  MeshText text_;
  MeshData mesh_;
  MeshIndex index_{mesh_};
  int version_ = 0;
  std::map<Tag, std::string> names_;
  std::map<Tag, MeshPlace> groups_at_;
  std::map<Tag, std::vector<int>> group_elements_;
  std::map<Tag, std::vector<int>> entity_groups_;
};

MeshData GmshFile::read() && {
  version_ = read_gmsh_version(text_);
  bool has_nodes = false;
  bool has_elements = false;
  while (text_.next_line()) {
    if (text_.fields() == 0) continue;
    const std::string name(text_.field(0));
    if (!name.starts_with('$')) {
      text_.fail(0, fmt::format("{} stands between the sections; expected a section, $...",
                                support::in_quotes(name)));
    }
    if (name == "$Nodes" && std::exchange(has_nodes, true))
      text_.fail("a second section $Nodes; expected one");
    if (name == "$Elements" && std::exchange(has_elements, true)) {
      text_.fail("a second section $Elements; expected one");
    }
    section(name);
  }
  if (!has_nodes) text_.fail("the mesh has no section $Nodes; expected one");
  if (!has_elements) text_.fail("the mesh has no section $Elements; expected one");
  make_groups();
  sort_by_tag(mesh_);
  return std::move(mesh_);
}

void GmshFile::section(const std::string& name) {
  if (name == "$PhysicalNames") return physical_names();
  if (name == "$Entities" && version_ == 4) return entities();
  if (name == "$Nodes") return version_ == 2 ? nodes_2() : nodes_4();
  if (name == "$Elements") return version_ == 2 ? elements_2() : elements_4();
  // These sections do not change the mesh.
  if (name == "$Comments" || name == "$Periodic" || name == "$Parametrizations") {
    return skip_section(text_, name);
  }
  text_.fail(0, fmt::format("section {} is not understood; expected $PhysicalNames, $Entities, "
                            "$Nodes, $Elements, $Periodic, $Parametrizations or $Comments",
                            support::in_quotes(name)));
}

void GmshFile::physical_names() {
  next_data(text_, "how many names there are");
  const int count = text_.whole(0, "the number of names", 0);
  for (int i = 0; i < count; ++i) {
    next_data(text_, fmt::format("name {} of {}", i + 1, count));
    const Tag tag{text_.whole(0, "the dimension of a group", 0),
                  text_.whole(1, "the number of a group", 1)};
    const auto line = text_.line();
    const auto first = line.find('"');
    const auto last = line.rfind('"');
    if (tag.first > 3 || first == std::string_view::npos || last <= first + 1) {
      text_.fail(2, "a group without a name in quotes; expected DIMENSION TAG \"NAME\"");
    }
    const bool is_new = names_.emplace(tag, line.substr(first + 1, last - first - 1)).second;
    if (!is_new) text_.fail("a second name of one group; expected one for each");
    groups_at_.emplace(tag, here());
    group_elements_[tag];
  }
  end_section(text_, "$PhysicalNames");
}

// Points, curves, surfaces and volumes of the geometry, each with its groups.
void GmshFile::entities() {
  next_data(text_, "how many points, curves, surfaces and volumes there are");
  std::vector<int> counts;
  for (std::size_t i = 0; i < 4; ++i) counts.push_back(text_.whole(i, "a number of entities", 0));
  for (int dimension = 0; dimension < 4; ++dimension) {
    const int count = counts[static_cast<std::size_t>(dimension)];
    for (int i = 0; i < count; ++i) {
      next_data(text_, fmt::format("entity {} of {} of dimension {}", i + 1, count, dimension));
      auto& groups = entity_groups_[{dimension, text_.whole(0, "the number of an entity", 0)}];
      const std::size_t place = dimension == 0 ? 4 : 7;  // after a position, or a box
      const int groups_here = text_.whole(place, "the number of groups of an entity", 0);
      for (int group = 0; group < groups_here; ++group) {
        const int tag = text_.whole(place + 1 + static_cast<std::size_t>(group),
                                    "the number of a group", -largest_tag);
        groups.push_back(std::abs(tag));  // negative: opposite orientation
        groups_at_.emplace(Tag(dimension, groups.back()), here());
      }
    }
  }
  end_section(text_, "$Entities");
}

void GmshFile::node(int tag, std::size_t first, MeshPlace at) {
  MeshNode node{tag, {}, at};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    node.place(static_cast<Eigen::Index>(axis)) = text_.real(first + axis, "a coordinate");
  }
  index_.add_node(text_, node);
}

void GmshFile::nodes_2() {
  next_data(text_, "how many nodes there are");
  const int count = text_.whole(0, "the number of nodes", 1);
  for (int i = 0; i < count; ++i) {
    next_data(text_, fmt::format("node {} of {}", i + 1, count));
    node(text_.whole(0, "the number of a node", 1), 1, here());
  }
  end_section(text_, "$Nodes");
}

std::vector<int> GmshFile::node_tags(int count) {
  std::vector<int> tags;
  for (int i = 0; i < count; ++i) {
    next_data(text_, fmt::format("the tag of node {} of {} in the block", i + 1, count));
    tags.push_back(text_.whole(0, "the number of a node", 1));
  }
  return tags;
}

void GmshFile::nodes_4() {
  next_data(text_, "how many blocks of nodes there are");
  const int blocks = text_.whole(0, "the number of blocks", 0);
  const int count = text_.whole(1, "the number of nodes", 1);
  for (int block = 0; block < blocks; ++block) {
    next_data(text_, fmt::format("block {} of {}", block + 1, blocks));
    const auto tags = node_tags(text_.whole(3, "the number of nodes of a block", 0));
    for (std::size_t i = 0; i < tags.size(); ++i) {
      next_data(text_, fmt::format("node {} of {} in the block", i + 1, tags.size()));
      node(tags[i], 0, here());
    }
  }
  if (mesh_.nodes.size() != static_cast<std::size_t>(count)) {
    text_.fail(fmt::format("the blocks have {} nodes; expected {}, as the section says",
                           mesh_.nodes.size(), count));
  }
  end_section(text_, "$Nodes");
}

MeshShape GmshFile::shape(int type, std::size_t field) const {
  const auto shape = gmsh_shape(type);
  if (!shape) {
    text_.fail(field, fmt::format("an element that is {}; expected points, lines, triangles of 3 "
                                  "or 6, quadrilaterals of 4 or 8, tetrahedra of 4 or 10, "
                                  "hexahedra of 8 or 20, prisms of 6 or 15, pyramids of 5 nodes{}",
                                  gmsh_called(type), gmsh_remedy(type)));
  }
  return *shape;
}

int GmshFile::copied(const MeshElement& element, const std::vector<int>& groups) const {
  if (version_ != 2 || mesh_.elements.empty()) return -1;
  const auto& before = mesh_.elements.back();
  if (before.shape != element.shape || before.nodes != element.nodes) return -1;
  const auto number = static_cast<int>(mesh_.elements.size()) - 1;
  const int dimension = mesh_dimension(element.shape);
  const bool other_group = std::ranges::all_of(groups, [&](int group) {
    const auto found = group_elements_.find({dimension, group});
    return found == group_elements_.end() || found->second.empty() ||
           found->second.back() != number;
  });
  return other_group && !groups.empty() ? number : -1;
}

void GmshFile::element(MeshShape shape, std::size_t first, const std::vector<int>& groups) {
  const auto count = static_cast<std::size_t>(mesh_nodes(shape));
  if (text_.fields() != first + count) {
    text_.fail(fmt::format("{} with {} numbers of nodes; expected {}", mesh_called(shape),
                           text_.fields() - std::min(first, text_.fields()), count));
  }
  std::vector<int> nodes;
  for (std::size_t i = 0; i < count; ++i) nodes.push_back(index_.node(text_, first + i));
  MeshElement element{text_.whole(0, "the number of an element", 1), shape,
                      from_gmsh_order(shape, nodes), std::nullopt, here()};
  int number = copied(element, groups);
  if (number < 0) number = index_.add_element(text_, std::move(element));
  add_to_groups(number, mesh_dimension(shape), groups);
}

void GmshFile::add_to_groups(int element, int dimension, const std::vector<int>& groups) {
  for (const int group : groups) {
    groups_at_.emplace(Tag(dimension, group), here());
    group_elements_[{dimension, group}].push_back(element);
  }
}

void GmshFile::elements_2() {
  next_data(text_, "how many elements there are");
  const int count = text_.whole(0, "the number of elements", 1);
  for (int i = 0; i < count; ++i) {
    next_data(text_, fmt::format("element {} of {}", i + 1, count));
    const MeshShape kind = shape(text_.whole(1, "the type of an element", 1), 1);
    const auto tags = static_cast<std::size_t>(text_.whole(2, "the number of tags", 0));
    std::vector<int> groups;  // the first tag; 0: none
    if (tags > 0) groups.push_back(std::abs(text_.whole(3, "the number of a group", -largest_tag)));
    std::erase(groups, 0);
    element(kind, 3 + tags, groups);
  }
  end_section(text_, "$Elements");
}

void GmshFile::elements_4() {
  next_data(text_, "how many blocks of elements there are");
  const int blocks = text_.whole(0, "the number of blocks", 0);
  const int count = text_.whole(1, "the number of elements", 1);
  for (int block = 0; block < blocks; ++block) {
    next_data(text_, fmt::format("block {} of {}", block + 1, blocks));
    const Tag entity{text_.whole(0, "the dimension of an entity", 0),
                     text_.whole(1, "the number of an entity", 0)};
    const MeshShape kind = shape(text_.whole(2, "the type of an element", 1), 2);
    const int count_here = text_.whole(3, "the number of elements of a block", 0);
    const auto groups = entity_groups_.find(entity);
    for (int i = 0; i < count_here; ++i) {
      next_data(text_, fmt::format("element {} of {} in the block", i + 1, count_here));
      element(kind, 1, groups == entity_groups_.end() ? std::vector<int>{} : groups->second);
    }
  }
  if (mesh_.elements.size() != static_cast<std::size_t>(count)) {
    text_.fail(fmt::format("the blocks have {} elements; expected {}, as the section says",
                           mesh_.elements.size(), count));
  }
  end_section(text_, "$Elements");
}

// Groups with the same name, such as a curve and its ends, are merged.
void GmshFile::make_groups() {
  static constexpr const char* kinds[] = {"point", "curve", "surface", "volume"};
  std::map<std::string, std::size_t> made;
  for (const auto& [tag, elements] : group_elements_) {
    const auto named = names_.find(tag);
    const std::string name =
        named != names_.end() ? named->second : fmt::format("{}.{}", kinds[tag.first], tag.second);
    const auto [entry, is_new] = made.emplace(name, mesh_.groups.size());
    if (is_new) mesh_.groups.push_back({name, groups_at_.at(tag), {}, {}, {}});
    auto& all = mesh_.groups[entry->second].elements;
    all.insert(all.end(), elements.begin(), elements.end());
  }
}

}  // namespace

MeshData read_gmsh(std::string_view text, const std::string& file) {
  if (!is_binary_gmsh(text)) return GmshFile(text, file).read();
  const std::string ascii = gmsh_as_text(text, file);
  GmshFile binary(ascii, file);
  binary.leave_out_lines();
  return std::move(binary).read();
}

}  // namespace kusabi::problems
