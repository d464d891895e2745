// Programs of limit analysis, in the units of the problem file: the optimum is the load factor.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "engine/analysis/analysis.hpp"
#include "engine/collectives.hpp"
#include "nodes/limit/root/safe_big_m.hpp"
#include "problems/limit/half_widths.hpp"
#include "problems/limit/limit_analysis.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/limit/mixed_limit.hpp"
#include "problems/limit/program_names.hpp"
#include "problems/structure/model/load_cases.hpp"
#include "run/command/command_run.hpp"
#include "run/command/registrations.hpp"
#include "run/export/exported_file.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"
#include "run/session/analysis_options.hpp"
#include "solvers/linear/mps_writer.hpp"

namespace kusabi::run {
namespace {

enum class Program { worst_case, kinematic, statics };

class ExportMps final : public ExportedFile {
 public:
  void describe(OptionTable& table) override;
  void check() const override;
  void prepare(CommandRun& run) override;
  void search(CommandRun& run) override;

 protected:
  void write(std::ostream& out) const override;

 private:
  void set_half_widths(const problems::Structure& whole);
  [[nodiscard]] linear::MixedProgram program() const;
  [[nodiscard]] std::vector<std::string> comments() const;
  [[nodiscard]] std::vector<std::string> comments_on_worst_case() const;

