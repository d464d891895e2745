// Checkpoint files: each is written under a temporary name, synced and renamed; all are verified
// when read.
#include "engine/checkpoint.hpp"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <sstream>
#include <streambuf>
#include <string_view>
#include <utility>
#include <vector>

#include <boost/archive/archive_exception.hpp>
#include <boost/core/demangle.hpp>
#include <boost/crc.hpp>
#include <fcntl.h>
#include <unistd.h>

namespace kusabi::engine {
namespace {

namespace fs = std::filesystem;

constexpr const char* manifest_magic = "kusabi-checkpoint";
constexpr const char* part_magic = "kusabi-checkpoint-part";
constexpr int format_version = 4;
constexpr int oldest_version = 3;  // its manifest lacks byte order, goal and types
constexpr const char* byte_order =
    std::endian::native == std::endian::little ? "little-endian" : "big-endian";
constexpr const char* other_problem = "is the checkpoint of another problem";
constexpr const char* previous_suffix = ".previous";
constexpr const char* beside_suffix = ".tmp";

std::string previous(const std::string& file) {
  return file + previous_suffix;
}

// Part files carry the name of the checkpoint, for FILE and FILE.previous alike.
std::string part_name(std::string manifest_file, std::uint64_t epoch, int rank) {
  const std::string suffix = previous_suffix;
  if (manifest_file.ends_with(suffix)) manifest_file.resize(manifest_file.size() - suffix.size());
  return manifest_file + "." + std::to_string(epoch) + "." + std::to_string(rank);
}

// Writes the body of a file.
using Write = std::function<void(std::streambuf&)>;

// A stream buffer that counts bytes and computes their checksum.
class Measure : public std::streambuf {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::string checksum() const { return std::to_string(crc_.checksum()); }

 protected:
  std::streamsize xsputn(const char* data, std::streamsize count) override {
    crc_.process_bytes(data, static_cast<std::size_t>(count));
    size_ += static_cast<std::size_t>(count);
    return count;
  }
  int_type overflow(int_type character) override {
    if (traits_type::eq_int_type(character, traits_type::eof()))
      return traits_type::not_eof(character);
    const char byte = traits_type::to_char_type(character);
    xsputn(&byte, 1);
    return character;
  }

