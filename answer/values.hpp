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

}  // namespace kusabi::answer
