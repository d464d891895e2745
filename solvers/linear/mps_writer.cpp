// MPS writer. Every bound and the sense are written explicitly, since the defaults of readers
// differ.
#include "solvers/linear/mps_writer.hpp"

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ostream.h>

namespace kusabi::linear {
namespace {

constexpr std::string_view objective_name = "OBJECTIVE";

bool all_readers_take(std::string_view name) {
  constexpr std::size_t longest = 255;
  const auto shown = [](char c) { return c > ' ' && c <= '~'; };
  return !name.empty() && name.size() <= longest && name.front() != '$' && name.front() != '\'' &&
         std::ranges::all_of(name, shown);
}

// The given names if valid and unique, otherwise numbers.
template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& all, char letter) {
  std::set<std::string_view> taken{objective_name};
  std::vector<std::string> names;
  bool good = true;
  for (const auto& each : all) {
    good = good && all_readers_take(each.name) && taken.insert(each.name).second;
    names.push_back(each.name);
  }
  if (good) return names;
  for (std::size_t k = 0; k < names.size(); ++k) names[k] = fmt::format("{}{}", letter, k + 1);
  return names;
}

class MpsWriter {
 public:
  MpsWriter(std::ostream& out, const MixedProgram& mixed)
      : out_(out),
        program_(mixed.program),
        columns_(names_of(program_.columns, 'c')),
        rows_(names_of(program_.rows, 'r')),
        binary_(program_.columns.size(), false),
        entries_(program_.columns.size()) {
    for (const int column : mixed.binaries) binary_[static_cast<std::size_t>(column)] = true;
    for (const auto& entry : program_.entries) {
      const auto& row = program_.rows[static_cast<std::size_t>(entry.row)];
      if (type(row) != 'N') entries_[static_cast<std::size_t>(entry.column)].push_back(entry);
    }
  }

  void write() {
    write_name();
    write_rows();
    write_columns();
    write_right_sides();
    write_ranges();
    write_bounds();
    out_ << "ENDATA\n";
  }

 private:
  static char type(const LinearRow& row) {
    if (row.lower == row.upper) return 'E';
    if (row.lower > -infinity) return 'G';
    return row.upper < infinity ? 'L' : 'N';
  }

  void write_name() {
    std::string name = program_.name;
    std::ranges::replace_if(
        name, [](char c) { return c <= ' ' || c > '~'; }, '_');
    fmt::print(out_, "NAME {}\n", name);
  }

  void write_rows() {
    fmt::print(out_, "ROWS\n N {}\n", objective_name);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const char kind = type(program_.rows[i]);
      if (kind != 'N') fmt::print(out_, " {} {}\n", kind, rows_[i]);
    }
  }

  void write_columns() {
    out_ << "COLUMNS\n";
    bool among_integers = false;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (binary_[k] != among_integers) write_marker(among_integers = binary_[k]);
      const double cost = program_.columns[k].cost;
      // A column is written if it has an entry, zero or not.
      if (cost != 0 || entries_[k].empty()) {
        fmt::print(out_, " {} {} {}\n", columns_[k], objective_name, cost);
      }
      for (const auto& entry : entries_[k]) {
        fmt::print(out_, " {} {} {}\n", columns_[k], rows_[static_cast<std::size_t>(entry.row)],
                   entry.value);
      }
    }
    if (among_integers) write_marker(false);
  }

  void write_marker(bool begins) {
    fmt::print(out_, " MARKER{} 'MARKER' '{}'\n", ++markers_, begins ? "INTORG" : "INTEND");
  }

  void write_right_sides() {
    out_ << "RHS\n";
    // Minus the constant, by the convention of GLPK, HiGHS and CBC.
    if (program_.constant != 0) {
      fmt::print(out_, " RHS {} {}\n", objective_name, -program_.constant);
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const auto& row = program_.rows[i];
      const char kind = type(row);
      const double side = kind == 'L' ? row.upper : row.lower;
      if (kind != 'N' && side != 0) fmt::print(out_, " RHS {} {}\n", rows_[i], side);
    }
  }

  void write_ranges() {
    bool any = false;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const auto& row = program_.rows[i];
      if (type(row) != 'G' || row.upper == infinity) continue;
      if (!any) out_ << "RANGES\n";
      any = true;
      fmt::print(out_, " RANGE {} {}\n", rows_[i], row.upper - row.lower);
    }
  }

  void write_bounds() {
    out_ << "BOUNDS\n";
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const auto& [cost, lower, upper, name] = program_.columns[k];
      if (lower == upper) {
        fmt::print(out_, " FX BOUND {} {}\n", columns_[k], lower);
      } else if (lower == -infinity && upper == infinity) {
        fmt::print(out_, " FR BOUND {}\n", columns_[k]);
      } else {
        if (lower == -infinity) fmt::print(out_, " MI BOUND {}\n", columns_[k]);
        if (lower > -infinity) fmt::print(out_, " LO BOUND {} {}\n", columns_[k], lower);
        if (upper < infinity) fmt::print(out_, " UP BOUND {} {}\n", columns_[k], upper);
      }
    }
  }

  std::ostream& out_;
  const LinearProgram& program_;
  std::vector<std::string> columns_, rows_;
  std::vector<bool> binary_;
  std::vector<std::vector<LinearEntry>> entries_;  // by column
  int markers_ = 0;
};

}  // namespace

void write_mps(std::ostream& out, const MixedProgram& mixed,
               std::span<const std::string> comments) {
  for (const auto& line : comments) fmt::print(out, "* {}\n", line);
  MpsWriter(out, mixed).write();
}

}  // namespace kusabi::linear
