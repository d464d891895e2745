// Comparison of two expansions of a node, and the exceptions of expansions.
#include "engine/detail/expanded.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <exception>
#include <iomanip>
#include <limits>
#include <sstream>

namespace kusabi::engine {
namespace {

std::string counts(const char* what, std::size_t first, std::size_t second) {
  return std::to_string(first) + ' ' + what + " the first time, " + std::to_string(second) +
         " the second time";
}

std::string precise(double value) {
  std::ostringstream text;
  text << std::setprecision(std::numeric_limits<double>::max_digits10) << value;
  return text.str();
}

}  // namespace

void rethrow_from_expand(const Path& path) {
  try {
    throw;
  } catch (const std::exception& error) {
    std::throw_with_nested(ExpansionFailed(path, error.what()));
  } catch (...) {
    std::throw_with_nested(ExpansionFailed(path, "an unknown exception"));
  }
}

std::optional<std::string> difference(const Expanded& first, const Expanded& second) {
  const auto children = std::min(first.children.size(), second.children.size());
  for (std::size_t i = 0; i < children; ++i) {
    const auto& one = first.children[i];
    const auto& other = second.children[i];
    if (one.node != other.node) return "child " + std::to_string(i) + " is not the same";
    if (std::bit_cast<std::uint64_t>(one.bound) != std::bit_cast<std::uint64_t>(other.bound)) {
      return "the bound of child " + std::to_string(i) + " is " + precise(one.bound) +
             " the first time, " + precise(other.bound) + " the second time";
    }
  }
  if (first.children.size() != second.children.size()) {
    return counts("children", first.children.size(), second.children.size());
  }
  const auto solutions = std::min(first.solutions.size(), second.solutions.size());
  for (std::size_t i = 0; i < solutions; ++i) {
    if (first.solutions[i] != second.solutions[i]) {
      return "solution " + std::to_string(i) + " is not the same";
    }
  }
  if (first.solutions.size() != second.solutions.size()) {
    return counts("solutions", first.solutions.size(), second.solutions.size());
  }
  return std::nullopt;
}

}  // namespace kusabi::engine
