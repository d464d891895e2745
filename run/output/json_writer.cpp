// Line breaks and indentation.
#include "run/output/json_writer.hpp"

#include <algorithm>

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

bool holds_objects(const ordered_json& value) {
  if (value.is_object()) return true;
  return value.is_array() && std::any_of(value.begin(), value.end(), holds_objects);
}

std::string text(const ordered_json& value) {
  return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace

void JsonWriter::next_line() {
  out_ << '\n';
  for (std::size_t i = 0; i < open_.size(); ++i) out_ << "  ";
}

void JsonWriter::before_value() {
  if (after_key_) {
    after_key_ = false;
    return;
  }
  if (open_.empty()) return;
  if (open_.back()) out_ << ',';
  open_.back() = true;
  next_line();
}

void JsonWriter::key(std::string_view name) {
  before_value();
  out_ << text(std::string(name)) << ": ";
  after_key_ = true;
}

void JsonWriter::begin(char bracket) {
  before_value();
  out_ << bracket;
  open_.push_back(false);
}

void JsonWriter::end(char bracket) {
  const bool anything = open_.back();
  open_.pop_back();
  if (anything) next_line();
  out_ << bracket;
}

void JsonWriter::end_object() {
  if (open_.size() == 1 && last_) {
    members(last_());
  }
  end('}');
}

void JsonWriter::begin_result(ordered_json head, const ordered_json& more) {
  auto result = std::move(head["result"]);
  head.erase("result");
  result.update(more);
  begin_object();
  members(head);
  key("result");
  begin_object();
  members(result);
}

// nlohmann::json would put each number of a list on its own line.
void JsonWriter::value(const ordered_json& value) {
  if (!holds_objects(value)) {
    before_value();
    out_ << text(value);
    return;
  }
  if (value.is_object()) {
    begin_object();
    members(value);
    end_object();
    return;
  }
  begin_list();
  for (const auto& element : value) this->value(element);
  end_list();
}

}  // namespace kusabi::run
