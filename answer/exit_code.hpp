// Exit codes of the command.
#pragma once

namespace kusabi::answer {

enum ExitCode : int {
  solved = 0,         ///< everything requested is answered ("none" is an answer)
  failed = 1,         ///< the run failed
  wrong_input = 2,    ///< the input or the call is invalid
  stopped_early = 3,  ///< stopped at a limit, or partly undecided, with a valid partial answer
};

}  // namespace kusabi::answer
