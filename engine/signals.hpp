// Signals as requests to a running search: a stop with everything saved, or a checkpoint.
#pragma once

#include "engine/options.hpp"

namespace kusabi::engine {

/// Installs the handlers. SIGINT, SIGTERM and SIGHUP (unless ignored, as under nohup) request a
/// stop; a second SIGINT ends the process at once. SIGUSR1, which batch systems send before the
/// time is up, requests a checkpoint.
void heed_signals();

/// True if a stop was requested.
bool end_asked_by_signal();

/// The pending request; a checkpoint is reported once. Suitable as Options::interrupt.
Interrupt asked_by_signal();

}  // namespace kusabi::engine
