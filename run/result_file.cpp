// A layout that a person can read.
#include "run/result_file.hpp"

#include <algorithm>
#include <ostream>

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
  lay_out(file_.stream(), result, "");
  file_.stream() << '\n';
  file_.put_in_place();
}

}  // namespace kusabi::run
