// Choice of the reader by file name. LP files are read by GLPK, whose messages are passed on.
#include "solvers/linear/program_file.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <glpk.h>
#include <zlib.h>

#include "solvers/linear/glpk_call.hpp"
#include "solvers/linear/mps_file.hpp"
#include "solvers/linear/unsupported.hpp"
#include "support/input_error.hpp"

namespace kusabi::linear {
namespace {

using support::InputError;

enum class Format { mps, lp };

Format format_of(const std::filesystem::path& file) {
  auto name = file;
  if (name.extension() == ".gz") name.replace_extension();
  const auto extension = name.extension();
  if (extension == ".mps" || extension == ".MPS") return Format::mps;
  if (extension == ".lp" || extension == ".LP") return Format::lp;
  throw InputError(
      file.string(), {},
      "the name does not say what is in the file; expected one that ends in .mps or .lp");
}

// The line of GLPK's output about the file: "FILE:12: fault".
std::string complaint(const std::string& messages, const std::string& file) {
  const auto at = messages.rfind(file + ":");
  if (at == std::string::npos) return {};
  auto line = messages.substr(at + file.size() + 1);
  line = line.substr(0, line.find('\n'));
  return line;
}

// Throws `FILE:LINE: ...` from "12: missing column name".
[[noreturn]] void refuse(const std::string& file, const std::string& messages) {
  const auto line = complaint(messages, file);
  const auto colon = line.find(':');
  if (colon == std::string::npos || colon == 0 || line.find_first_not_of("0123456789") != colon) {
    throw InputError(file, {}, "the file cannot be read as a linear program");
  }
  auto what = std::string_view(line).substr(colon + 1);
  while (what.starts_with(' ')) what.remove_prefix(1);
  throw InputError(fmt::format("{}:{}", file, line.substr(0, colon)), {},
                   fmt::format("{}; expected a program in CPLEX LP format", what));
}

void load(glp_prob* lp, const std::string& file) {
  int failed = 1;
  const auto messages = glpk_messages_of([&] { failed = glp_read_lp(lp, nullptr, file.c_str()); });
  if (failed != 0) refuse(file, messages);
}

// Bytes of a file, decompressed if compressed.
std::string unpacked(const std::string& file) {
  constexpr std::size_t maximum = std::size_t{1} << 32U;
  const auto close = [](gzFile open) { gzclose(open); };
  const std::unique_ptr<gzFile_s, decltype(close)> stream(gzopen(file.c_str(), "rb"), close);
  std::string text;
  std::array<char, std::size_t{1} << 16U> piece{};
  for (;;) {
    const int count =
        stream ? gzread(stream.get(), piece.data(), static_cast<unsigned>(piece.size())) : -1;
    int error = Z_OK;
    if (count < 0 || (count == 0 && (gzerror(stream.get(), &error), error != Z_OK))) {
      throw InputError(file, {}, "the file cannot be unpacked; expected a complete gzip file");
    }
    if (count == 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(count));
    if (text.size() > maximum) {
      throw InputError(file, {}, "the file is larger than 4 GiB; expected a smaller program");
    }
  }
}

struct ReadBounds {
  double lower;
  double upper;
};

// Numbers infinite in an MPS file are infinite in an LP file.
ReadBounds bounds(int type, double lower, double upper) {
  const bool below = type == GLP_LO || type == GLP_DB || type == GLP_FX;
  const bool above = type == GLP_UP || type == GLP_DB || type == GLP_FX;
  if (type == GLP_FX) upper = lower;
  return {below && lower > -infinite_in_files ? lower : -infinity,
          above && upper < infinite_in_files ? upper : infinity};
}

void check(const ReadBounds& bounds, const std::string& file, const char* what,
           const std::string& name) {
  if (bounds.lower <= bounds.upper && bounds.lower < infinite_in_files &&
      bounds.upper > -infinite_in_files) {
    return;
  }
  throw InputError(file, {},
                   fmt::format("{} {} has a lower bound of {} and an upper bound of {}; expected "
                               "bounds with a number between them",
                               what, support::in_quotes(name), bounds.lower, bounds.upper));
}

double finite(double value, const std::string& file, const char* what, const std::string& name) {
  if (std::isfinite(value)) return value;
  throw InputError(file, {},
                   fmt::format("{} {} has a coefficient of {}; expected a finite number", what,
                               support::in_quotes(name), value));
}

std::string text(const char* name) {
  return name == nullptr ? std::string() : std::string(name);
}

void add_columns(glp_prob* lp, const std::string& file, double sign, MixedProgram& mixed) {
  for (int j = 1; j <= glp_get_num_cols(lp); ++j) {
    auto [lower, upper] =
        bounds(glp_get_col_type(lp, j), glp_get_col_lb(lp, j), glp_get_col_ub(lp, j));
    auto name = text(glp_get_col_name(lp, j));
    if (name.empty()) name = fmt::format("x{}", j);
    check({lower, upper}, file, "column", name);
    const bool whole = glp_get_col_kind(lp, j) != GLP_CV;
    const bool fixed = lower == upper && std::floor(lower) == lower;
    const bool zero_one = lower >= 0 && upper <= 1;
    if (whole && !zero_one && !fixed) {
      throw InputError(file, {},
                       fmt::format("column {} is a general integer, {} to {}; expected integer "
                                   "columns between 0 and 1 only",
                                   support::in_quotes(name), lower, upper));
    }
    const int column = mixed.program.add_column(
        {sign * finite(glp_get_obj_coef(lp, j), file, "column", name), lower, upper, name});
    if (whole && zero_one) mixed.binaries.push_back(column);
  }
}

void add_rows(glp_prob* lp, const std::string& file, MixedProgram& mixed) {
  std::vector<int> at(static_cast<std::size_t>(glp_get_num_cols(lp)) + 1);
  std::vector<double> values(at.size());
  for (int i = 1; i <= glp_get_num_rows(lp); ++i) {
    if (glp_get_row_type(lp, i) == GLP_FR) continue;
    const auto [lower, upper] =
        bounds(glp_get_row_type(lp, i), glp_get_row_lb(lp, i), glp_get_row_ub(lp, i));
    const auto name = text(glp_get_row_name(lp, i));
    if (lower == -infinity && upper == infinity) continue;
    check({lower, upper}, file, "row", name);
    const int count = glp_get_mat_row(lp, i, at.data(), values.data());
    std::vector<LinearTerm> terms;
    for (int k = count; k >= 1; --k) {  // GLPK lists the last entry first
      const auto place = static_cast<std::size_t>(k);
      terms.push_back({at[place] - 1, finite(values[place], file, "row", name)});
    }
    mixed.program.add_row({lower, upper, name}, terms);
  }
}

}  // namespace

ProgramFile read_program(const std::filesystem::path& file) {
  const auto name = file.string();
  std::error_code failure;
  if (std::filesystem::is_directory(file, failure) || !std::ifstream(file)) {
    throw InputError(
        name, {}, "the file cannot be read; expected a linear program in MPS or CPLEX LP format");
  }
  if (format_of(file) == Format::mps) return parse_mps(unpacked(name), name);
  refuse_unsupported_lp(unpacked(name), name);
  const GlpkProblem loaded;
  load(loaded.get(), name);
  auto* const lp = loaded.get();
  ProgramFile result;
  result.maximise = glp_get_obj_dir(lp) == GLP_MAX;
  const double sign = result.maximise ? -1 : 1;
  result.mixed.program.name = text(glp_get_prob_name(lp));
  result.mixed.program.constant = sign * glp_get_obj_coef(lp, 0);
  add_columns(lp, name, sign, result.mixed);
  add_rows(lp, name, result.mixed);
  return result;
}

}  // namespace kusabi::linear
