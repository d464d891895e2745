// Names of states.
#include "answer/values.hpp"

#include <cmath>

#include <fmt/format.h>

namespace kusabi::answer {

std::string friction_words(std::string_view value, bool factor) {
  if (factor && value == "1") return "the friction given in the file";
  return factor ? fmt::format("{} times the friction given in the file", value)
                : fmt::format("{} {}", friction_name(false), value);
}

std::string short_friction_words(std::string_view value, bool factor) {
  return fmt::format("{}{}", value, factor ? " times" : "");
}

std::string status_name(engine::Status status) {
  return std::string(name_of(status));
}

nlohmann::ordered_json number_or_null(std::optional<double> value) {
  if (value && std::isfinite(*value)) return *value;
  return nullptr;
}

std::string counted(std::uint64_t count, std::string_view thing) {
  return counted(support::ExactCount(count), thing);
}

std::string counted(const support::ExactCount& count, std::string_view thing) {
  return fmt::format("{} {}{}", count.text(), thing, count == 1U ? "" : "s");
}

void add_count(nlohmann::ordered_json& json, const std::string& key,
               const support::ExactCount& count) {
  if (const auto number = count.number()) {
    json[key] = *number;
    return;
  }
  json[key] = count.digits();
  json[key + "_log10"] = count.log10();
}

}  // namespace kusabi::answer
