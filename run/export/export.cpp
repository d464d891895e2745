// `kusabi export`: programs and matrices as files for other solvers.
#include <iosfwd>
#include <memory>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/analysis/analysis.hpp"
#include "engine/collectives.hpp"
#include "nodes/limit/root/safe_big_m.hpp"
#include "problems/files/matrices/matrix_market.hpp"
#include "problems/limit/half_widths.hpp"
#include "problems/limit/limit_analysis.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/limit/mixed_limit.hpp"
#include "problems/limit/program_names.hpp"
#include "problems/structure/model/load_cases.hpp"
#include "problems/wedged/free_stiffness.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/command/command_run.hpp"
#include "run/command/listed_names.hpp"
#include "run/command/problem_input.hpp"
#include "run/command/subcommand.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"
#include "run/session/progress_line.hpp"
#include "run/wedged/contact_problem.hpp"
#include "run/wedged/problem_summary.hpp"
#include "solvers/conic/benchmark_format.hpp"
#include "solvers/conic/cone_program.hpp"
#include "solvers/linear/mps_writer.hpp"

namespace kusabi::run {
namespace {

class ExportedFile : public Subcommand {
 public:
  void read(CommandRun& run) final { input_.read(run); }
  /// Most exports need no search.
  void search(CommandRun& /*run*/) override {}
  std::vector<Step> results(CommandRun& run) final;

 protected:
  /// Rows common to all: the problem file first, options of the run last.
  void describe_input(OptionTable& table);
  static void describe_output(OptionTable& table);

  [[nodiscard]] const ProblemInput& input() const { return input_; }

  /// Writes the file, on rank 0, after the search.
  virtual void write(std::ostream& out) const = 0;

 private:
  ProblemInput input_;
};

void ExportedFile::describe_input(OptionTable& table) {
  table.problem(input_.file);
}

void ExportedFile::describe_output(OptionTable& table) {
  table.output("file to write. Default: standard output");
  table.serial();
}

std::vector<Step> ExportedFile::results(CommandRun& run) {
  if (run.wants("--output")) {
    return {run.file("--output", [this](std::ostream& out) { write(out); })};
  }
  std::ostringstream text;
  write(text);
  return {CommandRun::print(text.str())};
}

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

using Names = std::vector<std::string>;

class ExportCbf final : public ExportedFile {
 public:
  void describe(OptionTable& table) override;
  void prepare(CommandRun& run) override;

 protected:
  void write(std::ostream& out) const override;

 private:
  [[nodiscard]] support::IndexSet set_of(std::string_view text, std::string_view option) const;
  [[nodiscard]] Names comments(double unit) const;

  double coefficient_ = 0;
  std::string contact_names_, separated_names_;
  problems::WedgedProblem problem_;
  std::vector<double> friction_;
  support::IndexSet contact_, separated_;
};

void ExportCbf::describe(OptionTable& table) {
  describe_input(table);
  table.friction(coefficient_);
  table.text("--contact", contact_names_, "NODE,NODE,...",
             "candidates in contact at the node (U); none at the root");
  table.text("--separated", separated_names_, "NODE,NODE,...",
             "candidates separated at the node (R)");
  describe_output(table);
}

support::IndexSet ExportCbf::set_of(std::string_view text, std::string_view option) const {
  const auto [found, unknown] = names_in_list(text, problem_.contact_names);
  if (!unknown.empty()) {
    throw WrongInput(fmt::format("{}: {} has no contact candidate '{}'; expected {}", option,
                                 input().file, unknown, fmt::join(problem_.contact_names, " or ")));
  }
  support::IndexSet set;
  for (const auto i : found) set.insert(static_cast<int>(i));
  return set;
}

void ExportCbf::prepare(CommandRun& run) {
  problem_ = agreed_problem(run, input().structure(run));
  friction_ = friction_at(problem_, coefficient_, input().file);
  contact_ = set_of(contact_names_, "--contact");
  separated_ = set_of(separated_names_, "--separated");
  if (contact_.meets(separated_)) {
    throw WrongInput(fmt::format("--separated: {} is also in --contact; expected it in one of them",
                                 candidate_names(problem_, contact_ & separated_).front()));
  }
  if (candidate_names(problem_, separated_).size() == problem_.contact_names.size()) {
    throw WrongInput(
        "--separated: all candidates are separated, so none can have a reaction; expected fewer");
  }
}

Names ExportCbf::comments(double unit) const {
  const auto d = static_cast<std::size_t>(problem_.dimension);
  Names lines{
      fmt::format("{}, from {}, fingerprint {}", problem_.provenance.name, input().file,
                  hexadecimal(problem_.provenance.fingerprint)),
      fmt::format("The cone program of the sign pattern with contact: {}; separated: {}; friction "
                  "coefficient {}.",
                  listed(candidate_names(problem_, contact_)),
                  listed(candidate_names(problem_, separated_)), coefficient_),
      "Maximise t; the optimal objective is the margin t*. If t* < 0, no wedged configuration has "
      "this pattern.",
      fmt::format("F is divided by its mean normal compliance, {} {}/{}, so that t has no unit.",
                  unit, problem_.provenance.units.length, problem_.provenance.units.force)};
  for (std::size_t i = 0; i < problem_.contact_names.size(); ++i) {
    lines.push_back(fmt::format("columns {} to {}: reaction at {}: n, {}; friction {}", d * i,
                                d * i + d - 1, problem_.contact_names[i], d == 2 ? "t1" : "t1, t2",
                                friction_[i]));
  }
  lines.push_back(fmt::format("column {}: t", d * problem_.contact_names.size()));
  return lines;
}

void ExportCbf::write(std::ostream& out) const {
  const double unit = mean_normal_compliance(problem_);
  write_benchmark_format(
      out,
      conic::node_cone_program(problem_.compliance.matrix / unit, friction_, contact_, separated_),
      comments(unit));
}

enum class Matrix { stiffness, compliance };

class ExportMatrix final : public ExportedFile {
 public:
  void describe(OptionTable& table) override;
  void prepare(CommandRun& run) override;

