// `kusabi import DECK`: the problem file that a deck of Abaqus or CalculiX describes. The file is
// read again for the summary, or for the parts that it still needs.
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "problems/files/decks/deck_problem.hpp"
#include "problems/files/draft/mesh_file.hpp"
#include "problems/files/meshes/mesh_texts.hpp"
#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"
#include "run/command/command_run.hpp"
#include "run/command/subcommand.hpp"
#include "run/output/wrong_input.hpp"
#include "run/session/kept_state.hpp"
#include "run/show/structure_summary.hpp"
#include "support/input_error.hpp"

namespace kusabi::run {
namespace {

namespace fs = std::filesystem;

class Import final : public Subcommand {
 public:
  void describe(OptionTable& table) override {
    table_ = &table;
    table.file("file", file_, Role::input, "input deck (.inp)").required();
    table.output("problem file to write. Default: standard output");
    table.text("--units", units_, "LENGTH,FORCE",
               "units of length and force of the deck, such as "
               "mm,N; the deck does not contain them");
    table.number("--gap", &gap_, at_least(0),
                 "distance up to which a node of a contact pair or a tie touches the other "
                 "surface. Default: ADJUST and POSITION TOLERANCE of the deck");
    table.quiet_and_serial();
  }
  void check() const override {
    if (!problems::is_abaqus_file(file_))
      throw WrongInput(
          fmt::format("{}: not an input deck; expected a file name that ends in .inp", file_));
    const auto comma = units_.find(',');
    const bool two = comma != std::string::npos && comma > 0 && comma + 1 < units_.size();
    if (!units_.empty() && !two)
      throw WrongInput(fmt::format("--units {}: expected LENGTH,FORCE, such as mm,N", units_));
  }
  void read(CommandRun& run) override {
    deck_ = run.session().from_first_rank([&] { return problems::deck_text(file_); });
  }
  void prepare(CommandRun& run) override {
    const std::string name = fs::path(file_).filename().string();
    const auto mesh = problems::read_mesh_file({file_, deck_.meshes}, name);
    problems::DeckChoices choices;
    choices.file = seen_from_output(file_);
    choices.gap = gap_;
    if (const auto comma = units_.find(','); comma != std::string::npos) {
      choices.length = units_.substr(0, comma);
      choices.force = units_.substr(comma + 1);
    }
    problem_ = problems::deck_problem(mesh, choices);
    warn_all(run.session(), problem_.warnings);
    read_again(run);
  }
  void search(CommandRun& /*run*/) override {}
  std::vector<Step> results(CommandRun& run) override {
    if (!run.wants("--output")) return {CommandRun::print(problem_.text)};
    std::vector<Step> steps{
        run.file("--output", [this](std::ostream& out) { out << problem_.text; })};
    if (!summary_.empty()) steps.push_back(run.answer([this] { return summary_; }));
    return steps;
  }

 private:
  [[nodiscard]] std::string output() const {
    const OptionRow* row = table_->find("--output");
    return row == nullptr ? "" : row->given.value_or("");
  }
  /// A path, relative to the folder of the problem file.
  [[nodiscard]] std::string seen_from_output(const fs::path& path) const {
    // Folders that are links are followed, as ".." does.
    const auto folder_of = [](const fs::path& file) {
      return fs::weakly_canonical(fs::absolute(file).parent_path());
    };
    return (folder_of(path) / path.filename())
        .lexically_relative(folder_of(output().empty() ? "x" : output()));
  }
  /// Reads the problem file that is to be written. A fault is a warning: the file is written.
  void read_again(CommandRun& run) {
    problems::ProblemText text{problem_.text, {}};
    const auto folder = fs::path(file_).parent_path();
    for (auto& [place, bytes] : deck_.meshes)
      text.meshes.emplace(seen_from_output(folder / place), std::move(bytes));
    const std::string name = output().empty() ? "problem.toml" : output();
    try {
      summary_ = structure_summary(problems::read_structure(text, name));
    } catch (const support::InputError& error) {
      warn_all(run.session(), {fmt::format("the problem file needs editing: {}", error.what())});
    }
  }

  const OptionTable* table_ = nullptr;
  std::string file_;
  std::string units_;
  std::optional<double> gap_;
  problems::ProblemText deck_;
  problems::DeckProblem problem_;
  std::string summary_;
};

}  // namespace

constexpr Registration import_subcommand{
    {.name = "import",
     .chapter = "Files of other programs",
     .purpose = "problem file of an input deck of Abaqus or CalculiX",
     .description =
         "Writes the problem file that an input deck (.inp) of Abaqus or CalculiX describes: "
         "mesh, materials, supports, ties, contact candidates, and loads at nodes. Read and edit "
         "it before an analysis. Each keyword that is not understood is left out with a warning.",
     .example = "examples/wedge.inp --output wedge.toml"},
    make<Import>};

}  // namespace kusabi::run
