// What the subcommands that search have in common about checkpoints: where to go on from.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/journal.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// One line on standard error.
void warn(const std::string& line);

/// The warnings of what was read, on rank 0 only: on standard error at once, and again beneath the
/// answer and in the result file.
void warn_all(Session& session, const std::vector<std::string>& lines);

/// The checkpoint to go on from, found on rank 0 and told to all; empty if none is asked for.
/// @param checkpoint where the state will be kept; empty: nowhere
/// @param restart what to go on from; empty: nothing
/// @param tree fingerprint of the tree, as in engine::CheckpointOptions
/// @throws WrongInput if one cannot be used
std::string restart_from(Session& session, const std::string& checkpoint,
                         const std::string& restart, std::optional<std::uint64_t> tree);

/// What --resume names, opened or begun; on rank 0. If another run has it, its end is waited for: a
/// queue may begin a turn while ranks of the last one still write.
/// @param question fingerprint of the facts @param patience seconds to wait
/// @throws WrongInput if it cannot be used
std::unique_ptr<engine::Journal> opened_journal(const std::string& state,
                                                const engine::Facts& facts, std::uint64_t question,
                                                double patience);

/// How far the question is that is kept in a journal.
struct KeptState {
  bool searched = false;   ///< a search is finished
  bool searching = false;  ///< one is under way
  bool finished = false;   ///< nothing is left to do

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& searched& searching& finished;
  }
};
KeptState state_of(const engine::Journal& journal);

}  // namespace kusabi::run
