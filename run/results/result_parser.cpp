// SAX parser: one call per event.
#include "run/results/result_parser.hpp"

#include <cstddef>
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

}  // namespace

ParsedResult parse_result(const std::string& text) {
  Builder builder;
  if (!ResultJson::sax_parse(text, &builder))
    builder.result.json = ResultJson(ResultJson::value_t::discarded);
  return std::move(builder.result);
}

}  // namespace kusabi::run
