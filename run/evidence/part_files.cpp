// Parts are written by write(2) in whole lines, and found again by their names.
#include "run/evidence/part_files.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "engine/checkpoint.hpp"
#include "engine/collectives.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"

namespace kusabi::run {

namespace fs = std::filesystem;

namespace {

struct Part {
  unsigned run = 0;
  unsigned rank = 0;
  std::string file;
};

std::string part_name(const std::string& name, std::string_view run, int rank) {
  return fmt::format("{}.part.{}.{}", name, run, rank);
}

// All parts of a certificate, in the order of their runs and ranks.
std::vector<Part> parts_of(const std::string& name) {
  std::vector<Part> parts;
  const auto place = fs::absolute(name);
  const auto prefix = place.filename().string() + ".part.";
  for (const auto& entry : fs::directory_iterator(place.parent_path())) {
    const auto file = entry.path().filename().string();
    if (!file.starts_with(prefix)) continue;
    Part part;
    const char* const last = file.data() + file.size();
    const auto run = std::from_chars(file.data() + prefix.size(), last, part.run);
    if (run.ec != std::errc{} || run.ptr == last || *run.ptr != '.') continue;
    const auto rank = std::from_chars(run.ptr + 1, last, part.rank);
    if (rank.ec != std::errc{} || rank.ptr != last) continue;
    part.file = name + file.substr(prefix.size() - std::string_view(".part.").size());
    parts.push_back(std::move(part));
  }
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    return a.run != b.run ? a.run < b.run : a.rank < b.rank;
  });
  return parts;
}

std::string first_line(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  std::string line;
  return next_line(file, line) ? line : std::string{};
}

constexpr std::string_view of_checkpoint = " of the checkpoint ";

// The checkpoint that a part belongs to, if it still exists.
std::string checkpoint_of(const std::string& part) {
  const auto line = first_line(part);
  const auto at = line.find(of_checkpoint);
  if (at == std::string::npos) return {};
  auto checkpoint = line.substr(at + of_checkpoint.size());
  return engine::checkpoint_exists(checkpoint) ? checkpoint : std::string{};
}

bool is_being_written(const std::string& part) {
  const int descriptor = open(part.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool locked = flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return locked;
}

// Beginning of the first line of each part.
std::string of_tree(std::uint64_t tree) {
  return "part of the tree " + hexadecimal(tree);
}

void require_tree(const Part& part, const std::string& tree) {
  const auto line = first_line(part.file);
  // A part without a whole line is from a run killed at its start.
  if (line.empty() || line.starts_with(tree)) return;
  throw std::runtime_error(
      fmt::format("{} belongs to another problem, friction or tolerance", part.file));
}

}  // namespace

void require_file_name(const PartsOwner& owner) {
  std::error_code error;
  const auto kind = fs::status(owner.name, error).type();
  if (kind == fs::file_type::not_found || kind == fs::file_type::regular) return;
  throw WrongInput(
      fmt::format("{} {}: is a device or a pipe; expected a file name", owner.option, owner.name));
}

bool next_line(std::istream& file, std::string& line) {
  return static_cast<bool>(std::getline(file, line)) && !file.eof();
}

std::vector<std::string> parts_of_finished(const PartsOwner& owner) {
  std::vector<std::string> files;
  for (const auto& part : parts_of(owner.name)) {
    require_tree(part, of_tree(owner.tree));
    files.push_back(part.file);
  }
  return files;
}

void read_parts(const std::vector<std::string>& parts,
                const std::function<void(std::string_view)>& take) {
  std::string line;
  for (const auto& part : parts) {
    std::ifstream file(part, std::ios::binary);
    if (!file) throw std::runtime_error(part + ": cannot be read");
    next_line(file, line);  // fingerprint of its tree
    while (next_line(file, line)) take(line);
  }
}

void remove_parts(const std::string& name) {
  std::error_code nothing_to_be_done;
  try {
    for (const auto& part : parts_of(name)) fs::remove(part.file, nothing_to_be_done);
  } catch (const fs::filesystem_error&) {
    return;  // the folder cannot be read
  }
}

