// Checkpoint tests: stopping and resuming, any number of times and on any number of ranks, gives
// the outcome of one run; damaged and foreign files are refused.
#include "engine/checkpoint.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include <boost/crc.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/simulation.hpp"
#include "support/thorough.hpp"
#include "tests/engine/knapsack.hpp"
#include "tests/engine/random_tree.hpp"

namespace kusabi::engine {
namespace {

namespace fs = std::filesystem;
using examples::Knapsack;
using examples::RandomTree;
using testing::HasSubstr;

constexpr std::uint64_t problem = 42;

class Checkpoint : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "kusabi-checkpoint-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    file_ = (folder_ / "search").string();
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] Options options() const {
    Options options;
    options.reduction_interval = 20e-6;
    options.checkpoint.file = file_;
    options.checkpoint.interval = 1e9;
    options.checkpoint.problem = problem;
    options.pool = pool_;
    return options;
  }

  // Runs a search of `tree` in pieces, each ended by a limit of nodes, each on another number of
  // ranks and in the next of `orders`, and resumed from the last checkpoint.
  template <class P>
  Outcome<P> in_pieces(const P& tree, std::uint64_t piece, std::uint64_t seed, Goal goal,
                       int* pieces, const std::vector<Order>& orders = {Order::depth_first}) {
    auto choice = options();
    choice.goal = goal;
    for (*pieces = 1;; ++*pieces) {
      choice.limits.nodes = piece * static_cast<std::uint64_t>(*pieces);
      choice.order = orders[static_cast<std::size_t>(*pieces) % orders.size()];
      const int ranks = 1 + static_cast<int>((seed + static_cast<std::uint64_t>(*pieces)) % 5);
      auto simulated = simulate(tree, ranks, seed, {}, choice);
      EXPECT_EQ(simulated.left_behind, 0U);
      if (simulated.outcome.status == Status::solved) return std::move(simulated.outcome);
      EXPECT_EQ(simulated.outcome.status, Status::node_limit);
      std::string warning;
      choice.checkpoint.resume_from = usable_checkpoint(file_, problem, warning);
      EXPECT_EQ(warning, "");
    }
  }

  [[nodiscard]] std::vector<fs::path> parts() const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      if (entry.path() != file_ && entry.path().extension() != ".previous") {
        found.push_back(entry.path());
      }
    }
    return found;
  }

  // Leaves a checkpoint of a search on three ranks.
  void leave_one() {
    auto choice = options();
    choice.limits.nodes = 500;
    simulate(RandomTree(1, 20), 3, 1, {}, choice);
    ASSERT_EQ(read_manifest(file_).ranks, 3);
  }

  [[nodiscard]] std::string refusal() const {
    try {
      std::string warning;
      return "accepted " + usable_checkpoint(file_, problem, warning);
    } catch (const CheckpointError& error) {
      return error.what();
    }
  }

  fs::path folder_;
  std::string file_;
  Pool pool_;
};

