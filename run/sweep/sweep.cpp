// `kusabi sweep FILE --mu …`: number of sign patterns over the friction coefficient, also between
// the points; `kusabi sweep FILE --alpha …`: worst-case limit load over the uncertainty of loads.
// Options, and the choice between both.
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "answer/words.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "run/command/subcommand.hpp"
#include "run/output/wrong_input.hpp"
#include "run/results/result_reader.hpp"
#include "run/results/sweep_result.hpp"
#include "run/sweep/swept.hpp"

namespace kusabi::run {
namespace {

class Sweep final : public Subcommand {
 public:
  void describe(OptionTable& table) override;
  void check() const override;
  void read(CommandRun& run) override { options_.input.read(run); }
  void prepare(CommandRun& run) override;
  [[nodiscard]] std::string announcement(const std::string& ranks) const override {
    return swept_->announcement(ranks);
  }
  void search(CommandRun& run) override { swept_->search(run); }
  std::vector<Step> results(CommandRun& run) override;
  [[nodiscard]] answer::Verdict verdict() const override { return swept_->verdict(); }
  std::vector<std::string> remarks(CommandRun& run) override;

 private:
  SweepOptions options_;
  std::string csv_;
  std::string svg_;
  std::unique_ptr<Swept> swept_;
  std::optional<pictures::Chart> chart_;  // on rank 0
};

void Sweep::describe(OptionTable& table) {
  table.problem(options_.input.file);
  table.points("--mu", options_.mu, above(0),
               "friction coefficients: START:END:STEP, or a list with commas");
  table.number("--mu-max", &options_.mu_max, above(0),
               "largest friction coefficient; without --mu all steps up to it are listed");
  table.number("--width", &options_.width, above(0),
               "width of the bracket of the coefficient from which a pattern sticks");
  table
      .points(
          "--alpha", options_.alpha, at_least(0),
          "half-widths of the uncertain loads of a truss: START:END:STEP, or a list with commas")
      .unit("in the file's unit of force");
  table.load_case(options_.load_case).needs("--alpha");
  table.group_alpha(options_.group_alpha).needs("--alpha");
  table.output();
  table.file("--csv", csv_, Role::output, "CSV file of the points and the steps");
  table.file("--svg", svg_, Role::output, "chart of the points and the steps (SVG)");
  table
      .file(
          "--certificate", options_.certificates, Role::folder,
          "folder of certificates for kusabi verify: ALPHA.cert of each half-width, or MU.cert of "
          "the list of patterns at each point and at both ends of each step. A sweep of friction "
          "is then one with --prove")
      .ends_in({"/MU.cert"})
      .matters();
  table.search_limits(options_.limits);
  table.resume(options_.checkpoint);
  table.prove(options_.prove,
              "compare the numbers of patterns with lists whose nodes are tested in exact "
              "arithmetic, as kusabi verify does");
  table.quiet_and_serial();
}

void Sweep::check() const {
  const bool friction = !options_.mu.empty() || options_.mu_max;
  if (friction == !options_.alpha.empty()) {
    throw WrongInput(
        friction ? "--alpha: cannot be combined with a sweep of friction; expected --mu or --alpha"
                 : "the range of the sweep is missing; expected --mu, --mu-max or --alpha");
  }
  if (!friction) return;
  if (!options_.certificates.empty() && !options_.checkpoint.state.empty()) {
    throw WrongInput(
        "--certificate: a sweep of friction that is resumed has lost evidence; expected "
        "--certificate without --resume");
  }
  const auto& points = options_.mu;
  if (options_.mu_max && !points.empty() && points.back() > *options_.mu_max) {
    throw WrongInput(fmt::format("--mu-max {}: expected no less than the last point of --mu, {}",
                                 *options_.mu_max, points.back()));
  }
  const double maximum = options_.maximum();
  if (options_.width >= maximum || maximum > wedged::max_multiples * options_.width) {
    throw WrongInput(fmt::format("--width {}: expected a number below {} and above {}",
                                 options_.width, maximum, maximum / wedged::max_multiples));
  }
}

void Sweep::prepare(CommandRun& run) {
  swept_ = options_.alpha.empty() ? swept_friction(options_) : swept_loads(options_);
  swept_->prepare(run);
}

std::vector<Step> Sweep::results(CommandRun& run) {
  // Text and chart are made from the result file, as by later readers of it.
  const ResultReader result(swept_->json(run), "the result");
  std::vector<Step> steps{run.result([json = result.all()] { return json; }),
                          run.file("--csv", [this](std::ostream& out) { swept_->write_csv(out); })};
  steps.push_back(run.folder("--certificate",
                             [this](OutputFolder& folder) { swept_->write_certificates(folder); }));
  chart_ = sweep_chart(result, answer::headline(verdict()));
  if (chart_) {
    steps.push_back(run.file("--svg", [this](std::ostream& out) { write_chart(out, *chart_); }));
  }
  steps.push_back(run.answer([this] { return swept_->table(); }));
  return steps;
}

std::vector<std::string> Sweep::remarks(CommandRun& run) {
  std::vector<std::string> remarks;
  if (run.wants("--svg") && !chart_) {
    remarks.push_back(fmt::format("--svg: there are no results to draw; {} is unchanged", svg_));
  }
  return remarks;
}

}  // namespace

constexpr Registration sweep_subcommand{
    {.name = "sweep",
     .chapter = "Wedged configurations",
     .purpose = "patterns over friction, or limit load over uncertainty",
     .description =
         "The number of sign patterns as a function of the friction coefficient, or the "
         "worst-case limit load as a function of the load uncertainty, also between the points. "
         "Give --mu or --mu-max for friction, or --alpha for loads.",
     .example = "examples/two-bars.toml --mu 1.25:2.75:0.5"},
    make<Sweep>};

}  // namespace kusabi::run
