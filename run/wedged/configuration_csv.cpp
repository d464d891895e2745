// Columns by components, so that components of one kind are adjacent.
#include "run/wedged/configuration_csv.hpp"

#include <cstddef>

#include <fmt/format.h>

#include "run/wedged/problem_summary.hpp"

namespace kusabi::run {
namespace {

const char* component_name(int dimension, int axis) {
  if (axis == 0) return "n";
  if (dimension == 2) return "t";
  return axis == 1 ? "t1" : "t2";
}

}  // namespace

void add_pattern_columns(CsvWriter& csv) {
  csv.word("block").word("contact").word("separated").word("inactive");
}

void add_pattern(CsvWriter& csv, const problems::WedgedProblem& problem, std::uint32_t block,
                 const wedged::SignPattern& pattern, const support::IndexSet& inactive) {
  csv.count(std::uint64_t{block} + 1);
  csv.names(candidate_names(problem, pattern.contact));
  csv.names(candidate_names(problem, pattern.separated));
  csv.names(candidate_names(problem, pattern.inactive | inactive));
}

void add_configuration_columns(CsvWriter& csv, const problems::WedgedProblem& problem) {
  for (const char* const what : {"r", "u"}) {
    for (int axis = 0; axis < problem.dimension; ++axis) {
      for (const auto& name : problem.contact_names)
        csv.text(fmt::format("{}_{} {}", what, component_name(problem.dimension, axis), name));
    }
  }
}

void add_configuration(CsvWriter& csv, const problems::WedgedProblem& problem,
                       std::span<const double> reactions, std::span<const double> displacements) {
  const auto d = static_cast<std::size_t>(problem.dimension);
  const std::size_t size = d * problem.contact_names.size();
  for (const auto& vector : {reactions, displacements}) {
    for (std::size_t axis = 0; axis < d; ++axis) {
      for (std::size_t at = axis; at < size; at += d) {
        if (vector.empty()) {
          csv.nothing();
        } else {
          csv.number(vector[at]);
        }
      }
    }
  }
}

}  // namespace kusabi::run
