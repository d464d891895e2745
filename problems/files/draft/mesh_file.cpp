// Choice of the reader by the file name.
#include "problems/files/draft/mesh_file.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "problems/files/abaqus/abaqus_file.hpp"
#include "problems/files/abaqus/abaqus_text.hpp"
#include "problems/files/meshes/gmsh_file.hpp"
#include "support/input_error.hpp"

namespace kusabi::problems {
namespace {

/// Two elements with the same vertices would be a duplicate.
void refuse_copies(const MeshData& mesh) {
  std::vector<std::pair<std::vector<int>, int>> vertices;
  for (int number = 0; number < static_cast<int>(mesh.elements.size()); ++number) {
    const MeshElement& element = mesh.elements[static_cast<std::size_t>(number)];
    vertices.emplace_back(std::vector<int>(element.nodes.begin(),
                                           element.nodes.begin() + mesh_corners(element.shape)),
                          number);
    std::ranges::sort(vertices.back().first);
  }
  std::ranges::sort(vertices);
  const auto same = std::ranges::adjacent_find(vertices, [&](const auto& one, const auto& other) {
    const auto shape = [&](const auto& entry) {
      return mesh.elements[static_cast<std::size_t>(entry.second)].shape;
    };
    return one.first == other.first && mesh_dimension(shape(one)) == mesh_dimension(shape(other)) &&
           mesh_dimension(shape(one)) > 0;
  });
  if (same == vertices.end()) return;
  const MeshElement& first = mesh.elements[static_cast<std::size_t>(same->second)];
  const MeshElement& second = mesh.elements[static_cast<std::size_t>((same + 1)->second)];
  throw support::InputError(
      mesh.files[static_cast<std::size_t>(second.at.file)], {second.at.line, 1},
      fmt::format("element {} has the corners of element {}; expected each element once",
                  second.tag, first.tag));
}

}  // namespace

TomlText mesh_file_name(const TomlReader& reader, const toml::node& entry) {
  const auto value = entry.is_string() ? entry.value<std::string>() : std::nullopt;
  const TomlText name{value.value_or(""), reader.position(entry)};
  if (!name.text.ends_with(".msh") && !is_abaqus_file(name.text)) {
    reader.fail(entry,
                "file is not the name of a mesh; expected file = \"....msh\" (Gmsh) or "
                "\"....inp\" (Abaqus, CalculiX); mesh_file.py converts VTU, VTK and others");
  }
  return name;
}

bool is_abaqus_file(std::string_view name) {
  return capitals(name).ends_with(".INP");
}

MeshData read_mesh_file(const MeshTexts& texts, const std::string& place) {
  const std::string* text = texts.text(place);
  const std::string name = texts.name(place);
  if (text == nullptr) {
    throw support::InputError(name, {}, "the mesh was not read along with the problem file");
  }
  MeshData mesh = is_abaqus_file(place) ? read_abaqus(texts, place) : read_gmsh(*text, name);
  refuse_copies(mesh);
  return mesh;
}

}  // namespace kusabi::problems
