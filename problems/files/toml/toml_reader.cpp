// Typed reading of TOML: checks of kind and size, with errors that state the expected value.
#include "problems/files/toml/toml_reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "problems/files/toml/toml_text.hpp"
#include "support/nearest.hpp"

namespace kusabi::problems {
namespace {

support::SourcePosition position_in_file(const toml::source_position& position) {
  return {static_cast<int>(position.line), static_cast<int>(position.column)};
}

/// Kind with article, "an array", "a string", ..., for messages "is a string; expected ...".
std::string kind(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (node.is_array()) return "an array";
  if (node.is_string()) return "a string";
  if (node.is_integer()) return "an integer";
  if (node.is_floating_point()) return "a number";
  if (node.is_boolean()) return "true or false";
  return "a date or time";
}

/// A syntax error in the words of toml++, which mostly include the expected text.
std::string syntax_message(std::string_view description) {
  std::string message(description);
  if (description.find("expected") == description.npos) message += "; expected TOML 1.0 in UTF-8";
  return message;
}

toml::table parsed(std::string_view text, const std::string& file) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    throw support::InputError(file, position_in_file(error.source().begin),
                              syntax_message(error.description()));
  }
}

}  // namespace

TomlReader::TomlReader(std::string_view text, const std::string& file)
    : file_(file), root_(parsed(text, file)) {}

void TomlReader::fail(support::SourcePosition position, std::string_view message) const {
  throw support::InputError(file_, position, message);
}

void TomlReader::fail(const toml::node& node, std::string_view message) const {
  fail(position(node), message);
}

support::SourcePosition TomlReader::position(const toml::node& node) const {
  return position_in_file(node.source().begin);
}

void TomlReader::allow_only(const TomlTable& table,
                            std::initializer_list<std::string_view> allowed) const {
  for (const TomlEntry& entry : entries(*table.table, table.called)) {
    if (std::ranges::find(allowed, entry.key) != allowed.end()) continue;
    std::string message =
        fmt::format("unknown key {} in {}; expected one of {}", support::in_quotes(entry.key),
                    table.called, fmt::join(allowed, ", "));
    message += support::did_you_mean(entry.key, allowed);
    fail(entry.key_position, message);
  }
}

const toml::node& TomlReader::require(const TomlTable& table, std::string_view key,
                                      std::string_view expected) const {
  const toml::node* node = table.table->get(key);
  if (node == nullptr) {
    fail(*table.table, fmt::format("{} has no {}; expected {}", table.called, key, expected));
  }
  return *node;
}

std::vector<TomlEntry> TomlReader::entries(const toml::node& node, std::string_view called) const {
  std::vector<TomlEntry> result;
  for (const auto& [key, value] : *table(node, called).table) {
    result.push_back({std::string(key.str()), position_in_file(key.source().begin), &value});
  }
  if (result.empty()) fail(node, fmt::format("{} is empty; expected at least one entry", called));
  // Tables of TOML are sorted by key, not by place.
  std::ranges::sort(result, {}, [](const TomlEntry& entry) {
    return std::pair(entry.key_position.line, entry.key_position.column);
  });
  return result;
}

TomlTable TomlReader::table(const toml::node& node, std::string_view called) const {
  const toml::table* table = node.as_table();
  if (table == nullptr) {
    fail(node, fmt::format("{} is {}; expected a table of key = value", called, kind(node)));
  }
  return {table, std::string(called)};
}

std::vector<TomlTable> TomlReader::groups(const toml::node& node, std::string_view name) const {
  const toml::array* array = node.as_array();
  if (array == nullptr) {
    fail(node, fmt::format("{0} is {1}; expected groups, each under [[{0}]]", name, kind(node)));
  }
  std::vector<TomlTable> result;
  for (const toml::node* element : elements(node, name)) {
    result.push_back(table(*element, fmt::format("a [[{}]] group", name)));
  }
  return result;
}

