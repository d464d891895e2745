// First the trees of all rules in turn, each of which may be small; then, unless bounds and cuts
// follow, rounds of dives, until their nodes are as many as those of the estimated best tree.
#include "nodes/wedged/tree/branching_trial.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <utility>

#include <fmt/format.h>

#include "engine/collectives.hpp"
#include "nodes/wedged/tree/sign_pattern_tree.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

/// Trees of smaller blocks take no longer than sampling.
constexpr int min_sampled_candidates = 40;

/// The first rule is chosen unless another is estimated to take this many times fewer nodes: it is
/// never much worse than the others, and a few dives often miss the largest parts of a tree.
constexpr std::array tried{Branching::weighed, Branching::relative, Branching::deepest};
constexpr double times_fewer = 3;

/// Trees with at most this many nodes are not sampled, and fewer nodes of dives are not
/// significant. Nodes with more candidates take more time.
std::uint64_t few_nodes(int candidates) {
  return static_cast<std::uint64_t>(std::clamp(50'000 / candidates, 100, 500));
}

/// Blocks up to this size are searched by each rule before any sampling, with so many nodes for each
/// candidate in all: about as many as bounds of the candidates cost. Sampling these trees instead
/// takes three times as long as the bounds and the tree with cuts together, in which the rules
/// hardly differ. Larger blocks take too long on one rank, and only the first rule is tried.
constexpr int max_candidates_of_first_search = 100;
constexpr int first_nodes_per_candidate = 20;

constexpr int many_leaves = 20;

constexpr std::uint64_t dives_per_round = 4;  // for each rule
constexpr std::uint64_t max_rounds = 16;

struct Dive {
  double size = 0;           // estimate of the nodes of the tree
  std::uint64_t opened = 0;  // nodes

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& size& opened;
  }
};

// Ends early when the budget is used.
Dive dive(SignPatternTree& tree, std::uint32_t block, std::uint64_t number,
          const engine::Budget& budget) {
  std::mt19937_64 random(number);
  Dive result{.size = 1, .opened = 1};
  double ways = 1;
  try {
    auto decision = tree.decide({.block = block, .pattern = {}});
    while (!decision.children.empty() && !budget.spent()) {
      std::vector<SignPatternTree::NodeResult> branched;
      for (const auto& child : decision.children) {
        ++result.opened;
        result.size += ways;
        if (auto own = tree.decide(child); !own.children.empty())
          branched.push_back(std::move(own));
      }
      if (branched.empty()) break;
      ways *= static_cast<double>(branched.size());
      decision = std::move(branched[random() % branched.size()]);
    }
  } catch (const support::Stopped&) {
    return result;
  }
  return result;
}

// The trees of all rules, and the results of dives into one of their blocks.
class Trial {
 public:
  Trial(engine::Analysis& analysis, const problems::WedgedProblem& problem,
        std::span<const double> friction, const SignPatternOptions& options,
        std::span<const Branching> rules)
      : analysis_(analysis), rules_(rules) {
    for (const Branching rule : rules) {
      SignPatternOptions own = options;
      own.branching = rule;
      own.probes = 0;
      trees_.emplace_back(problem, friction, own);
      trees_.back().end_when(analysis.budget().stop());
    }
  }

  /// @param bounded true if bounds of the candidates are computed for a tree that is not small
  TriedTree best_of(std::uint32_t block, int candidates, bool bounded) {
    constexpr auto unknown = std::numeric_limits<double>::infinity();
    const auto few = few_nodes(candidates);
    const bool small = candidates <= max_candidates_of_first_search;
    const auto first = analysis_.by_first_rank(
        [&] { return small ? race(block, candidates) : look(0, block, few); });
    if (first.whole) return {rules_[first.rule], static_cast<double>(first.opened)};
    if (candidates < min_sampled_candidates || (small && bounded && !first.has_many))
      return {rules_.front(), unknown};
    const auto rules = first.has_many ? 1 : trees_.size();
    std::vector<double> sum(rules);
    std::uint64_t opened = 0;
    std::uint64_t round = 0;
    while (round < max_rounds) {
      const auto dives = share(block, round++, rules);
      for (std::size_t i = 0; i < dives.size(); ++i) {
        sum[i % rules] += dives[i].size;
        opened += dives[i].opened;
      }
      const double minimum = mean(*std::ranges::min_element(sum), round);
      if (rules == 1 || (opened >= few && static_cast<double>(opened) >= minimum) || ended()) break;
    }
    const auto minimum = std::ranges::min_element(sum);
    const auto best =
        *minimum * times_fewer < sum.front() ? static_cast<std::size_t>(minimum - sum.begin()) : 0;
    return {rules_[best], mean(sum[best], round)};
  }

 private:
  // The beginning of a tree. If it has many leaves, most of the work is in leaves, which all trees
  // have.
  struct Look {
    std::size_t rule = 0;
    std::uint64_t opened = 0;
    bool whole = false, has_many = false;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& rule& opened& whole& has_many;
    }
  };

  // The first tree that is small, or that has many leaves.
  Look race(std::uint32_t block, int candidates) {
    const auto nodes = static_cast<std::uint64_t>(first_nodes_per_candidate * candidates);
    Look result;
    for (std::size_t rule = 0; rule < trees_.size(); ++rule) {
      result = look(rule, block, nodes / trees_.size());
      if (result.whole || result.has_many) break;
    }
    return result;
  }

  Look look(std::size_t rule, std::uint32_t block, std::uint64_t few) {
    std::vector<SignPatternTree::Node> open{{.block = block, .pattern = {}}};
    Look result{.rule = rule};
    int found = 0;
    while (result.opened < few && !open.empty()) {
      if (found == many_leaves || analysis_.budget().spent()) {
        result.has_many = true;
        return result;
      }
      const auto node = open.back();
      open.pop_back();
      SignPatternTree::NodeResult decision;
      try {
        decision = trees_[rule].decide(node);
      } catch (const support::Stopped&) {
        result.has_many = true;
        return result;
      }
      ++result.opened;
      analysis_.say_now_and_then([&] {
        return fmt::format("sampling the tree to choose its branching rule: {} nodes",
                           result.opened);
      });
      if (decision.leaf) ++found;
      open.insert(open.end(), decision.children.rbegin(), decision.children.rend());
    }
    result.whole = open.empty();
    return result;
  }

  static double mean(double sum, std::uint64_t rounds) {
    return sum / static_cast<double>(dives_per_round * rounds);
  }

  std::vector<Dive> share(std::uint32_t block, std::uint64_t round, std::size_t rules) {
    return analysis_.share<Dive>(dives_per_round * rules, [&](std::uint64_t piece) {
      return dive(trees_[piece % rules], block, round * dives_per_round + piece / rules,
                  analysis_.budget());
    });
  }

  bool ended() {
    return engine::from_first_rank(analysis_.transport(),
                                   [&] { return analysis_.budget().spent(); });
  }

  engine::Analysis& analysis_;
  std::span<const Branching> rules_;
  std::vector<SignPatternTree> trees_;
};

