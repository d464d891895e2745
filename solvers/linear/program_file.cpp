// GLPK reads; what it prints is the message, and what it has read becomes plain data.
#include "solvers/linear/program_file.hpp"

#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <glpk.h>

#include "solvers/linear/glpk_call.hpp"
#include "support/input_error.hpp"

namespace kusabi::nodes::linear {
namespace {

using problems::infinity;
using problems::InputError;

// A problem of GLPK's, for as long as its environment lasts.
class Loaded {
 public:
  Loaded() {
    glpk_call([this] { lp_ = glp_create_prob(); });
    environment_ = glpk_environment();
  }
  Loaded(const Loaded&) = delete;
  Loaded& operator=(const Loaded&) = delete;
  ~Loaded() {
    if (environment_ == glpk_environment()) glp_delete_prob(lp_);
  }
  [[nodiscard]] glp_prob* get() const { return lp_; }

 private:
  glp_prob* lp_ = nullptr;
  unsigned environment_ = 0;
};

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

// The line of GLPK's that is about the file: "FILE:12: what".
std::string complaint(const std::string& messages, const std::string& file) {
  const auto at = messages.rfind(file + ":");
  if (at == std::string::npos) return {};
  auto line = messages.substr(at + file.size() + 1);
  line = line.substr(0, line.find('\n'));
  return line;
}

// Throws `FILE:LINE: ...` of "12: missing column name".
[[noreturn]] void refuse(const std::string& file, const std::string& messages) {
  const auto line = complaint(messages, file);
  const auto colon = line.find(':');
  if (colon == std::string::npos || colon == 0 || line.find_first_not_of("0123456789") != colon) {
    throw InputError(file, {}, "the file cannot be read as a linear program");
  }
  auto what = std::string_view(line).substr(colon + 1);
  while (what.starts_with(' ')) what.remove_prefix(1);
  throw InputError(fmt::format("{}:{}", file, line.substr(0, colon)), {},
                   fmt::format("{}; expected {}", what,
                               format_of(file) == Format::mps ? "a program in MPS format"
                                                              : "a program in CPLEX LP format"));
}

void load(glp_prob* lp, const std::string& file) {
  int failed = 1;
  std::string messages;
  if (format_of(file) == Format::lp) {
    messages = glpk_messages_of([&] { failed = glp_read_lp(lp, nullptr, file.c_str()); });
  } else {
    // Free MPS is what nearly all fixed MPS is as well; but names may have spaces in fixed MPS.
    messages =
        glpk_messages_of([&] { failed = glp_read_mps(lp, GLP_MPS_FILE, nullptr, file.c_str()); });
    if (failed != 0) {
      glpk_call([&] { failed = glp_read_mps(lp, GLP_MPS_DECK, nullptr, file.c_str()); });
    }
  }
  if (failed != 0) refuse(file, messages);
}

struct Bounds {
  double lower;
  double upper;
};

Bounds bounds(int type, double lower, double upper) {
  switch (type) {
    case GLP_FR:
      return {-infinity, infinity};
    case GLP_LO:
      return {lower, infinity};
    case GLP_UP:
      return {-infinity, upper};
    case GLP_FX:
      return {lower, lower};
    default:
      return {lower, upper};
  }
}

std::string text(const char* name) {
  return name == nullptr ? std::string() : std::string(name);
}

void add_columns(glp_prob* lp, const std::string& file, double sign,
                 problems::MixedProgram& mixed) {
  for (int j = 1; j <= glp_get_num_cols(lp); ++j) {
    auto [lower, upper] =
        bounds(glp_get_col_type(lp, j), glp_get_col_lb(lp, j), glp_get_col_ub(lp, j));
    auto name = text(glp_get_col_name(lp, j));
    if (name.empty()) name = fmt::format("x{}", j);
    const bool whole = glp_get_col_kind(lp, j) != GLP_CV;
    const bool fixed = lower == upper && std::floor(lower) == lower;
    const bool zero_one = lower >= 0 && upper <= 1;
    if (whole && !zero_one && !fixed) {
      throw InputError(file, {},
                       fmt::format("column {} is a general integer, {} to {}; expected integer "
                                   "columns between 0 and 1 only",
                                   problems::in_quotes(name), lower, upper));
    }
    const int column =
        mixed.program.add_column({sign * glp_get_obj_coef(lp, j), lower, upper, std::move(name)});
    if (whole && zero_one) mixed.binaries.push_back(column);
  }
}

void add_rows(glp_prob* lp, problems::MixedProgram& mixed) {
  std::vector<int> at(static_cast<std::size_t>(glp_get_num_cols(lp)) + 1);
  std::vector<double> values(at.size());
  for (int i = 1; i <= glp_get_num_rows(lp); ++i) {
    if (glp_get_row_type(lp, i) == GLP_FR) continue;
    const auto [lower, upper] =
        bounds(glp_get_row_type(lp, i), glp_get_row_lb(lp, i), glp_get_row_ub(lp, i));
    const int count = glp_get_mat_row(lp, i, at.data(), values.data());
    std::vector<problems::LinearTerm> terms;
    for (int k = count; k >= 1; --k) {  // GLPK puts the last entry first
      const auto place = static_cast<std::size_t>(k);
      terms.push_back({at[place] - 1, values[place]});
    }
    mixed.program.add_row({lower, upper, text(glp_get_row_name(lp, i))}, terms);
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
  const Loaded loaded;
  load(loaded.get(), name);
  auto* const lp = loaded.get();
  ProgramFile result;
  result.maximise = glp_get_obj_dir(lp) == GLP_MAX;
  const double sign = result.maximise ? -1 : 1;
  result.mixed.program.name = text(glp_get_prob_name(lp));
  result.mixed.program.constant = sign * glp_get_obj_coef(lp, 0);
  add_columns(lp, name, sign, result.mixed);
  add_rows(lp, result.mixed);
  return result;
}

}  // namespace kusabi::nodes::linear
