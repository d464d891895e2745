// Which file defaults come from, as the call has it.
#pragma once

#include <string>

namespace kusabi::run {

struct ConfigChoice {
  std::string file;   ///< of --config; empty: where one is looked for
  bool none = false;  ///< --no-config
};

}  // namespace kusabi::run