std::string content(const fs::path& name) {
  std::ifstream file(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void overwrite(const fs::path& name, const std::string& bytes) {
  std::ofstream(name, std::ios::binary | std::ios::trunc) << bytes;
}

TEST_F(Checkpoint, OutcomeIsTheSameAfterManyStops) {
  RandomTree tree(2, 16);
  const auto whole = search(tree);
  for (std::uint64_t seed = 1; seed <= (test::thorough ? 20 : 6); ++seed) {
    fs::remove_all(folder_);
    fs::create_directory(folder_);
    int pieces = 0;
    const auto outcome = in_pieces(RandomTree(2, 16), 1500, seed, Goal::all, &pieces);
    EXPECT_GT(pieces, 4);
    EXPECT_EQ(outcome.opened(), whole.opened());
    EXPECT_EQ(outcome.fingerprint(), whole.fingerprint());
    ASSERT_EQ(outcome.solutions.size(), whole.solutions.size());
    for (std::size_t i = 0; i < whole.solutions.size(); ++i) {
      ASSERT_EQ(outcome.solutions[i].path, whole.solutions[i].path);
      ASSERT_EQ(outcome.solutions[i].solution, whole.solutions[i].solution);
    }
    EXPECT_EQ(outcome.tally(), tree.tally());
  }
}

TEST_F(Checkpoint, KeepsTheBestSolution) {
  auto knapsack = Knapsack::random(5, 24);
  Options best;
  best.goal = Goal::best;
  const auto whole = search(knapsack, best);
  int pieces = 0;
  const auto outcome = in_pieces(knapsack, whole.opened() / 5, 3, Goal::best, &pieces);
  EXPECT_GT(pieces, 2);
  ASSERT_EQ(outcome.solutions.size(), 1U);
  EXPECT_EQ(outcome.solutions[0].path, whole.solutions[0].path);
  EXPECT_EQ(outcome.bound, whole.bound);
}

TEST_F(Checkpoint, KeepsTheSolutionsOfAPool) {
  auto knapsack = Knapsack::random(5, 18);
  pool_ = {.count = 30, .gap = 3};
  Options best;
  best.goal = Goal::best;
  best.pool = pool_;
  const auto whole = search(knapsack, best);
  ASSERT_GT(whole.solutions.size(), 10U);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    fs::remove_all(folder_);
    fs::create_directory(folder_);
    int pieces = 0;
    const auto outcome = in_pieces(knapsack, whole.opened() / 7, seed, Goal::best, &pieces);
    EXPECT_GT(pieces, 3);
    ASSERT_EQ(outcome.solutions.size(), whole.solutions.size());
    for (std::size_t i = 0; i < whole.solutions.size(); ++i) {
      EXPECT_EQ(outcome.solutions[i].path, whole.solutions[i].path);
    }
  }
}

TEST_F(Checkpoint, OneRankOpensNoMoreNodesThanTheLimitOverAllRuns) {
  auto choice = options();
  auto tree = RandomTree(1, 20);
  for (const std::uint64_t limit : {500U, 777U, 778U}) {
    choice.limits.nodes = limit;
    const auto outcome = search(tree, choice);
    EXPECT_EQ(outcome.status, Status::node_limit);
    EXPECT_EQ(outcome.opened(), limit);
    std::string warning;
    choice.checkpoint.resume_from = usable_checkpoint(file_, problem, warning);
  }
}

// Nodes that a larger pool requires may have been pruned.
TEST_F(Checkpoint, OfAnotherPoolIsRefused) {
  auto choice = options();
  choice.goal = Goal::best;
  choice.limits.nodes = 20;
  simulate(Knapsack::random(5, 24), 3, 1, {}, choice);
  choice.checkpoint.resume_from = file_;
  choice.pool = {.count = 2, .gap = 0.5};
  choice.cutoff = -7;
  auto knapsack = Knapsack::random(5, 24);
  try {
    search(knapsack, choice);
    FAIL();
  } catch (const CheckpointError& error) {
    EXPECT_EQ(error.what(), file_ +
                                ": is of a search with the goal best; expected the goal "
                                "best,count=2,gap=0.5,cutoff=-7");
  }
}

// The interval never elapses, so a checkpoint is written only when the incumbent improves; it
// contains that incumbent.
TEST_F(Checkpoint, IsWrittenWhenTheIncumbentImproves) {
  auto choice = options();
  choice.goal = Goal::best;
  choice.reduction_interval = 0;
  choice.nodes_per_step = 1;
  int several = 0;  // searches with several checkpoints
  for (unsigned seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    std::vector<double> kept;  // incumbents of the checkpoints
    double best = 0;
    std::uint64_t epoch = 0;
    choice.progress = [&](const Progress& progress) {
      const auto newest = checkpoint_exists(file_) ? read_manifest(file_).epoch : 0;
      if (newest != epoch) kept.push_back(best);
      epoch = newest;
      best = progress.objective;
    };
    auto knapsack = Knapsack::random(seed, 16);
    choice.checkpoint.on_improvement = false;
    search(knapsack, choice);
    EXPECT_TRUE(kept.empty());
    choice.checkpoint.on_improvement = true;
    const auto outcome = search(knapsack, choice);
    EXPECT_EQ(outcome.status, Status::solved);
    EXPECT_EQ(std::ranges::adjacent_find(kept, std::less_equal()), kept.end());
    ASSERT_FALSE(kept.empty());
    EXPECT_EQ(kept.back(), outcome.bound);
    if (kept.size() > 1) ++several;
    remove_checkpoint(file_);
  }
  EXPECT_GT(several, 0);
}

TEST_F(Checkpoint, ResumesInAnotherOrder) {
  auto knapsack = Knapsack::random(4, 12);
  const auto whole = search(knapsack);
  int pieces = 0;
  const auto outcome = in_pieces(knapsack, whole.opened() / 9, 2, Goal::all, &pieces,
                                 {Order::best_first, Order::depth_first, Order::hybrid});
  EXPECT_GT(pieces, 6);
  EXPECT_EQ(outcome.opened(), whole.opened());
  EXPECT_EQ(outcome.fingerprint(), whole.fingerprint());
  EXPECT_EQ(outcome.solutions.size(), whole.solutions.size());
}

TEST_F(Checkpoint, PeriodicWritingDoesNotChangeTheSearch) {
  RandomTree tree(2, 16);
  const auto whole = search(tree);
  auto choice = options();
  choice.checkpoint.interval = 1e-3;
  const auto simulated = simulate(RandomTree(2, 16), 4, 1, {}, choice);
  EXPECT_EQ(simulated.outcome.fingerprint(), whole.fingerprint());
  EXPECT_GE(read_manifest(file_).epoch, 3U);
  // Two epochs are kept, with four parts each, and nothing else.
  EXPECT_EQ(parts().size(), 8U);
  EXPECT_TRUE(fs::exists(file_ + ".previous"));
}

TEST_F(Checkpoint, ResumesFromAPeriodicCheckpointAsFromAStop) {
  RandomTree tree(2, 16);
  const auto whole = search(tree);
  auto choice = options();
  choice.checkpoint.interval = 1e-3;
  simulate(RandomTree(2, 16), 4, 1, {}, choice);
  // As if that run had been killed after its last checkpoint.
  for (const auto* from : {"", ".previous"}) {
    choice.checkpoint.file = "";
    choice.checkpoint.resume_from = file_ + from;
    const auto again = simulate(RandomTree(2, 16), 3, 1, {}, choice);
    EXPECT_EQ(again.outcome.fingerprint(), whole.fingerprint());
    EXPECT_EQ(again.outcome.solutions.size(), whole.solutions.size());
  }
}

TEST_F(Checkpoint, TheManifestSumsUpItsParts) {
  leave_one();
  const auto manifest = read_manifest(file_);
  EXPECT_EQ(manifest.problem, problem);
  EXPECT_EQ(manifest.epoch, 1U);
  EXPECT_GE(manifest.opened, 500U);
  EXPECT_GT(manifest.open, 0U);
  EXPECT_EQ(parts().size(), 3U);
}

TEST_F(Checkpoint, OfAnotherProblemIsRefused) {
  leave_one();
  std::string warning;
  EXPECT_THROW(usable_checkpoint(file_, problem + 1, warning), CheckpointError);
}

// A default fingerprint would be the same for all problems.
TEST_F(Checkpoint, NeedsTheFingerprintOfItsProblem) {
  Options file_only;
  file_only.checkpoint.file = file_;
  RandomTree tree(1, 5);
  EXPECT_THROW(search(tree, file_only), std::invalid_argument);
  leave_one();
  Options goes_on;
  goes_on.checkpoint.resume_from = file_;
  EXPECT_THROW(search(tree, goes_on), std::invalid_argument);
}

struct OtherSolutions : RandomTree {
  using Solution = std::uint32_t;
  using RandomTree::RandomTree;
  void expand(Node&& /*node*/, Expansion<OtherSolutions>& /*out*/) {}
};

TEST_F(Checkpoint, OfAnotherSearchIsRefused) {
  leave_one();
  auto choice = options();
  choice.checkpoint.resume_from = file_;
  const auto refusal_of = [&](auto tree) -> std::string {
    try {
      search(tree, choice);
      return "accepted";
    } catch (const CheckpointError& error) {
      return error.what();
    }
  };
  choice.goal = Goal::first;
  EXPECT_EQ(refusal_of(RandomTree(1, 20)),
            file_ + ": is of a search with the goal all; expected the goal first");
  choice.goal = Goal::all;
  EXPECT_EQ(refusal_of(Knapsack::random(5, 24)),
            file_ + ": is of a search with nodes of type kusabi::examples::RandomTree::Node; " +
                "expected nodes of type kusabi::examples::Knapsack::Node");
  EXPECT_EQ(refusal_of(OtherSolutions(1, 20)),
            file_ +
                ": is of a search with solutions of type unsigned long; expected solutions of " +
                "type unsigned int");
  choice.checkpoint.problem = problem + 1;
  EXPECT_EQ(refusal_of(RandomTree(1, 20)), file_ + ": is the checkpoint of another problem");
}

TEST_F(Checkpoint, OfAnotherByteOrderIsRefused) {
  leave_one();
  auto line = content(file_);
  line.resize(line.rfind(' '));  // without the checksum
  const std::string own = std::endian::native == std::endian::little ? "little" : "big";
  const std::string other = own == "big" ? "little" : "big";
  line.replace(line.find(own), own.size(), other);
  boost::crc_32_type crc;
  crc.process_bytes(line.data(), line.size());
  overwrite(file_, line + ' ' + std::to_string(crc.checksum()) + '\n');
  EXPECT_EQ(refusal(),
            file_ + ": was written on a " + other + "-endian machine; expected " + own + "-endian");
}

TEST_F(Checkpoint, IsNotOverwrittenByANewSearch) {
  leave_one();
  const auto before = content(file_);
  const auto refusal_of = [&](const Options& choice) -> std::string {
    try {
      simulate(RandomTree(1, 20), 2, 1, {}, choice);
      return "accepted";
    } catch (const CheckpointError& error) {
      return error.what();
    }
  };
  auto choice = options();
  choice.checkpoint.interval = 1e-3;
  EXPECT_EQ(refusal_of(choice),
            file_ + ": is a checkpoint already; expected Options::checkpoint.resume_from to name " +
                "it, so that the search resumes from it, or its removal");
  // A search that resumes from another checkpoint must not overwrite it either.
  const auto copy = folder_ / "copy";
  fs::create_directory(copy);
  for (const auto& entry : fs::directory_iterator(folder_)) {
    if (entry.is_regular_file()) fs::copy(entry.path(), copy);
  }
  choice.checkpoint.resume_from = (copy / "search").string();
  EXPECT_THAT(refusal_of(choice), HasSubstr("is a checkpoint already"));
  EXPECT_EQ(content(file_), before);
  choice.checkpoint.resume_from = file_;
  EXPECT_EQ(refusal_of(choice), "accepted");
  for (const auto& entry : fs::directory_iterator(folder_)) {
    if (entry.is_regular_file()) fs::remove(entry.path());
  }
  choice.checkpoint.resume_from.clear();
  EXPECT_EQ(refusal_of(choice), "accepted");
}

TEST_F(Checkpoint, AMissingFileIsRefused) {
  EXPECT_THAT(refusal(), HasSubstr("cannot be read"));
}

TEST_F(Checkpoint, AnyFlippedByteIsNoticed) {
  leave_one();
  auto files = parts();
  files.emplace_back(file_);
  for (const auto& name : files) {
    const auto good = content(name);
    const std::size_t stride = std::max<std::size_t>(1, good.size() / 200);
    for (std::size_t at = 0; at < good.size(); at += stride) {
      auto bad = good;
      bad[at] = static_cast<char>(bad[at] ^ 1);
      overwrite(name, bad);
      EXPECT_THAT(refusal(), testing::Not(testing::StartsWith("accepted"))) << name << " " << at;
    }
    overwrite(name, good);
  }
  EXPECT_THAT(refusal(), testing::StartsWith("accepted"));
}

TEST_F(Checkpoint, ATruncatedOrMissingPartIsNoticed) {
  leave_one();
  const auto name = parts().front();
  const auto good = content(name);
  for (const std::size_t size : {std::size_t{0}, std::size_t{10}, good.size() - 1}) {
    overwrite(name, good.substr(0, size));
    EXPECT_THAT(refusal(), HasSubstr(name.string()));
  }
  fs::remove(name);
  EXPECT_THAT(refusal(), HasSubstr("cannot be read"));
}

TEST_F(Checkpoint, APartOfAnotherEpochIsNoticed) {
  auto choice = options();
  choice.checkpoint.interval = 1e-3;
  simulate(RandomTree(2, 16), 2, 1, {}, choice);
  const auto newest = read_manifest(file_);
  const auto before = read_manifest(file_ + ".previous");
  const auto part = [&](std::uint64_t epoch) { return file_ + "." + std::to_string(epoch) + ".0"; };
  fs::copy_file(part(before.epoch), part(newest.epoch), fs::copy_options::overwrite_existing);
  EXPECT_THROW(read_part(file_, newest, 0), CheckpointError);
}

TEST_F(Checkpoint, ThePreviousEpochIsReadIfTheNewestIsDamaged) {
  auto choice = options();
  choice.checkpoint.interval = 1e-3;
  simulate(RandomTree(2, 16), 4, 1, {}, choice);
  overwrite(file_, content(file_).substr(0, 20));
  std::string warning;
  EXPECT_EQ(usable_checkpoint(file_, problem, warning), file_ + ".previous");
  EXPECT_THAT(warning, HasSubstr("resuming from"));
}

/// Binary tree that takes all of its leaves itself.
struct CountedLeaves {
  using Node = int;  // depth
  using Solution = int;
  static constexpr int depth = 11;

  [[nodiscard]] int root() const { return 0; }
  void expand(int node, Expansion<CountedLeaves>& out) const {
    if (node == depth) return out.solution(node);
    out.branch(node + 1);
    out.branch(node + 1);
  }
  bool emit(const Path& /*path*/, Solution& /*leaf*/) const { return true; }
};

std::uint64_t found_in(const Outcome<CountedLeaves>& outcome) {
  std::uint64_t found = 0;
  for (const auto& reports : {outcome.earlier, outcome.ranks}) {
    for (const auto& report : reports) found += report.statistics.found;
  }
  return found;
}

TEST_F(Checkpoint, SolutionsStoredByTheProblemAreCountedOverAllRuns) {
  int pieces = 0;
  const auto outcome = in_pieces(CountedLeaves(), 700, 1, Goal::all, &pieces);
  EXPECT_GT(pieces, 3);
  EXPECT_EQ(found_in(outcome), std::uint64_t{1} << CountedLeaves::depth);
  EXPECT_TRUE(outcome.solutions.empty());
}

TEST_F(Checkpoint, SolutionLimitCountsSolutionsOfEarlierRuns) {
  auto choice = options();
  choice.limits.nodes = 2000;
  const auto first = simulate(CountedLeaves(), 3, 1, {}, choice).outcome;
  ASSERT_EQ(first.status, Status::node_limit);
  std::string warning;
  choice.checkpoint.resume_from = usable_checkpoint(file_, problem, warning);
  choice.limits = {};
  choice.limits.solutions = found_in(first) + 1;
  const auto second = simulate(CountedLeaves(), 2, 1, {}, choice).outcome;
  EXPECT_EQ(second.status, Status::solution_limit);
  EXPECT_GE(found_in(second), choice.limits.solutions);
}

}  // namespace
}  // namespace kusabi::engine
