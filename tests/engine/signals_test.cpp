// Tests of signals as stop requests, in a process of their own: some effects last until it ends.
#include "engine/signals.hpp"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace kusabi::engine {
namespace {

/// Exit code of a child that waits for a request: 0 if it comes before its last signal, SIGALRM.
/// @param under_mpirun whether the child takes its parent for the mpirun of Open MPI
/// @param send sends signals to the child, which has its handlers
template <class Send>
int end_of_child(bool under_mpirun, Send send) {
  std::array<int, 2> ready{};
  EXPECT_EQ(pipe(ready.data()), 0);
  const pid_t child = fork();
  if (child == 0) {
    if (under_mpirun) setenv("OMPI_COMM_WORLD_SIZE", "1", 1);
    static volatile std::sig_atomic_t last = 0;
    std::signal(SIGALRM, [](int) { last = 1; });
    install_signal_handlers();
    if (write(ready[1], "x", 1) != 1) _exit(2);
    while (!end_asked_by_signal() && last == 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    _exit(end_asked_by_signal() ? 0 : 1);
  }
  char letter = 0;
  EXPECT_EQ(read(ready[0], &letter, 1), 1);
  send(child);
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  close(ready[0]);
  close(ready[1]);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Signals, ThatEndAJobRequestAStop) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR2})
    EXPECT_EQ(end_of_child(false, [&](pid_t child) { kill(child, signal); }), 0) << signal;
}

TEST(Signals, OfTheLauncherRequestAStopOneSignalEarlier) {
  EXPECT_EQ(end_of_child(true, [](pid_t child) { kill(child, SIGCONT); }), 0);
}

TEST(Signals, ThatContinueAJobRequestNoStop) {
  const auto shell_continues = [](pid_t child) {
    kill(child, SIGCONT);
    kill(child, SIGALRM);
  };
  EXPECT_EQ(end_of_child(false, shell_continues), 1);
  const auto queue_continues = [](pid_t child) {
    const pid_t other = fork();
    if (other == 0) _exit(kill(child, SIGCONT));
    waitpid(other, nullptr, 0);
    kill(child, SIGALRM);
  };
  EXPECT_EQ(end_of_child(true, queue_continues), 1);
}

}  // namespace
}  // namespace kusabi::engine
