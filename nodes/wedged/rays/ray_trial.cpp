// How much the tree may cost before double description goes on.
#include "nodes/wedged/rays/ray_trial.hpp"

#include <algorithm>
#include <utility>

#include "engine/search.hpp"

namespace kusabi::wedged {
namespace {

/// What a node costs, in pairs of rays: 15 microseconds against 0.1 (bench/README.md).
constexpr std::uint64_t pairs_for_a_node = 150;

/// And one that is a tie, or takes more digits than a double has: a millisecond.
constexpr std::uint64_t pairs_for_a_tie = 8'000;

/// The nodes may cost this part of the pairs if they promise to come to an end,
constexpr std::uint64_t part_for_nodes = 4;
/// and this part until they do.
constexpr std::uint64_t part_for_first_nodes = 32;

/// The first leaf costs at least so many times as much as all do on average, unless they are few.
constexpr std::uint64_t first_leaf = 4;

// The share of a binary tree that is closed when depth-first search comes to `path`, were all
// subtrees of one depth alike.
double closed_before(const engine::Path& path) {
  double closed = 0;
  double share = 1;
  for (const auto branch : path) {
    share /= 2;
    closed += branch * share;
  }
  return closed;
}

std::uint64_t cost(const SignPatternTally& nodes, std::uint64_t opened) {
  const auto ties =
      nodes.flat + nodes.faces + nodes.marginal + nodes.undecided + nodes.doubtful + nodes.climbed;
  return pairs_for_a_node * opened + pairs_for_a_tie * ties;
}

/// The problem type that engine::search searches: RayTree without the rays.
class LeafTree {
 public:
  using Node = PatternNode;
  using Solution = RayLeaf;
  using Tally = SignPatternTally;

  /// @param pairs that double description has looked at
  LeafTree(SignPatternTree tree, std::uint64_t pairs, const std::function<bool()>& stop)
      : tree_(std::move(tree)), pairs_(pairs), stop_(stop) {}

  Node root() const { return tree_.root(); }
  Tally tally() const { return tree_.tally(); }

  void expand(Node&& node, engine::Expansion<LeafTree>& out) {
    gave_up_ = gave_up_ || is_too_dear(out) || (stop_ && stop_());
    if (gave_up_) return;
    ++opened_;
    const auto fate = tree_.decide(node);
    for (const Node& child : fate.children) out.branch(child);
    if (fate.leaf) out.solution(RayLeaf::of(node, fate));
  }

  /// Whether nodes were dropped.
  bool gave_up() const { return gave_up_; }

 private:
  bool is_too_dear(const engine::Expansion<LeafTree>& out) const {
    const auto spent = cost(tree_.tally(), opened_);
    if (spent <= pairs_ / part_for_first_nodes) return false;
    if (spent > pairs_ / part_for_nodes) return true;
    return static_cast<double>(spent) > closed_before(out.path()) * static_cast<double>(pairs_);
  }

  SignPatternTree tree_;
  std::uint64_t pairs_;
  const std::function<bool()>& stop_;
  std::uint64_t opened_ = 0;
  bool gave_up_ = false;
};

}  // namespace

bool RayTrial::succeeds(std::uint64_t pairs) {
  // As its steps grow, double description will soon have looked at as many again as in the last.
  const auto worth = 2 * pairs - std::exchange(seen_, pairs);
  if (!found_.tree && pairs >= next_search_) look_for_leaves(pairs);
  return found_.tree && enumerates(worth);
}

void RayTrial::look_for_leaves(std::uint64_t pairs) {
  next_search_ = 2 * pairs;
  LeafTree tree(plant_(), pairs, stop_);
  auto outcome = engine::search(tree);
  if (tree.gave_up()) return;
  for (auto& leaf : outcome.solutions) leaves_.push_back(leaf.solution);
  found_.method = RayMethod::tree;
  found_.tree =
      RayTreeReport{.patterns = outcome.tally(),
                    .opened = outcome.opened(),
                    .open = 0,
                    .fingerprint = outcome.fingerprint(),
                    .ranks = {{.statistics = outcome.ranks.front().statistics, .tally = {}}}};
}

// As much work for the first k of l leaves as the tree is worth, and at most 4k/l of this.
bool RayTrial::enumerates(std::uint64_t worth) {
  for (; done_ < leaves_.size(); ++done_) {
    const RayLeaf& leaf = leaves_[done_];
    const auto most = std::min(worth, first_leaf * worth / leaves_.size() * (done_ + 1));
    if (effort_.pairs > most || (stop_ && stop_())) return false;
    if (!turns_) turns_.emplace(cone_, leaf.in_contact);
    if (!turns_->go_on(most - effort_.pairs)) return false;
    const auto rays = std::move(*turns_).result();
    turns_.reset();
    effort_ += rays.effort;
    found_.health += rays.health;
    const auto own = leaf.own(rays.rays, cone_.all());
    found_.rays.insert(found_.rays.end(), own.begin(), own.end());
  }
  return true;
}

RayFindings RayTrial::found() && {
  auto& tree = *found_.tree;
  tree.ranks.front().tally = {
      .patterns = tree.patterns, .effort = effort_, .health = found_.health};
  return std::move(found_);
}

}  // namespace kusabi::wedged
