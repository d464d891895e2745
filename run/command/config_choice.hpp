// File of default options, as named in the call.
#pragma once

#include <string>

namespace kusabi::run {

struct ConfigChoice {
  std::string file;   ///< of --config; empty: the default place
  bool none = false;  ///< --no-config
};

}  // namespace kusabi::run
