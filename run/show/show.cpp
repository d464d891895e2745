// `kusabi show FILE`: contents of a problem file, without solving it.
#include <string>
#include <vector>

#include <fmt/format.h>

#include "pictures/vtu/structure_grid.hpp"
#include "problems/structure/model/structure.hpp"
#include "run/command/command_run.hpp"
#include "run/command/problem_input.hpp"
#include "run/command/subcommand.hpp"
#include "run/output/values.hpp"
#include "run/pictures/structure_json.hpp"
#include "run/report/problem_page.hpp"
#include "run/results/result_reader.hpp"
#include "run/show/structure_summary.hpp"

namespace kusabi::run {
namespace {

// @param file its name in the call
ResultReader unsolved_result(const problems::Structure& structure, const std::string& file) {
  auto contact = ResultJson::array();
  const std::vector<double> none(static_cast<std::size_t>(structure.dimension));
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    const auto& each = structure.contact[i];
    ResultJson json{{"node", problems::candidate_name(structure, i)},
                    {"n", numbers(each.normal)},
                    {"t1", none},
                    {"friction", each.friction}};
    if (structure.dimension == 3) json["t2"] = none;
    contact.push_back(std::move(json));
  }
  ResultJson problem{
      {"file", file},
      {"name", structure.name},
      {"d", structure.dimension},
      {"units", {{"length", structure.units.length}, {"force", structure.units.force}}}};
  if (!contact.empty()) problem["contact"] = std::move(contact);
  problem["structure"] = structure_json(structure);
  return {
      ResultJson{
          {"command", "show"}, {"problem", std::move(problem)}, {"result", ResultJson::object()}},
      file};
}

class Show final : public Subcommand {
 public:
  void describe(OptionTable& table) override {
    table.problem(input_.file);
    table.further_output(
        "--vtu",
        "VTU picture of the structure for ParaView, with supports, normals, candidates and loads");
    table.further_output("--html", "HTML page of the structure, without an analysis");
    table.quiet_and_serial();
  }
  void read(CommandRun& run) override { input_.read(run); }
  void prepare(CommandRun& run) override { structure_ = input_.structure(run); }
  void search(CommandRun& /*run*/) override {}
  std::vector<Step> results(CommandRun& run) override {
    return {run.file("--vtu",
                     [this](std::ostream& out) {
                       auto grid = pictures::unsolved_grid(structure_);
                       grid.remark = fmt::format("{}; {} and {}", structure_->name,
                                                 structure_->units.length, structure_->units.force);
                       write_vtu(out, grid);
                     }),
            run.file("--html",
                     [this](std::ostream& out) {
                       out << problem_page(unsolved_result(structure_, input_.file),
                                           structure_summary(structure_), structure_->warnings);
                     }),
            run.answer([this] { return structure_summary(structure_); })};
  }

 private:
  ProblemInput input_;
  problems::CheckedStructure structure_;
};

}  // namespace

constexpr Registration show_subcommand{
    {.name = "show",
     .chapter = "Summaries, pictures and reports",
     .purpose = "summary of a problem file, without an analysis",
     .description = "Summary of a problem file: sizes, bodies, surfaces "
                    "that touch, coincident nodes, loads, and the expected "
                    "cost of an analysis.",
     .example = "examples/space-truss.toml"},
    make<Show>};

}  // namespace kusabi::run
