// The answer for a person and for a program.
#include "run/limit/limit_report.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "problems/limit/collapse_mode.hpp"
#include "run/limit/curve_report.hpp"
#include "run/limit/zero_one_report.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/values.hpp"

namespace kusabi::run {
namespace {

using limit::RootStatus;
using nlohmann::ordered_json;
using problems::LimitProblem;

const std::string& node_name(const LimitProblem& problem, int node) {
  return problem.node_names[static_cast<std::size_t>(node)];
}

// What zeta is, parameter by parameter.
ordered_json parameters_json(const LimitProblem& problem, const Eigen::VectorXd& zeta) {
  auto list = ordered_json::array();
  for (int j = 0; j < problem.uncertain_count(); ++j) {
    list.push_back({{"name", problems::parameter_name(problem, j)}, {"value", zeta(j)}});
  }
  return list;
}

// A load node by node, where it is not zero.
ordered_json load_json(const LimitProblem& problem, const Eigen::VectorXd& load) {
  auto list = ordered_json::array();
  for (int node = 0; node < static_cast<int>(problem.node_names.size()); ++node) {
    std::vector<double> force;
    for (int axis = 0; axis < problem.dimension; ++axis) {
      const int degree = problem.degrees.number(axis, node);
      force.push_back(degree < 0 ? 0 : load(degree));
    }
    if (std::ranges::any_of(force, [](double each) { return each != 0; })) {
      list.push_back({{"node", node_name(problem, node)}, {"force", force}});
    }
  }
  return list;
}

// All null if no critical load is known.
void add_critical_load(ordered_json& result, const LimitProblem& problem,
                       const Eigen::VectorXd& zeta) {
  const bool known = zeta.size() == problem.uncertain_count();
  const Eigen::VectorXd load = known ? problems::dead_load(problem, zeta) : problem.dead;
  result["critical_load"] = known ? load_json(problem, load) : ordered_json();
  result["critical_part"] = known ? load_json(problem, load - problem.dead) : ordered_json();
  result["critical_parameters"] = known ? parameters_json(problem, zeta) : ordered_json();
}

ordered_json mode_json(const LimitProblem& problem, const limit::LimitCollapse& collapse) {
  const auto mode = problems::collapse_mode(problem, collapse.motion);
  auto moving = ordered_json::array();
  for (const auto& [node, velocity] : mode.moving) {
    moving.push_back({{"node", node_name(problem, node)}, {"velocity", numbers(velocity)}});
  }
  auto yielding = ordered_json::array();
  for (const auto& [member, elongation] : mode.yielding) {
    const auto& bar = problem.members[static_cast<std::size_t>(member)];
    yielding.push_back({{"member", {node_name(problem, bar.first), node_name(problem, bar.second)}},
                        {"in", elongation > 0 ? "tension" : "compression"},
                        {"elongation", elongation}});
  }
  return {{"sway", mode.sway}, {"moving", moving}, {"yielding", yielding}};
}

const char* status_text(RootStatus status) {
  switch (status) {
    case RootStatus::closed:
      return "solved";
    case RootStatus::not_carried:
      return "not-carried";
    default:
      break;
  }
  return "open";
}

const char* method_name(limit::LimitMethod method) {
  switch (method) {
    case limit::LimitMethod::fixed:
      return "none";
    case limit::LimitMethod::disjunctive:
      return "disjunctive";
    case limit::LimitMethod::tightened:
      return "tighten";
    case limit::LimitMethod::all:
      return "all";
    case limit::LimitMethod::static_cuts:
      break;
  }
  return "static";
}

// The factors at which the load is carried.
ordered_json interval_json(const limit::LimitCollapse& collapse) {
  return {number_or_null(collapse.least), collapse.factor};
}

void write_mode(std::string& text, const LimitProblem& problem,
                const limit::LimitCollapse& collapse) {
  const auto mode = problems::collapse_mode(problem, collapse.motion);
  std::vector<std::string> tension;
  std::vector<std::string> compression;
  for (const auto& [member, elongation] : mode.yielding) {
    (elongation > 0 ? tension : compression).push_back(problems::member_name(problem, member));
  }
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "  collapse mode: {}, {} nodes move, {} members yield\n",
                 mode.sway ? "sway" : "not sway", mode.moving.size(), mode.yielding.size());
  if (!tension.empty()) fmt::format_to(out, "    in tension:     {}\n", fmt::join(tension, " "));
  if (!compression.empty()) {
    fmt::format_to(out, "    in compression: {}\n", fmt::join(compression, " "));
  }
}

void write_critical_load(std::string& text, const LimitProblem& problem,
                         const Eigen::VectorXd& zeta) {
  const auto out = std::back_inserter(text);
  text += "  critical part of the dead load:\n";
  for (int axis = 0; axis < problem.dimension; ++axis) {
    for (const bool positive : {true, false}) {
      std::vector<std::string> names;
      for (int j = 0; j < problem.uncertain_count(); ++j) {
        const auto& column = problem.uncertain[static_cast<std::size_t>(j)];
        if (!column.name.empty()) continue;
        const auto degree = static_cast<std::size_t>(column.direction.front().degree);
        const auto& free = problem.degrees.free[degree];
        if (free.axis == axis && (zeta(j) >= 0) == positive) {
          names.push_back(node_name(problem, free.node));
        }
      }
      if (names.empty()) continue;
      fmt::format_to(out, "    {}{} at {}\n", positive ? '+' : '-', problems::axis_name(axis),
                     fmt::join(names, " "));
    }
  }
  for (int j = 0; j < problem.uncertain_count(); ++j) {
    const auto& name = problem.uncertain[static_cast<std::size_t>(j)].name;
    if (name.empty()) continue;
    fmt::format_to(out, "    {}{}\n", zeta(j) >= 0 ? '+' : '-', name);
  }
}

// What holds at the load factor zero, where it is not what one expects.
void write_zero(std::string& text, const char* load, const limit::LimitCollapse& collapse) {
  if (collapse.factor < 0) {
    fmt::format_to(std::back_inserter(text), "  negative: {} alone collapses the structure\n",
                   load);
  } else if (collapse.least && *collapse.least > 0) {
    fmt::format_to(std::back_inserter(text),
                   "  {} alone is not carried: factors from {:.10g} to {:.10g} are\n", load,
                   *collapse.least, collapse.factor);
  }
}

const char* without_proof(bool proved) {
  return proved ? "" : " (as the simplex method finds it: not proved)";
}

void write_ends(std::string& text, const limit::LimitWorstCase& worst) {
  const auto out = std::back_inserter(text);
  if (worst.as_printed) {
    text += printed_ends_text(worst);
    return;
  }
  if (worst.proved) {
    fmt::format_to(out, "  load factor {:.10g} ... {:.10g}, proved\n", worst.ends.lower,
                   worst.ends.upper);
    return;
  }
  if (std::isfinite(worst.ends.lower)) {
    fmt::format_to(out, "  load factor at least {:.10g}{}\n", worst.ends.lower,
                   without_proof(worst.ends.lower_proved));
  } else {
    text += "  no lower bound of the load factor was found\n";
  }
  fmt::format_to(out, "  and at most {:.10g}{}\n", worst.ends.upper,
                 without_proof(worst.ends.upper_proved));
  if (worst.search == engine::Status::solved) {
    text += "  open: these two ends are not shown to be one\n";
  }
}

void write_worst(std::string& text, const LimitOptions& options, const LimitProblem& problem,
                 const limit::LimitWorstCase& worst) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "\nworst case of {} uncertain loads, alpha = {} {}\n",
                 problem.uncertain_count(), *options.question.alpha, problem.units.force);
  if (worst.status == RootStatus::not_carried) {
    fmt::format_to(out,
                   "  some admissible dead load is carried at no load factor, of either sign{}\n",
                   worst.proved ? ", proved" : without_proof(false));
    write_critical_load(text, problem, worst.zeta);
  } else {
    write_ends(text, worst);
    if (worst.collapse) {
      write_zero(text, worst.collapse->factor < 0 ? "an admissible dead load" : "this dead load",
                 *worst.collapse);
      write_mode(text, problem, *worst.collapse);
    }
    if (worst.zeta.size() > 0) write_critical_load(text, problem, worst.zeta);
  }
  if (worst.zero_one) text += zero_one_text(worst);
  if (worst.search != engine::Status::solved) {
    fmt::format_to(out, "  stopped early ({})\n", status_name(worst.search));
  }
  if (worst.as_printed) return;
  fmt::format_to(out,
                 "  static evidence: {} cuts, {} node{}; linear programs: {} load factors, {} "
                 "relaxations, {} for "
                 "cuts, {} in the tree\n",
                 worst.cuts, worst.nodes, worst.nodes == 1 ? "" : "s", worst.counts.load_factors,
                 worst.counts.relaxations, worst.counts.pricings, worst.tree_programs);
}