std::vector<const toml::node*> TomlReader::elements(const toml::node& node,
                                                    std::string_view called) const {
  const toml::array* array = node.as_array();
  if (array == nullptr) {
    fail(node, fmt::format("{} is {}; expected an array [...]", called, kind(node)));
  }
  if (array->empty()) fail(node, fmt::format("{} is empty; expected at least one entry", called));
  std::vector<const toml::node*> result;
  for (const toml::node& element : *array) result.push_back(&element);
  return result;
}

double TomlReader::number(const toml::node& node, std::string_view called) const {
  if (!node.is_number()) {
    fail(node, fmt::format("{} is {}; expected a number", called, kind(node)));
  }
  // An integer may have more digits than a double: it is rounded, as a decimal fraction is.
  const auto whole = node.value_exact<std::int64_t>();
  const double value =
      whole ? static_cast<double>(*whole) : node.value<double>().value_or(std::nan(""));
  if (!std::isfinite(value)) {
    fail(node, fmt::format("{} is {}; expected a finite number", called, value));
  }
  return value;
}

double TomlReader::positive(const toml::node& node, std::string_view called, std::string_view what,
                            double minimum, double maximum) const {
  const double value = number(node, called);
  if (value < minimum || value > maximum) {
    fail(node, fmt::format("{} is {:g}; expected a positive {} between {:g} and {:g}", called,
                           value, what, minimum, maximum));
  }
  return value;
}

int TomlReader::one_of(const toml::node& node, std::string_view called,
                       std::initializer_list<int> allowed) const {
  const auto value = node.is_integer() ? node.value<int>() : std::nullopt;
  if (!value || std::ranges::find(allowed, *value) == allowed.end()) {
    fail(node,
         fmt::format("{} is {}; expected {}", called, value ? fmt::to_string(*value) : kind(node),
                     fmt::join(allowed, " or ")));
  }
  return *value;
}

int TomlReader::count(const toml::node& node, std::string_view called, int maximum) const {
  const auto value = node.is_integer() ? node.value<std::int64_t>() : std::nullopt;
  if (!value || *value < 1 || *value > maximum) {
    fail(node, fmt::format("{} is {}; expected a whole number from 1 to {}", called,
                           value ? fmt::to_string(*value) : kind(node), maximum));
  }
  return static_cast<int>(*value);
}

Eigen::VectorXd TomlReader::vector(const toml::node& node, std::string_view called,
                                   int size) const {
  const auto components = elements(node, called);
  if (components.size() != static_cast<std::size_t>(size)) {
    fail(node, fmt::format("{} has {} components; expected {}, one for each dimension", called,
                           components.size(), size));
  }
  Eigen::VectorXd result(size);
  Eigen::Index axis = 0;
  for (const toml::node* component : components) {
    result(axis++) = number(*component, fmt::format("a component of {}", called));
  }
  return result;
}

void TomlReader::check_text(std::string_view text, std::string_view called,
                            support::SourcePosition position) const {
  if (text.empty()) fail(position, fmt::format("{} is an empty string; expected text", called));
  if (text.size() > longest_text) {
    fail(position, fmt::format("{} {} is {} bytes long; expected at most {}", called,
                               support::in_quotes(text), text.size(), longest_text));
  }
  if (std::ranges::any_of(text, is_control)) {
    fail(position, fmt::format("{} {} holds a control character; expected printable text", called,
                               support::in_quotes(text)));
  }
}

TomlText TomlReader::text(const toml::node& node, std::string_view called) const {
  const auto value = node.is_string() ? node.value<std::string>() : std::nullopt;
  if (!value) fail(node, fmt::format("{} is {}; expected a string", called, kind(node)));
  check_text(*value, called, position(node));
  return {*value, position(node)};
}

std::vector<TomlText> TomlReader::texts(const toml::node& node, std::string_view called) const {
  std::vector<TomlText> result;
  for (const toml::node* element : elements(node, called)) {
    result.push_back(text(*element, fmt::format("an entry of {}", called)));
  }
  return result;
}

}  // namespace kusabi::problems
