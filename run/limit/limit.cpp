// `kusabi limit`: options, stages and results, on all ranks.
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "answer/values.hpp"
#include "answer/words.hpp"
#include "engine/collectives.hpp"
#include "nodes/limit/limit_loads.hpp"
#include "problems/files/sections/node_forces.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/load_cases.hpp"
#include "run/command/command_run.hpp"
#include "run/command/listed_names.hpp"
#include "run/command/subcommand.hpp"
#include "run/limit/limit_cases.hpp"
#include "run/limit/limit_report.hpp"
#include "run/output/standard_output.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"
#include "run/pictures/structure_json.hpp"
#include "run/session/kept_state.hpp"
#include "support/fingerprint.hpp"
#include "support/input_error.hpp"
#include "verify/limit/truss_certificate.hpp"

namespace kusabi::run {
namespace {

using problems::LimitProblem;
using support::InputError;

// Names of the nodes and members of a truss, and the members that each stands for.
class MemberNames {
 public:
  MemberNames(const problems::Structure& truss, const LimitProblem& problem);

  std::vector<std::string> names;
  std::vector<std::vector<int>> members;  ///< of each name

 private:
  void add(const std::string& name, int member);

  std::unordered_map<std::string, std::size_t> places_;
};

MemberNames::MemberNames(const problems::Structure& truss, const LimitProblem& problem) {
  std::vector<std::vector<std::string>> of_node;
  for (const auto& name : truss.node_names) of_node.push_back({name});
  for (const auto& [name, node] : truss.more_names)
    of_node[static_cast<std::size_t>(node)].push_back(name);
  for (int i = 0; i < problem.member_count(); ++i) {
    const auto& bar = problem.members[static_cast<std::size_t>(i)];
    for (const auto& first : of_node[static_cast<std::size_t>(bar.first)]) {
      for (const auto& second : of_node[static_cast<std::size_t>(bar.second)]) {
        for (const auto& name : {first, second, first + '-' + second, second + '-' + first})
          add(name, i);
      }
    }
  }
}

void MemberNames::add(const std::string& name, int member) {
  const auto [place, is_new] = places_.try_emplace(name, names.size());
  if (is_new) {
    names.push_back(name);
    members.emplace_back();
  }
  members[place->second].push_back(member);
}

// Members that are named, and those at named nodes.
std::vector<int> kept_members(const problems::Structure& truss, const LimitProblem& problem,
                              const std::string& text) {
  const MemberNames all(truss, problem);
  const auto [found, unknown] = names_in_list(text, all.names);
  if (!unknown.empty()) {
    throw WrongInput(fmt::format(
        "--keep '{}': no such node or member; expected names separated by blanks or commas, a "
        "member as NODE-NODE",
        unknown));
  }
  std::set<int> members;
  for (const auto i : found) members.insert(all.members[i].begin(), all.members[i].end());
  return {members.begin(), members.end()};
}

// Nodal forces of the critical part of an earlier result.
Eigen::MatrixXd of_result(const std::string& text, const std::string& file,
                          const LimitProblem& problem) {
  const auto& names = problem.node_names;
  Eigen::MatrixXd forces =
      Eigen::MatrixXd::Zero(problem.dimension, static_cast<Eigen::Index>(names.size()));
  try {
    const auto json = nlohmann::json::parse(text);
    for (const auto& entry : json.at("result").at("critical_part")) {
      const auto name = entry.at("node").get<std::string>();
      const auto force = entry.at("force").get<std::vector<double>>();
      const auto node = std::ranges::find(names, name);
      if (node == names.end() || std::ssize(force) != problem.dimension) {
        throw InputError(file, {},
                         fmt::format("the critical part of the load at {} belongs to another "
                                     "problem; expected a result with the same nodes",
                                     support::in_quotes(name)));
      }
      forces.col(node - names.begin()) =
          Eigen::Map<const Eigen::VectorXd>(force.data(), problem.dimension);
    }
  } catch (const nlohmann::json::exception&) {
    throw InputError(file, {},
                     "is not a result file with a critical_part; expected a result of kusabi limit "
                     "--alpha, or a TOML file with [[loads]]");
  }
  return forces;
}

// Load of --curve-load, g, n^d, force, without the part on supports: from a TOML file, or a result
// file, which begins with a brace. @throws support::InputError; also if the load is zero
Eigen::VectorXd curve_load(const std::string& text, const std::string& file,
                           const problems::Structure& truss, const LimitProblem& problem) {
  const auto first = text.find_first_not_of(" \t\r\n");
  const bool is_result = first != std::string::npos && text[first] == '{';
  const Eigen::MatrixXd forces =
      is_result ? of_result(text, file, problem) : problems::read_node_forces(text, file, truss);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(problem.free_count());
  for (int node = 0; node < static_cast<int>(problem.node_names.size()); ++node) {
    for (int axis = 0; axis < problem.dimension; ++axis) {
      const int degree = problem.degrees.number(axis, node);
      if (degree >= 0) load(degree) = forces(axis, node);
    }
  }
  if (load.isZero(0.0)) {
    throw InputError(file, {},
                     "the load is zero at all free displacements; expected a force at a free node "
                     "along a free axis");
  }
  return load;
}

class Limit final : public Subcommand {
 public:
  void describe(OptionTable& table) override;
  void check() const override;
  void read(CommandRun& run) override;
  void prepare(CommandRun& run) override;
  [[nodiscard]] std::string announcement(const std::string& ranks) const override;
  void search(CommandRun& run) override;
  std::vector<Step> results(CommandRun& run) override;
  [[nodiscard]] answer::Verdict verdict() const override;

