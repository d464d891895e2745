// Destinations, temporary files beside them, and those left by killed processes.
#include "run/output/output_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "engine/transport/reason.hpp"
#include "run/output/standard_output.hpp"
#include "run/output/wrong_input.hpp"

namespace kusabi::run {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view suffix = ".tmp";

std::string host_name() {
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0) return "host";
  std::string text = name.data();
  for (char& c : text) {
    if (c == '/') c = '_';
  }
  return text;
}

// Process number of a name PLACE.HOST.PROCESS.tmp or PLACE.HOST.PROCESS.NUMBER.tmp of this host.
std::optional<pid_t> process_of(std::string_view file, const std::string& place) {
  const auto prefix = fmt::format("{}.{}.", place, host_name());
  if (!file.starts_with(prefix) || !file.ends_with(suffix)) return std::nullopt;
  pid_t process = 0;
  const char* const last = file.data() + file.size() - suffix.size();
  const auto [end, error] = std::from_chars(file.data() + prefix.size(), last, process);
  if (error != std::errc{} || process <= 0 || (end != last && *end != '.')) return std::nullopt;
  return process;
}

// True if the process is of this host and gone, and nobody holds the lock. Both are required, since
// several machines may share a host name, and locks may not reach other machines.
void remove_if_left(const fs::path& file, pid_t process) {
  if (kill(process, 0) == 0 || errno != ESRCH) return;
  const int descriptor = open(file.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW);
  if (descriptor < 0) return;
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) unlink(file.c_str());
  close(descriptor);
}

void remove_abandoned_files(const fs::path& place) {
  std::error_code error;
  const auto name = place.filename().string();
  for (fs::directory_iterator entry(place.parent_path(), error), end; !error && entry != end;
       entry.increment(error)) {
    if (const auto process = process_of(entry->path().filename().string(), name)) {
      remove_if_left(entry->path(), *process);
    }
  }
}

std::optional<struct stat> status_of(const std::string& name) {
  struct stat status {};
  if (stat(name.c_str(), &status) != 0) return std::nullopt;
  return status;
}

bool is_null_device(const struct stat& status) {
  const auto null = status_of("/dev/null");
  return S_ISCHR(status.st_mode) && null && S_ISCHR(null->st_mode) &&
         status.st_rdev == null->st_rdev;
}

bool same(const std::string& one, const std::string& other) {
  const auto first = status_of(one);
  const auto second = status_of(other);
  if (first && second) {
    if (is_null_device(*first)) return false;
    if (S_ISCHR(first->st_mode) && S_ISCHR(second->st_mode) && first->st_rdev == second->st_rdev)
      return true;  // two names of one device
    return first->st_dev == second->st_dev && first->st_ino == second->st_ino;
  }
  if (first || second) return false;
  // Neither exists yet: they are the same if they lead to one name in one folder.
  std::error_code error;
  const auto place = fs::weakly_canonical(fs::absolute(one), error);
  if (error) return false;
  const auto other_place = fs::weakly_canonical(fs::absolute(other), error);
  return !error && place == other_place;
}

}  // namespace

OutputFile::OutputFile(const std::string& option, const std::string& name,
                       const std::string& input) {
  place_ = name;
  if (name.empty() || is_standard_output()) return;
  const auto refuse = [&](const std::string& why) {
    throw WrongInput(fmt::format("{} {}: {}", option, name, why));
  };
  std::error_code error;
  const auto kind = fs::status(name, error).type();
  if (kind == fs::file_type::directory) refuse("is a folder; expected a file name");
  if (kind == fs::file_type::not_found || kind == fs::file_type::regular) {
    place_ = fs::weakly_canonical(fs::absolute(name), error);
    if (error) refuse(error.message());
    if (fs::equivalent(place_, input, error))
      refuse("would overwrite the problem file; expected another name");
    if (const auto why = open_beside(); !why.empty()) refuse("cannot be written: " + why);
  } else {
    // A device or a pipe is opened directly.
    file_.open(place_, std::ios::binary | std::ios::trunc);
    if (!file_) refuse(fmt::format("cannot be written: {}", std::strerror(errno)));
  }
}

std::string OutputFile::open_beside() {
  remove_abandoned_files(place_);
  const auto stem = fmt::format("{}.{}.{}", place_.string(), host_name(), getpid());
  constexpr mode_t for_all = 0666;
  constexpr mode_t all_bits = 07777;
  // The name may be used by a process with the same number on a machine or container with the same
  // host name.
  for (int number = 0; lock_ < 0; ++number) {
    auto name = number == 0 ? fmt::format("{}{}", stem, suffix)
                            : fmt::format("{}.{}{}", stem, number, suffix);
    const int made = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, for_all);
    if (made < 0 && errno == EEXIST) continue;
    if (made < 0) return std::strerror(errno);
    lock_ = made;
    beside_ = std::move(name);
  }
  flock(lock_, LOCK_EX | LOCK_NB);  // without locks, abandoned files are not removed
  // The new file has the permissions of the one that it replaces.
  struct stat old {};
  if (stat(place_.c_str(), &old) == 0 && S_ISREG(old.st_mode))
    fchmod(lock_, old.st_mode & all_bits);
  file_.open(beside_, std::ios::binary | std::ios::in | std::ios::out);
  if (!file_) return std::strerror(errno);
  return {};
}

