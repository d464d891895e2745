// `kusabi show`: reads and checks a file, prints its sizes, draws it.
#include "run/show/show.hpp"

#include <string>
#include <vector>

#include <fmt/format.h>

#include "pictures/vtu/structure_grid.hpp"
#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"
#include "run/command/command_run.hpp"
#include "run/report/problem_page.hpp"
#include "run/session/kept_state.hpp"
#include "run/show/structure_summary.hpp"
#include "run/show/unsolved_result.hpp"

namespace kusabi::run {
namespace {

class Show final : public Subcommand {
 public:
  [[nodiscard]] std::string_view name() const override { return "show"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "summary of a problem file, without an analysis";
  }
  [[nodiscard]] std::string_view example() const override { return "examples/space-truss.toml"; }
  void describe(OptionTable& table) override {
    table.problem(file_);
    table.further_output(
        "--vtu",
        "VTU picture of the structure for ParaView, with supports, normals, candidates and loads");
    table.further_output("--html", "HTML page of the structure, before anything is solved");
    table.quiet();
    table.serial();
  }
  void read(CommandRun& run) override {
    text_ = run.session().from_first_rank([&] { return problems::problem_text(file_); });
  }
  void prepare(CommandRun& run) override {
    structure_ = problems::read_structure(text_, file_);
    warn_all(run.session(), structure_.warnings);
  }
  void search(CommandRun& /*run*/) override {}
  std::vector<Step> results(CommandRun& run) override {
    return {run.file("--vtu",
                     [this](std::ostream& out) {
                       auto grid = pictures::unsolved_grid(structure_);
                       grid.remark = fmt::format("{}; {} and {}", structure_.name,
                                                 structure_.units.length, structure_.units.force);
                       write_vtu(out, grid);
                     }),
            run.file("--html",
                     [this](std::ostream& out) {
                       out << problem_page(unsolved_result(structure_, file_),
                                           structure_summary(structure_), structure_.warnings);
                     }),
            run.answer([this] { return structure_summary(structure_); })};
  }

 private:
  std::string file_;
  problems::ProblemText text_;
  problems::Structure structure_;
};

}  // namespace

std::unique_ptr<Subcommand> show_subcommand() {
  return std::make_unique<Show>();
}

}  // namespace kusabi::run
