// Journal file: reads and writes through one descriptor, which also holds the lock.
#include "engine/journal.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string_view>

#include <boost/crc.hpp>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace kusabi::engine {
namespace {

constexpr std::string_view journal_magic = "kusabi-state";
constexpr int journal_version = 1;
constexpr const char* journal_order =
    std::endian::native == std::endian::little ? "little-endian" : "big-endian";

/// Header of a record: lengths of kind and content, and the checksum.
struct RecordHead {
  std::uint64_t kind_size = 0;
  std::uint64_t content_size = 0;
  std::uint64_t sum = 0;
};

constexpr std::uint64_t longest_kind = 1U << 16U;

/// Kind of the last record of a finished analysis; it has no content.
constexpr std::string_view mark_of_the_end = "finished";

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
  throw CheckpointError(file + ": " + why);
}

std::string system_error() {
  return std::strerror(errno);
}

// Checksum of a record. It includes the number of the record, so that a record is valid in its
// place only.
std::uint64_t sum_of(std::uint64_t number, const RecordHead& head, std::string_view kind,
                     std::string_view content) {
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693, ~0ULL, ~0ULL, true, true> crc;
  crc.process_bytes(&number, sizeof number);
  crc.process_bytes(&head.kind_size, sizeof head.kind_size);
  crc.process_bytes(&head.content_size, sizeof head.content_size);
  crc.process_bytes(kind.data(), kind.size());
  crc.process_bytes(content.data(), content.size());
  return crc.checksum();
}

// Replaces line breaks, so that each fact takes one line and people can read the file.
std::string in_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return text;
}

std::string text_of(const Facts& facts) {
  std::string text;
  for (const auto& [name, value] : facts)
    text += in_one_line(name) + '\t' + in_one_line(value) + '\n';
  return text;
}

Facts facts_in(const std::string& text) {
  Facts facts;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const auto tab = line.find('\t');
    if (tab == std::string::npos) continue;
    facts.emplace_back(line.substr(0, tab), line.substr(tab + 1));
  }
  return facts;
}

// The header line and the facts. The header line ends with the checksum of the rest.
std::string beginning_of(const Facts& facts) {
  const auto text = text_of(facts);
  const auto line = std::string(journal_magic) + ' ' + std::to_string(journal_version) + ' ' +
                    journal_order + ' ' + std::to_string(text.size());
  boost::crc_32_type crc;
  crc.process_bytes(line.data(), line.size());
  crc.process_bytes(text.data(), text.size());
  return line + ' ' + std::to_string(crc.checksum()) + '\n' + text;
}

std::optional<std::string> value_of(const Facts& facts, const std::string& name) {
  const auto at = std::find_if(facts.begin(), facts.end(),
                               [&](const auto& fact) { return fact.first == name; });
  if (at == facts.end()) return std::nullopt;
  return at->second;
}

std::string said(const std::string& name, const std::optional<std::string>& value) {
  if (!value) return "no " + name;
  return value->empty() ? name : name + ' ' + *value;
}

// Message about the first fact that differs; empty if none does.
std::string difference(const Facts& there, const Facts& here) {
  auto names = here;
  names.insert(names.end(), there.begin(), there.end());
  for (const auto& [name, ignored] : names) {
    const auto before = value_of(there, name);
    const auto now = value_of(here, name);
    if (before == now) continue;
    return "was started with " + said(name, before) + ", and this call has " + said(name, now) +
           "; expected the call that it was started with, or another file";
  }
  return {};
}

