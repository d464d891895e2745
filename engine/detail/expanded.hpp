// Expanded: the result of expanding one node, as bytes, for the comparison of two expansions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/wire.hpp"

namespace kusabi::engine {

/// Children with their bounds, and solutions, in the order in which `expand` reported them.
struct Expanded {
  struct Child {
    Bytes node;
    double bound = 0;
  };
  std::vector<Child> children;
  std::vector<Bytes> solutions;
};

/// First difference between two expansions of a node; nothing if they are equal.
std::optional<std::string> difference(const Expanded& first, const Expanded& second);

}  // namespace kusabi::engine
