// Signals as requests to a running search: a stop with everything saved, or a checkpoint.
#pragma once

#include "engine/options.hpp"

namespace kusabi::engine {

/// Installs the handlers. SIGINT, SIGTERM, SIGHUP (unless ignored, as under nohup), SIGXCPU (limit
/// of CPU time) and SIGUSR2 request a stop, as does SIGCONT from the mpirun of Open MPI, by which
/// it begins to end its ranks; a second SIGINT ends the process at once. SIGUSR1 requests a
/// checkpoint.
void install_signal_handlers();

/// True if a stop was requested.
bool end_asked_by_signal();

/// The pending request; a checkpoint is reported once. Suitable as Options::interrupt.
Interrupt asked_by_signal();

}  // namespace kusabi::engine
