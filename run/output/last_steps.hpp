// Last steps of a command: files first, then the answer. A step that fails (disk full, closed pipe)
// does not keep the others from running.
#pragma once

#include <functional>
#include <vector>

namespace kusabi::run {

/// Runs all `steps` in order, even after an error, and then rethrows the first error; messages of
/// further errors go to standard error.
/// @throws the first error
void do_all(const std::vector<std::function<void()>>& steps);

}  // namespace kusabi::run
