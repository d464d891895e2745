// Matrices of the wedged problem, in the units of the problem file.
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "problems/files/matrices/matrix_market.hpp"
#include "problems/wedged/free_stiffness.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/command/command_run.hpp"
#include "run/command/registrations.hpp"
#include "run/export/exported_file.hpp"
#include "run/output/values.hpp"
#include "run/wedged/contact_problem.hpp"

namespace kusabi::run {
namespace {

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
