// SAX parser: one call per event.
#include "run/results/result_parser.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace kusabi::run {
namespace {

class Builder final : public nlohmann::json_sax<ResultJson> {
 public:
  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t& /*text*/) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t& /*value*/) override { return false; }  // does not occur in JSON text
  bool start_object(std::size_t /*size*/) override { return open(ResultJson::object()); }
  bool start_array(std::size_t /*size*/) override { return open(ResultJson::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    name_ = std::move(name);
    return true;
  }
  bool parse_error(std::size_t /*at*/, const std::string& /*before*/,
                   const nlohmann::detail::exception& /*what*/) override {
    return false;
  }

  ParsedResult result;

 private:
  // Open values are not moved: only the innermost grows.
  ResultJson& place(ResultJson value) {
    if (open_.empty()) return result.json = std::move(value);
    auto& parent = *open_.back();
    if (parent.is_array()) return parent.emplace_back(std::move(value));
    ResultJson::object_t::Container& members = parent.get_ref<ResultJson::object_t&>();
    return members.emplace_back(std::move(name_), std::move(value)).second;
  }
  bool add(ResultJson value) {
    place(std::move(value));
    return true;
  }
  bool open(ResultJson empty) {
    result.too_deep = open_.size() == deepest_result;
    if (result.too_deep) return false;
    open_.push_back(&place(std::move(empty)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::vector<ResultJson*> open_;  // from the root to the innermost
  std::string name_;               // name of the next value in an object
};

ParsedResult parsed(std::string_view text) {
  Builder builder;
  if (!ResultJson::sax_parse(text, &builder))
    builder.result.json = ResultJson(ResultJson::value_t::discarded);
  return std::move(builder.result);
}

// The object whose list of patterns or rays is in lines: a head, which names the list, its entries,
// and the members at its end.
ParsedResult joined_lines(std::string_view text) {
  ParsedResult whole;
  ResultJson list = ResultJson::array();
  std::string name;
  bool ended = false;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    auto line = parsed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.too_deep || !line.json.is_object() || ended) return parsed("");
    if (whole.json.is_null()) {
      whole = std::move(line);
      name = whole.json.value("lines", "");
      whole.json.erase("lines");
    } else if (line.json.contains("reaction")) {
      list.push_back(std::move(line.json));
    } else {
      whole.json.update(line.json);
      ended = true;
    }
  }
  if (!ended || !whole.json["result"].is_object()) return parsed("");
  whole.json["result"][name] = std::move(list);
  return whole;
}

}  // namespace

ParsedResult parse_result(const std::string& text) {
  const auto first = std::string_view(text).substr(0, text.find('\n'));
  const bool in_lines = first.find(R"("lines":"patterns")") != first.npos ||
                        first.find(R"("lines":"rays")") != first.npos;
  return in_lines ? joined_lines(text) : parsed(text);
}

}  // namespace kusabi::run
