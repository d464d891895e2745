// Writing beside and renaming, and a layout that a person can read.
#include "run/result_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "run/session.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

bool holds_objects(const ordered_json& value) {
  if (value.is_object()) return true;
  return value.is_array() && std::any_of(value.begin(), value.end(), holds_objects);
}

// One line for a list of numbers or names, and for a matrix; one line a member elsewhere. (The
// library's own layout gives every number a line of its own.)
void lay_out(std::ostream& out, const ordered_json& value, const std::string& indent) {
  if (!holds_objects(value)) {
    out << value.dump();
    return;
  }
  const std::string deeper = indent + "  ";
  const bool object = value.is_object();
  out << (object ? "{" : "[");
  const char* separator = "\n";
  for (const auto& [key, member] : value.items()) {
    out << separator << deeper;
    if (object) out << ordered_json(key).dump() << ": ";
    lay_out(out, member, deeper);
    separator = ",\n";
  }
  out << '\n' << indent << (object ? "}" : "]");
}

}  // namespace

ResultFile::ResultFile(const std::string& name) : name_(name), beside_(name + ".tmp") {
  if (name.empty()) return;
  if (std::filesystem::is_directory(name)) {
    throw WrongInput(fmt::format("--output {}: is a folder, expected a file name", name));
  }
  file_.open(beside_, std::ios::binary | std::ios::trunc);
  if (!file_) {
    throw WrongInput(fmt::format("--output {}: cannot be written: {}", name, std::strerror(errno)));
  }
}

ResultFile::~ResultFile() {
  if (!file_.is_open()) return;
  file_.close();
  std::error_code nothing_to_be_done;
  std::filesystem::remove(beside_, nothing_to_be_done);
}

void ResultFile::write(const nlohmann::ordered_json& result) {
  if (name_.empty()) return;
  lay_out(file_, result, "");
  file_ << '\n';
  file_.close();
  if (!file_) throw std::runtime_error(fmt::format("{}: could not be written in full", beside_));
  std::filesystem::rename(beside_, name_);
}

}  // namespace kusabi::run