 private:
  boost::crc_32_type crc_;
  std::size_t size_ = 0;
};

void put(const std::string& text, std::streambuf& target) {
  target.sputn(text.data(), static_cast<std::streamsize>(text.size()));
}

std::string checksum(const std::string& header, const Write& body) {
  Measure measure;
  put(header, measure);
  body(measure);
  return measure.checksum();
}

[[noreturn]] void fail(const std::string& file, const std::string& what) {
  throw CheckpointError(file + ": " + what);
}

// A word of a file, shortened for a message.
std::string shown(std::string word) {
  constexpr std::size_t longest = 200;
  for (char& character : word) {
    const auto byte = static_cast<unsigned char>(character);
    if (byte < 0x20U || byte == 0x7FU) character = '?';
  }
  if (word.size() > longest) word = word.substr(0, longest) + "...";
  return word;
}

// Demangled type name. Demangling can double the length of a name for every six bytes, because of
// back references; a long name from a file therefore stays mangled.
std::string type_name(const std::string& mangled) {
  constexpr std::size_t longest = 80;
  return shown(mangled.size() > longest ? mangled : boost::core::demangle(mangled.c_str()));
}

fs::path folder_of(const std::string& name) {
  const auto folder = fs::path(name).parent_path();
  return folder.empty() ? "." : folder;
}

void sync(const std::string& name, int flags) {
  const int descriptor = open(name.c_str(), flags);
  const bool synced = descriptor >= 0 && fsync(descriptor) == 0;
  if (descriptor >= 0) close(descriptor);
  if (!synced) fail(name, std::string("cannot be synced to the disk: ") + std::strerror(errno));
}

std::string beside(const std::string& name) {
  return name + beside_suffix;
}

// Writes a file of a header line, whose last word is the checksum of everything else, and a body.
void write_beside(const std::string& name, const std::string& header, const Write& body) {
  const auto other = beside(name);
  {
    std::ofstream file(other, std::ios::binary | std::ios::trunc);
    file << header << ' ' << checksum(header, body) << '\n';
    try {
      body(*file.rdbuf());
      file.flush();
    } catch (const boost::archive::archive_exception&) {  // the file takes no more bytes
      file.setstate(std::ios::badbit);
    }
    if (!file) fail(other, std::string("cannot be written: ") + std::strerror(errno));
  }
  sync(other, O_RDONLY);
}

// Renames the temporary file to its final name. The folder is synced too, so that after a crash of
// the machine the file is either the old one or the new one.
void put_in_place(const std::string& name) {
  std::error_code error;
  fs::rename(beside(name), name, error);
  if (error) fail(name, "cannot be put in place: " + error.message());
  sync(folder_of(name).string(), O_RDONLY | O_DIRECTORY);
}

std::string content_of(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  if (!file) fail(name, std::string("cannot be read: ") + std::strerror(errno));
  try {
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  } catch (const std::ios_base::failure&) {  // a folder, or a disk error: opened, but not readable
    fail(name, std::string("cannot be read: ") + std::strerror(errno));
  }
}

struct Content {
  int version;
  std::istringstream words;  // of the header, after the version
  std::string body;
};

Content checked(const std::string& name, const char* magic) {
  const auto content = content_of(name);
  const auto line_end = content.find('\n');
  if (!content.starts_with(std::string(magic) + " ") || line_end == std::string::npos) {
    fail(name, "is not a checkpoint file; expected one that begins with " + std::string(magic));
  }
  std::string header = content.substr(0, line_end);
  std::string body = content.substr(line_end + 1);
  const auto last_space = header.rfind(' ');
  const std::string stored = header.substr(last_space + 1);
  header.resize(last_space);

  std::istringstream words(header.substr(std::strlen(magic)));
  int version = 0;
  words >> version;
  if (version < oldest_version || version > format_version) {
    fail(name, "is of format version " + std::to_string(version) + "; expected " +
                   std::to_string(oldest_version) + " or " + std::to_string(format_version));
  }
  if (stored != checksum(header, [&](auto& target) { put(body, target); }))
    fail(name, "is damaged: its checksum does not match");
  return {version, std::move(words), std::move(body)};
}

// The manifest; nothing if there is none or it cannot be read.
std::optional<Manifest> readable_manifest(const std::string& manifest_file) {
  try {
    return read_manifest(manifest_file);
  } catch (const CheckpointError&) {
    return std::nullopt;
  }
}

// A leading number and the text after it.
template <class Number>
std::optional<std::pair<Number, std::string_view>> leading(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return std::nullopt;
  return std::pair(number, text.substr(static_cast<std::size_t>(end - text.data())));
}

// Epoch and rank of a part file, from its name. @param rest the name after that of the checkpoint
std::optional<std::pair<std::uint64_t, int>> part_of(std::string_view rest) {
  if (!rest.starts_with('.')) return std::nullopt;
  const auto epoch = leading<std::uint64_t>(rest.substr(1));
  if (!epoch || !epoch->second.starts_with('.')) return std::nullopt;
  const auto rank = leading<int>(epoch->second.substr(1));
  if (!rank || !(rank->second.empty() || rank->second == beside_suffix)) return std::nullopt;
  return std::pair(epoch->first, rank->first);
}

// True for a part and for the beginning of one, which a rank killed while writing leaves behind.
bool begins_like_a_part(const fs::path& name) {
  std::string expected = part_magic;
  std::string found(expected.size(), '\0');
  std::ifstream file(name, std::ios::binary);
  file.read(found.data(), static_cast<std::streamsize>(found.size()));
  found.resize(static_cast<std::size_t>(file.gcount()));
  return file.is_open() && expected.starts_with(found);
}

// Reads the whole checkpoint. @throws CheckpointError at the first fault
void verify(const std::string& manifest_file, std::uint64_t problem) {
  const auto manifest = read_manifest(manifest_file);
  if (manifest.problem != problem) fail(manifest_file, other_problem);
  for (int rank = 0; rank < manifest.ranks; ++rank) read_part(manifest_file, manifest, rank);
}

}  // namespace

void write_part(const std::string& file, const Manifest& manifest, int rank,
                const std::function<void(std::streambuf&)>& save) {
  Measure payload;
  save(payload);
  std::ostringstream header;
  header << part_magic << ' ' << format_version << ' ' << manifest.problem << ' ' << manifest.epoch
         << ' ' << rank << ' ' << payload.size();
  const auto name = part_name(file, manifest.epoch, rank);
  write_beside(name, header.str(), save);
  put_in_place(name);
}

Bytes read_part(const std::string& manifest_file, const Manifest& manifest, int rank) {
  const auto name = part_name(manifest_file, manifest.epoch, rank);
  auto [version, words, body] = checked(name, part_magic);
  std::uint64_t problem = 0;
  std::uint64_t epoch = 0;
  int its_rank = -1;
  std::size_t size = 0;
  words >> problem >> epoch >> its_rank >> size;
  if (problem != manifest.problem || epoch != manifest.epoch || its_rank != rank ||
      size != body.size()) {
    fail(name, "is not the part that " + manifest_file + " lists");
  }
  return {body.begin(), body.end()};
}

void commit(const std::string& file, const Manifest& manifest, std::uint64_t before) {
  std::ostringstream header;
  header << manifest_magic << ' ' << format_version << ' ' << manifest.problem << ' '
         << manifest.epoch << ' ' << manifest.ranks << ' ' << manifest.opened << ' '
         << manifest.fingerprint << ' ' << manifest.open << ' ' << byte_order << ' '
         << manifest.goal << ' ' << manifest.node << ' ' << manifest.solution;
  write_beside(file, header.str(), [](std::streambuf& /*none*/) {});
  // No file has changed so far. Only a checkpoint known to be good may replace the previous one: if
  // FILE was damaged and skipped, FILE.previous may be the only good one.
  const auto there = readable_manifest(file);
  if (there && there->epoch == before) {
    std::error_code error;
    fs::rename(file, previous(file), error);
    if (error) fail(file, "cannot be kept as the previous one: " + error.message());
  }
  put_in_place(file);
  remove_leftovers(file);
}

void remove_leftovers(const std::string& file) {
  // A failed clean-up leaves files behind; it must not end a long run.
  std::vector<Manifest> kept;
  for (const auto& name : {file, previous(file)}) {
    std::error_code ignored;
    const auto manifest = readable_manifest(name);
    if (manifest) {
      kept.push_back(*manifest);
    } else if (fs::exists(name, ignored)) {
      return;  // it is unknown which parts belong to it
    }
  }
  const auto listed = [&](std::uint64_t epoch, int rank) {
    return std::any_of(kept.begin(), kept.end(), [&](const Manifest& manifest) {
      return epoch == manifest.epoch && rank < manifest.ranks;
    });
  };
  const auto base = fs::path(file).filename().string();
  std::vector<fs::path> leftovers;
  std::error_code error;
  for (fs::directory_iterator entry(folder_of(file), error), end; !error && entry != end;
       entry.increment(error)) {
    const auto name = entry->path().filename().string();
    if (!name.starts_with(base)) continue;
    const auto part = part_of(std::string_view(name).substr(base.size()));
    if (!part) continue;
    const bool half_written = name.ends_with(beside_suffix);
    if (!half_written && listed(part->first, part->second)) continue;
    if (begins_like_a_part(entry->path())) leftovers.push_back(entry->path());
  }
  for (const auto& name : leftovers) fs::remove(name, error);
}

std::uint64_t newest_epoch(const std::string& file) {
  std::uint64_t newest = 0;
  for (const auto& name : {file, previous(file)}) {
    if (const auto manifest = readable_manifest(name)) newest = std::max(newest, manifest->epoch);
  }
  return newest;
}

Manifest read_manifest(const std::string& manifest_file) {
  auto [version, words, body] = checked(manifest_file, manifest_magic);
  Manifest manifest;
  words >> manifest.problem >> manifest.epoch >> manifest.ranks >> manifest.opened >>
      manifest.fingerprint >> manifest.open;
  std::string order = byte_order;
  if (version > oldest_version) {
    words >> order >> manifest.goal >> manifest.node >> manifest.solution;
  }
  if (!words || manifest.ranks < 1) fail(manifest_file, "is damaged: its line is incomplete");
  if (order != byte_order) {
    fail(manifest_file, "was written on a " + shown(order) + " machine; expected " + byte_order);
  }
  return manifest;
}

void expect_same_search(const std::string& manifest_file, const Manifest& found,
                        const Manifest& own) {
  if (found.problem != own.problem) fail(manifest_file, other_problem);
  if (found.goal.empty()) return;  // format version 3
  const auto expect = [&](const char* what, const std::string& there, const std::string& here,
                          const auto& name) {
    if (there == here) return;
    fail(manifest_file, std::string("is of a search with ") + what + ' ' + name(there) +
                            "; expected " + what + ' ' + name(here));
  };
  expect("the goal", found.goal, own.goal, shown);
  expect("nodes of type", found.node, own.node, type_name);
  expect("solutions of type", found.solution, own.solution, type_name);
}

void expect_folder(const std::string& file) {
  const auto folder = folder_of(file);
  if (fs::is_directory(folder)) return;
  fail(file, "cannot be written: there is no folder " + folder.string() +
                 "; expected an existing one in Options::checkpoint.file");
}

void expect_no_other(const std::string& file, const std::string& resume_from) {
  if (resume_from == file || resume_from == previous(file) || !checkpoint_exists(file)) return;
  fail(file,
       "is a checkpoint already; expected Options::checkpoint.resume_from to name it, so that the "
       "search resumes from it, or its removal");
}

std::string usable_checkpoint(const std::string& file, std::uint64_t problem,
                              std::string& warning) {
  try {
    verify(file, problem);
    return file;
  } catch (const CheckpointError& newest) {
    try {
      verify(previous(file), problem);
    } catch (const CheckpointError&) {
      throw newest;  // NOLINT(misc-throw-by-value-catch-by-reference): the first fault counts
    }
    warning = std::string(newest.what()) + "; resuming from " + previous(file);
    return previous(file);
  }
}

void remove_checkpoint(const std::string& file) {
  std::error_code error;
  if (!fs::exists(file, error) && !fs::exists(previous(file), error)) return;
  // The older one is removed first: as long as both exist, the newer one is used.
  fs::remove(previous(file), error);
  fs::remove(file, error);
  remove_leftovers(file);
}

bool checkpoint_exists(const std::string& file) {
  return fs::exists(file) || fs::exists(previous(file));
}

}  // namespace kusabi::engine
