// `kusabi hold`: options, stages and results, on all ranks.
#include "run/hold/hold.hpp"

#include <string>
#include <vector>

#include <fmt/format.h>

#include "problems/structure/model/load_cases.hpp"
#include "run/command/command_run.hpp"
#include "run/command/registrations.hpp"
#include "run/hold/hold_report.hpp"
#include "run/output/wrong_input.hpp"
#include "run/wedged/agreement.hpp"
#include "run/wedged/problem_summary.hpp"

namespace kusabi::run {
namespace {

class Hold final : public Subcommand {
 public:
  void describe(OptionTable& table) override;
  void read(CommandRun& run) override { options_.input.read(run); }
  void prepare(CommandRun& run) override;
  [[nodiscard]] std::string announcement(const std::string& ranks) const override;
  void search(CommandRun& run) override;
  std::vector<Step> results(CommandRun& run) override;
  [[nodiscard]] Verdict verdict() const override;

 private:
  void refuse_without_loads() const;

  HoldOptions options_;
  problems::CheckedStructure structure_;
  wedged::LoadedProblem loaded_;
  HoldFindings findings_;
};

void Hold::describe(OptionTable& table) {
  table.problem(options_.input.file);
  table.number("--mu", &options_.mu, at_least(0),
               "friction coefficient. Default: the smallest one for the dead load is computed");
  table.load_case(options_.load_case);
  table.number("--mu-max", &options_.question.most, above(0),
               "upper limit of the search for the smallest coefficient");
  table.output();
  table.search_limits(options_.limits);
  table.quiet_and_serial();
}

// Files without the requested load are refused.
void Hold::refuse_without_loads() const {
  const bool dead = loaded_.has_dead_part();
  if (dead || (options_.mu && loaded_.has_reference)) return;
  throw WrongInput(fmt::format(
      "{}: there is no {}; expected [[loads]] of kind \"dead\"{}, or a clearance of [[contact]]",
      options_.input.file, options_.mu ? "load" : "dead load",
      options_.mu ? " or \"reference\"" : ", or --mu for the factors of the reference load"));
}

void Hold::prepare(CommandRun& run) {
  structure_ = options_.input.structure(run);
  if (options_.load_case.empty() && !problems::load_cases(structure_).empty()) {
    throw WrongInput(
        fmt::format("{}: the file has load cases; expected --case with one of them: {}",
                    options_.input.file, problems::choice_of_load_cases(structure_)));
  }
  structure_ = problems::in_chosen_case(structure_, options_.load_case);
  loaded_ =
      run.within_limits([&](const auto& work) { return wedged::loaded_problem(structure_, work); });
  if (options_.mu) friction_at(loaded_.problem, *options_.mu, options_.input.file);
  refuse_without_loads();
  agree(run.session(), loaded_.problem);
}

std::string Hold::announcement(const std::string& ranks) const {
  const auto at = options_.mu
                      ? fmt::format("at friction coefficient {}", *options_.mu)
                      : fmt::format("up to a friction coefficient of {}", options_.question.most);
  return fmt::format("{}; {}; {}", problem_line(loaded_.problem), at, ranks);
}

void Hold::search(CommandRun& run) {
  engine::Analysis analysis(run.session().transport(), run.supervision(options_.limits));
  if (options_.mu)
    findings_.factors = wedged::held_factors(analysis, loaded_, *options_.mu, options_.question);
  else
    findings_.friction = wedged::holding_friction(analysis, loaded_, options_.question);
}

std::vector<Step> Hold::results(CommandRun& run) {
  return {run.result([this] { return hold_json(options_, structure_, loaded_, findings_); }),
          run.answer([this] { return hold_table(options_, loaded_, findings_); })};
}

Verdict Hold::verdict() const {
  return hold_verdict(options_, loaded_, findings_);
}

}  // namespace

constexpr Registration hold_subcommand{
    {.name = "hold",
     .chapter = "Loads held by friction",
     .purpose = "loads that contact with friction can hold",
     .description =
         "The smallest friction coefficient at which the structure can hold its dead load; with "
         "--mu, the factors of the reference load that it can hold in addition. With proved "
         "bounds.",
     .example = "examples/ladder.toml"},
    make<Hold>};

}  // namespace kusabi::run
