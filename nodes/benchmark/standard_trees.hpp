// Named trees of the Unbalanced Tree Search benchmark and their published counts.
#pragma once

#include <span>
#include <string_view>

#include "nodes/benchmark/unbalanced_tree.hpp"

namespace kusabi::benchmark {

struct StandardTree {
  std::string_view name;
  TreeParameters parameters;
  TreeCounts counts;
};

/// T1 to T5 and the larger T1L to T3L and T1XL with their published counts; before them T1
/// truncated at depth 4, 6 and 7 (T1-4, ...) for tests, counted by an independent program.
std::span<const StandardTree> standard_trees();

/// The tree of this name. @throws std::out_of_range if there is none
const StandardTree& standard_tree(std::string_view name);

}  // namespace kusabi::benchmark
