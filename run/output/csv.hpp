// Tables as CSV files (RFC 4180, with line feeds as line ends): header first, numbers that read
// back to the same bits, empty cells for absent values, no text that spreadsheets take for a
// formula.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace kusabi::run {

/// A text as a cell, in quotes. Spreadsheets compute a text that begins with = + - @ even in
/// quotes; an apostrophe before it prevents that.
inline std::string csv_cell(std::string_view text) {
  std::string quoted = "\"";
  if (!text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos)
    quoted += '\'';
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

/// Writer of a table, cell by cell and row by row.
class CsvWriter {
 public:
  explicit CsvWriter(std::ostream& out) : out_(out) {}

  /// An identifier of the program: a column, a state.
  CsvWriter& word(std::string_view word) { return add(word); }
  /// Any text.
  CsvWriter& text(std::string_view text) { return add(csv_cell(text)); }
  /// Names, separated by blanks.
  template <class Names>
  CsvWriter& names(const Names& names) {
    return text(fmt::format("{}", fmt::join(names, " ")));
  }
  CsvWriter& count(std::uint64_t count) { return add(fmt::format("{}", count)); }
  CsvWriter& number(double number) {
    return std::isfinite(number) ? add(fmt::format("{}", number)) : nothing();
  }
  CsvWriter& number(std::optional<double> value) { return value ? number(*value) : nothing(); }
  CsvWriter& nothing() { return add({}); }

  void end_row() {
    out_ << '\n';
    begins_ = true;
  }

 private:
  CsvWriter& add(std::string_view cell) {
    if (!begins_) out_ << ',';
    begins_ = false;
    out_ << cell;
    return *this;
  }

  std::ostream& out_;
  bool begins_ = true;  // the next cell begins a row
};

}  // namespace kusabi::run
