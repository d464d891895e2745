// JSON written piece by piece, for results that are too long to be held, in the layout of all
// results: one line for a list of numbers or names and for a matrix, one line a member elsewhere.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace kusabi::run {

/// Writes one value: either `value`, or what lies between a `begin_…` and its `end_…`.
///
///   JsonWriter json(out);
///   json.begin_object();
///   json.member("count", 2);
///   json.key("rays");
///   json.begin_list();
///   json.value(first);
///   json.value(second);
///   json.end_list();
///   json.end_object();
class JsonWriter {
 public:
  /// @param last makes an object when the rest is written: members that the root, if it is one,
  /// ends with
  explicit JsonWriter(std::ostream& out, std::function<nlohmann::ordered_json()> last = {})
      : out_(out), last_(std::move(last)) {}

  void begin_object() { begin('{'); }
  void end_object();
  void begin_list() { begin('['); }
  void end_list() { end(']'); }

  /// The name of the next value. @pre an object is open
  void key(std::string_view name);

  /// The root, the value of the last key, or the next element of the list that is open. Bytes of a
  /// text that are not UTF-8 (a file name's, say) become U+FFFD.
  void value(const nlohmann::ordered_json& value);

  void member(std::string_view name, const nlohmann::ordered_json& its_value) {
    key(name);
    value(its_value);
  }

 private:
  void begin(char bracket);
  void end(char bracket);
  void next_line();  // of the innermost object or list
  void before_value();

  std::ostream& out_;
  std::function<nlohmann::ordered_json()> last_;
  std::vector<bool> open_;  // for each object or list that is open: whether it has anything in it
  bool after_key_ = false;
};

}  // namespace kusabi::run
