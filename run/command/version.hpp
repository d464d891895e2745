// Text of `kusabi --version`: everything that results may depend on.
#pragma once

#include <string>
#include <string_view>

namespace kusabi::run {

/// The first line is "kusabi VERSION"; commit, MPI library, compiler and libraries follow, one per
/// line.
std::string version();

/// Date of this version in CITATION.cff: "2026-11-25".
std::string_view release_date();

}  // namespace kusabi::run
