// PartFiles: lines that all ranks write during a search, each into a file of its own, such as the
// proofs of a certificate or a long list of patterns. Rank 0 joins the parts at the end. Memory
// stays constant, and a killed run loses nothing that a checkpoint contains.
#pragma once

#include <cstdint>
#include <functional>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "run/session/session.hpp"

namespace kusabi::run {

/// The search that parts belong to.
struct PartsOwner {
  std::string option;      ///< that names the file, for messages
  std::string name;        ///< of the file into which the parts are joined
  std::string content;     ///< noun for their lines, for messages: "the evidence"
  std::uint64_t tree = 0;  ///< fingerprint of the searched tree
  std::string checkpoint;  ///< file that keeps the state of the search; empty: none
};

/// @throws WrongInput if the file is a device or a pipe, which has no place for parts
void require_file_name(const PartsOwner& owner);

/// Next line without its line end. A line without a line end, from a killed run, is not counted.
bool next_line(std::istream& file, std::string& line);

/// Names of the part files of NAME of a finished search, in the order of its runs and ranks.
/// @throws std::runtime_error if one belongs to another tree
std::vector<std::string> parts_of_finished(const PartsOwner& owner);

/// Calls `take` with each whole line of the parts but their first.
/// @throws std::runtime_error if one cannot be read
void read_parts(const std::vector<std::string>& parts,
                const std::function<void(std::string_view)>& take);

/// Removes all parts that can be removed.
void remove_parts(const std::string& name);

/// Part `rank` of a run is NAME.part.RUN.RANK until the parts are joined, and is locked while the
/// rank lives. Its first line identifies its tree and the checkpoint that it belongs to.
class PartFiles {
 public:
  /// Opens a part on every rank.
  /// @param goes_on the search resumes from a checkpoint: parts of the same tree must exist.
  ///        Otherwise parts that no search can resume from are removed, and any others are an error
  /// @throws WrongInput on every rank; std::runtime_error if a rank cannot open its part
  PartFiles(Session& session, PartsOwner owner, bool goes_on);
  PartFiles(const PartFiles&) = delete;
  PartFiles& operator=(const PartFiles&) = delete;
  /// Removes the parts if no later run can use them: without a checkpoint, or if one is incomplete.
  ~PartFiles();

  /// Writes whole lines. A full disk is reported by close().
  void put(std::string_view text);

  /// Closes this part; collective over all ranks.
  void close();

  /// Checks that all parts are complete, for a later run that resumes.
  /// @throws std::runtime_error if one is not
  /// @pre rank 0, closed
  void require() const;

  /// Names of the parts of this run and of those that it resumes, in the order of runs and ranks.
  /// Their first line is not content.
  /// @throws std::runtime_error if a part is missing or incomplete
  /// @pre rank 0, closed
  [[nodiscard]] std::vector<std::string> all() const;

 private:
  [[nodiscard]] std::string prepare(bool goes_on) const;

  Session& session_;
  PartsOwner owner_;
  std::string run_;
  int part_ = -1;        // a file descriptor
  bool failed_ = false;  // of this part; after close() of any part
};

}  // namespace kusabi::run
