// Lines in the order of CalculiX 2.20.
#include "problems/files/matrices/calculix_matrix.hpp"

#include <charconv>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "problems/files/abaqus/abaqus_text.hpp"
#include "problems/files/meshes/mesh_text.hpp"
#include "support/input_error.hpp"

namespace kusabi::problems {
namespace {

/// A positive integer.
std::optional<int> count_in(std::string_view text) {
  int value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size() || value < 1) return std::nullopt;
  return value;
}

class SubstructureReader {
 public:
  SubstructureReader(std::string_view text, const std::string& file) : in_(text, file, ",") {
    data_.file = file;
    data_.rows_file = file;
    data_.one_triangle = true;
  }

  MatrixData read();

 private:
  bool next_data();
  void head();
  void nodes();
  void directions();
  void matrix();
  void rest();
  void warn();
  bool is_comment() const { return in_.line().starts_with("**"); }
  bool is_keyword() const { return in_.line().starts_with('*') && !is_comment(); }

  MeshText in_;
  MatrixData data_;
};

// Goes to the next line that is neither empty nor a comment.
bool SubstructureReader::next_data() {
  while (in_.next_line()) {
    if (in_.fields() > 0 && !is_comment()) return true;
  }
  return false;
}

void SubstructureReader::head() {
  if (!next_data() || capitals(in_.field(0)) != "*USER ELEMENT") {
    in_.fail(
        "the file begins neither with %%MatrixMarket nor with *USER ELEMENT; expected a matrix in "
        "the Matrix Market format, or a substructure of CalculiX");
  }
  for (std::size_t field = 1; field < in_.fields(); ++field) {
    const auto text = capitals(in_.field(field));
    constexpr std::string_view key = "NODES=";
    if (!text.starts_with(key)) continue;
    const auto count = trimmed(std::string_view(text).substr(key.size()));
    data_.size = count_in(count).value_or(0);
  }
  data_.size_line = in_.number();
  if (data_.size == 0 || data_.size > max_matrix_rows) {
    in_.fail(fmt::format("*USER ELEMENT has {} rows; expected NODES= from 1 to {}", data_.size,
                         max_matrix_rows));
  }
}

// "** ELEMENT NODES", then lines such as "** 9, 9, 9, 10,": a node for each row.
void SubstructureReader::nodes() {
  bool begun = false;
  while (in_.next_line() && is_comment()) {
    const auto content = trimmed(in_.line().substr(2));
    if (!begun) {
      begun = capitals(content) == "ELEMENT NODES";
      continue;
    }
    for (std::size_t field = 0; field < in_.fields(); ++field) {
      const auto node =
          count_in(field == 0 ? trimmed(content.substr(0, content.find(','))) : in_.field(field));
      if (!node) in_.fail(field, "a comment that is not a list of nodes; expected whole numbers");
      data_.rows.push_back({*node, 0, in_.number()});
    }
  }
  in_.put_back();
  if (std::ssize(data_.rows) != data_.size) {
    in_.fail(fmt::format("the comments after *USER ELEMENT name {} nodes; expected {}, one a row",
                         data_.rows.size(), data_.size));
  }
}

// "1", then "2, 2": the number of the row, and its direction.
void SubstructureReader::directions() {
  for (int row = 1; row <= data_.size; ++row) {
    if (!next_data() || is_keyword()) {
      in_.fail(
          fmt::format("the rows end; expected the direction of row {} of {}", row, data_.size));
    }
    const std::size_t fields = row == 1 ? 1 : 2;
    if (in_.fields() != fields || (row > 1 && in_.whole(0, "the row", 1) != row)) {
      in_.fail(fmt::format("the line is not that of row {}; expected {}its direction", row,
                           row == 1 ? "" : "its number and "));
    }
    data_.rows[static_cast<std::size_t>(row) - 1].direction =
        in_.whole(fields - 1, "a direction", 1);
  }
}

void SubstructureReader::matrix() {
  if (!next_data() || capitals(in_.field(0)) != "*MATRIX" || in_.fields() != 2 ||
      capitals(in_.field(1)) != "TYPE=STIFFNESS") {
    in_.fail("the matrix is missing here; expected *MATRIX, TYPE=STIFFNESS");
  }
  std::size_t field = in_.fields();
  for (int row = 0; row < data_.size; ++row) {
    for (int column = 0; column <= row; ++column) {
      if (field >= in_.fields()) {
        if (!next_data() || is_keyword()) {
          in_.fail(fmt::format("the matrix ends; expected entry ({}, {}) of {} rows", row + 1,
                               column + 1, data_.size));
        }
        field = 0;
      }
      data_.add({row, column, in_.real(field, "an entry"), in_.number()}, in_.field(field));
      ++field;
    }
  }
  if (field < in_.fields()) in_.fail(field, "the matrix continues; expected its end");
}

// The mass matrix may follow.
void SubstructureReader::rest() {
  while (next_data()) {
    if (!is_keyword()) in_.fail("the matrix continues; expected its end");
    if (capitals(in_.field(0)) != "*MATRIX") {
      in_.fail(fmt::format("{} after the stiffness; expected the end of the file, or *MATRIX",
                           support::in_quotes(in_.field(0))));
    }
    data_.warnings.emplace_back(
        support::InputError(in_.file(), {in_.number(), 1},
                            "a matrix after the stiffness is ignored, since wedged configurations "
                            "are static")
            .what());
    while (in_.next_line()) {
      if (!is_keyword()) continue;
      in_.put_back();
      break;
    }
  }
}

// CalculiX writes K_cc, with the other nodes fixed, although its own reactions under *STATIC are
// those of the condensed matrix (tests/meshes/calculix_matrices.py).
void SubstructureReader::warn() {
  data_.warnings.emplace_back(
      support::InputError(in_.file(), {data_.size_line, 1},
                          "CalculiX 2.20 does not condense its substructures: the nodes that are "
                          "not retained are fixed; its .sti and .dof files fix the supports only")
          .what());
}

MatrixData SubstructureReader::read() {
  head();
  warn();
  nodes();
  directions();
  matrix();
  rest();
  return std::move(data_);
}

std::vector<MatrixRow> stored_rows(std::string_view dofs, const std::string& file) {
  std::vector<MatrixRow> rows;
  MeshText in(dofs, file, ".");
  while (in.next_line()) {
    if (in.fields() == 0) continue;
    if (in.fields() != 2) in.fail("the line is not NODE.DIRECTION; expected a row such as 17.3");
    rows.push_back({in.whole(0, "a node", 1), in.whole(1, "a direction", 1), in.number()});
    if (std::ssize(rows) > max_matrix_rows) {
      in.fail(fmt::format("too many rows; expected at most {}", max_matrix_rows));
    }
  }
  if (rows.empty()) in.fail("the file has no rows; expected NODE.DIRECTION on each line");
  return rows;
}

}  // namespace

MatrixData read_substructure(std::string_view text, const std::string& file) {
  return SubstructureReader(text, file).read();
}

MatrixData read_stored_matrix(std::string_view text, const std::string& file, std::string_view dofs,
                              const std::string& dof_file) {
  MatrixData data;
  data.file = file;
  data.rows_file = dof_file;
  data.one_triangle = true;
  data.rows = stored_rows(dofs, dof_file);
  data.size = static_cast<int>(data.rows.size());
  MeshText in(text, file, " ");
  const auto index = [&](std::size_t field, std::string_view called) {
    const int value = in.whole(field, called, 1);
    if (value > data.size) {
      in.fail(field, fmt::format("{} is {}; expected at most {}, the rows in {}", called, value,
                                 data.size, support::in_quotes(dof_file)));
    }
    return value - 1;
  };
  while (in.next_line()) {
    if (in.fields() == 0) continue;
    if (in.fields() != 3) {
      in.fail(fmt::format("the line has {} numbers; expected a row, a column and a value",
                          in.fields()));
    }
    const int row = index(0, "a row");
    const int column = index(1, "a column");
    data.add({row, column, in.real(2, "an entry"), in.number()}, in.field(2));
  }
  return data;
}

}  // namespace kusabi::problems
