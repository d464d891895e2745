// Names of members from those of nodes.
#include "run/limit/loss_options.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include "run/output/wrong_input.hpp"

namespace kusabi::run {
namespace {

using problems::LimitProblem;

// Members that are named, and those at named nodes.
std::vector<int> kept_members(const LimitProblem& problem, const std::string& names) {
  std::vector<bool> kept(static_cast<std::size_t>(problem.member_count()));
  for (std::size_t from = 0; from < names.size();) {
    const auto to = std::min(names.find(' ', from), names.size());
    const auto name = names.substr(from, to - from);
    from = to + 1;
    if (name.empty()) continue;
    bool any = false;
    for (int i = 0; i < problem.member_count(); ++i) {
      const auto& bar = problem.members[static_cast<std::size_t>(i)];
      const auto& first = problem.node_names[static_cast<std::size_t>(bar.first)];
      const auto& second = problem.node_names[static_cast<std::size_t>(bar.second)];
      if (name != first && name != second && name != first + '-' + second &&
          name != second + '-' + first) {
        continue;
      }
      any = true;
      kept[static_cast<std::size_t>(i)] = true;
    }
    if (!any) {
      throw WrongInput(fmt::format(
          "--keep '{}': no such node or member; expected names separated by blanks, a member as "
          "NODE-NODE",
          name));
    }
  }
  std::vector<int> members;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i]) members.push_back(static_cast<int>(i));
  }
  return members;
}

}  // namespace

void LossOptions::describe(OptionTable& table) {
  table.number(
      "--lose", &maximum, between(1, 1000),
      "least load factor after the loss of up to this number of members; with half-widths of "
      "uncertain loads, also over these loads");
  table
      .number("--at-least", &at_least, Range{},
              "decide whether the limit load factor is at least this after every such loss")
      .needs("--lose");
  table
      .text("--keep", kept, "NAMES",
            "members (NODE-NODE) that cannot be lost, and nodes all of whose members cannot; "
            "separated by blanks")
      .needs("--lose");
  table
      .number("--sudden", &sudden, between(1, 100),
              "dynamic factor by which a sudden loss multiplies all loads: 1 for a slow loss or "
              "unlimited ductility, 2 for an elastic structure")
      .needs("--lose");
}

std::optional<limit::LossParameters> LossOptions::parameters(const LimitProblem& problem) const {
  if (maximum == 0) return std::nullopt;
  return limit::LossParameters{maximum, at_least, kept_members(problem, kept), sudden};
}

}  // namespace kusabi::run
