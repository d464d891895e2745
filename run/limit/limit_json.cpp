// JSON of `kusabi limit`.
#include <algorithm>
#include <utility>

#include "answer/ending.hpp"
#include "answer/values.hpp"
#include "problems/limit/action_factors.hpp"
#include "problems/limit/collapse_mode.hpp"
#include "problems/limit/half_widths.hpp"
#include "problems/limit/utilisation.hpp"
#include "run/limit/collapse_loads.hpp"
#include "run/limit/curve_report.hpp"
#include "run/limit/limit_report.hpp"
#include "run/limit/limit_words.hpp"
#include "run/limit/loss_report.hpp"
#include "run/limit/strut_report.hpp"
#include "run/limit/zero_one_report.hpp"
#include "run/output/values.hpp"
#include "run/pictures/guaranteed_interval_report.hpp"
#include "run/pictures/limit_problem_json.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;
using problems::LimitProblem;

const std::string& node_name(const LimitProblem& problem, int node) {
  return problem.node_names[static_cast<std::size_t>(node)];
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

// Reactions by names of the supported nodes.
ordered_json support_reactions_json(const LimitReport& report, const limit::LimitCollapse& collapse,
                                    const Eigen::VectorXd& dead) {
  const auto load = load_at_collapse(report.truss, report.problem, collapse, dead);
  const auto reactions = support_reactions(report.truss, load, collapse.forces);
  auto supports = ordered_json::object();
  for (std::size_t node = 0; node < report.truss.fixed.size(); ++node) {
    const auto& held = report.truss.fixed[node];
    if (std::ranges::any_of(held, [](bool each) { return each; }))
      supports[report.problem.node_names[node]] =
          numbers(reactions.col(static_cast<Eigen::Index>(node)));
  }
  return supports;
}

// Load factors that are carried.
ordered_json carried_between(const limit::LimitCollapse& collapse) {
  return {answer::number_or_null(collapse.minimum), collapse.factor};
}

ordered_json options_json(const LimitOptions& options) {
  const auto& parameters = options.parameters;
  ordered_json chosen{{"alpha", answer::number_or_null(options.asked.alpha)},
                      {"cuts", word_of(limit_method_words(), parameters.method)},
                      {"big_m", answer::number_or_null(parameters.big_m)},
                      {"samples", parameters.samples},
                      {"seed", parameters.seed},
                      {"curve", parameters.curve}};
  for (const auto& [name, half_width] : options.asked.groups)
    chosen["group_alpha"][name] = half_width;
  if (!options.load_case.empty()) chosen["case"] = options.load_case;
  if (!options.curve_load.empty()) chosen["curve_load"] = options.curve_load;
  chosen["curve_to"] = parameters.curve_to;
  if (parameters.loss) {
    chosen["lose"] = parameters.loss->maximum;
    chosen["at_least"] = answer::number_or_null(parameters.loss->at_least);
    if (parameters.loss->sudden != 1) chosen["sudden"] = parameters.loss->sudden;
    if (!options.loss.kept.empty()) chosen["keep"] = options.loss.kept;
  }
  return chosen;
}

void add_worst_case(ordered_json& result, const LimitReport& report,
                    const limit::LimitWorstCase& worst) {
  result["alpha"] = answer::number_or_null(
      problems::common_half_width(report.problem, *report.options.parameters.alpha));
  result["uncertain_components"] = report.problem.uncertain_count();
  result["worst_case"] = {{"lower", answer::number_or_null(worst.ends.at_least())},
                          {"upper", answer::number_or_null(worst.ends.at_most())},
                          {"proved", worst.proved()},
                          {"lower_proved", is_proved(worst.ends.lower)},
                          {"upper_proved", is_proved(worst.ends.upper)},
                          {"from", worst.as_printed ? "zero-one" : "static-evidence"}};
  if (worst.zero_one) result["zero_one"] = zero_one_json(*worst.zero_one);
  add_critical_load(result, report.problem, worst.zeta);
  if (worst.collapse) {
    result["critical_interval"] = carried_between(*worst.collapse);
    result["collapse_mode"] = mode_json(report.problem, worst.collapse->motion);
    result["forces"] = numbers(worst.collapse->forces);
    result["utilisation"] = numbers(utilisation(report.problem, worst.collapse->forces));
    result["support_reactions"] = support_reactions_json(
        report, *worst.collapse, problems::dead_load(report.problem, worst.zeta));
  }
  result["cuts"] = worst.cuts;
  result["programs"] = {{"load_factors", worst.counts.load_factors},
                        {"relaxations", worst.counts.relaxations},
                        {"cuts", worst.counts.pricings},
                        {"rounds", worst.counts.rounds}};
}

void add_interval(ordered_json& result, const LimitReport& report) {
  auto& interval = result["guaranteed_interval"];
  interval = interval_json(guaranteed_interval(report.answer, report.residual));
  const auto& reversed = (report.residual ? *report.residual : report.answer).reversed;
  if (!reversed || reversed->zeta.size() == 0) return;
  interval["lower"]["critical_parameters"] = parameters_json(report.problem, reversed->zeta);
}

ordered_json samples_json(const LimitReport& report) {
  auto factors = ordered_json::array();
  for (const double factor : report.answer.samples) factors.push_back(factor);
  return {{"seed", report.options.parameters.seed},
          {"least", answer::number_or_null(*std::ranges::min_element(report.answer.samples))},
          {"factors", std::move(factors)}};
}

ordered_json result_json(const LimitReport& report) {
  const auto& options = report.options;
  const auto& problem = report.problem;
  const auto& answer = report.answer;
  ordered_json result;
  if (!report.load_case.empty()) {
    result["case"] = report.load_case;
    result["cases"] = cases_json(report.cases);
    if (report.options.parameters.alpha && !report.loss) {
      result["guaranteed_interval_of_all_cases"] = interval_json(interval_of_all(report.cases));
    }
  }
  result["nominal"] = answer.nominal ? ordered_json(answer.nominal->factor) : ordered_json();
  if (answer.nominal) {
    result["nominal_interval"] = carried_between(*answer.nominal);
    result["nominal_bounds"] = interval_json(nominal_interval(answer, {}));
    result["nominal_mode"] = mode_json(problem, answer.nominal->motion);
    result["nominal_forces"] = numbers(answer.nominal->forces);
    result["nominal_utilisation"] = numbers(utilisation(problem, answer.nominal->forces));
    result["nominal_support_reactions"] =
        support_reactions_json(report, *answer.nominal, problem.dead);
  }
  if (report.residual) result["struts"] = strut_json(report);
  if (report.loss) result["member_loss"] = loss_json(problem, report.truss, *report.loss);
  if (answer.worst) add_worst_case(result, report, *answer.worst);
  if (!report.truss.actions.empty() && !report.loss) {
    result["critical_factors"] =
        factors_json(report.truss, problem, answer.worst ? answer.worst->zeta : Eigen::VectorXd());
  }
  if (options.parameters.alpha && !report.loss) add_interval(result, report);
  if (!answer.samples.empty()) result["samples"] = samples_json(report);
  CurveReport{options, problem, answer}.add_to(result);
  return result;
}

ordered_json statistics_json(const LimitReport& report) {
  ordered_json statistics{{"ranks", report.ranks}};
  if (report.loss) {
    const auto& counts = report.loss->counts;
    statistics["member_loss"] = {{"rounds", counts.rounds},
                                 {"nodes", counts.nodes},
                                 {"states", counts.states},
                                 {"programs", counts.programs}};
  }
  if (const auto& worst = report.answer.worst) {
    statistics["nodes"] = worst->nodes;
    statistics["corners"] = worst->corners;
    statistics["tree_programs"] = worst->tree_programs;
    if (const auto& zero_one = worst->zero_one) {
      statistics["zero_one"] = {{"nodes", zero_one->nodes}, {"programs", zero_one->programs}};
    }
  }
  return statistics;
}

}  // namespace

