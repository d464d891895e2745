// First the tree by the rule that is never much worse, which may be small; then rounds of dives,
// until there are as many nodes in them as the best tree may have.
#include "nodes/wedged/branching_trial.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>

#include "engine/shared_work.hpp"
#include "engine/together.hpp"

namespace kusabi::wedged {
namespace {

/// Smaller blocks have trees that are searched sooner than sampled.
constexpr int fewest_candidates = 40;

/// The first unless another seems to take so many times fewer nodes: it is never much worse than
/// the others, and a few dives miss the largest parts of a tree more often than not.
constexpr std::array tried{Branching::weighed, Branching::relative, Branching::deepest};
constexpr double times_fewer = 3;

/// Trees of no more nodes are not worth a trial, and fewer nodes of dives say little; but a node
/// takes the more time the more candidates there are.
std::uint64_t few_nodes(int candidates) {
  return static_cast<std::uint64_t>(std::clamp(50'000 / candidates, 100, 500));
}

constexpr int much = 20;  // leaves

constexpr std::uint64_t dives_a_round = 4;  // by each rule
constexpr std::uint64_t most_rounds = 16;

struct Dive {
  double size = 0;           // estimate of the nodes of the tree
  std::uint64_t opened = 0;  // nodes

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& size& opened;
  }
};

// Ends early where the budget is spent.
Dive dive(SignPatternTree& tree, std::uint32_t block, std::uint64_t number,
          const engine::Budget& budget) {
  std::mt19937_64 random(number);
  Dive result{.size = 1, .opened = 1};
  double ways = 1;
  auto fate = tree.decide({.block = block, .pattern = {}});
  while (!fate.children.empty() && !budget.spent()) {
    std::vector<SignPatternTree::Fate> branched;
    for (const auto& child : fate.children) {
      ++result.opened;
      result.size += ways;
      if (auto own = tree.decide(child); !own.children.empty()) branched.push_back(std::move(own));
    }
    if (branched.empty()) break;
    ways *= static_cast<double>(branched.size());
    fate = std::move(branched[random() % branched.size()]);
  }
  return result;
}

// The trees by all rules, and what the dives into one of their blocks say.
class Trial {
 public:
  Trial(engine::Campaign& campaign, const problems::WedgedProblem& problem,
        std::span<const double> friction, const SignPatternOptions& options)
      : campaign_(campaign) {
    for (const Branching rule : tried) {
      SignPatternOptions own = options;
      own.branching = rule;
      trees_.emplace_back(problem, friction, own);
    }
  }

  Branching best_of(std::uint32_t block, int candidates) {
    const auto few = few_nodes(candidates);
    if (engine::from_first_rank(campaign_.transport(), [&] { return is_plain(block, few); }))
      return tried.front();
    std::array<double, tried.size()> sum{};
    std::uint64_t opened = 0;
    for (std::uint64_t round = 0; round < most_rounds; ++round) {
      const auto dives = share(block, round);
      for (std::size_t i = 0; i < dives.size(); ++i) {
        sum[i % tried.size()] += dives[i].size;
        opened += dives[i].opened;
      }
      const double least =
          *std::ranges::min_element(sum) / static_cast<double>(dives_a_round * (round + 1));
      if ((opened >= few && static_cast<double>(opened) >= least) || ended()) break;
    }
    const auto least = std::ranges::min_element(sum);
    return *least * times_fewer < sum.front() ? tried[static_cast<std::size_t>(least - sum.begin())]
                                              : tried.front();
  }

 private:
  // Whether the first tree has few nodes, or much to list: then most of the work is its leaves,
  // which all trees have.
  bool is_plain(std::uint32_t block, std::uint64_t few) {
    std::vector<SignPatternTree::Node> open{{.block = block, .pattern = {}}};
    int found = 0;
    for (std::uint64_t opened = 0; opened < few && !open.empty(); ++opened) {
      if (found == much || campaign_.budget().spent()) return true;
      const auto node = open.back();
      open.pop_back();
      const auto fate = trees_.front().decide(node);
      if (fate.leaf) ++found;
      open.insert(open.end(), fate.children.rbegin(), fate.children.rend());
    }
    return open.empty();
  }

  std::vector<Dive> share(std::uint32_t block, std::uint64_t round) {
    return engine::share_work<Dive>(
        campaign_.transport(), dives_a_round * tried.size(), [&](std::uint64_t piece) {
          return dive(trees_[piece % tried.size()], block,
                      round * dives_a_round + piece / tried.size(), campaign_.budget());
        });
  }

  bool ended() {
    return engine::from_first_rank(campaign_.transport(),
                                   [&] { return campaign_.budget().spent(); });
  }

  engine::Campaign& campaign_;
  std::vector<SignPatternTree> trees_;
};

}  // namespace

Branching untried_branching(int candidates) {
  return candidates < fewest_candidates ? Branching::relative : tried.front();
}

std::vector<Branching> tried_branching(engine::Campaign& campaign,
                                       const problems::WedgedProblem& problem,
                                       std::span<const double> friction,
                                       const SignPatternOptions& options) {
  const auto blocks = problems::blocks_of(problem);
  if (options.branching != Branching::automatic)
    return std::vector<Branching>(blocks.size(), options.branching);
  std::vector<Branching> rules(blocks.size(), Branching::relative);
  // Loose bodies and polyhedral cones have no centre, by which the rules differ.
  if (options.facets != 0 || problem.motions.cols() > 0) return rules;
  std::optional<Trial> trial;
  for (std::uint32_t block = 0; block < blocks.size(); ++block) {
    if (blocks[block].size() < fewest_candidates) continue;
    if (!trial) trial.emplace(campaign, problem, friction, options);
    rules[block] = trial->best_of(block, blocks[block].size());
  }
  return rules;
}

}  // namespace kusabi::wedged
