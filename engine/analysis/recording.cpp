// Recording: rank 0 reads and writes the journal and broadcasts its records.
#include "engine/analysis/recording.hpp"

#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include "engine/checkpoint_check.hpp"
#include "engine/collectives.hpp"

namespace kusabi::engine {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view search_kind = "search of ";

std::string checkpoint_of_part(const std::string& file, const std::string& number) {
  return file + ".search" + number;
}

// Hash of a part; parts with successive numbers get unrelated fingerprints.
std::uint64_t fingerprint_of_part(std::uint64_t facts_fingerprint, std::uint64_t number) {
  constexpr std::uint64_t odd = 0x9E3779B97F4A7C15U;  // 2^64 / golden ratio
  return facts_fingerprint + odd * (number + 1);
}

// Record of a part, as broadcast by rank 0.
struct RecordedPart {
  bool known = false;
  Bytes content;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& known& content;
  }
};

}  // namespace

std::string checkpoint_of_part(const std::string& file, std::uint64_t number) {
  return checkpoint_of_part(file, std::to_string(number));
}

std::string kind_of_search(const std::string& problem) {
  return std::string(search_kind) + problem;
}

bool has_searched(const Journal& journal) {
  for (std::size_t i = 0; i < journal.size(); ++i) {
    if (journal.kind(i).starts_with(search_kind)) return true;
  }
  return false;
}

bool is_searching(const Journal& journal) {
  const auto place = fs::absolute(journal.file());
  const auto beginning = checkpoint_of_part(place.filename().string(), "");
  std::error_code error;
  for (fs::directory_iterator entry(place.parent_path(), error), end; !error && entry != end;
       entry.increment(error)) {
    const auto name = entry->path().filename().string();
    if (!name.starts_with(beginning)) continue;
    const auto digits = name.find_first_not_of("0123456789", beginning.size());
    if (digits == std::string::npos && checkpoint_exists(entry->path().string())) return true;
  }
  return false;
}

void expect_usable_checkpoint(const Journal& journal, std::uint64_t facts_fingerprint) {
  const auto file = checkpoint_of_part(journal.file(), journal.size());
  if (!checkpoint_exists(file)) return;
  try {
    std::string warning;  // reported when the search resumes
    usable_checkpoint(file, fingerprint_of_part(facts_fingerprint, journal.size()), warning);
  } catch (const CheckpointError& error) {
    throw CheckpointError(std::string(error.what()) + "; without " + file +
                          "* this search would start again");
  }
}

Recording::Recording(Transport& transport, JournalOptions journal_options,
                     std::function<void(const std::string&)> warn)
    : transport_(transport), journal_options_(std::move(journal_options)), warn_(std::move(warn)) {}

std::optional<Bytes> Recording::known(const std::string& kind, bool spent, bool for_all) {
  if (!replaying_ || !sound(spent)) return std::nullopt;
  Bytes own;
  auto recorded = from_first_rank(transport_, [&] {
    auto& journal = *journal_options_.journal;
    if (next_ >= journal.size()) return RecordedPart{};
    if (journal.kind(next_) != kind) {
      throw CheckpointError(journal.file() + ": its part " + std::to_string(next_ + 1) +
                            " is of something else; expected the same build of kusabi, or another "
                            "file");
    }
    // A killed run may have left a checkpoint of this part.
    remove_checkpoint(checkpoint_of_part(journal_options_.file, next_));
    own = journal.content(next_);
    return RecordedPart{true, for_all ? own : Bytes()};
  });
  replaying_ = recorded.known;
  if (!recorded.known) return std::nullopt;
  ++next_;
  if (is_first()) return own;
  return std::move(recorded.content);
}

bool Recording::sound(bool spent) {
  if (!sound_) return false;
  // The reduction counts the ranks that were asked to stop.
  sound_ = all_reduce(transport_, {.ranks = 1, .found = spent ? 1U : 0U}).found == 0;
  return sound_;
}

CheckpointOptions Recording::checkpoint() {
  const auto file = checkpoint_of_part(journal_options_.file, next_);
  const auto problem = fingerprint_of_part(journal_options_.facts_fingerprint, next_);
  auto resume_from = from_first_rank(transport_, [&]() -> std::string {
    if (!checkpoint_exists(file)) return {};
    std::string warning;
    auto usable = usable_checkpoint(file, problem, warning);
    if (!warning.empty() && warn_) warn_(warning);
    return usable;
  });
  return {.file = file,
          .interval = journal_options_.interval,
          .on_improvement = journal_options_.on_improvement,
          .resume_from = std::move(resume_from),
          .problem = problem};
}

void Recording::keep(const std::string& kind, const Bytes& content) {
  const auto number = next_++;
  if (!is_first() || !writable_) return;
  try {
    journal_options_.journal->append(kind, content);
  } catch (const CheckpointError& error) {
    writable_ = false;  // a missing part must not be followed by a present one
    if (warn_) warn_(std::string(error.what()) + "; no further results are stored");
    return;
  }
  remove_checkpoint(checkpoint_of_part(journal_options_.file, number));
}

}  // namespace kusabi::engine