PartFiles::PartFiles(Session& session, PartsOwner owner, bool goes_on)
    : session_(session), owner_(std::move(owner)) {
  auto& state = owner_.checkpoint;
  if (!state.empty()) state = fs::absolute(state).string();
  run_ = session.from_first_rank([&] { return prepare(goes_on); });
  const auto file = part_name(owner_.name, run_, session.transport().rank());
  constexpr mode_t for_all = 0666;
  part_ = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, for_all);
  if (part_ < 0) {
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", file, std::strerror(errno)));
  }
  flock(part_, LOCK_EX | LOCK_NB);
  const auto tree = of_tree(owner_.tree);
  put(state.empty() ? tree + '\n' : fmt::format("{}{}{}\n", tree, of_checkpoint, state));
}

PartFiles::~PartFiles() {
  const bool open = part_ >= 0;
  if (open) ::close(part_);
  if (!owner_.checkpoint.empty() && !failed_) return;
  if (session_.is_first()) {
    remove_parts(owner_.name);
  } else if (open) {
    ::unlink(part_name(owner_.name, run_, session_.transport().rank()).c_str());
  }
}

// @return a free number for the parts of this run
std::string PartFiles::prepare(bool goes_on) const {
  const auto& name = owner_.name;
  const auto refuse = [&](const std::string& why) {
    throw WrongInput(fmt::format("{} {}: {}", owner_.option, name, why));
  };
  require_file_name(owner_);
  const auto parts = parts_of(name);
  for (const auto& part : parts) {
    if (is_being_written(part.file)) {
      refuse(fmt::format("{} is in use by another search; expected another name", part.file));
    }
    const auto checkpoint = goes_on ? std::string{} : checkpoint_of(part.file);
    // Parts of a run that was killed before its first checkpoint are useless.
    if (!checkpoint.empty() && checkpoint != owner_.checkpoint) {
      refuse(
          fmt::format("{} belongs to an unfinished search; expected --resume {} to resume it, or a "
                      "new name",
                      part.file, checkpoint));
    }
  }
  const unsigned run = parts.empty() ? 1 : parts.back().run + 1;
  if (!goes_on) {
    remove_parts(name);
    return std::to_string(run);
  }
  if (parts.empty()) {
    refuse(
        fmt::format("{}.part.*, {} of the search so far, do not exist; expected the name with "
                    "which the search began",
                    name, owner_.content));
  }
  for (const auto& part : parts) {
    try {
      require_tree(part, of_tree(owner_.tree));
    } catch (const std::runtime_error& fault) {
      refuse(fault.what());
    }
  }
  return std::to_string(run);
}

void PartFiles::put(std::string_view text) {
  while (!text.empty() && !failed_) {
    const auto written = write(part_, text.data(), text.size());
    if (written >= 0) text.remove_prefix(static_cast<std::size_t>(written));
    if (written < 0 && errno != EINTR) failed_ = true;
  }
}

void PartFiles::close() {
  if (::close(part_) != 0) failed_ = true;
  part_ = -1;
  engine::Reduction own{.ranks = 1};
  if (failed_) own.request_flags = engine::report_write_failure;
  failed_ = (engine::all_reduce(session_.transport(), own).request_flags &
             engine::report_write_failure) != 0;
}

void PartFiles::require() const {
  if (!failed_) return;
  throw std::runtime_error(
      fmt::format("{}: a part is incomplete; the disk may be full", owner_.name));
}

std::vector<std::string> PartFiles::all() const {
  require();
  const auto parts = parts_of(owner_.name);
  const auto own = std::count_if(parts.begin(), parts.end(), [&](const Part& part) {
    return std::to_string(part.run) == run_;
  });
  if (own != session_.ranks()) {
    throw std::runtime_error(
        fmt::format("{}: {} of {} parts exist; expected a folder that all ranks share", owner_.name,
                    own, session_.ranks()));
  }
  std::vector<std::string> files;
  files.reserve(parts.size());
  for (const auto& part : parts) files.push_back(part.file);
  return files;
}

}  // namespace kusabi::run
