// Checkpoints and states: found, opened, or refused.
#include "run/session/restart.hpp"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

#include "engine/analysis/recording.hpp"
#include "engine/checkpoint.hpp"
#include "engine/kept_search.hpp"
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

// Checked before the search, so that a wrong name is reported at once.
void require_writable_folder(const std::string& checkpoint) {
  const auto folder = std::filesystem::absolute(checkpoint).parent_path();
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    throw WrongInput(fmt::format("--checkpoint {}: cannot be written: {}: {}", checkpoint,
                                 folder.string(), std::strerror(errno)));
  }
}

}  // namespace

void warn(const std::string& line) {
  print_warning("kusabi: warning: " + line);
}

void warn_all(Session& session, const std::vector<std::string>& lines) {
  if (!session.speaks()) return;
  for (const auto& line : lines) {
    warn(line);
    session.note(line);
  }
}

std::string restart_from(Session& session, const std::string& checkpoint,
                         const std::string& restart, std::optional<std::uint64_t> tree) {
  return session.from_first_rank([&]() -> std::string {
    if (!checkpoint.empty()) require_writable_folder(checkpoint);
    // The engine refuses to overwrite a checkpoint, too; this message contains the call that
    // resumes.
    if (!checkpoint.empty() && restart != checkpoint && engine::checkpoint_exists(checkpoint)) {
      throw WrongInput(
          fmt::format("--checkpoint {}: exists already; expected --restart {} to resume from it, "
                      "its removal, or another name",
                      checkpoint, checkpoint));
    }
    if (restart.empty()) return {};
    try {
      std::string warning;
      auto file = engine::usable_checkpoint(restart, tree.value(), warning);
      if (!warning.empty()) warn(warning);
      return file;
    } catch (const engine::CheckpointError& error) {
      throw WrongInput(fmt::format("--restart {}", error.what()));
    }
  });
}

std::unique_ptr<engine::Journal> opened_journal(const std::string& state,
                                                const engine::Facts& facts, std::uint64_t question,
                                                double patience) {
  try {
    auto journal = journal_when_free(state, facts, patience);
    engine::expect_usable_search(*journal, question);
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
