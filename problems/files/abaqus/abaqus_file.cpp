// Reader of Abaqus input files, keyword by keyword.
#include "problems/files/abaqus/abaqus_file.hpp"

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "problems/files/abaqus/abaqus_contact.hpp"
#include "problems/files/abaqus/abaqus_keywords.hpp"
#include "problems/files/abaqus/abaqus_loads.hpp"
#include "problems/files/abaqus/abaqus_materials.hpp"
#include "problems/files/abaqus/abaqus_parts.hpp"
#include "problems/files/abaqus/abaqus_supports.hpp"
#include "problems/files/abaqus/abaqus_text.hpp"
#include "problems/files/abaqus/abaqus_types.hpp"
#include "problems/files/meshes/mesh_groups.hpp"
#include "support/input_error.hpp"

namespace kusabi::problems {
namespace {

class AbaqusFile {
 public:
  AbaqusFile(const MeshTexts& texts, const std::string& place) : text_(texts, place) {}

  MeshData read() &&;

 private:
  void read_card(const AbaqusCard& card);
  void read_understood(const AbaqusCard& card);
  void leave_out(const AbaqusCard& card, std::string_view why);
  void nodes(const AbaqusCard& card);
  void elements(const AbaqusCard& card);
  void element(const AbaqusType& type, std::vector<int>& numbers);
  MeshData& mesh() { return parts_.current().mesh; }
  MeshIndex& index() { return parts_.current().index; }
  AbaqusGroups& groups() { return parts_.current().groups; }

