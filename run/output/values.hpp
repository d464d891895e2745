// Text of values: names of states, numbers in JSON, counts in sentences.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/statistics.hpp"
#include "support/exact_count.hpp"

namespace kusabi::run {

/// Name in the result file: "solved", "time-limit", ...
const char* status_name(engine::Status status);

/// null for an infinite or absent number, since JSON has no infinity.
nlohmann::ordered_json number_or_null(std::optional<double> value);

/// One line of JSON, without a line end. Bytes that are not UTF-8 (in file names) become U+FFFD.
std::string json_line(const nlohmann::ordered_json& json);

/// A fingerprint in 16 hexadecimal digits.
std::string hexadecimal(std::uint64_t fingerprint);

/// "1 rank", "2 ranks".
std::string counted(std::uint64_t count, std::string_view thing);
std::string counted(const support::ExactCount& count, std::string_view thing);

/// Suffix of a friction coefficient.
/// @param factor true if it multiplies the coefficient of each candidate; otherwise the suffix is
///   empty
constexpr const char* of_each_candidate(bool factor) {
  return factor ? " times that of each candidate" : "";
}

/// A number if every JSON reader has it exactly, otherwise a string of decimal digits, with its
/// logarithm in KEY_log10.
void add_count(nlohmann::ordered_json& json, const std::string& key,
               const support::ExactCount& count);

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
