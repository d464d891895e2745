// Lines of a recorded tree: depth and CPU time of each node in depth-first order (Options::record),
// for `kusabi bench scaling --trace`.
#pragma once

#include <cmath>
#include <cstddef>
#include <ostream>

namespace kusabi::engine {

inline constexpr const char* node_record_header =
    "# depth, nanoseconds: the nodes in depth-first order\n";

inline void write_node_record(std::ostream& out, std::size_t depth, double seconds) {
  out << depth << ' ' << std::llround(1e9 * seconds) << '\n';
}

}  // namespace kusabi::engine
