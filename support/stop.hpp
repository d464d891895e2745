// Stop: a callback that ends long computations, which then need no clock or signal handler. The
// result of a completed computation must not depend on the calls.
#pragma once

#include <functional>

namespace kusabi::support {

/// True: end soon with the result so far. Empty: never. It may be called often, and by each rank
/// separately; once true it should stay true.
using Stop = std::function<bool()>;

inline bool asked(const Stop& stop) {
  return stop && stop();
}

}  // namespace kusabi::support
