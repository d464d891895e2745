// Expanded: the result of expanding one node, as bytes, for the comparison of two expansions; and
// the exceptions of expansions.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/path.hpp"
#include "engine/wire.hpp"

namespace kusabi::engine {

/// An exception thrown by `expand`, nested, with the path of the node.
class ExpansionFailed : public std::runtime_error {
 public:
  ExpansionFailed(const Path& path, const std::string& reason)
      : std::runtime_error("node " + to_string(path) + ": " + reason) {}
};

/// Two expansions of a node that differ (Options::check_expand).
class ExpansionDiffers : public std::logic_error {
 public:
  ExpansionDiffers(const Path& path, const std::string& what)
      : std::logic_error("node " + to_string(path) + ": opened twice, " + what +
                         "; expected that expand depends on the node alone") {}
};

/// Throws ExpansionFailed with the exception that is being handled. @param path of the node
[[noreturn]] void rethrow_from_expand(const Path& path);

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
