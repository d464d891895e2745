// Keys `density` and `expansion`.
#include "problems/files/draft/body_properties.hpp"

#include <string_view>

#include <fmt/format.h>

namespace kusabi::problems {
namespace {

constexpr double largest_property = 1e50;

double property(const TomlReader& reader, const TomlTable& group, std::string_view key) {
  const toml::node* entry = group.table->get(key);
  if (entry == nullptr) return 0;
  const double value = reader.number(*entry, key);
  if (!(value >= 0 && value <= largest_property))
    reader.fail(*entry, fmt::format("{} is {:g}; expected 0 or a positive number", key, value));
  return value;
}

}  // namespace

std::pair<double, double> body_properties(const TomlReader& reader, const TomlTable& group) {
  return {property(reader, group, "density"), property(reader, group, "expansion")};
}

}  // namespace kusabi::problems
