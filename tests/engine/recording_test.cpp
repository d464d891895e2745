// Recording tests: finished parts of an analysis are not repeated in the next run, and interrupted
// parts are not taken as finished.
#include "engine/analysis/recording.hpp"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/analysis/analysis.hpp"
#include "engine/journal.hpp"
#include "engine/transport/single_process.hpp"
#include "tests/engine/queens.hpp"

namespace kusabi::engine {
namespace {

namespace fs = std::filesystem;
using examples::Queens;
using testing::HasSubstr;
using testing::ThrowsMessage;

const Facts these_facts{{"the problem", "7"}, {"--mu", "0.65"}, {"--thorough", ""}};

class Recorded : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "kusabi recording-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    file_ = (folder_ / "state").string();
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string content() const {
    std::ifstream file(file_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  void write(const std::string& content) const {
    std::ofstream(file_, std::ios::binary | std::ios::trunc) << content;
  }
  [[nodiscard]] auto refusal(const Facts& facts) const {
    return [this, facts] { const Journal journal(file_, facts); };
  }
  void keep_two() const {
    Journal journal(file_, these_facts);
    journal.append("first", {'1'});
    journal.append("second", {'2', '2'});
  }

  fs::path folder_;
  std::string file_;
};

using JournalFile = Recorded;

TEST_F(JournalFile, ReadsAppendedRecords) {
  keep_two();
  Journal journal(file_, these_facts);
  ASSERT_EQ(journal.size(), 2U);
  EXPECT_EQ(journal.kind(1), "second");
  EXPECT_EQ(journal.content(1), (Bytes{'2', '2'}));
  EXPECT_EQ(journal.content(0), Bytes{'1'});
  EXPECT_TRUE(journal.warnings().empty());
  EXPECT_FALSE(journal.is_finished());
}

TEST_F(JournalFile, IsFinishedUntilSomethingIsAppended) {
  keep_two();
  Journal(file_, these_facts).finish();
  {
    Journal journal(file_, these_facts);
    EXPECT_TRUE(journal.is_finished());
    EXPECT_EQ(journal.size(), 2U);
    journal.append("third", {});
    EXPECT_FALSE(journal.is_finished());
  }
  const Journal journal(file_, these_facts);
  EXPECT_EQ(journal.size(), 3U);
  EXPECT_FALSE(journal.is_finished());
  EXPECT_TRUE(journal.warnings().empty());
}

TEST_F(JournalFile, RefusesACallWithDifferentFacts) {
  keep_two();
  const auto before = content();
  EXPECT_THAT(refusal({{"the problem", "7"}, {"--mu", "0.7"}, {"--thorough", ""}}),
              ThrowsMessage<CheckpointError>(
                  HasSubstr("was started with --mu 0.65, and this call has --mu 0.7")));
  EXPECT_THAT(refusal({{"the problem", "7"}, {"--mu", "0.65"}}),
              ThrowsMessage<CheckpointError>(
                  HasSubstr("was started with --thorough, and this call has no --thorough")));
  EXPECT_EQ(content(), before);
}

TEST_F(JournalFile, IsUsedByOneProcessAtATime) {
  const Journal journal(file_, these_facts);
  EXPECT_THAT(refusal(these_facts), ThrowsMessage<CheckpointError>(HasSubstr("is in use")));
}

TEST_F(JournalFile, RefusesAFileThatIsNoJournal) {
  for (const auto* const text : {"name = \"truss\"\n", "kusabi-checkpoint 4 1 2 3\n"}) {
    write(text);
    EXPECT_THAT(refusal(these_facts), ThrowsMessage<CheckpointError>(HasSubstr("is not a state")));
    EXPECT_EQ(content(), text);
  }
}

TEST_F(JournalFile, TruncatedAnywhereKeepsWholeRecordsOrIsRefused) {
  keep_two();
  const auto whole = content();
  std::array<int, 3> found{};
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write(whole.substr(0, length));
    Journal journal(file_, these_facts);
    ASSERT_LT(journal.size(), 2U) << length;
    ++found[journal.size()];
    if (journal.size() == 1) {
      EXPECT_EQ(journal.content(0), Bytes{'1'});
    }
    // Records appended now are read again.
    journal.append("again", {'3'});
    EXPECT_EQ(journal.kind(journal.size() - 1), "again");
  }
  EXPECT_GT(found[0], 0);
  EXPECT_GT(found[1], 0);
}

TEST_F(JournalFile, WithAnyBitFlippedKeepsWholeRecordsOrIsRefused) {
  keep_two();
  const auto whole = content();
  int refused = 0;
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    auto broken = whole;
    broken[bit / 8] = static_cast<char>(broken[bit / 8] ^ (1 << (bit % 8)));
    write(broken);
    try {
      const Journal journal(file_, these_facts);
      ASSERT_LT(journal.size(), 2U) << bit;
      EXPECT_EQ(journal.warnings().size(), 1U) << bit;
      if (journal.size() == 1) {
        EXPECT_EQ(journal.content(0), Bytes{'1'});
      }
    } catch (const CheckpointError&) {
      ++refused;
      EXPECT_EQ(content(), broken);
    }
  }
  EXPECT_GT(refused, 0);
}

// An analysis of two searches, shared work that determines the size of the second, and work of rank
// 0.
struct Answer {
  std::size_t first = 0, second = 0;
  std::vector<std::uint64_t> squares;
  int broadcast = 0;
  std::uint64_t opened = 0;  // in this run and those before