 private:
  void take_cases(const problems::CheckedStructure& whole);
  void set_half_widths(const problems::Structure& whole);
  void warn_without_uncertain_loads(CommandRun& run) const;
  [[nodiscard]] const char* option_of_worst_case() const;
  void refuse_with_losses() const;
  void refuse_without_worst_case() const;
  [[nodiscard]] bool claims_losses() const;
  [[nodiscard]] const char* why_no_certificate() const;

  LimitOptions options_;
  std::string certificate_;
  std::string curve_csv_;
  std::string vtu_;
  std::string load_text_;
  std::vector<LimitCase> cases_;  // one without a name if the file has none
};

void Limit::describe(OptionTable& table) {
  constexpr double max_samples = 1e8;
  table.problem(options_.input.file);
  table.alpha(options_.asked.alpha, ", unless the file gives it another one").swept();
  table.load_case(options_.load_case, ". Default: all load cases of the file");
  table.group_alpha(options_.asked.groups);
  table.choice("--cuts", options_.parameters.method,
               {{"none", limit::LimitMethod::fixed},
                {"disjunctive", limit::LimitMethod::disjunctive},
                {"tighten", limit::LimitMethod::tightened},
                {"static", limit::LimitMethod::static_cuts},
                {"all", limit::LimitMethod::all}},
               "method for the worst case: static cuts, or all corners of few uncertain loads, "
               "whichever is predicted to take less work (static), or the 0-1 program (29) of the "
               "paper without cuts (none), with the paper's disjunctive cuts (disjunctive), with a "
               "tightened M (tighten), or with all of these (all). With --big-m, none and "
               "disjunctive are the algorithms printed in the paper");
  table.big_m(options_.parameters.big_m).needs("--cuts");
  table.number("--samples", &options_.parameters.samples, between(1, max_samples),
               "number of random admissible dead loads whose load factors are computed for "
               "comparison; --cuts none and disjunctive start from the smallest of these factors");
  table.number("--seed", &options_.parameters.seed, at_least(0), "random seed for --samples");
  table.flag("--curve", options_.parameters.curve,
             "two curves: the load factor as a function of the multiple of the critical dead load, "
             "and the worst case as a function of the multiple of alpha");
  table.file("--curve-load", options_.curve_load, Role::input,
             "curve of the load factor as a function of the multiple of the load in this file: "
             "[[loads]] with nodes and forces, or a result file, whose critical load is used");
  table.number("--curve-to", &options_.parameters.curve_to, between(1e-9, 1e9),
               "end of the curves, as a multiple of that load or of alpha");
  table.file("--curve-csv", curve_csv_, Role::output,
             "CSV file of the curves, one row per breakpoint");
  table.number(
      "--lose", &options_.loss.maximum, between(1, 1000),
      "least load factor after the loss of up to this number of members; with half-widths of "
      "uncertain loads, also over these loads");
  table
      .number("--at-least", &options_.loss.at_least, Range{},
              "decide whether the limit load factor is at least this after every such loss")
      .needs("--lose");
  table
      .text("--keep", options_.kept, "NAMES",
            "members (NODE-NODE) that cannot be lost, and nodes all of whose members cannot; "
            "separated by blanks or commas")
      .needs("--lose");
  table
      .number("--sudden", &options_.loss.sudden, between(1, 100),
              "dynamic factor by which a sudden loss multiplies all loads: 1 for a slow loss or "
              "unlimited ductility, 2 for an elastic structure")
      .needs("--lose");
  table.output();
  table.further_output("--csv", "CSV file of the members: forces, utilisation, yielding");
  table.pictures(vtu_, "collapse, nominal and worst case", "limit.pvd");
  table.file("--certificate", certificate_, Role::output, "certificate file, for kusabi verify")
      .matters();
  table.search_limits(options_.limits);
  table.resume(options_.checkpoint);
  table.save_on(options_.checkpoint);
  table.quiet_and_serial();
}

void Limit::check() const {
  if (options_.loss.maximum > 0) refuse_with_losses();
  if (options_.parameters.big_m && options_.parameters.method == limit::LimitMethod::static_cuts)
    throw WrongInput("--big-m: requires --cuts none, disjunctive, tighten or all");
  if (options_.parameters.curve || !options_.curve_load.empty()) return;
  if (!curve_csv_.empty()) {
    throw WrongInput("--curve-csv: requires --curve or --curve-load");
  }
  if (options_.parameters.curve_to != limit::LimitParameters{}.curve_to) {
    throw WrongInput("--curve-to: requires --curve or --curve-load");
  }
}

// An option on a worst case without losses, if one is given.
const char* Limit::option_of_worst_case() const {
  const auto& parameters = options_.parameters;
  if (parameters.curve) return "--curve";
  if (parameters.samples > 0) return "--samples";
  if (parameters.method != limit::LimitMethod::static_cuts) return "--cuts";
  return nullptr;
}

void Limit::refuse_with_losses() const {
  const char* const option = option_of_worst_case();
  if (option == nullptr) return;
  throw WrongInput(fmt::format("{}: not available with --lose; expected one of them", option));
}

// Options that require a worst case.
void Limit::refuse_without_worst_case() const {
  const char* const option = option_of_worst_case();
  if (option == nullptr) return;
  throw WrongInput(
      fmt::format("{}: requires half-widths of the uncertain loads; expected --alpha, or alpha in "
                  "the groups of the file",
                  option));
}

// Half-widths of uncertain loads, from the file and the call.
void Limit::set_half_widths(const problems::Structure& whole) {
  std::vector<problems::LimitProblem*> problems;
  for (auto& each : cases_) problems.push_back(&each.problem);
  auto asked = options_.asked;
  asked.groups = problems::of_cases(std::move(asked.groups), problems, whole);
  try {
    options_.parameters.alpha = problems::set_half_widths(problems, asked);
  } catch (const problems::HalfWidthError& error) {
    throw WrongInput(fmt::format(
        "{}: {}", options_.asked.groups.empty() ? "--alpha" : "--group-alpha", error.what()));
  }
  if (options_.parameters.alpha || options_.loss.maximum > 0) return;
  refuse_without_worst_case();
}

void Limit::warn_without_uncertain_loads(CommandRun& run) const {
  const auto has_none = [](const LimitCase& each) { return each.problem.uncertain.empty(); };
  if (options_.asked.alpha.value_or(0) == 0 || !std::ranges::all_of(cases_, has_none)) return;
  warn_all(run.session(), {"--alpha has no effect: no load on a free displacement is uncertain; "
                           "expected [[uncertainty]] in the problem file"});
}

void Limit::read(CommandRun& run) {
  options_.input.read(run);
  if (options_.curve_load.empty()) return;
  load_text_ = run.session().from_first_rank(
      [&] { return problems::file_text(options_.curve_load, "a result file in JSON"); });
}

// All load cases of the file, or the requested one.
void Limit::take_cases(const problems::CheckedStructure& whole) {
  const auto structure = problems::in_chosen_case(whole, options_.load_case);
  auto names = problems::load_cases(structure);
  if (names.empty()) names.emplace_back();
  for (const auto& name : names) {
    auto truss =
        name.empty() ? structure : problems::checked(problems::in_load_case(structure, name));
    auto problem = problems::limit_problem(truss);
    cases_.push_back({name, std::move(truss), std::move(problem)});
  }
}

void Limit::prepare(CommandRun& run) {
  const auto structure = options_.input.structure(run);
  if (structure->imposed_forces.size() > 0) {
    warn_all(run.session(),
             {"kusabi limit ignores temperature and displaced supports: a limit load does not "
              "depend on them"});
  }
  if (!structure->contact.empty()) {
    warn_all(run.session(),
             {"kusabi limit ignores [[contact]]: the truss is analysed without obstacles"});
  }
  take_cases(structure);
  set_half_widths(*structure);
  warn_without_uncertain_loads(run);
  if (options_.loss.maximum > 0) {
    options_.loss.kept = kept_members(*cases_.front().truss, cases_.front().problem, options_.kept);
    options_.parameters.loss = options_.loss;
  }
  engine::Facts facts;
  for (const auto& [name, truss, problem, found] : cases_) {
    engine::require_equal_on_all_ranks(run.session().transport(), problem.fingerprint);
    facts.emplace_back(name.empty() ? "the problem" : "the problem, case " + name,
                       hexadecimal(problem.fingerprint));
  }
  if (problems::has_struts(structure)) {
    support::Fingerprint strengths;
    for (const auto& member : structure->members)
      strengths.add(member.yield->residual.value_or(member.yield->compression));
    facts.emplace_back("the residual strengths", hexadecimal(strengths.value()));
  }
  if (!options_.curve_load.empty()) {
    options_.parameters.curve_load =
        curve_load(load_text_, options_.curve_load, cases_.front().truss, cases_.front().problem);
    support::Fingerprint load;
    load.add(load_text_);
    facts.emplace_back("--curve-load", hexadecimal(load.value()));
  }
  run.keep_state(options_.checkpoint, std::move(facts));
}

std::string Limit::announcement(const std::string& ranks) const {
  const auto& problem = cases_.front().problem;
  return fmt::format("{}: {}, {}, {}, {}{}; {}", problem.name,
                     problem.dimension == 2 ? "in the plane" : "in space",
                     answer::counted(problem.node_names.size(), "node"),
                     answer::counted(problem.member_count(), "member"),
                     answer::counted(problem.free_count(), "free displacement"),
                     cases_.size() == 1 ? "" : fmt::format(", {} load cases", cases_.size()),
                     ranks);
}

void Limit::search(CommandRun& run) {
  options_.parameters.evidence = !certificate_.empty();
  engine::Analysis analysis(run.session().transport(), run.analysis_options(options_.limits));
  try {
    for (auto& each : cases_) {
      if (cases_.size() > 1) analysis.say("load case " + each.name);
      each.found = limit::limit_loads(analysis, each.truss, each.problem, options_.parameters);
    }
  } catch (const limit::BigMTooSmall&) {
    throw WrongInput(
        "--cuts: (29) is infeasible, since its M is too small; expected a larger --big-m, or none");
  }
  const auto no_safe_m = [](const LimitCase& each) {
    return each.found.answer.worst && each.found.answer.worst->no_safe_m;
  };
  if (run.shows() && std::ranges::any_of(cases_, no_safe_m)) {
    print_message(
        "--cuts: no safe M was found, so (29) was not solved; the bounds are those of static "
        "cuts\n");
  }
}

std::vector<Step> Limit::results(CommandRun& run) {
  const auto report = std::make_shared<const LimitReport>(
      LimitReport{options_, cases_, governing(cases_), run.session().ranks()});
  std::vector<Step> steps{run.result([this, report, &run] {
    return run.result_json(limit_problem_json(report->problem, report->truss, options_.input.file),
                           result_json(*report), statistics_json(*report));
  })};
  steps.push_back(
      run.file("--csv", [report](std::ostream& out) { write_members_csv(out, *report); }));
  steps.push_back(
      run.file("--curve-csv", [report](std::ostream& out) { write_curves_csv(out, *report); }));
  steps.push_back(run.folder("--vtu", [report](auto& folder) { draw_collapses(folder, *report); }));
  if (claims_losses() || have_theorems(cases_, false)) {
    steps.push_back(run.file("--certificate", [this](std::ostream& out) {
      out << truss_certificate_text(all_theorems(cases_, claims_losses()));
    }));
  }
  steps.push_back(run.answer([report] { return report->table(CommandRun::page()); }));
  return steps;
}

// True if the certificate is one of losses; otherwise it has claims without loss, if any.
bool Limit::claims_losses() const {
  return options_.loss.maximum > 0 && have_theorems(cases_, true);
}

const char* Limit::why_no_certificate() const {
  const auto& worst = cases_.front().found.answer.worst;
  if (worst && worst->as_printed) return answer::ended_before_the_proof;
  return answer::not_all_is_proved;
}

answer::Verdict Limit::verdict() const {
  auto verdict = limit_verdict(options_, cases_);
  if (!certificate_.empty() && !claims_losses() && !have_theorems(cases_, false)) {
    verdict.missing.push_back(fmt::format("No certificate was written ({} is unchanged): {}.",
                                          certificate_, why_no_certificate()));
  }
  return verdict;
}

}  // namespace

constexpr Registration limit_subcommand{
    {.name = "limit",
     .chapter = "Limit loads of trusses",
     .purpose = "collapse load factor of a truss, and its worst case",
     .description =
         "The load factor at which a truss collapses, and its worst case under loads that are "
         "not known exactly.",
     .example = "examples/paper/limit-3x3.toml --alpha 40",
     .progress = ProgressLines::bounds},
    make<Limit>};

}  // namespace kusabi::run
