// The files of a checkpoint.
//
// A checkpoint is one part a rank and a manifest that lists them. Parts are named after the
// manifest, the epoch and the rank; each is written beside its place, synced to the disk and
// renamed. The rename of the manifest, which comes last, is what makes the epoch count. The
// manifest before it is kept as FILE.previous together with its parts, so there is a good one at
// any moment.
//
// Everything is verified when it is read: format, version, byte order, the fingerprint of the
// problem, epoch and rank, length and checksum of every part; and by the search that goes on, its
// goal and the types of its nodes and solutions. What fails is refused with one line.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "engine/wire.hpp"

namespace kusabi::engine {

/// A checkpoint that cannot be used; `what()` says which file and why, in one line.
class CheckpointError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What the manifest says.
struct Manifest {
  std::uint64_t problem = 0;      ///< fingerprint of the problem
  std::uint64_t epoch = 0;        ///< 1 for the first checkpoint of a search
  int ranks = 0;                  ///< as many parts
  std::uint64_t opened = 0;       ///< nodes opened so far, and
  std::uint64_t fingerprint = 0;  ///< the sum of their path hashes
  std::uint64_t open = 0;         ///< nodes in the parts
  std::string goal = {};          ///< of the search: name_of(Goal), and
  std::string node = {};          ///< what the compiler calls the type of its nodes
  std::string solution = {};  ///< … and of its solutions; all three empty in files of version 3

  friend bool operator==(const Manifest&, const Manifest&) = default;
};

/// Lets a search go on from a checkpoint only if it was written by one of the same problem, goal,
/// nodes and solutions.
/// @param manifest_file for the message @param own of the search that is to go on
/// @throws CheckpointError that says which of them differs
void expect_same_search(const std::string& manifest_file, const Manifest& found,
                        const Manifest& own);

/// Lets nothing take the place of a checkpoint that it does not go on from.
/// @param file where checkpoints will be written @param resume_from what the search goes on from,
/// or
///   empty
/// @throws CheckpointError if there is another checkpoint there, good or not
void expect_no_other(const std::string& file, const std::string& resume_from);

/// Writes one rank's part. @throws CheckpointError if the disk is full, or the like.
void write_part(const std::string& file, const Manifest& manifest, int rank, const Bytes& payload);

/// The payload of a part of the checkpoint that `manifest_file` (FILE or FILE.previous) describes.
/// @throws CheckpointError if it is not there, not of this checkpoint, or damaged
Bytes read_part(const std::string& manifest_file, const Manifest& manifest, int rank);

/// Makes the epoch count: the manifest there is becomes FILE.previous, and this one takes its
/// place. What neither of the two lists goes. Call when all parts are written.
/// @param before the epoch that was last found good or made to count, 0 if none. A manifest of
///   another epoch is not kept as FILE.previous; the one that is, is.
/// @throws CheckpointError; then the checkpoint of epoch `before` still counts
void commit(const std::string& file, const Manifest& manifest, std::uint64_t before);

/// Removes parts, also half-written ones, that neither FILE nor FILE.previous lists: those of runs
/// that were killed and of epochs that failed. Call when no rank is writing. Never throws a
/// CheckpointError.
void remove_leftovers(const std::string& file);

/// The greatest epoch that FILE or FILE.previous lists, with good parts or not; 0 if neither can be
/// read. A new epoch must be greater: its parts would otherwise mix with older ones.
std::uint64_t newest_epoch(const std::string& file);

/// @throws CheckpointError if it is not there, no manifest, or damaged
Manifest read_manifest(const std::string& manifest_file);

/// The newest checkpoint of `problem` that is whole: `file` or, if that one is damaged,
/// `file`.previous. Reads and verifies all parts.
/// @param warning receives why the newest was passed over, if it was
/// @throws CheckpointError with the fault of the newest if neither is good
std::string usable_checkpoint(const std::string& file, std::uint64_t problem, std::string& warning);

/// Removes a checkpoint that is no longer needed, with all its parts, if there is one. Never throws
/// a CheckpointError: what cannot be removed stays.
void remove_checkpoint(const std::string& file);

/// Whether there is a checkpoint, good or not, that a new search would overwrite.
bool checkpoint_exists(const std::string& file);

}  // namespace kusabi::engine