const OptionWords<limit::LimitMethod>& limit_method_words() {
  using limit::LimitMethod;
  static const OptionWords<LimitMethod> words{{"none", LimitMethod::fixed},
                                              {"disjunctive", LimitMethod::disjunctive},
                                              {"tighten", LimitMethod::tightened},
                                              {"static", LimitMethod::static_cuts},
                                              {"all", LimitMethod::all}};
  return words;
}

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

ordered_json mode_json(const LimitProblem& problem, const Eigen::VectorXd& motion,
                       std::span<const int> lost) {
  const auto mode = problems::collapse_mode(problem, motion);
  auto moving = ordered_json::array();
  for (const auto& [node, velocity] : mode.moving) {
    moving.push_back({{"node", node_name(problem, node)}, {"velocity", numbers(velocity)}});
  }
  auto yielding = ordered_json::array();
  for (const auto& [member, elongation] : mode.yielding) {
    if (std::ranges::find(lost, member) != lost.end()) continue;
    const auto& bar = problem.members[static_cast<std::size_t>(member)];
    yielding.push_back({{"member", {node_name(problem, bar.first), node_name(problem, bar.second)}},
                        {"in", elongation > 0 ? "tension" : "compression"},
                        {"elongation", elongation}});
  }
  return {
      {"along_reference_load", mode.along_reference}, {"moving", moving}, {"yielding", yielding}};
}

// Meaning of zeta, parameter by parameter.
ordered_json parameters_json(const LimitProblem& problem, const Eigen::VectorXd& zeta) {
  auto list = ordered_json::array();
  for (int j = 0; j < problem.uncertain_count(); ++j) {
    const double half_width = problem.uncertain[static_cast<std::size_t>(j)].half_width;
    list.push_back(
        {{"name", problems::parameter_name(problem, j)}, {"value", half_width * zeta(j)}});
  }
  return list;
}

ordered_json factors_json(const problems::Structure& truss, const LimitProblem& problem,
                          const Eigen::VectorXd& zeta) {
  auto list = ordered_json::array();
  if (zeta.size() != problem.uncertain_count()) return list;
  for (const auto& [action, factor, reference] : problems::action_factors(truss, problem, zeta))
    list.push_back({{"action", action}, {"factor", factor}, {"reference", reference}});
  return list;
}

ordered_json LimitReport::json() const {
  return {{"command", "limit"},
          {"version", KUSABI_VERSION},
          {"problem", limit_problem_json(problem, truss, options.input.file)},
          {"options", options_json(options)},
          {"status", answer::status_text(limit_verdict(options, cases))},
          {"result", result_json(*this)},
          {"statistics", statistics_json(*this)}};
}

}  // namespace kusabi::run
