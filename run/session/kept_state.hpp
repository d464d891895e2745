// States of analyses that --resume keeps, common to all subcommands.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/journal.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// Prints one line on standard error.
void warn(const std::string& line);

/// Reports warnings about the input, on rank 0 only: at once on standard error unless the session
/// is silent, and with the answer and in the result file.
void warn_all(Session& session, const std::vector<std::string>& lines);

/// The state file of --resume, opened or created; on rank 0. If another run holds it, the call
/// waits: a queue may begin a job while ranks of the previous one still write.
/// @param facts_fingerprint fingerprint of the facts
/// @param patience maximum waiting time in seconds
/// @throws WrongInput if it cannot be used
std::unique_ptr<engine::Journal> opened_journal(const std::string& state,
                                                const engine::Facts& facts,
                                                std::uint64_t facts_fingerprint, double patience);

/// Progress recorded in a state file.
struct KeptState {
  bool searched = false;   ///< a search is finished
  bool searching = false;  ///< a search is under way
  bool finished = false;   ///< all searches are finished

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& searched& searching& finished;
  }
};
KeptState state_of(const engine::Journal& journal);

}  // namespace kusabi::run
