// Typed reading of a TOML document; every failure is an InputError with line and column.
//
// It reads the kinds of entries of problem files (numbers, vectors, names, groups) without their
// meaning. Only sources that read files include this header, since toml++ is a large one.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <toml++/toml.h>

#include "support/input_error.hpp"

namespace kusabi::problems {

/// A table and its name in messages: "the file", "a [[members]] group".
struct TomlTable {
  const toml::table* table;
  std::string called;
};

/// A value with its key.
struct TomlEntry {
  std::string key;
  support::SourcePosition key_position;
  const toml::node* value;
};

/// A string with its place.
struct TomlText {
  std::string text;
  support::SourcePosition position;
};

class TomlReader {
 public:
  /// Parses the whole text.
  /// @throws InputError if it is not UTF-8 or not TOML 1.0
  TomlReader(std::string_view text, const std::string& file);

  TomlTable root() const { return {&root_, "the file"}; }

  /// @throws InputError at the first other key, with the most similar of `allowed`
  void allow_only(const TomlTable& table, std::initializer_list<std::string_view> allowed) const;

  /// The entry under `key`.
  /// @param expected text of the error if it is missing
  const toml::node& require(const TomlTable& table, std::string_view key,
                            std::string_view expected) const;

  /// The entries of a nonempty table, in the order of the file.
  std::vector<TomlEntry> entries(const toml::node& node, std::string_view called) const;
  TomlTable table(const toml::node& node, std::string_view called) const;
  /// The tables of a nonempty array: [[name]] in the file.
  std::vector<TomlTable> groups(const toml::node& node, std::string_view name) const;
  /// The elements of a nonempty array.
  std::vector<const toml::node*> elements(const toml::node& node, std::string_view called) const;

  /// A finite number; integers are accepted.
  double number(const toml::node& node, std::string_view called) const;
  /// A number from `minimum`, which is positive, to `maximum`. @param what its name: "area"
  double positive(const toml::node& node, std::string_view called, std::string_view what,
                  double minimum, double maximum) const;
  /// An integer that is one of `allowed`.
  int one_of(const toml::node& node, std::string_view called,
             std::initializer_list<int> allowed) const;
  /// An integer from 1 to `maximum`.
  int count(const toml::node& node, std::string_view called, int maximum) const;
  /// A vector of `size` finite numbers.
  Eigen::VectorXd vector(const toml::node& node, std::string_view called, int size) const;
  /// A string for tables of results: not empty, short, without control characters.
  TomlText text(const toml::node& node, std::string_view called) const;
  std::vector<TomlText> texts(const toml::node& node, std::string_view called) const;
  /// Applies the rule of `text` to another string (a key).
  void check_text(std::string_view text, std::string_view called,
                  support::SourcePosition position) const;

  support::SourcePosition position(const toml::node& node) const;
  const std::string& file() const { return file_; }
  [[noreturn]] void fail(support::SourcePosition position, std::string_view message) const;
  [[noreturn]] void fail(const toml::node& node, std::string_view message) const;

 private:
  std::string file_;
  toml::table root_;
};

}  // namespace kusabi::problems
