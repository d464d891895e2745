// End of a run: its exit code, and its status in result files.
#pragma once

#include <string>

#include "answer/exit_code.hpp"
#include "answer/verdict.hpp"

namespace kusabi::answer {

/// True if nothing that was requested is open.
bool is_answered(const Verdict& verdict);

ExitCode exit_code(const Verdict& verdict);

/// The key `status`: "solved", the limit that ended the search, or, for loads, "not-carried" or
/// "open".
std::string status_text(const Verdict& verdict);

}  // namespace kusabi::answer
