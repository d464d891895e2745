// Problem file of two bars that share a reference load, simple enough for hand calculation.
#pragma once

#include <string>

namespace kusabi::limit {

/// A tip on a level bar with forces from -2 to 3 and an upright one from -5 to 5, with the
/// reference load (1, 1). @param more further sections of the file
inline std::string two_bars(const std::string& more) {
  return R"(name = "two bars"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
left = [0, 0]
top = [1, 1]
tip = [1, 0]
[[members]]
yield = { tension = 3, compression = 2 }
between = [["left", "tip"]]
[[members]]
yield = 5
between = [["top", "tip"]]
[[supports]]
nodes = ["left", "top"]
[[loads]]
kind = "reference"
nodes = ["tip"]
force = [1, 1]
)" + more;
}

}  // namespace kusabi::limit
