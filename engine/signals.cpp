// Signal handlers, which only set a flag; the search reads it at its next reduction.
#include "engine/signals.hpp"

#include <csignal>
#include <cstdlib>

#include <unistd.h>

namespace kusabi::engine {
namespace {

volatile std::sig_atomic_t stop_asked = 0;
volatile std::sig_atomic_t checkpoint_asked = 0;
volatile pid_t launcher = 0;

extern "C" void note_stop(int signal) {
  stop_asked = 1;
  if (signal == SIGINT) std::signal(SIGINT, SIG_DFL);
}

extern "C" void note_checkpoint(int /*signal*/) {
  checkpoint_asked = 1;
}

extern "C" void note_continued(int /*signal*/, siginfo_t* info, void* /*context*/) {
  if (info->si_pid == launcher) stop_asked = 1;
}

// The mpirun of Open MPI ends its ranks by SIGCONT, then, each after the pause of
// odls_base_sigkill_timeout, SIGTERM and SIGKILL. The first one leaves twice the time to write.
void install_launcher_handler() {
  if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr) return;
  launcher = getppid();
  struct sigaction action {};
  action.sa_sigaction = &note_continued;
  action.sa_flags = SA_SIGINFO | SA_RESTART;
  sigaction(SIGCONT, &action, nullptr);
}

}  // namespace

void install_signal_handlers() {
  install_launcher_handler();
  std::signal(SIGINT, &note_stop);
  for (const int signal : {SIGTERM, SIGXCPU, SIGUSR2}) std::signal(signal, &note_stop);
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
