// What a person sees while a search runs, on standard error: a bar that moves on a terminal, one
// line an interval elsewhere, nothing if the search ends at once.
#pragma once

#include "engine/options.hpp"
#include "run/session/progress_text.hpp"
#include "run/session/remaining_time.hpp"

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
  double shown_opened_ = -1;  // -1: nothing seen yet
  unsigned long rows_ = 0;
  bool bar_shown_ = false;
};

}  // namespace kusabi::run