// Why there is no nominal factor.
std::string no_nominal(const limit::LimitAnswer& answer) {
  if (answer.status == limit::LoadStatus::not_carried) {
    return fmt::format("the nominal dead load is carried at no load factor, of either sign{}\n",
                       answer.no_factor_proved ? ", proved" : without_proof(false));
  }
  if (answer.rest != engine::Status::solved) {
    return fmt::format("stopped early ({}), before the nominal load factor was found\n",
                       status_name(answer.rest));
  }
  return "open: the simplex method failed on the nominal load factor\n";
}

}  // namespace

std::string LimitReport::table() const {
  if (!answer.nominal) return no_nominal(answer);
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "nominal load factor {:.10g}\n", answer.nominal->factor);
  write_zero(text, "the dead load", *answer.nominal);
  write_mode(text, problem, *answer.nominal);
  if (answer.worst) write_worst(text, options, problem, *answer.worst);
  if (!answer.samples.empty()) {
    const auto [least, greatest] = std::ranges::minmax(answer.samples);
    double sum = 0;
    for (const double factor : answer.samples) sum += factor;
    fmt::format_to(out, "\n{} random dead loads: load factors {:.6g} ... {:.6g}, mean {:.6g}\n",
                   answer.samples.size(), least, greatest,
                   sum / static_cast<double>(answer.samples.size()));
  }
  text += CurveReport{options, problem, answer}.table();
  if (answer.rest != engine::Status::solved) {
    fmt::format_to(out, "stopped early ({}): not all that was asked for is here\n",
                   status_name(answer.rest));
  }
  return text;
}

