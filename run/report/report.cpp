// `kusabi report`: reads the result, writes the page.
#include "run/report/report.hpp"

#include <ostream>
#include <string>
#include <vector>

#include "problems/files/structure_file.hpp"
#include "run/command/command_run.hpp"
#include "run/report/page.hpp"

namespace kusabi::run {
namespace {

class Report final : public Subcommand {
 public:
  [[nodiscard]] std::string_view name() const override { return "report"; }
  [[nodiscard]] std::string_view purpose() const override { return "HTML page of a result file"; }
  [[nodiscard]] std::string_view description() const override {
    return "A self-contained HTML page of a result file, with conclusion, pictures and numbers.";
  }
  [[nodiscard]] std::string_view example() const override {
    return "result.json --output report.html";
  }
  void describe(OptionTable& table) override {
    table.result(file_);
    table.output("HTML file; default: standard output");
    table.quiet();
    table.serial();
  }
  void read(CommandRun& run) override {
    text_ = run.session().from_first_rank(
        [&] { return problems::file_text(file_, "a result file in JSON", largest_result); });
  }
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

std::unique_ptr<Subcommand> report_subcommand() {
  return std::make_unique<Report>();
}

}  // namespace kusabi::run
