// The bar and the table row.
#include "run/progress_line.hpp"

#include <cstdio>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

namespace kusabi::run {
namespace {

// In seconds: short searches should not flicker, long ones not fill the log.
constexpr double bar_interval = 0.2;
constexpr double row_interval = 2.0;
constexpr unsigned long rows_a_page = 30;

std::string bar(double share) {
  constexpr int width = 24;
  const auto full = static_cast<int>(share * width);
  return fmt::format("[{:#<{}}{:.<{}}]", "", full, "", width - full);
}

}  // namespace

ProgressLine::ProgressLine()
    : terminal_(isatty(STDERR_FILENO) != 0), next_(terminal_ ? bar_interval : row_interval) {}

ProgressLine::~ProgressLine() {
  if (bar_shown_) fmt::print(stderr, "\r\033[K");  // the result follows; the bar has done its work
}

void ProgressLine::show(const engine::Progress& progress) {
  if (progress.seconds < next_) return;
  next_ = progress.seconds + (terminal_ ? bar_interval : row_interval);
  terminal_ ? show_bar(progress) : show_row(progress);
  std::fflush(stderr);
}

void ProgressLine::show_bar(const engine::Progress& progress) {
  bar_shown_ = true;
  fmt::print(stderr, "\r\033[K{} {:5.1f} %  {} found  {} nodes  {} open  {:.0f} s",
             bar(progress.closed), 100 * progress.closed, progress.found, progress.opened,
             progress.open, progress.seconds);
}

void ProgressLine::show_row(const engine::Progress& progress) {
  if (rows_++ % rows_a_page == 0) {
    fmt::print(stderr, "{:>8} {:>12} {:>8} {:>8} {:>6} {:>8}\n", "time", "nodes", "open", "found",
               "idle", "done");
  }
  fmt::print(stderr, "{:>6.0f} s {:>12} {:>8} {:>8} {:>6} {:>6.1f} %\n", progress.seconds,
             progress.opened, progress.open, progress.found, progress.idle, 100 * progress.closed);
}

}  // namespace kusabi::run
