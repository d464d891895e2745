// Output files of `kusabi limit`: JSON, members as CSV, pictures of collapse.
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "pictures/vtu/structure_grid.hpp"
#include "problems/limit/action_factors.hpp"
#include "problems/limit/collapse_mode.hpp"
#include "problems/limit/half_widths.hpp"
#include "problems/limit/utilisation.hpp"
#include "run/limit/limit_report.hpp"
#include "run/output/csv.hpp"
#include "run/output/output_file.hpp"
#include "run/output/values.hpp"
#include "run/pictures/limit_values.hpp"
#include "run/pictures/vtu_series.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;
using problems::LimitProblem;
using problems::Structure;

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

// Part of the loads on supported displacements, at a load factor.
Eigen::MatrixXd loads_on_supports(const Structure& truss, double factor) {
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(truss.dimension, truss.coordinates.cols());
  for (const auto& load : truss.loads) {
    for (int axis = 0; axis < truss.dimension; ++axis) {
      const bool fixed =
          truss.fixed[static_cast<std::size_t>(load.node)][static_cast<std::size_t>(axis)];
      if (!fixed) continue;
      loads(axis, load.node) +=
          (load.kind == problems::Load::Kind::reference ? factor : 1) * load.force(axis);
    }
  }
  return loads;
}

// f_D + lambda f_R at all nodes, d x nodes, force, including loads on supports.
Eigen::MatrixXd load_at_collapse(const Structure& truss, const LimitProblem& problem,
                                 const limit::LimitCollapse& collapse,
                                 const Eigen::VectorXd& dead) {
  return problems::node_by_node(problem, dead + collapse.factor * problem.reference) +
         loads_on_supports(truss, collapse.factor);
}

