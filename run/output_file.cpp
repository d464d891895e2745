// Which place, and what to open there.
#include "run/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>
#include <unistd.h>

#include "run/session.hpp"

namespace kusabi::run {

namespace fs = std::filesystem;

OutputFile::OutputFile(const std::string& option, const std::string& name,
                       const std::string& input) {
  if (name.empty()) return;
  const auto refuse = [&](const std::string& why) {
    throw WrongInput(fmt::format("{} {}: {}", option, name, why));
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

OutputFile::~OutputFile() {
  if (beside_.empty()) return;
  std::error_code nothing_to_be_done;
  fs::remove(beside_, nothing_to_be_done);
}

void OutputFile::put_in_place() {
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