constexpr std::array without_centre{Branching::relative};

}  // namespace

Branching untried_branching(int candidates) {
  return candidates < min_sampled_candidates ? Branching::relative : tried.front();
}

std::vector<TriedTree> tried_trees(engine::Analysis& analysis,
                                   const problems::WedgedProblem& problem,
                                   std::span<const double> friction,
                                   const SignPatternOptions& options, int minimum) {
  const auto blocks = problems::blocks_of(problem);
  std::vector<TriedTree> result(blocks.size());
  const std::array asked{options.branching};
  const bool automatic = options.branching == Branching::automatic;
  if (!automatic) std::ranges::fill(result, TriedTree{.branching = options.branching});
  if (options.facets != 0) return result;
  // Unconstrained bodies have no centre, in which the rules differ.
  const bool has_centre = problem.modes.matrix.cols() == 0;
  std::optional<Trial> small, large;
  for (std::uint32_t block = 0; block < blocks.size(); ++block) {
    const int candidates = blocks[block].size();
    const bool is_large = automatic && has_centre && candidates >= min_sampled_candidates;
    if (candidates < minimum && !is_large) continue;
    auto& trial = is_large ? large : small;
    if (!trial) {
      const auto rules = is_large    ? std::span<const Branching>(tried)
                         : automatic ? std::span<const Branching>(without_centre)
                                     : std::span<const Branching>(asked);
      trial.emplace(analysis, problem, friction, options, rules);
    }
    const bool bounded = options.tightening != Tightening::never;
    result[block] = trial->best_of(block, candidates, bounded);
  }
  return result;
}

}  // namespace kusabi::wedged
