// Progress of a search on standard error: a bar on a terminal, otherwise one line per interval;
// nothing for short searches. With it come the limits and signals that end an analysis.
#pragma once

#include "engine/analysis/analysis.hpp"
#include "engine/options.hpp"
#include "run/session/progress_text.hpp"

namespace kusabi::run {

class ProgressLine {
 public:
  explicit ProgressLine(engine::Goal goal, const ShownObjective& shown = {});
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  void show(const engine::Progress& progress);

 private:
  void show_bar();
  void show_row();

  bool terminal_;
  ProgressState state_;
  RemainingTime remaining_;
  double next_sample_ = 0;
  double next_line_;
  double shown_seconds_ = 0;
  double shown_opened_ = -1;  // -1: none yet
  unsigned long rows_ = 0;
  bool bar_shown_ = false;
};

/// Catches signals from here on. @param quiet no progress is shown
engine::AnalysisOptions analysis_options(const engine::Limits& limits, bool quiet);

}  // namespace kusabi::run
