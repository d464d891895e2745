// One progress line per search, one line of text for each stage between searches.
#include "run/session/analysis_options.hpp"

#include <memory>
#include <string>

#include "engine/signals.hpp"
#include "run/output/standard_output.hpp"
#include "run/session/progress_line.hpp"

namespace kusabi::run {

engine::AnalysisOptions analysis_options(const engine::Limits& limits, bool quiet) {
  engine::install_signal_handlers();
  engine::AnalysisOptions result;
  result.limits = limits;
  result.interrupt = engine::asked_by_signal;
  if (quiet) return result;
  result.watch = [](engine::Goal goal, const engine::ShownObjective& shown) {
    const auto line = std::make_shared<ProgressLine>(goal, shown);
    return [line](const engine::Progress& progress) { line->show(progress); };
  };
  result.say = [](const std::string& text) { print_message("{}\n", text); };
  return result;
}

}  // namespace kusabi::run
