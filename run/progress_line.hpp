// What a person sees while a search runs, on standard error: a bar that moves on a terminal, one
// line an interval elsewhere, nothing if the search ends at once.
#pragma once

#include "engine/options.hpp"

namespace kusabi::run {

class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  void show(const engine::Progress& progress);

 private:
  void show_bar(const engine::Progress& progress);
  void show_row(const engine::Progress& progress);

  bool terminal_;
  double next_;
  unsigned long rows_ = 0;
  bool bar_shown_ = false;
};

}  // namespace kusabi::run
