// Signal handlers, which only set a flag; the search reads it at its next reduction.
#include "engine/signals.hpp"

#include <csignal>

namespace kusabi::engine {
namespace {

volatile std::sig_atomic_t stop_asked = 0;
volatile std::sig_atomic_t checkpoint_asked = 0;

extern "C" void note_stop(int signal) {
  stop_asked = 1;
  if (signal == SIGINT) std::signal(SIGINT, SIG_DFL);
}

extern "C" void note_checkpoint(int /*signal*/) {
  checkpoint_asked = 1;
}

}  // namespace

void heed_signals() {
  std::signal(SIGINT, &note_stop);
  std::signal(SIGTERM, &note_stop);
  // SIGHUP means that the terminal is closed. Under nohup it is ignored and stays so.
  if (std::signal(SIGHUP, &note_stop) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  std::signal(SIGUSR1, &note_checkpoint);
}

bool end_asked_by_signal() {
  return stop_asked != 0;
}

Interrupt asked_by_signal() {
  if (end_asked_by_signal()) return Interrupt::stop;
  if (checkpoint_asked == 0) return Interrupt::none;
  checkpoint_asked = 0;
  return Interrupt::checkpoint;
}

}  // namespace kusabi::engine
