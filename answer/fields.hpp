// Fields of an object in a file. A struct lists its fields once, each with key, member and meaning;
// the object is written from that list, and described from it in the schema.
//
//   struct LoadRange {
//     std::optional<double> half_width{};
//     static constexpr auto fields() {
//       return std::tuple{field("half_width", &LoadRange::half_width, "unit of force")};
//     }
//   };
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include <nlohmann/json.hpp>

#include "answer/values.hpp"
#include "support/bracket.hpp"
#include "support/exact_count.hpp"

namespace kusabi::answer {

template <class Owner, class Value>
struct Field {
  const char* key;
  Value Owner::*member;
  const char* meaning;  ///< with its unit; may be empty
  bool omissible;       ///< left out if it is empty, false or absent; otherwise written as it is
};

template <class Owner, class Value>
constexpr Field<Owner, Value> field(const char* key, Value Owner::*member,
                                    const char* meaning = "") {
  return {key, member, meaning, false};
}

/// A field that is left out if it is empty, false or absent.
template <class Owner, class Value>
constexpr Field<Owner, Value> if_any(const char* key, Value Owner::*member,
                                     const char* meaning = "") {
  return {key, member, meaning, true};
}

/// The list of a struct.
template <class T>
struct FieldsOf {
  static constexpr auto list() requires requires { T::fields(); }
  { return T::fields(); }
};

template <>
struct FieldsOf<support::Bound> {
  static constexpr const char* title = "bound";
  static constexpr auto list() {
    return std::tuple{field("value", &support::Bound::value),
                      field("standing", &support::Bound::standing)};
  }
};

template <>
struct FieldsOf<support::Bracket> {
  static constexpr const char* title = "bracket";
  static constexpr auto list() {
    return std::tuple{field("lower", &support::Bracket::lower, "null: open"),
                      field("upper", &support::Bracket::upper, "null: open")};
  }
};

template <class T>
concept HasFields = requires {
  FieldsOf<T>::list();
};

/// A struct with `static constexpr const char* title` is described once, in `$defs`, under that name.
template <class T>
constexpr const char* title_of() {
  if constexpr (requires { FieldsOf<T>::title; }) {
    return FieldsOf<T>::title;
  } else if constexpr (requires { T::title; }) {
    return T::title;
  } else {
    return nullptr;
  }
}

/// A struct with `static constexpr const char* kind`, which becomes its first key.
template <class T>
concept HasKind = requires {
  std::string_view(T::kind);
};

namespace detail {

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;

template <class T>
bool is_empty(const T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    return !value;
  } else if constexpr (requires { value.empty(); }) {
    return value.empty();
  } else if constexpr (is_optional<T>) {
    return !value.has_value();
  } else {
    return false;
  }
}

}  // namespace detail

/// A value as JSON: numbers that are not finite and what is absent as null, counts that some
/// readers would round as strings of digits, enumerations by their names, structs by their fields.
template <class T>
nlohmann::ordered_json written(const T& value) {
  using nlohmann::ordered_json;
  if constexpr (std::is_same_v<T, double>) {
    return number_or_null(value);
  } else if constexpr (std::is_same_v<T, support::ExactCount>) {
    const auto number = value.number();
    return number ? ordered_json(*number) : ordered_json(value.digits());
  } else if constexpr (HasNames<T>) {
    return name_of(value);
  } else if constexpr (detail::is_optional<T>) {
    return value ? written(*value) : ordered_json();
  } else if constexpr (detail::is_vector<T>) {
    auto json = ordered_json::array();
    for (const auto& each : value) json.push_back(written(each));
    return json;
  } else if constexpr (HasFields<T>) {
    auto json = ordered_json::object();
    if constexpr (HasKind<T>) json["kind"] = T::kind;
    const auto add = [&](const auto& each) {
      if (!each.omissible || !detail::is_empty(value.*each.member))
        json[each.key] = written(value.*each.member);
    };
    std::apply([&](const auto&... each) { (add(each), ...); }, FieldsOf<T>::list());
    return json;
  } else {
    static_assert(std::is_arithmetic_v<T> || std::is_same_v<T, std::string>,
                  "the type has no form in files");
    return value;
  }
}

}  // namespace kusabi::answer
