// Times of progress lines, and their destination.
#include "run/session/progress_line.hpp"

#include <cstdio>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "engine/signals.hpp"
#include "run/output/standard_output.hpp"

namespace kusabi::run {
namespace {

// In seconds. Idle ranks cause bursts of reductions; estimates need some distance in time.
constexpr double sample_interval = 0.1;
constexpr double bar_interval = 0.2;
constexpr unsigned long rows_per_page = 30;

// Queried each time, since windows change. The last column stays free, since some terminals begin a
// new line after it.
std::size_t terminal_width() {
  constexpr std::size_t usual = 80;
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return usual - 1;
  return size.ws_col - 1U;
}

}  // namespace

ProgressLine::ProgressLine(engine::Goal goal, const ShownObjective& shown)
    : terminal_(isatty(STDERR_FILENO) != 0),
      next_line_(terminal_ ? bar_interval : row_interval(0)) {
  state_.has_objective = goal == engine::Goal::best;
  state_.shown = shown;
}

ProgressLine::~ProgressLine() {
  if (bar_shown_) print_message("\r\033[K");  // the result follows
}

void ProgressLine::show(const engine::Progress& progress) {
  const double opened = static_cast<double>(progress.opened);
  if (progress.seconds >= next_sample_) {
    next_sample_ = progress.seconds + sample_interval;
    remaining_.observe(progress.seconds, progress.closed);
    if (shown_opened_ < 0) {  // a resumed search has opened nodes before
      shown_opened_ = opened;
      shown_seconds_ = progress.seconds;
    }
  }
  if (progress.seconds < next_line_) return;
  const double elapsed = progress.seconds - shown_seconds_;
  if (elapsed > 0) state_.nodes_per_second = (opened - shown_opened_) / elapsed;
  shown_opened_ = opened;
  shown_seconds_ = progress.seconds;
  state_.progress = progress;
  state_.remaining = remaining_.seconds();
  next_line_ = progress.seconds + (terminal_ ? bar_interval : row_interval(progress.seconds));
  terminal_ ? show_bar() : show_row();
  std::fflush(stderr);
}

void ProgressLine::show_bar() {
  bar_shown_ = true;
  print_message("\r\033[K{}", progress_bar(state_, terminal_width()));
}

void ProgressLine::show_row() {
  if (rows_++ % rows_per_page == 0) {
    print_message("{}\n", progress_header(state_.has_objective));
  }
  print_message("{}\n", progress_row(state_));
}

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
