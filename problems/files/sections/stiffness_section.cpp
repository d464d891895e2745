// Section [[stiffness]]: a matrix computed by another program, and the meaning of its rows.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "problems/files/draft/stiffness_outlines.hpp"
#include "problems/files/matrices/calculix_matrix.hpp"
#include "problems/files/matrices/matrix_file.hpp"
#include "problems/files/matrices/matrix_market.hpp"
#include "problems/files/sections/problem_sections.hpp"

namespace kusabi::problems {
namespace {

/// First number of a rotation among the directions of rows in CalculiX and Abaqus.
constexpr int first_rotation = 4;

/// The meaning of a row, or nothing if it is fixed.
using Row = std::optional<SuperelementRow>;

class StiffnessSection {
 public:
  StiffnessSection(ProblemDraft& draft, const TomlTable& group);

  void read();

  /// The mesh of the stiffness; null if not specified.
  const NamedMesh* mesh() const { return mesh_; }

 private:
  const std::string& text_of(const std::string& place) const;
  std::vector<SuperelementRow> row_kinds(std::vector<bool>& held) const;
  std::vector<ListedNode> nodes() const;
  std::vector<Row> listed_rows() const;
  std::vector<Row> named_rows() const;
  SuperelementRow named_row(const MatrixRow& row) const;
  void add(const std::vector<Row>& rows);
  const toml::node* entry(std::string_view key) const { return group_.table->get(key); }

