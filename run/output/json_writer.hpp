// JsonWriter: JSON written piece by piece, for results too long for memory. Layout of all results:
// lists of numbers or names and matrices on one line, objects with one line per member.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace kusabi::run {

/// Writer of one value: either `value`, or a `begin_…`, its members and its `end_…`.
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
  /// @param last makes an object at the end of the writing, whose members are appended to the root
  ///        object
  explicit JsonWriter(std::ostream& out, std::function<nlohmann::ordered_json()> last = {})
      : out_(out), last_(std::move(last)) {}

  void begin_object() { begin('{'); }
  void end_object();
  void begin_list() { begin('['); }
  void end_list() { end(']'); }

  /// Name of the next value. @pre an object is open
  void key(std::string_view name);

  /// The root, the value of the last key, or the next element of the open list. Bytes that are not
  /// UTF-8 (in file names) become U+FFFD.
  void value(const nlohmann::ordered_json& value);

  void member(std::string_view name, const nlohmann::ordered_json& its_value) {
    key(name);
    value(its_value);
  }
  /// Those of an object.
  void members(const nlohmann::ordered_json& object) {
    for (const auto& [name, its_value] : object.items()) member(name, its_value);
  }

  /// Begins a result file, up to further members of `result`.
  /// @param head its first members  @param more of `result`, after those of the head
  void begin_result(nlohmann::ordered_json head, const nlohmann::ordered_json& more);

 private:
  void begin(char bracket);
  void end(char bracket);
  void next_line();  // of the innermost object or list
  void before_value();

  std::ostream& out_;
  std::function<nlohmann::ordered_json()> last_;
  std::vector<bool> open_;  // for each open object or list: it is not empty
  bool after_key_ = false;
};

}  // namespace kusabi::run