OutputFile::~OutputFile() {
  if (!beside_.empty()) {
    std::error_code nothing_to_be_done;
    fs::remove(beside_, nothing_to_be_done);
  }
  if (lock_ >= 0) close(lock_);
}

// Through stdio, as all printed text, so that the order is kept.
std::ostream& OutputFile::stream() {
  return is_standard_output() ? std::cout : file_;
}

void OutputFile::put_in_place() {
  if (is_standard_output()) {
    std::cout.flush();
    flush_standard_output();
    if (!std::cout) throw std::runtime_error("standard output is incomplete: writing failed");
    return;
  }
  const auto fail = [&](const std::string& why) {
    throw std::runtime_error(fmt::format("{}: {}", place_.string(), why));
  };
  file_.close();
  if (!file_) fail("the file is incomplete; the disk may be full");
  if (beside_.empty()) return;
  // Some file systems report a full disk only here; others do not support fsync.
  if (fsync(lock_) != 0 && errno != EINVAL && errno != ENOTSUP) {
    fail(fmt::format("the file is incomplete: {}", std::strerror(errno)));
  }
  std::error_code error;
  fs::rename(beside_, place_, error);
  if (error) fail("cannot be renamed to its final name: " + error.message());
  beside_.clear();
}

OutputFolder::OutputFolder(std::string option, const std::string& name, std::string input)
    : option_(std::move(option)), input_(std::move(input)), place_(name) {
  if (name.empty()) return;
  std::error_code error;
  if (fs::is_directory(place_, error)) return;
  if (fs::exists(place_, error)) {
    throw WrongInput(
        fmt::format("{} {}: is not a folder; expected a folder or a new name", option_, name));
  }
  made_ = fs::create_directory(place_, error);
  if (error) {
    throw WrongInput(fmt::format("{} {}: cannot be created: {}", option_, name, error.message()));
  }
}

OutputFolder::~OutputFolder() {
  std::error_code not_empty;
  if (made_) fs::remove(place_, not_empty);
}

std::string OutputFolder::last() const {
  if (!last_.empty()) return last_.string();
  return fs::is_empty(place_) ? "" : place_.string();
}

void OutputFolder::write(const std::string& file,
                         const std::function<void(std::ostream&)>& write_to) {
  last_ = place_ / file;
  OutputFile output(option_, last_.string(), input_);
  write_to(output.stream());
  output.put_in_place();
}

void check_outputs(const std::string& input, const std::vector<NamedFile>& outputs,
                   const std::vector<NamedFile>& others) {
  std::vector<NamedFile> all;
  for (const auto* files : {&outputs, &others}) {
    for (const auto& file : *files) {
      if (!file.name.empty()) all.push_back(file);
    }
  }
  for (auto file = all.begin(); file != all.end(); ++file) {
    if (!input.empty() && same(file->name, input)) {
      throw WrongInput(fmt::format("{} {}: would overwrite the problem file; expected another name",
                                   file->option, file->name));
    }
    for (auto before = all.begin(); before != file; ++before) {
      if (!same(before->name, file->name)) continue;
      throw WrongInput(fmt::format("{} {}: is also the file of {}; expected another name",
                                   file->option, file->name, before->option));
    }
  }
  // Opened and closed again, except for pipes, whose readers would see the end.
  for (const auto& [option, name] : outputs) {
    if (name == standard_output_file) continue;
    const auto kind = status_of(name);
    if (!kind || S_ISREG(kind->st_mode)) OutputFile(option, name, input);
    if (kind && S_ISDIR(kind->st_mode)) OutputFile(option, name, input);
  }
}

void check_read_files(const std::vector<std::string>& read, const std::vector<NamedFile>& outputs) {
  for (const auto& file : outputs) {
    const auto found = std::ranges::find_if(
        read, [&](const std::string& name) { return !file.name.empty() && same(file.name, name); });
    if (found == read.end()) continue;
    throw WrongInput(fmt::format(
        "{} {}: would overwrite {}, which the problem file names; expected another name",
        file.option, file.name, *found));
  }
}

void do_all(const std::vector<std::function<void()>>& steps) {
  std::exception_ptr first;
  for (const auto& step : steps) {
    try {
      step();
    } catch (const std::exception& error) {
      if (first) {
        print_message("kusabi: {}\n", engine::reason_of(error.what()));
      } else {
        first = std::current_exception();
      }
    }
  }
  if (first) std::rethrow_exception(first);
}

}  // namespace kusabi::run
