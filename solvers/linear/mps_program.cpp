// The program of an MPS file: bounds and types of columns, ranges of rows, sign of the objective.
#include "solvers/linear/mps_program.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "solvers/linear/mps_file.hpp"
#include "support/input_error.hpp"

namespace kusabi::linear {
namespace {

using support::in_quotes;

// The first row of type N, or that of section OBJNAME.
std::size_t objective_of(const MpsContent& content, const std::string& file,
                         std::size_t last_line) {
  for (std::size_t i = 0; i < content.rows.size(); ++i) {
    if (content.rows[i].type != 'N') continue;
    if (!content.objective_name || content.rows[i].name == *content.objective_name) return i;
  }
  if (content.objective_name) {
    refuse_line(file, last_line,
                fmt::format("OBJNAME names {}, which is not a row of type N",
                            in_quotes(*content.objective_name)),
                "one of ROWS");
  }
  refuse_line(file, last_line, "no row of type N, the objective", "one in ROWS");
}

bool is_binary(const MpsColumn& column, const std::string& file) {
  if (!column.is_integer) return false;
  if (column.lower >= 0 && column.upper <= 1) return true;
  if (column.lower == column.upper && std::floor(column.lower) == column.lower) return false;
  refuse_line(file, column.line,
              fmt::format("column {} is a general integer, {} to {}", in_quotes(column.name),
                          column.lower, column.upper),
              "integer columns between 0 and 1 only");
}

// Lower and upper bound of a row.
std::pair<double, double> range_of(const MpsRow& row) {
  const auto at = [](double value) {
    if (std::abs(value) < infinite_in_files) return value;
    return value > 0 ? infinity : -infinity;
  };
  const double right = at(row.right.value_or(0));
  if (!std::isfinite(right)) return {-infinity, infinity};
  const double range = at(row.range.value_or(row.type == 'E' ? 0 : infinity));
  switch (row.type) {
    case 'L':
      return {right - std::abs(range), right};
    case 'G':
      return {right, right + std::abs(range)};
    case 'E':
      return {range < 0 ? right + range : right, range > 0 ? right + range : right};
    default:
      return {-infinity, infinity};
  }
}

}  // namespace

void refuse_line(const std::string& file, std::size_t line, std::string_view fault,
                 std::string_view expected) {
  throw support::InputError(fmt::format("{}:{}", file, line), {},
                            fmt::format("{}; expected {}", fault, expected));
}

ProgramFile program_of(MpsContent content, const std::string& file, std::size_t last_line) {
  ProgramFile result;
  result.maximise = content.maximise;
  result.warnings = std::move(content.warnings);
  const double sign = content.maximise ? -1 : 1;
  auto& [program, binaries] = result.mixed;
  program.name = content.name;
  const auto objective_row = objective_of(content, file, last_line);
  for (const auto& column : content.columns) {
    if (column.lower > column.upper) {
      refuse_line(file, column.line,
                  fmt::format("column {} has a lower bound of {} and an upper bound of {}",
                              in_quotes(column.name), column.lower, column.upper),
                  "a lower bound that is not above the upper one");
    }
    if (column.is_integer && !column.lower_given && !column.upper_given) {
      refuse_line(file, column.line,
                  fmt::format("integer column {} has no bounds, which some readers take for 0 to 1 "
                              "and others for none",
                              in_quotes(column.name)),
                  "bounds in BOUNDS");
    }
    const int at = program.add_column({0, column.lower, column.upper, column.name});
    if (is_binary(column, file)) binaries.push_back(at);
  }
  for (const auto& [column, value] : content.rows[objective_row].terms) {
    if (value == 0) continue;
    program.columns[static_cast<std::size_t>(column)].cost = sign * value;
  }
  // Sign convention of HiGHS and CBC, with which the objective of Netlib's e226 has its published
  // value.
  program.constant = -sign * content.rows[objective_row].right.value_or(0);
  if (program.constant == 0) program.constant = 0;  // avoids -0
  for (const auto& row : content.rows) {
    const auto [lower, upper] = range_of(row);
    if (lower == -infinity && upper == infinity) continue;
    program.add_row({lower, upper, row.name}, row.terms);
  }
  return result;
}

}  // namespace kusabi::linear
