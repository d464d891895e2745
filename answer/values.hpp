// Names of states, counts in sentences, numbers in JSON.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/statistics.hpp"
#include "support/bracket.hpp"
#include "support/exact_count.hpp"

namespace kusabi::answer {

/// Names in files, in the order of the enumeration.
constexpr std::array<std::string_view, 6> names_of(engine::Status /*type*/) {
  return {"solved", "time-limit", "node-limit", "solution-limit", "gap-limit", "interrupted"};
}

constexpr std::array<std::string_view, 2> names_of(support::Standing /*type*/) {
  return {"computed", "proved"};
}

/// An enumeration with `names_of(E)`, an array of the names of its values in their order.
template <class E>
concept HasNames = std::is_enum_v<E> && requires(E value) {
  names_of(value).at(0);
};

template <HasNames E>
constexpr std::string_view name_of(E value) {
  return names_of(E{}).at(static_cast<std::size_t>(value));
}

std::string status_name(engine::Status status);

/// null for an infinite or absent number, since JSON has no infinity.
nlohmann::ordered_json number_or_null(std::optional<double> value);

/// "1 rank", "2 ranks".
std::string counted(std::uint64_t count, std::string_view thing);
/// The same. @pre count >= 0
std::string counted(std::signed_integral auto count, std::string_view thing) {
  return counted(static_cast<std::uint64_t>(count), thing);
}
std::string counted(const support::ExactCount& count, std::string_view thing);

/// Name of the friction coefficient of a call.
/// @param factor true if it multiplies coefficients or factors that the file gives to its candidates
constexpr const char* friction_name(bool factor) {
  return factor ? "factor of the friction given in the file" : "friction coefficient";
}

/// "friction coefficient 0.3", "0.3 times the friction given in the file"; without "1 times".
std::string friction_words(std::string_view value, bool factor);
inline std::string friction_words(double value, bool factor) {
  return friction_words(fmt::format("{}", value), factor);
}

/// Where the name has been said: "0.3", "0.3 times".
std::string short_friction_words(std::string_view value, bool factor);

/// A number if every JSON reader has it exactly, otherwise a string of decimal digits, with its
/// logarithm in KEY_log10.
void add_count(nlohmann::ordered_json& json, const std::string& key,
               const support::ExactCount& count);

}  // namespace kusabi::answer
