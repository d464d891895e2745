// Limits of the tree's costs relative to those of double description.
#include "nodes/wedged/rays/ray_trial.hpp"

#include <algorithm>
#include <utility>

#include "engine/search.hpp"

namespace kusabi::wedged {
namespace {

/// Cost of a node in pairs of rays: 15 microseconds compared with 0.1 (bench/history.md).
constexpr std::uint64_t pairs_for_a_node = 150;

/// Cost of a degenerate node, or of a node in higher precision: a millisecond.
constexpr std::uint64_t pairs_for_a_degenerate_node = 8'000;

/// The cost of the nodes is limited to pairs / part_for_nodes; above pairs / part_for_first_nodes
/// it must be below the pairs times the closed share of the tree.
constexpr std::uint64_t part_for_nodes = 4;
constexpr std::uint64_t part_for_first_nodes = 32;

/// With a long list, most of the work of double description is still to come: at least this many
/// times the pairs so far, and a walk along the edges of the cones takes a fraction of that.
constexpr std::uint64_t pairs_to_come = 8;

/// The first leaf is assumed to cost at least this many times the average, unless there are few.
constexpr std::uint64_t first_leaf = 4;

// The closed share of a binary tree when depth-first search is at `path`, if all subtrees of one
// depth were equal.
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
  const auto degenerate = nodes.flat + nodes.faces + nodes.marginal + nodes.undecided +
                          nodes.branched_undecided + nodes.escalated;
  return pairs_for_a_node * opened + pairs_for_a_degenerate_node * degenerate;
}

/// Problem type of engine::search: RayTree without the rays.
class LeafTree {
 public:
  using Node = PatternNode;
  using Solution = RayLeaf;
  using Tally = SignPatternTally;

  /// @param pairs of double description with which the nodes are compared
  LeafTree(SignPatternTree tree, std::uint64_t pairs) : tree_(std::move(tree)), pairs_(pairs) {}

  Node root() const { return tree_.root(); }
  Tally tally() const { return tree_.tally(); }

  void expand(Node&& node, engine::Expansion<LeafTree>& out) {
    gave_up_ = gave_up_ || is_too_dear(out);
    if (gave_up_) return;
    ++opened_;
    const auto decision = tree_.decide(node, out);
    if (!decision) return;
    for (const Node& child : decision->children) out.branch(child);
    if (decision->leaf) out.solution(RayLeaf::of(node, *decision));
  }

  /// True if nodes were discarded.
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
  std::uint64_t opened_ = 0;
  bool gave_up_ = false;
};

}  // namespace

bool RayTrial::succeeds(std::uint64_t pairs) {
  // As its steps grow, double description is expected to process as many pairs again as in its last
  // step.
  const auto worth = 2 * pairs - std::exchange(seen_, pairs);
  if (!found_.tree && pairs >= next_search_) {
    next_search_ = 2 * pairs;
    look_for_leaves(pairs);
  }
  return found_.tree && enumerates(worth);
}

bool RayTrial::is_worth_searching(std::uint64_t pairs) {
  // No walk is possible on the cones of unconstrained bodies.
  if (cone_.equations() > 0) return false;
  if (!found_.tree) look_for_leaves(pairs_to_come * pairs);
  return found_.tree.has_value();
}

void RayTrial::look_for_leaves(std::uint64_t worth) {
  LeafTree tree(make_tree_(), worth);
  engine::Options options;
  options.interrupt = [this] {
    return stop_ && stop_() ? engine::Interrupt::stop : engine::Interrupt::none;
  };
  auto outcome = engine::search(tree, options);
  if (tree.gave_up() || outcome.status != engine::Status::solved) return;
  for (auto& leaf : outcome.solutions) leaves_.push_back(leaf.solution);
  found_.method = RayMethod::tree;
  found_.tree =
      RayTreeReport{.patterns = outcome.tally(),
                    .opened = outcome.opened(),
                    .open = 0,
                    .fingerprint = outcome.fingerprint(),
                    .ranks = {{.statistics = outcome.ranks.front().statistics, .tally = {}}}};
}

// The limit of costs for the first k of l leaves: `worth`, or first_leaf k / l times `worth` if
// that is less.
bool RayTrial::enumerates(std::uint64_t worth) {
  for (; done_ < leaves_.size(); ++done_) {
    const RayLeaf& leaf = leaves_[done_];
    const auto maximum = std::min(worth, first_leaf * worth / leaves_.size() * (done_ + 1));
    if (cost_.pairs > maximum || (stop_ && stop_())) return false;
    if (!turns_) turns_.emplace(cone_, leaf.in_contact, stop_);
    if (!turns_->resume(maximum - cost_.pairs)) return false;
    const auto rays = std::move(*turns_).result();
    turns_.reset();
    cost_ += rays.cost;
    found_.health += rays.health;
    const auto own = leaf.own(rays.rays, cone_.all());
    found_.rays.insert(found_.rays.end(), own.begin(), own.end());
  }
  return true;
}

RayFindings RayTrial::found() && {
  auto& tree = *found_.tree;
  tree.ranks.front().tally = {.patterns = tree.patterns, .cost = cost_, .health = found_.health};
  return std::move(found_);
}

}  // namespace kusabi::wedged
