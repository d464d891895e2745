// Half-widths of groups first, then alpha for the others.
#include "problems/limit/half_widths.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "support/input_error.hpp"
#include "support/nearest.hpp"

namespace kusabi::problems {
namespace {

bool is_called(const UncertainColumn& column, const std::string& name) {
  return column.name == name || column.group == name;
}

/// A column and its problem, and whether its half-width is known.
struct Settled {
  const LimitProblem* problem;
  int number;
  UncertainColumn* column;
  bool known;

  [[nodiscard]] std::string name() const {
    return support::in_quotes(parameter_name(*problem, number));
  }
};

// Suggestion for an unknown name of a load or group.
std::string names_instead(const std::vector<Settled>& columns, const std::string& name) {
  std::vector<std::string_view> names;
  for (const auto& each : columns) {
    for (const std::string* known : {&each.column->name, &each.column->group}) {
      if (!known->empty()) names.emplace_back(*known);
    }
  }
  return support::did_you_mean(name, names);
}

void settle_group(std::vector<Settled>& columns, const std::string& name, double half_width) {
  bool any = false;
  for (auto& each : columns) {
    if (!is_called(*each.column, name)) continue;
    any = true;
    if (each.column->in_file) {
      throw HalfWidthError(
          fmt::format("the file says alpha = {} of {}; expected a group that it "
                      "leaves open",
                      each.column->half_width, support::in_quotes(name)));
    }
    if (each.known) {
      throw HalfWidthError(fmt::format(
          "{} is given twice, as by its name and by its group; expected once", each.name()));
    }
    each.column->half_width = half_width;
    each.known = true;
  }
  if (any) return;
  throw HalfWidthError(
      fmt::format("no uncertain load has the name or the group {}; expected one "
                  "of [[uncertainty]]{}",
                  support::in_quotes(name), names_instead(columns, name)));
}

std::vector<Settled> columns_of(std::span<LimitProblem* const> cases) {
  std::vector<Settled> columns;
  for (auto* const problem : cases) {
    for (int j = 0; j < problem->uncertain_count(); ++j) {
      auto& column = problem->uncertain[static_cast<std::size_t>(j)];
      columns.push_back({problem, j, &column, column.in_file});
    }
  }
  return columns;
}

}  // namespace

GroupHalfWidths of_cases(GroupHalfWidths groups, std::span<LimitProblem* const> cases,
                         const Structure& whole) {
  if (!whole.uncertain) return groups;
  const auto columns = columns_of(cases);
  std::erase_if(groups, [&](const auto& asked) {
    const auto& name = asked.first;
    const auto has_it = [&](const Settled& each) { return is_called(*each.column, name); };
    const auto is_it = [&](const UncertainParameter& each) {
      return each.name == name || each.group == name;
    };
    return std::ranges::none_of(columns, has_it) && std::ranges::any_of(*whole.uncertain, is_it);
  });
  return groups;
}

void fix_half_widths(LimitProblem& problem,
                     std::span<const std::pair<std::string, double>> groups) {
  LimitProblem* const one = &problem;
  auto columns = columns_of({&one, 1});
  for (const auto& [name, half_width] : groups) settle_group(columns, name, half_width);
  for (auto& each : columns) each.column->in_file = each.known;
}

std::optional<double> set_half_widths(std::span<LimitProblem* const> cases,
                                      const RequestedHalfWidths& asked) {
  auto columns = columns_of(cases);
  for (const auto& [name, half_width] : asked.groups) settle_group(columns, name, half_width);
  const auto open = std::ranges::find(columns, false, &Settled::known);
  if (std::ranges::find(columns, true, &Settled::known) == columns.end()) return asked.alpha;
  if (open == columns.end()) {
    if (!asked.alpha) return 1;
    throw HalfWidthError("every uncertain load has a half-width of its own; expected no --alpha");
  }
  if (!asked.alpha) {
    throw HalfWidthError(
        fmt::format("other uncertain loads have half-widths of their own, but {} has none; "
                    "expected --alpha as well",
                    open->name()));
  }
  for (auto& each : columns) {
    if (!each.known) each.column->half_width = *asked.alpha;
  }
  return 1;
}

std::optional<double> common_half_width(const LimitProblem& problem, double alpha) {
  if (problem.uncertain.empty()) return 0;
  const auto [minimum, maximum] =
      std::ranges::minmax(problem.uncertain, {}, &UncertainColumn::half_width);
  if (minimum.half_width != maximum.half_width) return {};
  return alpha * minimum.half_width;
}

}  // namespace kusabi::problems
