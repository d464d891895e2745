// Lines of a recorded tree: depth and CPU time of each node in depth-first order (Options::record),
// for `kusabi bench scaling --trace`.
#pragma once

#include <cmath>
#include <cstddef>
#include <ostream>
#include <string_view>

namespace kusabi::engine {

inline constexpr const char* node_record_header =
    "# depth, nanoseconds: the nodes in depth-first order\n";

/// Last line of the record of a search that ended early.
inline constexpr std::string_view incomplete_record =
    "# the search ended early: the nodes above are a part of the tree";

inline void write_node_record(std::ostream& out, std::size_t depth, double seconds) {
  out << depth << ' ' << std::llround(1e9 * seconds) << '\n';
}

}  // namespace kusabi::engine
