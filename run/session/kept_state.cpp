// Opening of states of analyses: waits for another run, or refuses.
#include "run/session/kept_state.hpp"

#include <chrono>
#include <thread>

#include <fmt/format.h>

#include "engine/analysis/recording.hpp"
#include "engine/checkpoint.hpp"
#include "engine/checkpoint_check.hpp"
#include "run/output/standard_output.hpp"

namespace kusabi::run {
namespace {

constexpr auto between_two_looks = std::chrono::milliseconds(100);

std::unique_ptr<engine::Journal> journal_when_free(const std::string& state,
                                                   const engine::Facts& facts, double patience) {
  using Clock = std::chrono::steady_clock;
  const auto begun = Clock::now();
  for (bool announced = false;; announced = true) {
    try {
      return std::make_unique<engine::Journal>(state, facts);
    } catch (const engine::JournalInUse&) {
      if (std::chrono::duration<double>(Clock::now() - begun).count() >= patience) throw;
    }
    if (!announced)
      warn(fmt::format("{}: in use by another run; waiting up to {} s", state, patience));
    std::this_thread::sleep_for(between_two_looks);
  }
}

}  // namespace

void warn(const std::string& line) {
  print_warning("kusabi: warning: " + line);
}

void warn_all(Session& session, const std::vector<std::string>& lines) {
  if (!session.is_first()) return;
  for (const auto& line : lines) {
    if (!session.silent()) warn(line);
    session.note(line);
  }
}

std::unique_ptr<engine::Journal> opened_journal(const std::string& state,
                                                const engine::Facts& facts,
                                                std::uint64_t facts_fingerprint, double patience) {
  try {
    auto journal = journal_when_free(state, facts, patience);
    engine::expect_usable_checkpoint(*journal, facts_fingerprint);
    return journal;
  } catch (const engine::CheckpointError& error) {
    throw WrongInput(fmt::format("--resume {}", error.what()));
  }
}

KeptState state_of(const engine::Journal& journal) {
  KeptState state;
  state.searched = engine::has_searched(journal);
  state.searching = engine::is_searching(journal);
  state.finished = journal.is_finished();
  return state;
}

}  // namespace kusabi::run
