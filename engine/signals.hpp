// What a signal asks of a running search: an end with everything kept, or a checkpoint.
#pragma once

#include "engine/options.hpp"

namespace kusabi::engine {

/// From now on SIGINT, SIGTERM and SIGHUP (unless nohup has it ignored) ask for an end (a second
/// SIGINT ends the process at once), and
/// SIGUSR1, which batch systems send before the time is up, asks for a checkpoint.
void heed_signals();

/// Whether an end has been asked for.
bool end_asked_by_signal();

/// What has been asked for; a checkpoint is told once. Fits Options::interrupt.
Interrupt asked_by_signal();

}  // namespace kusabi::engine
