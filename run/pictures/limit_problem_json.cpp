// The key `problem` of limit analysis.
#include "run/pictures/limit_problem_json.hpp"

#include <utility>

#include "problems/limit/limit_problem.hpp"
#include "run/output/values.hpp"
#include "run/pictures/structure_json.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;
using problems::LimitProblem;

// T by columns: nodal forces of each uncertain load for a zeta of one unit of force.
ordered_json uncertain_loads_json(const LimitProblem& problem) {
  auto list = ordered_json::array();
  for (int j = 0; j < problem.uncertain_count(); ++j) {
    const auto& column = problem.uncertain[static_cast<std::size_t>(j)];
    auto components = ordered_json::array();
    for (const auto& [degree, value] : column.direction) {
      const auto& [node, axis] = problem.degrees.free[static_cast<std::size_t>(degree)];
      components.push_back({{"node", problem.node_names[static_cast<std::size_t>(node)]},
                            {"axis", problems::axis_name(axis)},
                            {"weight", column.weight * value}});
    }
    ordered_json load{{"name", problems::parameter_name(problem, j)},
                      {"components", std::move(components)}};
    if (column.in_file) load["half_width"] = column.half_width;
    list.push_back(std::move(load));
  }
  return list;
}

}  // namespace

ordered_json limit_problem_json(const LimitProblem& problem, const problems::Structure& truss,
                                const std::string& file) {
  return {{"file", file},
          {"name", problem.name},
          {"d", problem.dimension},
          {"m", problem.uncertain_count()},
          {"nodes", problem.node_names.size()},
          {"members", problem.member_count()},
          {"units", {{"length", problem.units.length}, {"force", problem.units.force}}},
          {"fingerprint", hexadecimal(problem.fingerprint)},
          {"uncertain_loads", uncertain_loads_json(problem)},
          {"structure", structure_json(truss)}};
}

}  // namespace kusabi::run