  AbaqusText text_;
  AbaqusParts parts_;
  AbaqusMaterials materials_;
  AbaqusSupports supports_;
  AbaqusLoads loads_;
  AbaqusGravity gravity_;
  AbaqusContact contact_;
};

MeshData AbaqusFile::read() && {
  AbaqusCard card;
  while (text_.next_card(card)) read_card(card);
  parts_.finish(text_);
  MeshData& mesh = parts_.assembly().mesh;
  mesh.files = text_.files();
  if (mesh.nodes.empty()) text_.line().fail("the file has no *NODE; expected nodes");
  if (mesh.elements.empty()) text_.line().fail("the file has no *ELEMENT; expected elements");
  materials_.finish(mesh);
  contact_.finish(text_, mesh);
  unite_supports(text_, mesh);
  loads_.finish(text_, mesh);
  gravity_.finish(mesh);
  mesh.warnings = text_.warnings();
  sort_by_tag(mesh);
  return std::move(mesh);
}

void AbaqusFile::read_card(const AbaqusCard& card) {
  const std::string& keyword = card.keyword;
  switch (keyword_use(keyword)) {
    case KeywordUse::read:
      return read_understood(card);
    case KeywordUse::left_out:
      return leave_out(card, "is left out");
    case KeywordUse::refused:
      text_.line().fail(
          fmt::format("{} is not understood; expected a deck in which each node and each element "
                      "is written out",
                      keyword));
    case KeywordUse::unknown:
      break;
  }
  const std::string similar = similar_keyword(keyword);
  if (!similar.empty()) {
    text_.line().fail(fmt::format("keyword {} is not understood; expected a keyword of Abaqus{}",
                                  support::in_quotes(keyword), similar));
  }
  leave_out(card, "is not understood and left out: the structure is without it");
}

void AbaqusFile::read_understood(const AbaqusCard& card) {
  const std::string& keyword = card.keyword;
  if (parts_.read(text_, card)) return;
  if (contact_.read(text_, card, parts_.current())) return;
  if (keyword == "*HEADING") {
    while (text_.next_data())
      if (mesh().heading.empty()) mesh().heading = trimmed(text_.line().line());
    return;
  }
  if (keyword == "*NODE") return nodes(card);
  if (keyword == "*ELEMENT") return elements(card);
  if (keyword == "*NSET") return groups().read_node_set(text_, card);
  if (keyword == "*ELSET") return groups().read_element_set(text_, card);
  if (keyword == "*SURFACE") return groups().read_surface(text_, card);
  if (keyword == "*MATERIAL") return materials_.read_material(text_, card);
  if (keyword == "*ELASTIC") return materials_.read_elastic(text_, card);
  if (keyword == "*DENSITY") return materials_.read_density(text_);
  if (keyword == "*SOLID SECTION") return materials_.read_section(text_, card, parts_.current());
  if (keyword == "*BOUNDARY") return supports_.read_boundary(text_, card, parts_.current());
  if (keyword == "*CLOAD") return loads_.read(text_, card, parts_.assembly());
  if (keyword == "*DLOAD") return gravity_.read(text_, card, parts_.assembly());
  if (keyword == "*TRANSFORM") return read_transform(text_, card, parts_.current());
  if (keyword == "*STEP") {
    supports_.begin_step();
    loads_.begin_step();
    gravity_.begin_step();
  }
  leave_out(card, "is left out");
}

void AbaqusFile::leave_out(const AbaqusCard& card, std::string_view why) {
  text_.warn(fmt::format("{} {}", card.keyword, why), card.at);
  while (text_.next_data()) continue;
}

void AbaqusFile::nodes(const AbaqusCard& card) {
  allow_only(text_, card, {"NSET"});
  std::vector<int> numbers;
  while (text_.next_data()) {
    const MeshText& line = text_.line();
    MeshNode node{line.whole(0, "the number of a node", 1), Eigen::Vector3d::Zero(), text_.here()};
    if (line.fields() < 3 || line.fields() > 4) {
      line.fail(
          fmt::format("a node with {} coordinates; expected two or three", line.fields() - 1));
    }
    for (std::size_t i = 1; i < line.fields(); ++i) {
      node.place(static_cast<Eigen::Index>(i) - 1) = line.real(i, "a coordinate");
    }
    numbers.push_back(static_cast<int>(mesh().nodes.size()));
    index().add_node(line, node);
  }
  if (const auto* set = card.find("NSET"); set != nullptr) {
    auto& all = groups().group(text_, *set, card.at).nodes;
    all.insert(all.end(), numbers.begin(), numbers.end());
  }
}

void AbaqusFile::elements(const AbaqusCard& card) {
  allow_only(text_, card, {"TYPE", "ELSET"});
  const std::string name = capitals(required(text_, card, "TYPE"));
  const AbaqusType type = abaqus_type(name);
  if (type.use == AbaqusType::Use::refused) {
    text_.line().fail(fmt::format("elements of type {} are not understood; expected {}",
                                  support::in_quotes(name), abaqus_types_read()));
  }
  if (type.use == AbaqusType::Use::left_out) {
    text_.warn(fmt::format("elements of type {} are left out: the structure is without them", name),
               card.at);
    while (text_.next_data()) index().leave_out_element(text_.line().whole(0, "a number", 1));
  }
  if (!type.instead.empty()) {
    text_.warn(
        fmt::format("elements of type {} are read as {}, fully integrated", name, type.instead),
        card.at);
  }
  std::vector<int> numbers;
  while (text_.next_data()) element(type, numbers);
  if (const auto* set = card.find("ELSET"); set != nullptr) {
    auto& all = groups().group(text_, *set, card.at).elements;
    all.insert(all.end(), numbers.begin(), numbers.end());
  }
}

// The nodes of an element may take several lines.
void AbaqusFile::element(const AbaqusType& type, std::vector<int>& numbers) {
  MeshElement element{text_.line().whole(0, "the number of an element", 1),
                      type.shape,
                      {},
                      type.state,
                      text_.here()};
  const auto count = static_cast<std::size_t>(mesh_nodes(type.shape));
  std::size_t first = 1;
  while (true) {
    const MeshText& line = text_.line();
    for (std::size_t i = first; i < line.fields(); ++i) {
      if (element.nodes.size() == count) {
        line.fail(
            i, fmt::format("more nodes than {} has; expected {}", mesh_called(type.shape), count));
      }
      element.nodes.push_back(index().node(line, i));
    }
    if (element.nodes.size() == count) break;
    if (!text_.next_data()) {
      throw support::InputError(
          text_.files()[static_cast<std::size_t>(element.at.file)], {element.at.line, 1},
          fmt::format("the element has {} nodes; expected {}", element.nodes.size(), count));
    }
    first = 0;
  }
  // Abaqus orders the midpoint of a line between its ends.
  if (type.shape == MeshShape::line3) std::swap(element.nodes[1], element.nodes[2]);
  numbers.push_back(index().add_element(text_.line(), std::move(element)));
}

}  // namespace

MeshData read_abaqus(const MeshTexts& texts, const std::string& place) {
  return AbaqusFile(texts, place).read();
}

}  // namespace kusabi::problems
