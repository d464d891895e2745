// `kusabi report RESULT`: a result file as a self-contained HTML page.
#include <ostream>
#include <string>
#include <vector>

#include "run/command/command_run.hpp"
#include "run/command/subcommand.hpp"
#include "run/report/page/page.hpp"
#include "run/results/result_reader.hpp"

namespace kusabi::run {
namespace {

class Report final : public Subcommand {
 public:
  void describe(OptionTable& table) override {
    table.result(file_);
    table.output("HTML file. Default: standard output");
    table.quiet_and_serial();
  }
  void read(CommandRun& run) override { text_ = result_text(run.session(), file_); }
  void prepare(CommandRun& /*run*/) override { page_ = report_page(ResultReader(text_, file_)); }
  void search(CommandRun& /*run*/) override {}
  std::vector<Step> results(CommandRun& run) override {
    if (run.wants("--output"))
      return {run.file("--output", [this](std::ostream& out) { out << page_; })};
    return {CommandRun::print(page_)};
  }

 private:
  std::string file_;
  std::string text_;
  std::string page_;
};

}  // namespace

constexpr Registration report_subcommand{
    {.name = "report",
     .chapter = "Summaries, pictures and reports",
     .purpose = "HTML page of a result file",
     .description =
         "A self-contained HTML page of a result file, with conclusion, pictures and numbers.",
     .example = "result.json --output report.html"},
    make<Report>};

}  // namespace kusabi::run
