// Values in files: lines of JSON, fingerprints, counts of a tally.
#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include <nlohmann/json.hpp>

namespace kusabi::run {

/// One line of JSON, without a line end. Bytes that are not UTF-8 (in file names) become U+FFFD.
std::string json_line(const nlohmann::ordered_json& json);

/// A fingerprint in 16 hexadecimal digits.
std::string hexadecimal(std::uint64_t fingerprint);

/// Elements of a vector, in order.
template <class Vector>
std::vector<double> numbers(const Vector& vector) {
  return {vector.begin(), vector.end()};
}

/// Counts of a tally (engine::Counts) by name; nothing for other tallies.
template <class Tally>
nlohmann::ordered_json counts_json(const Tally& tally) {
  auto json = nlohmann::ordered_json::object();
  tally.each([&](const char* name, const auto& value) {
    if constexpr (std::is_integral_v<std::remove_cvref_t<decltype(value)>>) json[name] = value;
  });
  return json;
}

}  // namespace kusabi::run
