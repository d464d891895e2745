// Every access is checked, since the file may be invalid.
#include "run/results/result_reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "problems/files/structure_file.hpp"
#include "run/output/wrong_input.hpp"

namespace kusabi::run {
namespace {

/// Maximum size of a result file in bytes: ten thousand patterns of a hundred nodes take 70 MB.
constexpr std::uintmax_t largest_result = std::uintmax_t{1} << 30U;

/// Larger numbers do not occur in results; squares and their sums stay finite up to here.
constexpr double largest_number = 1e100;

}  // namespace

std::string result_text(Session& session, const std::string& file) {
  return session.from_first_rank(
      [&] { return problems::file_text(file, "a result file in JSON", largest_result); });
}

bool has_own_friction(const ResultReader& reader) {
  const auto& candidates = reader.list(reader.at(reader.all(), "problem"), "contact");
  return std::ranges::any_of(
      candidates, [&](const auto& each) { return reader.number(each, "friction") != 1; });
}

ResultReader::ResultReader(const std::string& text, std::string file) : file_(std::move(file)) {
  auto [json, too_deep] = parse_result(text);
  if (too_deep) refuse(fmt::format("is nested deeper than {}", deepest_result));
  json_ = std::move(json);
  if (!json_.is_object()) refuse("is not a JSON object");
}

void ResultReader::refuse(std::string_view what) const {
  throw WrongInput(fmt::format(
      "{}: {}; expected a result file of kusabi patterns, rays, critical, hold, limit or sweep",
      file_, what));
}

const ResultJson* ResultReader::find(const ResultJson& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() || found->is_null() ? nullptr : &*found;
}

const ResultJson& ResultReader::at(const ResultJson& object, const char* key) const {
  const auto* const found = find(object, key);
  if (found == nullptr) refuse(fmt::format("'{}' is missing", key));
  return *found;
}

std::string ResultReader::text(const ResultJson& object, const char* key) const {
  const auto& value = at(object, key);
  if (!value.is_string()) refuse(fmt::format("'{}' is not a text", key));
  return value.get<std::string>();
}

double ResultReader::number_of(const ResultJson& value, std::string_view name) const {
  if (!value.is_number() || !(std::abs(value.get<double>()) <= largest_number))
    refuse(fmt::format("{} is not a number up to {:g}", name, largest_number));
  return value.get<double>();
}

double ResultReader::number(const ResultJson& object, const char* key) const {
  return number_of(at(object, key), fmt::format("'{}'", key));
}

const ResultJson* ResultReader::bound_value(const ResultJson& bracket, const char* key) const {
  const auto* const found = find(bracket, key);
  if (found == nullptr) return nullptr;
  const auto& value = at(*found, "value");
  number_of(value, fmt::format("'{}'", key));
  return &value;
}

std::optional<double> ResultReader::bound(const ResultJson& bracket, const char* key) const {
  const auto* const value = bound_value(bracket, key);
  return value == nullptr ? std::nullopt : std::optional(value->get<double>());
}

support::ExactCount ResultReader::count(const ResultJson& object, const char* key) const {
  const auto& value = at(object, key);
  const bool digits = value.is_string();
  if (digits || value.is_number_unsigned() || value.is_number_integer()) {
    const auto count =
        support::ExactCount::read(digits ? value.get_ref<const std::string&>() : value.dump());
    if (count) return *count;
  }
  refuse(fmt::format("'{}' is not a count", key));
}

int ResultReader::index(const ResultJson& value, std::size_t count) const {
  if (!value.is_number_integer() || value.get<std::int64_t>() < 0 ||
      value.get<std::uint64_t>() >= count) {
    refuse(fmt::format("{} is not one of {} nodes", value.dump(), count));
  }
  return value.get<int>();
}

const ResultJson& ResultReader::list(const ResultJson& object, const char* key) const {
  const auto& value = at(object, key);
  if (!value.is_array()) refuse(fmt::format("'{}' is not a list", key));
  return value;
}

const ResultJson& ResultReader::list(const ResultJson& object, const char* key,
                                     std::size_t length) const {
  const auto& value = list(object, key);
  if (value.size() != length)
    refuse(fmt::format("'{}' has {} entries instead of {}", key, value.size(), length));
  return value;
}

Eigen::Vector3d ResultReader::vector(const ResultJson& value, int dimension) const {
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  if (!value.is_array() || value.size() != static_cast<std::size_t>(dimension))
    refuse(fmt::format("{} is not a list of {} numbers", value.dump().substr(0, 40), dimension));
  for (int axis = 0; axis < dimension; ++axis) {
    const auto& component = value[static_cast<std::size_t>(axis)];
    vector(axis) = number_of(component, component.dump().substr(0, 40));
  }
  return vector;
}

std::vector<std::string> ResultReader::names(const ResultJson& object, const char* key) const {
  std::vector<std::string> all;
  for (const auto& each : list(object, key)) {
    if (!each.is_string()) refuse(fmt::format("'{}' has an entry that is not a name", key));
    all.push_back(each.get<std::string>());
  }
  return all;
}

}  // namespace kusabi::run
