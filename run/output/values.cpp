// Text of values.
#include "run/output/values.hpp"

#include <fmt/format.h>

namespace kusabi::run {

std::string json_line(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string hexadecimal(std::uint64_t fingerprint) {
  return fmt::format("{:016x}", fingerprint);
}

}  // namespace kusabi::run
