// A layout that a person can read.
#include "run/result_file.hpp"

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <sstream>
#include <stdexcept>

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

bool holds_objects(const ordered_json& value) {
  if (value.is_object()) return true;
  return value.is_array() && std::any_of(value.begin(), value.end(), holds_objects);
}

// A file name need not be UTF-8; what is not becomes U+FFFD.
std::string text(const ordered_json& value) {
  return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

// One line for a list of numbers or names, and for a matrix; one line a member elsewhere. (The
// library's own layout gives every number a line of its own.)
void lay_out(std::ostream& out, const ordered_json& value, const std::string& indent) {
  if (!holds_objects(value)) {
    out << text(value);
    return;
  }
  const std::string deeper = indent + "  ";
  const bool object = value.is_object();
  out << (object ? "{" : "[");
  const char* separator = "\n";
  for (const auto& [key, member] : value.items()) {
    out << separator << deeper;
    if (object) out << text(key) << ": ";
    lay_out(out, member, deeper);
    separator = ",\n";
  }
  out << '\n' << indent << (object ? "}" : "]");
}

}  // namespace

ResultFile::ResultFile(const std::string& name, const std::string& input)
    : file_("--output", name, input) {}

void ResultFile::write(const ordered_json& result) {
  if (!file_.wanted()) return;
  write([&] { return result; }, {});
}

void ResultFile::write(const std::function<ordered_json()>& result,
                       std::span<const LongList> lists) {
  if (!file_.wanted()) return;
  const auto laid_out = [&] {
    std::ostringstream text;
    lay_out(text, result(), "");
    return text.str();
  };
  auto& out = file_.stream();
  std::size_t written = 0;  // of the text: up to the last mark it does not change
  for (const auto& [mark, next] : lists) {
    const std::string text = laid_out();
    const std::size_t at = text.find('"' + mark + '"', written);
    if (at == std::string::npos) throw std::logic_error("a result without the mark " + mark);
    const auto start = text.rfind('\n', at) + 1;
    const std::string indent(text.find_first_not_of(' ', start) - start, ' ');
    out << text.substr(written, at - written);
    ordered_json element;
    const char* separator = "[\n";
    bool any = false;
    for (; next(element); any = true, separator = ",\n") {
      out << separator << indent << "  ";
      lay_out(out, element, indent + "  ");
    }
    out << (any ? "\n" + indent + "]" : "[]");
    written = at + mark.size() + 2;
  }
  out << laid_out().substr(written) << '\n';
  file_.put_in_place();
}

}  // namespace kusabi::run
