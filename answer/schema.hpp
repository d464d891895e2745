// JSON schema of values that are written from lists of fields (fields.hpp).
#pragma once

#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include <nlohmann/json.hpp>

#include "answer/fields.hpp"

namespace kusabi::answer {

template <class T>
nlohmann::ordered_json schema_of(nlohmann::ordered_json& definitions);

namespace detail {

template <class T>
struct Element;
template <class T>
struct Element<std::optional<T>> {
  using type = T;
};
template <class T>
struct Element<std::vector<T>> {
  using type = T;
};

// "number" becomes ["number", "null"]; other descriptions an alternative to null.
inline nlohmann::ordered_json or_null(nlohmann::ordered_json schema) {
  if (schema.contains("type") && schema["type"].is_string() && !schema.contains("properties")) {
    schema["type"] = {schema["type"], "null"};
    return schema;
  }
  return {{"anyOf", {{{"type", "null"}}, std::move(schema)}}};
}

/// @param closed no other members are allowed
template <class T>
nlohmann::ordered_json object_schema(nlohmann::ordered_json& definitions, bool closed = true) {
  using nlohmann::ordered_json;
  auto properties = ordered_json::object();
  auto required = ordered_json::array();
  if constexpr (HasKind<T>) {
    properties["kind"] = {{"const", T::kind}};
    required.push_back("kind");
  }
  const auto add = [&]<class Value>(const Field<T, Value>& each) {
    ordered_json schema;
    if (*each.meaning != '\0') schema["description"] = each.meaning;
    if constexpr (is_optional<Value>) {
      using Inner = typename Element<Value>::type;
      schema.update(each.omissible ? schema_of<Inner>(definitions) : schema_of<Value>(definitions));
    } else {
      schema.update(schema_of<Value>(definitions));
    }
    properties[each.key] = std::move(schema);
    if (!each.omissible) required.push_back(each.key);
  };
  std::apply([&](const auto&... each) { (add(each), ...); }, FieldsOf<T>::list());
  ordered_json schema{{"type", "object"}, {"properties", std::move(properties)}};
  if (!required.empty()) schema["required"] = std::move(required);
  if (closed) schema["additionalProperties"] = false;
  return schema;
}

}  // namespace detail

/// The schema of what `written` makes of a value of this type.
/// @param definitions receives those of structs with a title
template <class T>
nlohmann::ordered_json schema_of(nlohmann::ordered_json& definitions) {
  using nlohmann::ordered_json;
  if constexpr (std::is_same_v<T, bool>) {
    return {{"type", "boolean"}};
  } else if constexpr (std::is_same_v<T, double>) {
    return {{"type", "number"}};
  } else if constexpr (std::is_same_v<T, std::string>) {
    return {{"type", "string"}};
  } else if constexpr (std::is_same_v<T, support::ExactCount>) {
    return {{"type", {"integer", "string"}}, {"minimum", 0}, {"pattern", "^[0-9]{16,}$"}};
  } else if constexpr (HasNames<T>) {
    return {{"enum", names_of(T{})}};
  } else if constexpr (std::is_unsigned_v<T>) {
    return {{"type", "integer"}, {"minimum", 0}};
  } else if constexpr (std::is_integral_v<T>) {
    return {{"type", "integer"}};
  } else if constexpr (detail::is_optional<T>) {
    return detail::or_null(schema_of<typename detail::Element<T>::type>(definitions));
  } else if constexpr (detail::is_vector<T>) {
    return {{"type", "array"},
            {"items", schema_of<typename detail::Element<T>::type>(definitions)}};
  } else if constexpr (title_of<T>() != nullptr) {
    if (!definitions.contains(title_of<T>())) {
      definitions[title_of<T>()] = nullptr;  // a struct may contain itself
      definitions[title_of<T>()] = detail::object_schema<T>(definitions);
    }
    return {{"$ref", std::string("#/$defs/") + title_of<T>()}};
  } else {
    return detail::object_schema<T>(definitions);
  }
}

}  // namespace kusabi::answer
