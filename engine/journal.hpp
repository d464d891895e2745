// Journal: an append-only file with the results of the finished parts of an analysis, one record
// per part, in the order in which they finished.
//
// The file begins with a header line and the facts that identify the analysis. The records follow,
// each with its length, its number and a checksum. An incomplete or damaged record (a killed
// process, a disk fault) is dropped together with all records after it; those parts are repeated.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/checkpoint.hpp"
#include "engine/wire.hpp"

namespace kusabi::engine {

/// Input of an analysis, by name. A journal with other facts belongs to another analysis.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// A journal that another process has open.
class JournalInUse : public CheckpointError {
 public:
  using CheckpointError::CheckpointError;
};

class Journal {
 public:
  /// Opens or creates the file, and locks it for the lifetime of this object. The kernel releases
  /// the lock when the process ends in any way.
  /// @throws JournalInUse if another process holds the lock
  /// @throws CheckpointError if the file cannot be read or written, is not a journal, or has other
  ///   facts; the file is then unchanged
  Journal(std::string file, const Facts& facts);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  [[nodiscard]] const std::string& file() const { return file_; }

  /// Number of complete records.
  [[nodiscard]] std::size_t size() const { return records_.size(); }

  /// Faults of the file, or of its lock, that leave it usable: one line each.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

  /// Kind of a record, as appended.
  [[nodiscard]] const std::string& kind(std::size_t number) const { return records_[number].kind; }

  /// @throws CheckpointError if the record cannot be read
  [[nodiscard]] Bytes content(std::size_t number) const;

  /// @throws CheckpointError if it cannot be written; the journal is then unchanged
  void append(const std::string& kind, const Bytes& content);

  /// True if the analysis was marked as finished and nothing was appended since.
  [[nodiscard]] bool is_finished() const { return finished_; }

  /// Marks the analysis as finished; a later append removes the mark. @throws as append()
  void finish();

 private:
  struct Record {
    std::string kind;
    std::uint64_t first = 0;  // offset of the content in the file
    std::uint64_t size = 0;
  };

  void open_file();
  void lock();
  void begin(const std::string& beginning);
  // Offset of the first record.
  std::uint64_t check_beginning(const Facts& facts);
  void read_records(std::uint64_t at);
  // Writes a record at the end and truncates the file after it. @return offset of its content
  std::uint64_t write_record(const std::string& kind, const Bytes& content);

  std::string file_;
  int descriptor_ = -1;
  std::uint64_t end_ = 0;  // offset of the end of the last complete record
  bool finished_ = false;  // a mark of completion follows the last record
  std::vector<Record> records_;
  std::vector<std::string> warnings_;
};

}  // namespace kusabi::engine
