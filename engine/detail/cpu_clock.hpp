// CPU time of this thread, for recordings of trees: it does not count the time in which others had
// the core.
#pragma once

#include <ctime>

namespace kusabi::engine {

/// CPU time of this thread since its start, in seconds.
inline double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace kusabi::engine
