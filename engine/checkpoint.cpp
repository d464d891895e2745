// Writing beside, syncing, renaming; and reading with suspicion.
#include "engine/checkpoint.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include <boost/crc.hpp>
#include <fcntl.h>
#include <unistd.h>

namespace kusabi::engine {
namespace {

namespace fs = std::filesystem;

constexpr const char* manifest_magic = "kusabi-checkpoint";
constexpr const char* part_magic = "kusabi-checkpoint-part";
constexpr int format_version = 1;
constexpr const char* previous_suffix = ".previous";

std::string previous(const std::string& file) {
  return file + previous_suffix;
}

// Parts carry the name of the checkpoint, whichever of the two manifests lists them.
std::string part_name(std::string manifest_file, std::uint64_t epoch, int rank) {
  const std::string suffix = previous_suffix;
  if (manifest_file.ends_with(suffix)) manifest_file.resize(manifest_file.size() - suffix.size());
  return manifest_file + "." + std::to_string(epoch) + "." + std::to_string(rank);
}

std::string checksum(const std::string& header, const std::string& body) {
  boost::crc_32_type crc;
  crc.process_bytes(header.data(), header.size());
  crc.process_bytes(body.data(), body.size());
  return std::to_string(crc.checksum());
}

[[noreturn]] void fail(const std::string& file, const std::string& what) {
  throw CheckpointError(file + ": " + what);
}

void sync(const std::string& name, int flags) {
  const int descriptor = open(name.c_str(), flags);
  const bool synced = descriptor >= 0 && fsync(descriptor) == 0;
  if (descriptor >= 0) close(descriptor);
  if (!synced) fail(name, std::string("cannot be synced to the disk: ") + std::strerror(errno));
}

// Writes beside, syncs, renames, and syncs the folder, so that after a crash of the machine the
// file is either the old one or the new one.
void replace(const std::string& name, const std::string& content) {
  const std::string beside = name + ".tmp";
  {
    std::ofstream file(beside, std::ios::binary | std::ios::trunc);
    file << content;
    file.flush();
    if (!file) fail(beside, std::string("cannot be written: ") + std::strerror(errno));
  }
  sync(beside, O_RDONLY);
  std::error_code error;
  fs::rename(beside, name, error);
  if (error) fail(name, "cannot be put in place: " + error.message());
  const auto folder = fs::path(name).parent_path();
  sync(folder.empty() ? "." : folder.string(), O_RDONLY | O_DIRECTORY);
}

std::string content_of(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  if (!file) fail(name, std::string("cannot be read: ") + std::strerror(errno));
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// Both kinds of file are a header line of words, the last of which is the checksum of all else, and
// a body. @return the words after the magic and the version, and the body.
std::pair<std::istringstream, std::string> checked(const std::string& name, const char* magic) {
  const auto content = content_of(name);
  const auto line_end = content.find('\n');
  if (!content.starts_with(std::string(magic) + " ") || line_end == std::string::npos) {
    fail(name, "is no checkpoint file; expected one that begins with " + std::string(magic));
  }
  std::string header = content.substr(0, line_end);
  std::string body = content.substr(line_end + 1);
  const auto last_space = header.rfind(' ');
  const std::string stored = header.substr(last_space + 1);
  header.resize(last_space);

  std::istringstream words(header.substr(std::strlen(magic)));
  int version = 0;
  words >> version;
  if (version != format_version) {
    fail(name, "is of format version " + std::to_string(version) + "; expected " +
                   std::to_string(format_version));
  }
  if (stored != checksum(header, body)) fail(name, "is damaged: its checksum does not match");
  return {std::move(words), std::move(body)};
}

std::string with_checksum(const std::string& header, const std::string& body) {
  return header + " " + checksum(header, body) + "\n" + body;
}

void remove_with_parts(const std::string& manifest_file) {
  // A failed clean-up must not end a long run: it leaves files behind, nothing worse.
  try {
    const auto manifest = read_manifest(manifest_file);
    std::error_code ignored;
    for (int rank = 0; rank < manifest.ranks; ++rank) {
      fs::remove(part_name(manifest_file, manifest.epoch, rank), ignored);
    }
    fs::remove(manifest_file, ignored);
  } catch (const CheckpointError&) {
  }
}

// Reads all of a checkpoint and lets nothing wrong pass.
void verify(const std::string& manifest_file, std::uint64_t problem) {
  const auto manifest = read_manifest(manifest_file);
  if (manifest.problem != problem) fail(manifest_file, "is the checkpoint of another problem");
  for (int rank = 0; rank < manifest.ranks; ++rank) read_part(manifest_file, manifest, rank);
}

}  // namespace

void write_part(const std::string& file, const Manifest& manifest, int rank, const Bytes& payload) {
  std::ostringstream header;
  header << part_magic << ' ' << format_version << ' ' << manifest.problem << ' ' << manifest.epoch
         << ' ' << rank << ' ' << payload.size();
  replace(part_name(file, manifest.epoch, rank),
          with_checksum(header.str(), {payload.begin(), payload.end()}));
}

Bytes read_part(const std::string& manifest_file, const Manifest& manifest, int rank) {
  const auto name = part_name(manifest_file, manifest.epoch, rank);
  auto [words, body] = checked(name, part_magic);
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

void commit(const std::string& file, const Manifest& manifest) {
  std::ostringstream header;
  header << manifest_magic << ' ' << format_version << ' ' << manifest.problem << ' '
         << manifest.epoch << ' ' << manifest.ranks << ' ' << manifest.opened << ' '
         << manifest.fingerprint << ' ' << manifest.open;
  remove_with_parts(previous(file));
  std::error_code error;
  if (fs::exists(file)) fs::rename(file, previous(file), error);
  if (error) fail(file, "cannot be kept as the previous one: " + error.message());
  replace(file, with_checksum(header.str(), ""));
}

Manifest read_manifest(const std::string& manifest_file) {
  auto [words, body] = checked(manifest_file, manifest_magic);
  Manifest manifest;
  words >> manifest.problem >> manifest.epoch >> manifest.ranks >> manifest.opened >>
      manifest.fingerprint >> manifest.open;
  if (!words || manifest.ranks < 1) fail(manifest_file, "is damaged: its line is incomplete");
  return manifest;
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
    warning = std::string(newest.what()) + "; going on from " + previous(file);
    return previous(file);
  }
}

bool checkpoint_exists(const std::string& file) {
  return fs::exists(file) || fs::exists(previous(file));
}

}  // namespace kusabi::engine