// Support reactions: the sum of load and member forces along fixed axes, with opposite sign; zero
// elsewhere. d x nodes, force.
Eigen::MatrixXd support_reactions(const Structure& truss, const Eigen::MatrixXd& load,
                                  const Eigen::VectorXd& forces) {
  Eigen::MatrixXd rest = load;
  for (std::size_t i = 0; i < truss.members.size(); ++i) {
    const auto& member = truss.members[i];
    const Eigen::VectorXd along =
        (truss.coordinates.col(member.second) - truss.coordinates.col(member.first)).normalized();
    const Eigen::VectorXd pull = forces(static_cast<Eigen::Index>(i)) * along;
    rest.col(member.first) += pull;
    rest.col(member.second) -= pull;
  }
  for (Eigen::Index node = 0; node < rest.cols(); ++node) {
    const auto& fixed = truss.fixed[static_cast<std::size_t>(node)];
    for (Eigen::Index axis = 0; axis < rest.rows(); ++axis)
      rest(axis, node) = fixed[static_cast<std::size_t>(axis)] ? -rest(axis, node) : 0;
  }
  return rest;
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

void add_worst_case(ordered_json& result, const LimitReport& report,
                    const limit::LimitWorstCase& worst) {
  result["alpha"] = answer::number_or_null(
      problems::common_half_width(report.problem, *report.options.parameters.alpha));
  result["uncertain_components"] = report.problem.uncertain_count();
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

// The load that determines the least factor that is carried under every admissible load.
void add_critical_load_of_minimum(ordered_json& result, const LimitReport& report) {
  const auto& reversed = (report.residual ? *report.residual : report.answer).reversed;
  if (reversed && reversed->zeta.size() > 0)
    result["minimum_parameters"] = parameters_json(report.problem, reversed->zeta);
}

ordered_json samples_json(const LimitReport& report) {
  auto factors = ordered_json::array();
  for (const double factor : report.answer.samples) factors.push_back(factor);
  return {{"seed", report.options.parameters.seed},
          {"least", answer::number_or_null(*std::ranges::min_element(report.answer.samples))},
          {"factors", std::move(factors)}};
}

}  // namespace

ordered_json result_json(const LimitReport& report) {
  const auto& options = report.options;
  const auto& problem = report.problem;
  const auto& answer = report.answer;
  ordered_json result;
  if (!report.load_case.empty()) {
    result["case"] = report.load_case;
    result["cases"] = cases_json(report.cases);
  }
  result["nominal"] = answer.nominal ? ordered_json(answer.nominal->factor) : ordered_json();
  if (answer.nominal) {
    result["nominal_interval"] = carried_between(*answer.nominal);
    // Otherwise these bounds are the answer.
    if (options.parameters.alpha || options.parameters.loss || report.residual ||
        report.cases.size() > 1)
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
  if (options.parameters.alpha && !report.loss) add_critical_load_of_minimum(result, report);
  if (!answer.samples.empty()) result["samples"] = samples_json(report);
  add_curves(result, report);
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

namespace {

/// One collapse by members; all cells are empty if there is none.
class Collapse {
 public:
  Collapse(const problems::LimitProblem& problem,
           const std::optional<limit::LimitCollapse>& collapse) {
    if (!collapse) return;
    forces_ = collapse->forces;
    utilisation_ = problems::utilisation(problem, forces_);
    elongation_ = Eigen::VectorXd::Zero(problem.member_count());
    for (const auto& [member, elongation] :
         problems::collapse_mode(problem, collapse->motion).yielding)
      elongation_(member) = elongation;
  }

  void add_member(CsvWriter& csv, int member) const {
    if (forces_.size() == 0) {
      csv.nothing().nothing().nothing();
      return;
    }
    csv.number(forces_(member)).number(utilisation_(member));
    const double elongation = elongation_(member);
    csv.word(elongation > 0 ? "tension" : elongation < 0 ? "compression" : "");
  }

 private:
  Eigen::VectorXd forces_;
  Eigen::VectorXd utilisation_;
  Eigen::VectorXd elongation_;  // 0: elastic
};

/// Cells on the loss of each member.
class Losses {
 public:
  explicit Losses(const limit::LossAnswer& loss) : loss_(loss) {}

  void add_member(CsvWriter& csv, int member) const {
    const auto single = std::ranges::find(loss_.singles, member, &limit::SingleLoss::member);
    if (single == loss_.singles.end()) {
      const bool stopped = loss_.singles.empty() && loss_.eligible > 0;
      csv.nothing().word(stopped ? "" : "kept");
    } else if (single->status == limit::LoadStatus::collapses) {
      csv.number(single->factor).word("collapses");
    } else {
      csv.nothing().word(loss_state(single->status));
    }
    const bool lost = std::ranges::find(loss_.lost, member) != loss_.lost.end();
    csv.word(lost ? "lost" : "");
  }

 private:
  const limit::LossAnswer& loss_;
};

}  // namespace

void write_members_csv(std::ostream& out, const LimitReport& report) {
  const auto& problem = report.problem;
  const auto& answer = report.answer;
  const Collapse nominal(problem, answer.nominal);
  const Collapse worst(problem, answer.worst ? answer.worst->collapse : std::nullopt);
  CsvWriter csv(out);
  for (const char* const column :
       {"member", "first", "second", "yield_tension", "yield_compression", "nominal_forces",
        "nominal_utilisation", "nominal_mode", "forces", "utilisation", "collapse_mode"})
    csv.word(column);
  if (report.loss) csv.word("factor_after_loss").word("state_after_loss").word("worst_loss");
  csv.end_row();
  for (int i = 0; i < problem.member_count(); ++i) {
    const auto& bar = problem.members[static_cast<std::size_t>(i)];
    csv.text(problems::member_name(problem, i));
    for (const int node : {bar.first, bar.second})
      csv.text(problem.node_names[static_cast<std::size_t>(node)]);
    csv.number(problem.tension(i)).number(problem.compression(i));
    nominal.add_member(csv, i);
    worst.add_member(csv, i);
    if (report.loss) Losses(*report.loss).add_member(csv, i);
    csv.end_row();
  }
}

namespace {

pictures::UnstructuredGrid collapse_grid(const Structure& truss, const LimitProblem& problem,
                                         const limit::LimitCollapse& collapse,
                                         const Eigen::VectorXd& dead, const std::string& remark) {
  const auto by_node = [&](const Eigen::VectorXd& vector) {
    return problems::node_by_node(problem, vector);
  };
  auto grid = pictures::structure_grid(truss);
  grid.remark =
      fmt::format("{}: {}; {} and {}", truss.name, remark, truss.units.length, truss.units.force);
  const auto load = load_at_collapse(truss, problem, collapse, dead);
  auto& points = grid.point_data;
  points.push_back(pictures::node_vectors("velocity", by_node(collapse.motion)));
  points.push_back(pictures::node_vectors("dead_load", by_node(dead)));
  points.push_back(pictures::node_vectors("reference_load", by_node(problem.reference)));
  points.push_back(pictures::node_vectors("load", load));
  points.push_back(
      pictures::node_vectors("support_reaction", support_reactions(truss, load, collapse.forces)));
  const auto add = [&](const char* name, const Eigen::VectorXd& values) {
    grid.cell_data.push_back(pictures::member_numbers(grid, name, numbers(values)));
  };
  add("axial_force", collapse.forces);
  add("utilisation", problems::utilisation(problem, collapse.forces));
  add("elongation_rate", problem.equilibrium.transpose() * collapse.motion);
  return grid;
}

}  // namespace

void draw_collapses(OutputFolder& folder, const LimitReport& report) {
  const auto& truss = report.truss;
  const auto& problem = report.problem;
  const auto& answer = report.answer;
  VtuSeries series(folder);
  if (answer.nominal) {
    series.add("nominal.vtu",
               collapse_grid(truss, problem, *answer.nominal, problem.dead,
                             fmt::format("collapse at load factor {}", answer.nominal->factor)));
  }
  if (answer.worst && answer.worst->collapse) {
    const auto& collapse = *answer.worst->collapse;
    series.add(
        "worst-case.vtu",
        collapse_grid(
            truss, problem, collapse, problems::dead_load(problem, answer.worst->zeta),
            fmt::format("collapse {}, at load factor {}",
                        answer.worst->proved() ? "in the worst case" : "under the worst load known",
                        collapse.factor)));
  }
  series.finish("limit.pvd", problem.name);
}

}  // namespace kusabi::run
