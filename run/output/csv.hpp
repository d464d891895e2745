// Text in CSV files (RFC 4180).
#pragma once

#include <string>
#include <string_view>

namespace kusabi::run {

/// A text as a cell: in quotes, since names may hold commas and quotes.
inline std::string csv_cell(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace kusabi::run
