// The sections of a problem file and the order in which they are read.
#include "problems/files/structure_file.hpp"

#include <fstream>
#include <iostream>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "problems/files/draft/problem_draft.hpp"
#include "problems/files/problem_text.hpp"
#include "problems/files/sections/actions_section.hpp"
#include "problems/files/sections/loads_file.hpp"
#include "problems/files/sections/problem_sections.hpp"
#include "problems/files/toml/toml_reader.hpp"
#include "problems/structure/bodies/connected_bodies.hpp"
#include "problems/structure/geometry/surface.hpp"

namespace kusabi::problems {
namespace {

void read_header(ProblemDraft& draft) {
  const TomlReader& reader = draft.reader();
  Structure& structure = draft.structure();
  const TomlTable root = reader.root();
  structure.name = reader.text(reader.require(root, "name", "name = \"...\""), "name").text;
  structure.dimension =
      reader.one_of(reader.require(root, "dimension", "2 or 3"), "dimension", {2, 3});
  const std::string_view pattern = "units = { length = \"...\", force = \"...\" }";
  const TomlTable units = reader.table(reader.require(root, "units", pattern), "units");
  reader.allow_only(units, {"length", "force"});
  structure.units.length =
      reader.text(reader.require(units, "length", pattern), "the unit of length").text;
  structure.units.force =
      reader.text(reader.require(units, "force", pattern), "the unit of force").text;
}

void read_nodes(ProblemDraft& draft) {
  const TomlReader& reader = draft.reader();
  const int dimension = draft.structure().dimension;
  draft.structure().coordinates.resize(dimension, 0);
  if (draft.section("nodes") == nullptr && draft.section("mesh") != nullptr) return;
  const auto& section =
      reader.require(reader.root(), "nodes", "a table [nodes] of name = position");
  for (const TomlEntry& entry : reader.entries(section, "[nodes]")) {
    reader.check_text(entry.key, "a node name", entry.key_position);
    const auto called = fmt::format("the position of node {}", support::in_quotes(entry.key));
    draft.add_node(entry.key, reader.vector(*entry.value, called, dimension), entry.key_position);
  }
}

void read_loads(ProblemDraft& draft) {
  const LoadsFile file(draft.reader(),
                       [&draft](const TomlTable& table) { return draft.nodes_listed(table); });
  if (const auto* section = draft.section("loads"); section != nullptr) {
    file.read_loads(*section, draft.structure());
  }
  if (const auto* section = draft.section("uncertainty"); section != nullptr) {
    file.read_uncertainty(*section, draft.structure());
  }
}

StructureAndFacets read(std::string_view toml_text, const std::string& file_name,
                        const MeshTexts& meshes) {
  if (toml_text.empty()) {
    throw support::InputError(file_name, {1, 1},
                              "the file is empty; expected a problem file in TOML");
  }
  ProblemDraft draft(toml_text, file_name, meshes);
  draft.reader().allow_only(
      draft.reader().root(),
      {"name", "dimension", "units", "gravity", "temperature", "nodes", "mesh", "material",
       "members", "elements", "supports", "springs", "stiffness", "ties", "contact", "loads",
       "uncertainty", "actions", "combinations"});
  read_header(draft);
  read_nodes(draft);
  read_meshes(draft);
  read_members(draft);
  read_elements(draft);
  read_supports(draft);
  read_springs(draft);
  read_stiffnesses(draft);
  read_ties(draft);
  read_contact(draft);
  read_loads(draft);
  read_actions(draft);
  read_body_loads(draft);
  auto facets = std::move(draft.facets());
  CheckedStructure structure(std::move(draft).finished());
  structure.warn(normal_warnings(structure));
  structure.warn(coincidence_warnings(structure));
  return {std::move(structure), std::move(facets)};
}

}  // namespace

CheckedStructure read_structure(std::string_view toml_text, const std::string& file_name) {
  return read(toml_text, file_name, {}).structure;
}

CheckedStructure read_structure(const ProblemText& text, const std::string& file_name) {
  return read_structure_and_facets(text, file_name).structure;
}

StructureAndFacets read_structure_and_facets(const ProblemText& text,
                                             const std::string& file_name) {
  return read(text.toml, file_name, {file_name, text.meshes});
}

std::string file_text(const std::filesystem::path& file, std::string_view expected,
                      std::uintmax_t largest) {
  const bool standard_input = file == "-";
  std::ifstream opened;
  if (!standard_input) opened.open(file, std::ios::binary);
  std::istream& stream = standard_input ? std::cin : opened;
  std::string text;
  // The size of pipes is unknown, and folders can be opened.
  for (std::vector<char> part(std::size_t{1} << 16U); stream && text.size() <= largest;) {
    stream.read(part.data(), static_cast<std::streamsize>(part.size()));
    text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream.eof() && text.size() <= largest) {
    throw support::InputError(file.string(), {},
                              fmt::format("the file cannot be read; expected {}", expected));
  }
  if (text.size() > largest) {
    std::error_code unknown;
    const auto size = std::filesystem::file_size(file, unknown);
    throw support::InputError(
        file.string(), {},
        fmt::format("the file has {} bytes; expected at most {}",
                    unknown ? fmt::format("more than {}", largest) : fmt::to_string(size),
                    largest));
  }
  return text;
}

CheckedStructure load_structure(const std::filesystem::path& file) {
  return read_structure(problem_text(file), file.string());
}

}  // namespace kusabi::problems
