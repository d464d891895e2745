// Parts of a certificate, written by write(2) in whole lines, and found again.
#include "run/evidence/certificate_file.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "engine/checkpoint.hpp"
#include "engine/together.hpp"
#include "run/output/values.hpp"
#include "support/sha1.hpp"

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

// The next line without its line end. A line without a line end, from a killed run, is not counted.
bool next_line(std::istream& file, std::string& line) {
  return static_cast<bool>(std::getline(file, line)) && !file.eof();
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

// Writes the text and adds it to the digest.
class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(out) {}

  void add(std::string_view text) {
    out_ << text;
    digest_.add(text);
  }

  void end() { out_ << "digest " << support::hexadecimal(digest_.digest()) << '\n'; }

 private:
  std::ostream& out_;
  support::Sha1Stream digest_;
};

// Concatenates all parts into one file.
void write_whole(OutputFile& whole, const std::string& header, const std::vector<Part>& parts) {
  Writer writer(whole.stream());
  writer.add(header);
  std::uint64_t count = 0;
  std::string line;
  for (const auto& part : parts) {
    std::ifstream file(part.file, std::ios::binary);
    if (!file) throw std::runtime_error(part.file + ": cannot be read");
    next_line(file, line);  // fingerprint of its tree
    while (next_line(file, line)) {
      writer.add(line + '\n');
      ++count;
    }
  }
  writer.add(fmt::format("end {}\n", count));
  writer.end();
  whole.put_in_place();
}

// True if a file is a complete certificate with this beginning.
bool is_whole(const std::string& name, const std::string& header) {
  std::ifstream file(name, std::ios::binary);
  std::string beginning(header.size(), '\0');
  if (!file.read(beginning.data(), static_cast<std::streamsize>(beginning.size())) ||
      beginning != header) {
    return false;
  }
  support::Sha1Stream digest;
  digest.add(header);
  std::string line;
  while (next_line(file, line)) {
    if (line == "digest " + support::hexadecimal(digest.digest())) return true;
    digest.add(line + '\n');
  }
  return false;
}

void remove(const std::vector<Part>& parts) {
  std::error_code nothing_to_be_done;
  for (const auto& part : parts) fs::remove(part.file, nothing_to_be_done);
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

CertificateFile::CertificateFile(Session& session, const std::string& name,
                                 const std::string& input, std::uint64_t tree, bool goes_on,
                                 const std::string& checkpoint)
    : session_(session), name_(name), tree_(of_tree(tree)) {
  if (!wanted()) return;
  const auto state = checkpoint.empty() ? std::string{} : fs::absolute(checkpoint).string();
  run_ = session.from_first_rank([&] { return prepare(input, goes_on, state); });
  const auto file = part_name(name_, run_, session.transport().rank());
  constexpr mode_t for_all = 0666;
  part_ = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, for_all);
  if (part_ < 0) {
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", file, std::strerror(errno)));
  }
  flock(part_, LOCK_EX | LOCK_NB);
  put(state.empty() ? tree_ + '\n' : fmt::format("{}{}{}\n", tree_, of_checkpoint, state));
}

CertificateFile::~CertificateFile() {
  if (part_ >= 0) ::close(part_);
}

// @return a free number for the parts of this run
std::string CertificateFile::prepare(const std::string& input, bool goes_on,
                                     const std::string& own) {
  const auto refuse = [&](const std::string& why) {
    throw WrongInput(fmt::format("--certificate {}: {}", name_, why));
  };
  std::error_code error;
  const auto kind = fs::status(name_, error).type();
  if (kind != fs::file_type::not_found && kind != fs::file_type::regular) {
    refuse("is a device or a pipe; expected a file name");
  }
  whole_.emplace("--certificate", name_, input);
  const auto parts = parts_of(name_);
  for (const auto& part : parts) {
    if (is_being_written(part.file)) {
      refuse(fmt::format("{} is in use by another search; expected another name", part.file));
    }
    const auto checkpoint = goes_on ? std::string{} : checkpoint_of(part.file);
    // Parts of a run that was killed before its first checkpoint are useless.
    if (!checkpoint.empty() && checkpoint != own) {
      refuse(
          fmt::format("{} belongs to an unfinished search; expected --resume {} to resume it, or a "
                      "new name",
                      part.file, checkpoint));
    }
  }
  const unsigned run = parts.empty() ? 1 : parts.back().run + 1;
  if (!goes_on) {
    drop();
    return std::to_string(run);
  }
  if (parts.empty()) {
    refuse(
        fmt::format("{}.part.*, the proofs of the search so far, do not exist; expected the name "
                    "with which the search began",
                    name_));
  }
  for (const auto& part : parts) {
    try {
      require_tree(part, tree_);
    } catch (const std::runtime_error& fault) {
      refuse(fault.what());
    }
  }
  return std::to_string(run);
}

void CertificateFile::add(const wedged::Evidence& evidence) {
  put(certificate_line(evidence));
}

void CertificateFile::put(std::string_view text) {
  while (!text.empty() && !failed_) {
    const auto written = write(part_, text.data(), text.size());
    if (written >= 0) text.remove_prefix(static_cast<std::size_t>(written));
    if (written < 0 && errno != EINTR) failed_ = true;
  }
}

void CertificateFile::close() {
  if (::close(part_) != 0) failed_ = true;
  part_ = -1;
  engine::Reduction own{.ranks = 1};
  if (failed_) own.wishes = engine::wish_failed;
  failed_ = (engine::all_reduce(session_.transport(), own).wishes & engine::wish_failed) != 0;
}

void CertificateFile::require_parts() const {
  if (!failed_) return;
  throw std::runtime_error(fmt::format("{}: a part is incomplete; the disk may be full", name_));
}

void CertificateFile::put_in_place(const std::string& header) {
  require_parts();
  const auto parts = parts_of(name_);
  const auto own = std::count_if(parts.begin(), parts.end(), [&](const Part& part) {
    return std::to_string(part.run) == run_;
  });
  if (own != session_.ranks()) {
    throw std::runtime_error(
        fmt::format("{}: {} of {} parts exist; expected a folder that all ranks share", name_, own,
                    session_.ranks()));
  }
  write_whole(*whole_, header, parts);
  drop();
}

void put_earlier_certificate_in_place(const std::string& name, const std::string& input,
                                      std::uint64_t tree, const std::string& header) {
  const auto parts = parts_of(name);
  if (!is_whole(name, header)) {
    if (parts.empty()) {
      throw std::runtime_error(
          fmt::format("{}: neither the certificate nor its parts exist; expected one of them, or "
                      "another --resume",
                      name));
    }
    for (const auto& part : parts) require_tree(part, of_tree(tree));
    OutputFile whole("--certificate", name, input);
    write_whole(whole, header, parts);
  }
  remove(parts);
}

void CertificateFile::drop() {
  remove(parts_of(name_));
}

}  // namespace kusabi::run
