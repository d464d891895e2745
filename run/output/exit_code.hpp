// What the command's exit code means.
#pragma once

namespace kusabi::run {

enum ExitCode : int {
  solved = 0,         ///< the whole question is answered ("none" is an answer)
  failed = 1,         ///< the run failed
  wrong_input = 2,    ///< the input or the call is wrong
  stopped_early = 3,  ///< stopped at a limit, with a valid partial answer
};

}  // namespace kusabi::run
