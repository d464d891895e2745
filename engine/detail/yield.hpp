// What one opening of a node yields, as bytes: whether two openings yield the same.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/wire.hpp"

namespace kusabi::engine {

/// Children, with their bounds, and solutions, in the order in which they were handed over.
struct Yield {
  struct Child {
    Bytes node;
    double bound = 0;
  };
  std::vector<Child> children;
  std::vector<Bytes> solutions;
};

/// What differs first between two openings of a node, if anything does.
std::optional<std::string> difference(const Yield& first, const Yield& second);

}  // namespace kusabi::engine
