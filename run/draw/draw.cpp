// `kusabi draw RESULT`: answers of a result file as an SVG image.
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "run/command/command_run.hpp"
#include "run/command/subcommand.hpp"
#include "run/output/wrong_input.hpp"
#include "run/results/hold_chart.hpp"
#include "run/results/result_reader.hpp"
#include "run/results/result_scenes.hpp"
#include "run/results/sweep_result.hpp"

namespace kusabi::run {
namespace {

class Draw final : public Subcommand {
 public:
  void describe(OptionTable& table) override {
    table.result(file_);
    table.output("SVG file. Default: standard output");
    table.number("--pattern", &pattern_, above(0),
                 "number of the pattern, ray, state or motion to draw in detail; for a result of "
                 "kusabi limit, 1 is the nominal load and 2 the worst case or the worst loss");
    table.quiet_and_serial();
  }
  void read(CommandRun& run) override { text_ = result_text(run.session(), file_); }
  void prepare(CommandRun& /*run*/) override {
    const ResultReader reader(text_, file_);
    if (is_sweep(reader) || is_charted_hold(reader)) {
      take_chart(reader);
    } else {
      take_scenes(reader);
    }
  }
  void search(CommandRun& /*run*/) override {}
  std::vector<Step> results(CommandRun& run) override {
    if (run.wants("--output"))
      return {run.file("--output", [this](std::ostream& out) { write(out); })};
    std::ostringstream text;
    write(text);
    return {CommandRun::print(text.str())};
  }

 private:
  void take_chart(const ResultReader& reader) {
    if (pattern_ > 0) {
      throw WrongInput(fmt::format(
          "--pattern {}: the picture of {} is one chart; expected no --pattern", pattern_, file_));
    }
    chart_ = is_sweep(reader) ? sweep_chart(reader, reader.sentence())
                              : hold_chart(reader, reader.sentence());
    if (!chart_)
      throw WrongInput(fmt::format(
          "{}: has no results that could be drawn; expected a result with at least one", file_));
  }

  void take_scenes(const ResultReader& reader) {
    drawn_ = result_scenes(
        reader, file_,
        pattern_ > 0 ? SceneChoice{pattern_ - 1, 1} : SceneChoice{0, pictures::max_per_sheet});
    const auto count = drawn_.count;
    if (pattern_ > count) {
      throw WrongInput(fmt::format("--pattern {}: expected 1 to {}, the {} of {}", pattern_, count,
                                   drawn_.things, file_));
    }
    if (pattern_ == 0 && count > pictures::max_per_sheet) {
      drawn_.picture.lines.push_back(
          fmt::format("the first {} of them; --pattern N draws any", pictures::max_per_sheet));
    }
  }

  void write(std::ostream& out) const {
    const auto& scenes = drawn_.scenes;
    if (chart_) {
      write_chart(out, *chart_);
    } else if (scenes.size() == 1) {
      write_svg(out, drawn_.picture, scenes.front());
    } else {
      write_sheet(out, drawn_.picture, scenes);
    }
  }

  std::string file_;
  std::uint64_t pattern_ = 0;  // 0: all
  std::string text_;
  ResultScenes drawn_;
  std::optional<pictures::Chart> chart_;  // for a sweep or loads that are held
};

}  // namespace

constexpr Registration draw_subcommand{
    {.name = "draw",
     .chapter = "Summaries, pictures and reports",
     .purpose = "picture of the results in a file, as SVG",
     .description = "A picture of one result in detail, or of all results in a file, as SVG.",
     .example = "result.json --output answers.svg"},
    make<Draw>};

}  // namespace kusabi::run