  friend bool operator==(const Answer&, const Answer&) = default;
};

class ResumedAnalysis : public Recorded {
 protected:
  // One run, which is stopped after `reductions` reductions.
  Answer run(int reductions = 1'000'000) {
    Journal journal(file_, these_facts);
    SingleProcess alone;
    int left = reductions;
    AnalysisOptions analysis_options;
    analysis_options.interrupt = [&left] { return --left < 0 ? Interrupt::stop : Interrupt::none; };
    analysis_options.journal_options =
        JournalOptions{.journal = &journal, .file = file_, .interval = 0, .facts_fingerprint = 5};
    Analysis analysis(alone, std::move(analysis_options));
    done_ = 0;
    Options options;
    options.reduction_interval = 0;
    options.nodes_per_step = 20;
    Answer answer;
    Queens small(6);
    const auto first = analysis.search(small, options);
    answer.first = first.solutions.size();
    answer.squares = analysis.share<std::uint64_t>(4, [this](std::uint64_t number) {
      ++done_;
      return number * number;
    });
    Queens large(static_cast<int>(answer.squares.back()) - 1);
    const auto second = analysis.search(large, options);
    answer.second = second.solutions.size();
    answer.broadcast = analysis.by_first_rank([this] {
      ++done_;
      return 42;
    });
    answer.opened = first.opened() + second.opened();
    ended_ = analysis.budget().spent();
    return answer;
  }

  int done_ = 0;  // parts that are not searches, in the last run
  bool ended_ = false;
};

const Answer the_answer{4, 92, {0, 1, 4, 9}, 42, 153 + 2057};

TEST_F(ResumedAnalysis, HasTheExpectedResultWithoutAnInterruption) {
  EXPECT_EQ(run(), the_answer);
  EXPECT_EQ(done_, 5);
}

TEST_F(ResumedAnalysis, RepeatsNoFinishedSearch) {
  run();
  EXPECT_EQ(run(), the_answer);
  EXPECT_EQ(done_, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);  // no checkpoint is left
}

TEST_F(ResumedAnalysis, OpensEachNodeOnceInAnyNumberOfRuns) {
  int runs = 0;
  Answer answer;
  do {
    answer = run(25);
    ++runs;
  } while (ended_ && runs < 1000);
  EXPECT_GT(runs, 3);
  EXPECT_EQ(answer, the_answer);
}

TEST_F(ResumedAnalysis, RecordsNoStoppedSearchAsFinished) {
  run(0);
  EXPECT_EQ(Journal(file_, these_facts).size(), 0U);
  EXPECT_EQ(run(), the_answer);
}

TEST_F(ResumedAnalysis, ComputesDamagedRecordsAgain) {
  run();
  const auto kept = content();
  for (const double share : {0.3, 0.6, 0.9}) {
    auto broken = kept;
    auto& letter = broken[static_cast<std::size_t>(share * static_cast<double>(kept.size()))];
    letter = static_cast<char>(letter ^ 1);
    write(broken);
    EXPECT_EQ(run(), the_answer);
    EXPECT_EQ(content().size(), kept.size());
  }
}

// A search with a limit of its own, which may be larger than what the run has left.
TEST_F(ResumedAnalysis, RecordsNoSearchOfOneRankThatTheLimitOfTheRunEnded) {
  const auto opened = [this](std::uint64_t nodes) {
    Journal journal(file_, these_facts);
    SingleProcess alone;
    AnalysisOptions analysis_options;
    analysis_options.limits.nodes = nodes;
    analysis_options.journal_options =
        JournalOptions{.journal = &journal, .file = file_, .interval = 0, .facts_fingerprint = 5};
    Analysis analysis(alone, std::move(analysis_options));
    return analysis.by_first_rank([&analysis] {
      Queens queens(6);
      Options options;
      options.limits.nodes = 1000;
      return analysis.search_alone(queens, options).opened();
    });
  };
  EXPECT_LT(opened(20), 153U);
  EXPECT_EQ(opened(1000), 153U);
}

TEST_F(ResumedAnalysis, RefusesTheRecordsOfAnotherBuild) {
  {
    Journal journal(file_, these_facts);
    journal.append("search of something else", {});
  }
  EXPECT_THROW(run(), CheckpointError);
}

}  // namespace
}  // namespace kusabi::engine