ordered_json LimitReport::json() const {
  ordered_json result;
  std::string status = answer.nominal ? "solved" : "open";
  if (answer.status == limit::LoadStatus::not_carried && answer.no_factor_proved) {
    status = "not-carried";
  }
  if (answer.rest != engine::Status::solved) status = status_name(answer.rest);
  result["nominal"] = answer.nominal ? ordered_json(answer.nominal->factor) : ordered_json();
  if (answer.nominal) {
    result["nominal_interval"] = interval_json(*answer.nominal);
    result["nominal_mode"] = mode_json(problem, *answer.nominal);
    result["nominal_forces"] = numbers(answer.nominal->forces);
  }
  if (answer.worst) {
    const auto& worst = *answer.worst;
    if (worst.search != engine::Status::solved) {
      status = status_name(worst.search);
    } else if (answer.rest == engine::Status::solved) {
      status = worst.proved ? status_text(worst.status) : "open";
    }
    result["alpha"] = *options.question.alpha;
    result["uncertain_components"] = problem.uncertain_count();
    result["worst_case"] = {{"lower", number_or_null(worst.ends.lower)},
                            {"upper", number_or_null(worst.ends.upper)},
                            {"proved", worst.proved},
                            {"lower_proved", worst.ends.lower_proved},
                            {"upper_proved", worst.ends.upper_proved},
                            {"from", worst.as_printed ? "zero-one" : "static-evidence"}};
    if (worst.zero_one) result["zero_one"] = zero_one_json(*worst.zero_one);
    add_critical_load(result, problem, worst.zeta);
    if (worst.collapse) {
      result["critical_interval"] = interval_json(*worst.collapse);
      result["collapse_mode"] = mode_json(problem, *worst.collapse);
      result["forces"] = numbers(worst.collapse->forces);
    }
    result["cuts"] = worst.cuts;
    result["programs"] = {{"load_factors", worst.counts.load_factors},
                          {"relaxations", worst.counts.relaxations},
                          {"cuts", worst.counts.pricings},
                          {"rounds", worst.counts.rounds}};
  }
  if (!answer.samples.empty()) {
    auto factors = ordered_json::array();
    for (const double factor : answer.samples) factors.push_back(number_or_null(factor));
    result["samples"] = {{"seed", options.question.seed},
                         {"least", number_or_null(*std::ranges::min_element(answer.samples))},
                         {"factors", std::move(factors)}};
  }
  CurveReport{options, problem, answer}.add_to(result);
  if (status == "solved" && !answer.whole()) status = "open";  // a curve
  ordered_json statistics{{"ranks", ranks}};
  if (answer.worst) {
    statistics["nodes"] = answer.worst->nodes;
    statistics["tree_programs"] = answer.worst->tree_programs;
    if (const auto& zero_one = answer.worst->zero_one) {
      statistics["zero_one"] = {{"nodes", zero_one->nodes}, {"programs", zero_one->programs}};
    }
  }
  ordered_json chosen = ordered_json::object();
  chosen["alpha"] = number_or_null(options.question.alpha);
  chosen["cuts"] = method_name(options.question.method);
  chosen["big_m"] = number_or_null(options.question.big_m);
  chosen["samples"] = options.question.samples;
  chosen["seed"] = options.question.seed;
  chosen["curve"] = options.question.curve;
  if (!options.curve_load.empty()) chosen["curve_load"] = options.curve_load;
  chosen["curve_to"] = options.question.curve_to;
  return {{"command", "limit"},
          {"version", KUSABI_VERSION},
          {"problem",
           {{"file", options.file},
            {"name", problem.name},
            {"d", problem.dimension},
            {"m", problem.uncertain_count()},
            {"nodes", problem.node_names.size()},
            {"members", problem.member_count()},
            {"units", {{"length", problem.units.length}, {"force", problem.units.force}}},
            {"fingerprint", hexadecimal(problem.fingerprint)}}},
          {"options", std::move(chosen)},
          {"status", status},
          {"result", std::move(result)},
          {"statistics", std::move(statistics)}};
}

}  // namespace kusabi::run
