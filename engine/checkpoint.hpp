// Checkpoint files.
//
// A checkpoint consists of one part file per rank and a manifest that lists them. Parts are named
// after the manifest, the epoch and the rank. Each file is written under a temporary name, synced
// to the disk and renamed. The rename of the manifest comes last and makes the epoch valid. The
// manifest before it is kept as FILE.previous together with its parts, so that a valid checkpoint
// exists at any moment.
//
// Reading verifies format, version, byte order, the fingerprint of the problem, epoch and rank, and
// length and checksum of every part; the search that resumes verifies its goal and the types of its
// nodes and solutions. A fault is reported in one line.
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <streambuf>
#include <string>

#include "engine/wire.hpp"

namespace kusabi::engine {

/// An unusable checkpoint; `what()` names the file and the fault in one line.
class CheckpointError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Content of the manifest.
struct Manifest {
  std::uint64_t problem = 0;      ///< fingerprint of the problem
  std::uint64_t epoch = 0;        ///< 1 for the first checkpoint of a search
  int ranks = 0;                  ///< number of parts
  std::uint64_t opened = 0;       ///< nodes opened so far
  std::uint64_t fingerprint = 0;  ///< mark sum of these nodes
  std::uint64_t open = 0;         ///< nodes in the parts
  std::string goal = {};          ///< of the search: name_of(Goal)
  std::string node = {};          ///< mangled name of the node type
  /// mangled name of the solution type; goal and types are empty in files of version 3
  std::string solution = {};

  friend bool operator==(const Manifest&, const Manifest&) = default;
};

/// Requires that a checkpoint was written by a search for the same problem, goal, nodes and
/// solutions.
/// @param manifest_file name for the message @param own manifest of the search that resumes
/// @throws CheckpointError that names the first difference
void expect_same_search(const std::string& manifest_file, const Manifest& found,
                        const Manifest& own);

/// Prevents a search from finding out at its first checkpoint that it cannot write any.
/// @throws CheckpointError unless the folder of `file` exists
void expect_folder(const std::string& file);

/// Prevents a new search from overwriting a checkpoint from which it does not resume.
/// @param file manifest to be written @param resume_from manifest to resume from, or empty
/// @throws CheckpointError if `file` is another checkpoint, valid or not
void expect_no_other(const std::string& file, const std::string& resume_from);

/// Writes the part of one rank, without a copy in memory.
/// @param save writes the payload, the same bytes at each of three calls: its size and its checksum
///     are before it in the file
/// @throws CheckpointError on a failed write, for example a full disk
void write_part(const std::string& file, const Manifest& manifest, int rank,
                const std::function<void(std::streambuf&)>& save);

/// Payload of one part of a checkpoint. @param manifest_file FILE or FILE.previous
/// @throws CheckpointError if the part is missing, of another checkpoint, or damaged
Bytes read_part(const std::string& manifest_file, const Manifest& manifest, int rank);

/// Makes an epoch valid: FILE becomes FILE.previous, and `manifest` becomes FILE. Removes files
/// that neither lists. @pre all parts are written
/// @param before the last epoch verified or committed by this search, 0 if none. FILE is kept as
///   FILE.previous only if it is of that epoch; otherwise FILE.previous stays
/// @throws CheckpointError; the checkpoint of epoch `before` is then still valid
void commit(const std::string& file, const Manifest& manifest, std::uint64_t before);

/// Removes parts, complete or not, that neither FILE nor FILE.previous lists: those of killed runs
/// and of failed epochs. Never throws a CheckpointError. @pre no rank is writing
void remove_leftovers(const std::string& file);

/// Greatest epoch that FILE or FILE.previous lists, with valid parts or not; 0 if neither can be
/// read. A new epoch must be greater, or its parts would mix with older ones.
std::uint64_t newest_epoch(const std::string& file);

/// @throws CheckpointError if the file is missing, not a manifest, or damaged
Manifest read_manifest(const std::string& manifest_file);

/// Manifest of the newest valid checkpoint of `problem`: `file` or, if that one is damaged,
/// `file`.previous. Reads and verifies all parts.
/// @param warning receives the fault of the newest checkpoint if that one is skipped
/// @throws CheckpointError with the fault of the newest checkpoint if none is valid
std::string usable_checkpoint(const std::string& file, std::uint64_t problem, std::string& warning);

/// Removes a checkpoint with all its parts, if there is one. Never throws a CheckpointError; files
/// that cannot be removed stay.
void remove_checkpoint(const std::string& file);

/// True if there is a checkpoint, valid or not, that a new search would overwrite.
bool checkpoint_exists(const std::string& file);

}  // namespace kusabi::engine