  Program choice_ = Program::worst_case;
  std::optional<double> alpha_;
  std::string load_case_;
  problems::GroupHalfWidths group_alpha_;
  std::optional<double> asked_m_;
  bool struts_ = false;  // some members have a residual strength
  std::optional<problems::LimitProblem> problem_;
  Eigen::VectorXd big_m_;  // of the worst case, one per uncertain component
};

void ExportMps::describe(OptionTable& table) {
  describe_input(table);
  table.choice("--program", choice_,
               {{"worst-case", Program::worst_case},
                {"kinematic", Program::kinematic},
                {"static", Program::statics}},
               "program: 0-1 program (29) of the worst case, or a linear program for the nominal "
               "dead load: kinematic (15), or static (5), whose optimum is minus the load factor");
  table.alpha(alpha_, ", for --program worst-case");
  table.group_alpha(group_alpha_);
  table.big_m(asked_m_);
  table.load_case(load_case_);
  describe_output(table);
}

void ExportMps::check() const {
  const bool of_worst_case = choice_ == Program::worst_case;
  if (!of_worst_case && (alpha_ || asked_m_ || !group_alpha_.empty())) {
    throw WrongInput("--alpha, --group-alpha, --big-m: require --program worst-case");
  }
}

void ExportMps::prepare(CommandRun& run) {
  const auto structure = input().structure(run);
  struts_ = problems::has_struts(structure);
  problem_ = problems::limit_problem(problems::in_chosen_case(structure, load_case_));
  if (choice_ == Program::worst_case) set_half_widths(*structure);
  engine::require_equal_on_all_ranks(run.session().transport(), problem_->fingerprint);
}

void ExportMps::set_half_widths(const problems::Structure& whole) {
  problems::LimitProblem* const one = &*problem_;
  try {
    alpha_ = problems::set_half_widths(
        {&one, 1}, {.alpha = alpha_, .groups = problems::of_cases(group_alpha_, {&one, 1}, whole)});
  } catch (const problems::HalfWidthError& error) {
    throw WrongInput(
        fmt::format("{}: {}", group_alpha_.empty() ? "--alpha" : "--group-alpha", error.what()));
  }
  if (!alpha_) throw WrongInput("--program worst-case: requires --alpha");
  // Loads with a half-width of zero are not part of the program.
  std::erase_if(one->uncertain,
                [&](const auto& column) { return *alpha_ * column.half_width == 0; });
}

void ExportMps::search(CommandRun& run) {
  if (choice_ != Program::worst_case) return;
  if (asked_m_) {
    big_m_.setConstant(problem_->uncertain_count(), *asked_m_);
    return;
  }
  engine::Analysis analysis(run.session().transport(), analysis_options({}, false));
  const auto derived = limit::safe_big_m(analysis, *problem_, *alpha_);
  if (!derived)
    throw WrongInput(
        "--alpha: no safe M of (29) was found, perhaps because a load is not carried at any factor "
        "(see kusabi limit); expected a smaller alpha, or --big-m");
  big_m_ = *derived;
}

linear::MixedProgram ExportMps::program() const {
  const auto model = problems::unscaled_model(*problem_);
  linear::MixedProgram mixed;
  switch (choice_) {
    case Program::statics:
      mixed.program = static_program(model, model.dead);
      name_static_program(*problem_, mixed.program);
      break;
    case Program::kinematic:
      mixed.program = kinematic_program(model, model.dead);
      name_kinematic_program(*problem_, mixed.program);
      break;
    case Program::worst_case: {
      const auto unlimited = [](int size) {
        return Eigen::VectorXd::Constant(size, linear::infinity).eval();
      };
      mixed = worst_case_program(model, *alpha_, big_m_, unlimited(model.free_count()),
                                 unlimited(model.member_count()));
      name_worst_case_program(*problem_, mixed.program);
    }
  }
  return mixed;
}

std::vector<std::string> ExportMps::comments_on_worst_case() const {
  const auto alpha = problems::common_half_width(*problem_, *alpha_);
  const auto unit = problems::alpha_is_force(*problem_) ? ' ' + problem_->units.force : "";
  std::vector<std::string> lines{
      alpha ? fmt::format("Its uncertain components have half-widths of {}{} times their weights.",
                          *alpha, unit)
            : std::string("Its uncertain components have individual half-widths."),
      "Minimise; the optimal objective is the worst-case load factor, lambda_min.",
      "u: collapse mode, with f_R'u = 1; z: absolute elongation of each member; gamma: absolute "
      "displacement of each uncertain",
      "component; tau: 1 if that displacement is positive, 0 if it is negative."};
  if (asked_m_) {
    lines.push_back(
        fmt::format("M is {}, as given; if it is too small, it cuts off the optimum.", *asked_m_));
  } else if (big_m_.size() > 0) {
    lines.push_back(fmt::format(
        "M is {:g} to {:g}, derived for each component such that no optimum is cut off.",
        big_m_.minCoeff(), big_m_.maxCoeff()));
  }
  return lines;
}

std::vector<std::string> ExportMps::comments() const {
  std::vector<std::string> lines{
      fmt::format("{}, from {}, fingerprint {}", problem_->name, input().file,
                  hexadecimal(problem_->fingerprint)),
      fmt::format("Forces are in {}, lengths in {}, as in the problem file.", problem_->units.force,
                  problem_->units.length)};
  if (struts_)
    lines.emplace_back("All struts are at their strength, not at their residual strength.");
  switch (choice_) {
    case Program::statics:
      lines.emplace_back("The static principle (5) of limit analysis with the nominal dead load.");
      lines.emplace_back(
          "Minimise; the optimal objective is minus the load factor. q: member forces.");
      break;
    case Program::kinematic:
      lines.emplace_back(
          "The kinematic principle (15) of limit analysis with the nominal dead load.");
      lines.emplace_back(
          "Minimise; the optimal objective is the load factor. u: collapse mode, with f_R'u = 1; "
          "z: absolute elongation of each member.");
      break;
    case Program::worst_case: {
      lines.emplace_back("The 0-1 program (29) of limit analysis with an uncertain dead load.");
      const auto more = comments_on_worst_case();
      lines.insert(lines.end(), more.begin(), more.end());
    }
  }
  return lines;
}

void ExportMps::write(std::ostream& out) const {
  write_mps(out, program(), comments());
}

}  // namespace

constexpr Registration export_mps_subcommand{
    {.name = "export mps",
     .chapter = "Files for other solvers",
     .purpose = "programs of limit analysis, as free MPS",
     .description =
         "The programs of limit analysis as free MPS, for solvers of (0-1) linear programs.",
     .example = "examples/gust.toml --alpha 0.5 --output gust.mps"},
    make<ExportMps>};

}  // namespace kusabi::run
