// The problem file, section by section: which keys there are and what they mean.
#include "problems/structure_file.hpp"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "problems/loads_file.hpp"
#include "problems/structure_check.hpp"
#include "problems/toml_reader.hpp"

namespace kusabi::problems {
namespace {

/// Fills a structure from the sections of one file. Nodes come first: all else names them.
class StructureFile {
 public:
  StructureFile(std::string_view text, const std::string& file) : reader_(text, file) {
    structure_.sources.file = file;
  }

  Structure read() &&;

 private:
  void header();
  void nodes();
  void members();
  void supports();
  void contact();
  void loads();

  void member_group(const TomlTable& group);
  void support_group(const TomlTable& group);
  void contact_group(const TomlTable& group);
  int node(const TomlText& name) const;
  void axial_stiffness(const TomlTable& group, Member& bar, SourcePosition& position) const;
  std::array<bool, 3> fixed_axes(const TomlTable& group) const;

  TomlReader reader_;
  Structure structure_;
  std::map<std::string, int, std::less<>> node_numbers_;
  std::map<int, SourcePosition> supported_;
};

Structure StructureFile::read() && {
  reader_.allow_only(reader_.root(), {"name", "dimension", "units", "nodes", "members", "supports",
                                      "contact", "loads", "uncertainty"});
  header();
  nodes();
  members();
  supports();
  contact();
  loads();
  check_structure(structure_);
  return std::move(structure_);
}

void StructureFile::header() {
  const TomlTable root = reader_.root();
  structure_.name = reader_.text(reader_.require(root, "name", "name = \"...\""), "name").text;
  structure_.dimension =
      reader_.one_of(reader_.require(root, "dimension", "2 or 3"), "dimension", {2, 3});
  const std::string_view pattern = "units = { length = \"...\", force = \"...\" }";
  const TomlTable units = reader_.table(reader_.require(root, "units", pattern), "units");
  reader_.allow_only(units, {"length", "force"});
  structure_.units.length =
      reader_.text(reader_.require(units, "length", pattern), "the unit of length").text;
  structure_.units.force =
      reader_.text(reader_.require(units, "force", pattern), "the unit of force").text;
}

void StructureFile::nodes() {
  const auto entries = reader_.entries(
      reader_.require(reader_.root(), "nodes", "a table [nodes] of name = position"), "[nodes]");
  structure_.coordinates.resize(structure_.dimension, static_cast<Eigen::Index>(entries.size()));
  structure_.fixed.resize(entries.size(), {false, false, false});
  int number = 0;
  for (const TomlEntry& entry : entries) {
    reader_.check_text(entry.key, "a node name", entry.key_position);
    structure_.coordinates.col(number) =
        reader_.vector(*entry.value, fmt::format("the position of node {}", in_quotes(entry.key)),
                       structure_.dimension);
    structure_.node_names.push_back(entry.key);
    structure_.sources.nodes.push_back(entry.key_position);
    node_numbers_.emplace(entry.key, number++);
  }
}

int StructureFile::node(const TomlText& name) const {
  const auto found = node_numbers_.find(name.text);
  if (found != node_numbers_.end()) return found->second;
  const std::vector<std::string_view> names(structure_.node_names.begin(),
                                            structure_.node_names.end());
  std::string message =
      fmt::format("node {} does not exist; expected a name from [nodes]", in_quotes(name.text));
  const std::string_view meant = nearest(name.text, names);
  if (!meant.empty()) message += fmt::format("; did you mean {}?", in_quotes(meant));
  reader_.fail(name.position, message);
}

void StructureFile::members() {
  const auto& section =
      reader_.require(reader_.root(), "members", "at least one [[members]] group");
  for (const TomlTable& group : reader_.groups(section, "members")) member_group(group);
}

void StructureFile::axial_stiffness(const TomlTable& group, Member& bar,
                                    SourcePosition& position) const {
  const toml::node* entry = group.table->get("EA");
  position = reader_.position(entry == nullptr ? *group.table : *entry);
  if (entry == nullptr) return;
  bar.axial_stiffness = reader_.number(*entry, "EA");
  // Zero would mean that none is given.
  if (bar.axial_stiffness == 0) reader_.fail(position, axial_stiffness_fault(0));
}

void StructureFile::member_group(const TomlTable& group) {
  reader_.allow_only(group, {"EA", "yield", "between"});
  Member bar{};
  SourcePosition stiffness_position;
  axial_stiffness(group, bar, stiffness_position);
  const toml::node* yield_entry = group.table->get("yield");
  if (yield_entry != nullptr) bar.yield = yield_in(reader_, *yield_entry);
  const SourcePosition yield_position =
      reader_.position(yield_entry == nullptr ? *group.table : *yield_entry);
  const auto& between = reader_.require(group, "between", "between = [[\"a\", \"b\"], ...]");
  for (const toml::node* pair : reader_.elements(between, "between")) {
    const auto ends = reader_.texts(*pair, "a member");
    if (ends.size() != 2) {
      reader_.fail(*pair, fmt::format("a member has {} ends; expected two node names, [\"a\", "
                                      "\"b\"]",
                                      ends.size()));
    }
    bar.first = node(ends[0]);
    bar.second = node(ends[1]);
    structure_.members.push_back(bar);
    structure_.sources.members.push_back(reader_.position(*pair));
    structure_.sources.axial_stiffnesses.push_back(stiffness_position);
    structure_.sources.yields.push_back(yield_position);
  }
}

void StructureFile::supports() {
  const auto& section =
      reader_.require(reader_.root(), "supports", "at least one [[supports]] group");
  for (const TomlTable& group : reader_.groups(section, "supports")) support_group(group);
}

std::array<bool, 3> StructureFile::fixed_axes(const TomlTable& group) const {
  const toml::node* entry = group.table->get("fixed");
  if (entry != nullptr) return axes_in(reader_, *entry, "fixed", structure_.dimension);
  std::array<bool, 3> fixed{};
  std::fill_n(fixed.begin(), structure_.dimension, true);
  return fixed;
}

void StructureFile::support_group(const TomlTable& group) {
  reader_.allow_only(group, {"nodes", "fixed"});
  const auto& names = reader_.require(group, "nodes", "nodes = [\"a\", ...]");
  const std::array<bool, 3> fixed = fixed_axes(group);
  for (const TomlText& name : reader_.texts(names, "nodes")) {
    const int number = node(name);
    const auto [before, is_new] = supported_.emplace(number, name.position);
    if (!is_new) {
      reader_.fail(name.position,
                   fmt::format("node {} is supported twice, first on line {}; expected once",
                               in_quotes(name.text), before->second.line));
    }
    structure_.fixed[static_cast<std::size_t>(number)] = fixed;
  }
}

void StructureFile::contact() {
  const toml::node* section = reader_.root().table->get("contact");
  if (section == nullptr) return;
  for (const TomlTable& group : reader_.groups(*section, "contact")) contact_group(group);
}

void StructureFile::loads() {
  const toml::node* section = reader_.root().table->get("loads");
  const LoadsFile file(reader_, [this](const TomlText& name) { return node(name); });
  if (section != nullptr) file.read_loads(*section, structure_);
  section = reader_.root().table->get("uncertainty");
  if (section != nullptr) file.read_uncertainty(*section, structure_);
}

void StructureFile::contact_group(const TomlTable& group) {
  reader_.allow_only(group, {"nodes", "normal", "tangent", "friction"});
  const auto& names = reader_.require(group, "nodes", "nodes = [\"a\", ...]");
  const auto& normal_entry =
      reader_.require(group, "normal", "normal = [...], the outward normal of the obstacle");
  const Eigen::VectorXd direction =
      reader_.vector(normal_entry, "the normal", structure_.dimension);
  if (direction.isZero(0.0)) {
    reader_.fail(normal_entry, "the normal is zero; expected the outward normal of the obstacle");
  }
  const Eigen::VectorXd normal = direction.stableNormalized();
  const toml::node* tangent_entry = group.table->get("tangent");
  std::optional<Eigen::VectorXd> tangent;
  SourcePosition tangent_position;
  if (tangent_entry != nullptr) {
    tangent = reader_.vector(*tangent_entry, "the tangent", structure_.dimension);
    tangent_position = reader_.position(*tangent_entry);
  }
  double friction = 1;
  SourcePosition friction_position;
  if (const toml::node* entry = group.table->get("friction"); entry != nullptr) {
    friction = reader_.number(*entry, "friction");
    friction_position = reader_.position(*entry);
  }
  for (const TomlText& name : reader_.texts(names, "nodes")) {
    structure_.contact.push_back({node(name), normal, tangent, friction});
    structure_.sources.contact.push_back(name.position);
    structure_.sources.normals.push_back(reader_.position(normal_entry));
    structure_.sources.tangents.push_back(tangent_position);
    structure_.sources.frictions.push_back(friction_position);
  }
}

}  // namespace

Structure read_structure(std::string_view toml_text, const std::string& file_name) {
  if (toml_text.empty()) {
    throw InputError(file_name, {1, 1}, "the file is empty; expected a problem file in TOML");
  }
  return StructureFile(toml_text, file_name).read();
}

std::string file_text(const std::filesystem::path& file) {
  std::error_code failure;
  const std::uintmax_t size = std::filesystem::file_size(file, failure);
  if (!failure && size > largest_file) {
    throw InputError(file.string(), {},
                     fmt::format("the file has {} bytes; expected at most {}", size, largest_file));
  }
  std::ifstream stream(file, std::ios::binary);
  if (failure || !stream) {
    throw InputError(file.string(), {}, "the file cannot be read; expected a problem file in TOML");
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

Structure load_structure(const std::filesystem::path& file) {
  return read_structure(file_text(file), file.string());
}

}  // namespace kusabi::problems
