// Cone program with the margin t* of a node as its optimum, in the scaled units of t*.
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "problems/wedged/wedged_problem.hpp"
#include "run/command/command_run.hpp"
#include "run/command/listed_names.hpp"
#include "run/command/registrations.hpp"
#include "run/export/exported_file.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"
#include "run/wedged/contact_problem.hpp"
#include "run/wedged/problem_summary.hpp"
#include "solvers/conic/benchmark_format.hpp"
#include "solvers/conic/cone_program.hpp"

namespace kusabi::run {
namespace {

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

}  // namespace

constexpr Registration export_cbf_subcommand{
    {.name = "export cbf",
     .chapter = "Files for other solvers",
     .purpose = "cone program of one node of the tree, as CBF",
     .description =
         "The cone program of one node of the tree of sign patterns in the Conic Benchmark "
         "Format, for solvers of second-order cone programs.",
     .example = "examples/two-bars.toml --mu 2 --output node.cbf"},
    make<ExportCbf>};

}  // namespace kusabi::run
