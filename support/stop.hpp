// "Should this end now?", asked by long work that knows nothing of clocks and signals. A stop may
// only end work; what a completed run gives must not depend on when it was asked.
#pragma once

#include <functional>

namespace kusabi::support {

/// True: end soon, with what holds so far. Empty: never. It may be asked often, and by each rank
/// for itself; once it is true it should stay so.
using Stop = std::function<bool()>;

inline bool asked(const Stop& stop) {
  return stop && stop();
}

}  // namespace kusabi::support
