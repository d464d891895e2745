// The end of a command: each file in its place, then the answer printed. A step that fails (the
// disk is full, nobody reads) must not keep the others from saving what they can.
#pragma once

#include <functional>
#include <vector>

namespace kusabi::run {

/// Does all of `steps` in their order, also after one has failed, and then throws what the first
/// that failed has thrown; what the others say goes to standard error.
/// @throws std::runtime_error, say
void do_all(const std::vector<std::function<void()>>& steps);

}  // namespace kusabi::run
