// What the finished parts of a question came to, in one file that grows: one record a part, in the
// order in which they were finished.
//
// The file begins with a line that says what it is and the facts that it belongs to; then come the
// records, each with its length, its number and a checksum. A record that is not whole, since its
// process was killed or a disk gave up, goes together with all behind it: that is done again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/checkpoint.hpp"
#include "engine/wire.hpp"

namespace kusabi::engine {

/// What a question depends on, each fact with its name: a journal of other facts is another's.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// A journal that another process has open.
class JournalInUse : public CheckpointError {
 public:
  using CheckpointError::CheckpointError;
};

class Journal {
 public:
  /// Opens the file, or begins it if there is none, and locks it as long as this lives. The lock is
  /// the kernel's, so it goes with the process, however that ends: who holds it lives.
  /// @throws JournalInUse if another process has it
  /// @throws CheckpointError if the file cannot be read or written, is none of these, or is of
  ///   other facts; then nothing in it has changed
  Journal(std::string file, const Facts& facts);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  [[nodiscard]] const std::string& file() const { return file_; }

  /// Records that are whole.
  [[nodiscard]] std::size_t size() const { return records_.size(); }

  /// What was wrong with the file, or with its lock, without making it useless: a line each.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

  /// What kind of thing the record is of, as it was appended.
  [[nodiscard]] const std::string& kind(std::size_t number) const { return records_[number].kind; }

  /// @throws CheckpointError if it cannot be read any more
  [[nodiscard]] Bytes content(std::size_t number) const;

  /// @throws CheckpointError if it cannot be written; the journal is as it was before
  void append(const std::string& kind, const Bytes& content);

  /// Whether nothing was left to do when it was last closed.
  [[nodiscard]] bool is_finished() const { return finished_; }

  /// Nothing is left to do, until something is appended all the same. @throws as append()
  void finish();

 private:
  struct Record {
    std::string kind;
    std::uint64_t first = 0;  // byte of the content in the file
    std::uint64_t size = 0;
  };

  void open_file();
  void lock();
  void begin(const std::string& beginning);
  // Where the records begin.
  std::uint64_t check_beginning(const Facts& facts);
  void read_records(std::uint64_t at);
  // Writes a record at the end; what is behind it goes. @return where its content begins
  std::uint64_t write_record(const std::string& kind, const Bytes& content);

  std::string file_;
  int descriptor_ = -1;
  std::uint64_t end_ = 0;  // of the last whole record
  bool finished_ = false;  // a mark of that is behind it
  std::vector<Record> records_;
  std::vector<std::string> warnings_;
};

}  // namespace kusabi::engine
