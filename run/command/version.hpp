// Text of `kusabi --version`: everything that results may depend on.
#pragma once

#include <string>

namespace kusabi::run {

/// The first line is "kusabi VERSION"; commit, MPI library, compiler and libraries follow, one per
/// line.
std::string version();

}  // namespace kusabi::run
