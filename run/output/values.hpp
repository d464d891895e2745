// How values look wherever they are shown: the names of states, numbers in JSON, counted things in
// sentences.
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

/// As the result file calls it: "solved", "time-limit", ...
const char* status_name(engine::Status status);

/// JSON has no infinity: null, as if there were no number.
nlohmann::ordered_json number_or_null(std::optional<double> value);

/// A fingerprint, in 16 digits.
std::string hexadecimal(std::uint64_t fingerprint);

/// "1 rank", "2 ranks".
std::string counted(std::uint64_t count, std::string_view thing);
std::string counted(const support::ExactCount& count, std::string_view thing);

/// A number where every reader has it exactly, else its decimal digits as a string; then KEY_log10
/// has its size.
void add_count(nlohmann::ordered_json& json, const std::string& key,
               const support::ExactCount& count);

/// The numbers of a vector, in its order.
template <class Vector>
std::vector<double> numbers(const Vector& vector) {
  return {vector.begin(), vector.end()};
}

/// The counts of a tally (engine::Counts) by their names; of other things than counts nothing.
template <class Tally>
nlohmann::ordered_json counts_json(const Tally& tally) {
  auto json = nlohmann::ordered_json::object();
  tally.each([&](const char* name, const auto& value) {
    if constexpr (std::is_integral_v<std::remove_cvref_t<decltype(value)>>) json[name] = value;
  });
  return json;
}

}  // namespace kusabi::run
