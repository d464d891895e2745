// Writing beside and renaming, and a layout that a person can read.
#include "run/result_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>
#include <unistd.h>

#include "run/session.hpp"

namespace kusabi::run {
namespace {

namespace fs = std::filesystem;
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

ResultFile::ResultFile(const std::string& name, const std::string& input) {
  if (name.empty()) return;
  const auto refuse = [&](const std::string& why) {
    throw WrongInput(fmt::format("--output {}: {}", name, why));
  };
  std::error_code error;
  const auto kind = fs::status(name, error).type();
  if (kind == fs::file_type::directory) refuse("is a folder, expected a file name");
  if (kind == fs::file_type::not_found || kind == fs::file_type::regular) {
    place_ = fs::weakly_canonical(name, error);
    if (error) refuse(error.message());
    if (fs::equivalent(place_, input, error)) refuse("is the problem file itself");
    beside_ = place_;
    beside_ += fmt::format(".{}.tmp", getpid());
    if (fs::exists(beside_, error)) refuse(beside_.string() + " is in the way");
  } else {
    place_ = name;  // a device or a pipe, whose real name nobody can open
  }
  file_.open(beside_.empty() ? place_ : beside_, std::ios::binary | std::ios::trunc);
  if (!file_) refuse(fmt::format("cannot be written: {}", std::strerror(errno)));
}

ResultFile::~ResultFile() {
  if (beside_.empty()) return;
  std::error_code nothing_to_be_done;
  fs::remove(beside_, nothing_to_be_done);
}

void ResultFile::write(const ordered_json& result) {
  if (place_.empty()) return;
  lay_out(file_, result, "");
  file_ << '\n';
  file_.close();
  if (!file_) {
    throw std::runtime_error(
        fmt::format("{}: could not be written in full; is the disk full?", place_.string()));
  }
  if (beside_.empty()) return;
  fs::rename(beside_, place_);
  beside_.clear();
}

}  // namespace kusabi::run