std::string read_at(int descriptor, std::uint64_t first, std::uint64_t size) {
  std::string content(size, '\0');
  std::uint64_t done = 0;
  while (done < size) {
    const auto count =
        pread(descriptor, content.data() + done, size - done, static_cast<off_t>(first + done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    done += static_cast<std::uint64_t>(count);
  }
  content.resize(done);
  return content;
}

bool write_at(int descriptor, std::uint64_t first, std::string_view content) {
  while (!content.empty()) {
    const auto count =
        pwrite(descriptor, content.data(), content.size(), static_cast<off_t>(first));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    first += static_cast<std::uint64_t>(count);
    content.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

std::uint64_t size_of_file(int descriptor) {
  struct stat status {};
  return fstat(descriptor, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

}  // namespace

Journal::Journal(std::string file, const Facts& facts) : file_(std::move(file)) {
  open_file();
  try {
    lock();
    const auto beginning = beginning_of(facts);
    // A process killed while it created the file may have left a part of this.
    const auto first = read_at(descriptor_, 0, beginning.size() + 1);
    if (first.size() < beginning.size() && beginning.starts_with(first)) {
      begin(beginning);
    } else {
      read_records(check_beginning(facts));
    }
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

Journal::~Journal() {
  close(descriptor_);
}

void Journal::open_file() {
  constexpr mode_t for_all = 0666;
  descriptor_ = open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, for_all);
  if (descriptor_ < 0) refuse(file_, "cannot be opened: " + system_error());
  struct stat status {};
  if (fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode)) return;
  close(descriptor_);
  refuse(file_, "is not a file; expected the name of a file, which need not exist yet");
}

void Journal::lock() {
  if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  if (errno == EWOULDBLOCK)
    throw JournalInUse(file_ + ": is in use by another run; expected its end, or another file");
  warnings_.push_back(file_ + ": cannot be locked here (" + system_error() +
                      "): make sure that only one run uses it at a time");
}

void Journal::begin(const std::string& beginning) {
  if (!write_at(descriptor_, 0, beginning)) refuse(file_, "cannot be written: " + system_error());
  fsync(descriptor_);
  end_ = beginning.size();
}

std::uint64_t Journal::check_beginning(const Facts& facts) {
  constexpr std::uint64_t longest_line = 200;
  const auto start = read_at(descriptor_, 0, longest_line);
  const auto line_end = start.find('\n');
  if (!start.starts_with(std::string(journal_magic) + ' ') || line_end == std::string::npos) {
    refuse(file_, "is not a state to resume from; expected a file that begins with " +
                      std::string(journal_magic) + ", or an unused name");
  }
  std::istringstream words(start.substr(journal_magic.size(), line_end - journal_magic.size()));
  int version = 0;
  std::string order;
  std::uint64_t size = 0;
  words >> version >> order >> size;
  const auto text = read_at(descriptor_, line_end + 1, std::min(size, size_of_file(descriptor_)));
  const auto found = facts_in(text);
  if (version == journal_version && order != journal_order &&
      (order == "little-endian" || order == "big-endian")) {
    refuse(file_, "was written on a " + order + " machine; expected " + journal_order);
  }
  if (!words || start.substr(0, line_end + 1) + text != beginning_of(found)) {
    refuse(file_, "has a damaged header; expected another file");
  }
  if (const auto what = difference(found, facts); !what.empty()) refuse(file_, what);
  return line_end + 1 + size;
}

void Journal::read_records(std::uint64_t at) {
  const auto whole = size_of_file(descriptor_);
  for (end_ = at; end_ < whole;) {
    RecordHead head;
    const auto bytes = read_at(descriptor_, end_, sizeof head);
    if (bytes.size() != sizeof head) break;
    std::memcpy(&head, bytes.data(), sizeof head);
    const auto left = whole - end_ - sizeof head;
    if (head.kind_size > std::min(longest_kind, left) || head.content_size > left - head.kind_size)
      break;
    const auto body = read_at(descriptor_, end_ + sizeof head, head.kind_size + head.content_size);
    if (body.size() != head.kind_size + head.content_size) break;
    const auto kind = body.substr(0, head.kind_size);
    const auto content = std::string_view(body).substr(head.kind_size);
    if (head.sum != sum_of(records_.size(), head, kind, content)) break;
    const auto next = end_ + sizeof head + body.size();
    finished_ = kind == mark_of_the_end && next == whole;
    if (finished_) return;
    records_.push_back({kind, end_ + sizeof head + head.kind_size, head.content_size});
    end_ = next;
  }
  if (end_ == whole) return;
  warnings_.push_back(file_ + ": " + std::to_string(whole - end_) + " bytes from byte " +
                      std::to_string(end_) +
                      " on are cut short or damaged; their results are computed again");
  if (ftruncate(descriptor_, static_cast<off_t>(end_)) != 0)
    refuse(file_, "cannot be written: " + system_error());
}

Bytes Journal::content(std::size_t number) const {
  const auto& record = records_[number];
  const auto content = read_at(descriptor_, record.first, record.size);
  if (content.size() != record.size) refuse(file_, "cannot be read: " + system_error());
  return {content.begin(), content.end()};
}

std::uint64_t Journal::write_record(const std::string& kind, const Bytes& content) {
  RecordHead head{.kind_size = kind.size(), .content_size = content.size()};
  head.sum = sum_of(records_.size(), head, kind, {content.data(), content.size()});
  std::string record(sizeof head, '\0');
  std::memcpy(record.data(), &head, sizeof head);
  record += kind;
  record.append(content.begin(), content.end());
  const auto end = static_cast<off_t>(end_);
  if (ftruncate(descriptor_, end) != 0 || !write_at(descriptor_, end_, record) ||
      fdatasync(descriptor_) != 0) {
    const auto why = system_error();
    // Without truncation, the incomplete record would be reported as damage.
    if (ftruncate(descriptor_, end) != 0) errno = 0;
    refuse(file_, "cannot be written: " + why);
  }
  return end_ + sizeof head + kind.size();
}

void Journal::append(const std::string& kind, const Bytes& content) {
  finished_ = false;
  const auto first = write_record(kind, content);
  records_.push_back({kind, first, content.size()});
  end_ = first + content.size();
}

void Journal::finish() {
  if (finished_) return;
  write_record(std::string(mark_of_the_end), {});
  finished_ = true;
}

}  // namespace kusabi::engine
