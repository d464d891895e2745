// What `kusabi --version` prints: all that an answer may depend on.
#pragma once

#include <string>

namespace kusabi::run {

/// The first line is "kusabi VERSION"; then commit, MPI library, compiler and libraries, a line
/// each.
std::string version();

}  // namespace kusabi::run