 protected:
  void write(std::ostream& out) const override;

 private:
  [[nodiscard]] std::vector<std::string> comments() const;

  Matrix choice_ = Matrix::stiffness;
  problems::WedgedProblem problem_;
};

void ExportMatrix::describe(OptionTable& table) {
  describe_input(table);
  table.choice("--matrix", choice_,
               {{"stiffness", Matrix::stiffness}, {"compliance", Matrix::compliance}},
               "stiffness K of r = K u, or compliance F = K^-1, of the displacements u and "
               "reactions r of the contact candidates");
  describe_output(table);
}

void ExportMatrix::prepare(CommandRun& run) {
  problem_ = agreed_problem(run, input().structure(run));
}

std::vector<std::string> ExportMatrix::comments() const {
  const bool stiffness = choice_ == Matrix::stiffness;
  std::vector<std::string> lines{
      fmt::format("{}, from {}, fingerprint {}", problem_.provenance.name, input().file,
                  hexadecimal(problem_.provenance.fingerprint)),
      stiffness ? fmt::format("The stiffness K condensed onto the contact candidates: r = K u, in "
                              "{}/{}.",
                              problem_.provenance.units.force, problem_.provenance.units.length)
                : fmt::format("The compliance F of the contact candidates: u = F r, in {}/{}.",
                              problem_.provenance.units.length, problem_.provenance.units.force),
      "Each candidate has its own frame: n out of the obstacle, t along it."};
  for (const auto& [node, nodes, motions] : problem_.modes.bodies) {
    lines.push_back(fmt::format("The body of node {} {}: {}", node, motions,
                                stiffness
                                    ? "K is only semidefinite."
                                    : "F includes grounding springs; it gives the displacements of "
                                      "reactions in equilibrium, up to these motions."));
  }
  constexpr const char* axes[] = {"n", "t1", "t2"};
  int row = 0;
  for (std::size_t i = 0; i < problem_.contact_names.size(); ++i) {
    for (int axis = 0; axis < problem_.dimension; ++axis) {
      const Eigen::VectorXd direction = problem_.frames[i].col(axis);
      lines.push_back(fmt::format("row {}: {} of {}, along ({})", ++row, axes[axis],
                                  problem_.contact_names[i], fmt::join(direction, ", ")));
    }
  }
  return lines;
}

void ExportMatrix::write(std::ostream& out) const {
  problems::write_matrix_market(out,
                                choice_ == Matrix::stiffness ? problems::free_stiffness(problem_)
                                                             : problem_.compliance.matrix,
                                comments());
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

constexpr Registration export_cbf_subcommand{
    {.name = "export cbf",
     .chapter = "Files for other solvers",
     .purpose = "cone program of one node of the tree, as CBF",
     .description =
         "The cone program of one node of the tree of sign patterns in the Conic Benchmark "
         "Format, for solvers of second-order cone programs.",
     .example = "examples/two-bars.toml --mu 2 --output node.cbf"},
    make<ExportCbf>};

constexpr Registration export_matrix_subcommand{
    {.name = "export matrix",
     .chapter = "Files for other solvers",
     .purpose = "condensed stiffness or compliance, as Matrix Market",
     .description =
         "The stiffness condensed onto the contact candidates, or its inverse, as a Matrix "
         "Market file.",
     .example = "examples/two-bars.toml --output stiffness.mtx"},
    make<ExportMatrix>};

}  // namespace kusabi::run
