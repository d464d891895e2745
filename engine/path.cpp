// Text form of a path.
#include "engine/path.hpp"

#include <span>

namespace kusabi::engine {
namespace {

std::string joined(std::span<const std::uint32_t> branches) {
  std::string text;
  for (const auto branch : branches) {
    if (!text.empty()) text += '.';
    text += std::to_string(branch);
  }
  return text;
}

}  // namespace

std::string to_string(const Path& path) {
  constexpr std::size_t longest = 64;
  constexpr std::size_t end = 16;
  const std::span<const std::uint32_t> branches(path);
  if (path.empty()) return "root";
  if (path.size() <= longest) return joined(branches);
  return joined(branches.first(end)) + "...(" + std::to_string(path.size() - 2 * end) +
         " more)..." + joined(branches.last(end));
}

}  // namespace kusabi::engine