  ProblemDraft& draft_;
  const TomlReader& reader_;
  const TomlTable& group_;
  TomlText file_;
  const NamedMesh* mesh_ = nullptr;  // the mesh of the stiffness, if specified
  std::string heading_;              // prefix of the tags of nodes in the file
  bool others_free_ = false;         // unknown nodes have internal unknowns
  MatrixData data_;
};

StiffnessSection::StiffnessSection(ProblemDraft& draft, const TomlTable& group)
    : draft_(draft), reader_(draft.reader()), group_(group) {
  reader_.allow_only(group, {"file", "nodes", "except", "every", "rows", "mesh", "others"});
  file_ = matrix_file_name(reader_, reader_.require(group, "file", "file = \"....mtx\""));
  if (const auto* mesh = entry("mesh"); mesh != nullptr) {
    const TomlText name = reader_.text(*mesh, "mesh");
    mesh_ = draft.mesh(name.text);
    if (mesh_ == nullptr) {
      reader_.fail(name.position, fmt::format("no [[mesh]] is named {}; expected the name of one",
                                              support::in_quotes(name.text)));
    }
    heading_ = name.text + ".";
  }
  if (const auto* others = entry("others"); others != nullptr) {
    if (reader_.text(*others, "others").text != "free") {
      reader_.fail(*others, "others is not \"free\"; expected others = \"free\", or no others");
    }
    others_free_ = true;
  }
}

const std::string& StiffnessSection::text_of(const std::string& place) const {
  const std::string* text = draft_.meshes().text(place);
  if (text == nullptr) {
    throw support::InputError(draft_.meshes().name(place), {},
                              "the matrix was not read along with the problem file");
  }
  return *text;
}

void StiffnessSection::read() {
  const auto place = MeshTexts::place("", file_.text);
  const std::string name = draft_.meshes().name(place);
  const std::string& text = text_of(place);
  if (const auto dofs = rows_file_of(place); !dofs.empty()) {
    data_ = read_stored_matrix(text, name, text_of(dofs), draft_.meshes().name(dofs));
  } else {
    data_ = is_matrix_market(text) ? read_matrix_market(text, name) : read_substructure(text, name);
  }
  add(data_.rows.empty() ? listed_rows() : named_rows());
}

/// The meaning of the rows of each node.
std::vector<SuperelementRow> StiffnessSection::row_kinds(std::vector<bool>& held) const {
  const int dimension = draft_.structure().dimension;
  std::vector<SuperelementRow> kinds;
  const auto* rows = entry("rows");
  if (rows == nullptr) {
    for (int axis = 0; axis < dimension; ++axis) kinds.push_back({0, axis});
    held.assign(kinds.size(), false);
    return kinds;
  }
  std::set<int> seen;
  for (const TomlText& name : reader_.texts(*rows, "rows")) {
    SuperelementRow kind{-1, 0};
    for (int axis = 0; axis < dimension; ++axis) {
      if (name.text == axis_name(axis)) kind = {0, axis};
    }
    if (kind.node < 0 && name.text != "free" && name.text != "held") {
      reader_.fail(name.position,
                   fmt::format("a row is {}; expected {}, \"free\" or \"held\"",
                               support::in_quotes(name.text),
                               dimension == 2 ? "\"x\", \"y\"" : "\"x\", \"y\", \"z\""));
    }
    if (kind.node == 0 && !seen.insert(kind.axis).second) {
      reader_.fail(name.position,
                   fmt::format("rows has {} twice; expected once", support::in_quotes(name.text)));
    }
    kinds.push_back(kind);
    held.push_back(name.text == "held");
  }
  return kinds;
}

// The listed nodes, by default those of the mesh.
std::vector<ListedNode> StiffnessSection::nodes() const {
  if (mesh_ == nullptr || entry("nodes") != nullptr) return draft_.nodes_listed(group_);
  std::vector<ListedNode> all;
  for (const int node : mesh_->nodes) all.push_back({node, file_.position});
  return all;
}

std::vector<Row> StiffnessSection::listed_rows() const {
  if (const auto* others = entry("others"); others != nullptr) {
    reader_.fail(*others,
                 "others is for files of CalculiX, which know their nodes; expected nodes, or the "
                 "mesh, in the order of the rows");
  }
  const auto listed = nodes();
  std::vector<bool> held;
  const auto kinds = row_kinds(held);
  if (data_.size != static_cast<std::int64_t>(listed.size() * kinds.size())) {
    throw support::InputError(
        data_.file, {data_.size_line, 1},
        fmt::format("the matrix has {} rows; expected {}: {} nodes with {} each", data_.size,
                    listed.size() * kinds.size(), listed.size(), kinds.size()));
  }
  std::set<int> seen;
  std::vector<Row> rows;
  for (const ListedNode& each : listed) {
    const int node = each.node;
    if (!seen.insert(node).second) {
      reader_.fail(each.position,
                   fmt::format("node {} is listed twice; expected once", draft_.node_name(node)));
    }
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      auto& row = rows.emplace_back();
      if (!held[k]) row = SuperelementRow{kinds[k].node < 0 ? -1 : node, kinds[k].axis};
    }
  }
  return rows;
}

SuperelementRow StiffnessSection::named_row(const MatrixRow& row) const {
  const auto fail = [&](const std::string& message) {
    throw support::InputError(data_.rows_file, {row.line, 1}, message);
  };
  const std::string name = heading_ + std::to_string(row.node);
  const bool is_known = draft_.names_node(name);
  if (!is_known && !others_free_) {
    fail(
        fmt::format("node {} of the matrix would be {}, which does not exist; expected it among "
                    "the nodes of the problem, or others = \"free\" in [[stiffness]]",
                    row.node, support::in_quotes(name)));
  }
  if (!is_known || row.direction >= first_rotation) return {-1, 0};
  if (row.direction > draft_.structure().dimension) {
    fail(fmt::format("node {} has a row along z; expected dimension = 3, or a matrix in the plane",
                     row.node));
  }
  return {draft_.node({name, file_.position}), row.direction - 1};
}

std::vector<Row> StiffnessSection::named_rows() const {
  for (const char* key : {"nodes", "except", "every", "rows"}) {
    if (const auto* other = entry(key); other != nullptr) {
      reader_.fail(*other, fmt::format("{} is for a Matrix Market file; expected none, since {} "
                                       "names the rows",
                                       key, support::in_quotes(data_.rows_file)));
    }
  }
  std::vector<Row> rows;
  std::map<std::pair<int, int>, int> lines;
  for (const MatrixRow& row : data_.rows) {
    const auto [first, is_new] = lines.emplace(std::pair(row.node, row.direction), row.line);
    if (!is_new) {
      throw support::InputError(
          data_.rows_file, {row.line, 1},
          fmt::format("node {} has two rows in direction {}, the first on line {}; expected one",
                      row.node, row.direction, first->second));
    }
    rows.emplace_back(named_row(row));
  }
  return rows;
}

// Adds the matrix without its fixed rows.
void StiffnessSection::add(const std::vector<Row>& rows) {
  Structure& structure = draft_.structure();
  auto& warnings = structure.warnings;
  std::ranges::move(data_.warnings, std::back_inserter(warnings));
  auto [matrix, rounding, warning] = symmetric_matrix(std::move(data_));
  if (warning) warnings.push_back(*warning);
  Superelement made;
  made.rounding = rounding;
  std::vector<int> place;  // among the remaining rows
  for (const Row& row : rows) {
    place.push_back(row ? static_cast<int>(made.rows.size()) : -1);
    if (row) made.rows.push_back(*row);
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (int column = 0; column < static_cast<int>(matrix.outerSize()); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry) {
      const int row = place[static_cast<std::size_t>(entry.row())];
      const int other = place[static_cast<std::size_t>(column)];
      if (row >= 0 && other >= 0) entries.emplace_back(row, other, entry.value());
    }
  }
  const auto size = static_cast<Eigen::Index>(made.rows.size());
  made.stiffness.resize(size, size);
  made.stiffness.setFromTriplets(entries.begin(), entries.end());
  structure.superelements.push_back(std::move(made));
  structure.sources.superelements.push_back(file_.position);
}

}  // namespace

bool is_of_stiffness(const ProblemDraft& draft, std::string_view mesh) {
  const toml::node* section = draft.section("stiffness");
  const toml::array* groups = section == nullptr ? nullptr : section->as_array();
  if (groups == nullptr) return false;
  return std::ranges::any_of(*groups, [&](const toml::node& group) {
    const toml::table* table = group.as_table();
    const toml::node* name = table == nullptr ? nullptr : table->get("mesh");
    return name != nullptr && name->value<std::string_view>() == mesh;
  });
}

void read_stiffnesses(ProblemDraft& draft) {
  const toml::node* section = draft.section("stiffness");
  if (section == nullptr) return;
  std::set<const NamedMesh*> meshes;
  for (const TomlTable& group : draft.reader().groups(*section, "stiffness")) {
    StiffnessSection own(draft, group);
    own.read();
    if (own.mesh() != nullptr) meshes.insert(own.mesh());
  }
  set_outlines(meshes, draft.structure());
}

}  // namespace kusabi::problems
