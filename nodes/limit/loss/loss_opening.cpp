// States until a node is closed, or a support to branch on.
#include "nodes/limit/loss/loss_opening.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "nodes/limit/root/worst_case.hpp"

namespace kusabi::limit {

using support::IndexSet;

namespace {

/// A piece is large enough to be worth a message, and small enough that others soon have its
/// states.
constexpr std::uint64_t programs_of_a_piece = 8;

/// Members that one node tries as its last loss.
constexpr int members_of_a_share = 8;

/// Room below the scaled factor of a state: corrections of equilibrium may change it.
constexpr double factor_room = closed_gap;

// Supports that are pairwise disjoint outside of `kept`, the smallest first.
std::vector<IndexSet> packing(const std::vector<IndexSet>& supports, const IndexSet& kept) {
  std::vector<std::pair<int, IndexSet>> rest;
  rest.reserve(supports.size());
  for (const auto& support : supports) {
    auto each = support - kept;
    const int size = each.size();
    rest.emplace_back(size, std::move(each));
  }
  std::ranges::stable_sort(rest, {}, &std::pair<int, IndexSet>::first);
  std::vector<IndexSet> packed;
  IndexSet all;
  for (auto& [size, each] : rest) {
    if (each.meets(all)) continue;
    all |= each;
    packed.push_back(std::move(each));
  }
  return packed;
}

IndexSet with(IndexSet set, int member) {
  set.insert(member);
  return set;
}

}  // namespace

/// A node while it is opened.
struct LossOpener::Opening {
  const LossNode& node;
  std::vector<IndexSet> supports{};  // of states without lost members
  IndexSet branches{};               // members to branch on; empty: closed
};

// If a state is not proved, one with a larger margin is looked for, then one of any members, from
// the first basis: the simplex method may also find none by mistake.
LossOpener::Found LossOpener::find_state(Opening& here, const IndexSet& lost,
                                         const IndexSet& avoided) {
  if (std::ranges::find(known_.undecided, lost) != known_.undecided.end()) return Found::undecided;
  struct Attempt {
    const IndexSet& avoided;
    const IndexSet& free;
    double margin;
  };
  const IndexSet none;
  const auto& kept = here.node.kept;
  const Attempt attempts[] = {{avoided, kept, yield_margins[0]},
                              {avoided, kept, yield_margins[1]},
                              {none, none, yield_margins[0]},
                              {none, none, yield_margins[1]}};
  for (const auto& [members, free, margin] : attempts) {
    if (support::is_requested(stop_)) return Found::none;
    ++piece_.programs;
    if (&members == &none) program_.restart(known_.target / factor_unit_ + factor_room);
    if (program_.solve(lost, members, free, margin) != StateProgram::Result::found) continue;
    const bool last = &members == &none && margin == yield_margins[1];
    if (auto state = proof_.proved(program_.state(), program_.basic_members(), known_.target, lost,
                                   last, stop_)) {
      here.supports.push_back(state->support);
      piece_.states.push_back(*std::move(state));
      return Found::state;
    }
  }
  if (support::is_requested(stop_)) return Found::none;
  piece_.suspect = lost;
  piece_.has_suspect = true;
  return Found::none;
}

// Branches with a share of the members each.
void LossOpener::share(const LossNode& node, const IndexSet& members) {
  std::vector<LossNode> children;
  for (const int member : members) {
    if (children.empty() || children.back().share.size() == members_of_a_share) {
      children.push_back(node);
      children.back().share = {};
    }
    children.back().share.insert(member);
  }
  stack_.insert(stack_.end(), children.rbegin(), children.rend());
}

// One further loss: the members that all supports have are tried one by one. If none is lost yet,
// they are most members of the truss, and branches share them; the states of a piece that ends in
// between are known when it is opened again.
// @return true if the node is opened completely
bool LossOpener::finish_last(Opening& here) {
  const auto& node = here.node;
  IndexSet common = here.supports.front() - node.kept;
  for (const auto& support : here.supports) common &= support;
  const bool shared = !node.share.empty();
  if (!shared && node.lost.empty() && common.size() > members_of_a_share) {
    share(node, common);
    return true;
  }
  for (;;) {
    const auto tried = shared ? common & node.share : common;
    if (tried.empty()) return true;
    if (shared && piece_.programs >= programs_of_a_piece) return false;
    const int member = tried.lowest();
    const auto found = find_state(here, with(here.node.lost, member), common);
    if (found == Found::none) return false;
    if (found == Found::state) common &= here.supports.back();
    common -= IndexSet::single(member);
  }
}

// Several further losses: disjoint supports, until they are too many to be broken, or no more are
// found.
bool LossOpener::pack(Opening& here) {
  const auto& kept = here.node.kept;
  for (;;) {
    const auto packed = packing(here.supports, kept);
    if (packed.front().empty() || static_cast<int>(packed.size()) > here.node.left) return true;
    IndexSet all;
    for (const auto& each : packed) all |= each;
    const auto found = find_state(here, here.node.lost, all);
    if (found != Found::state) return found == Found::undecided;
    const auto rest = here.supports.back() - kept;
    if (rest.empty()) return true;
    if (rest.meets(all)) break;
  }
  const auto smallest = std::ranges::min_element(
      here.supports, {}, [&](const IndexSet& support) { return (support - kept).size(); });
  here.branches = *smallest - kept;
  return true;
}

// The member of most supports first.
void LossOpener::branch(const Opening& here) {
  std::vector<std::pair<std::ptrdiff_t, int>> members;
  for (const int member : here.branches) {
    const auto uses = std::ranges::count_if(
        here.supports, [member](const IndexSet& support) { return support.contains(member); });
    members.emplace_back(-uses, member);
  }
  std::ranges::sort(members);
  auto kept = here.node.kept;
  std::vector<LossNode> children;
  for (const auto& [uses, member] : members) {
    children.push_back({with(here.node.lost, member), kept, here.node.left - 1});
    kept.insert(member);
  }
  stack_.insert(stack_.end(), children.rbegin(), children.rend());
}

bool LossOpener::open_one(const LossNode& node) {
  Opening here{node};
  const auto take = [&](const IndexSet& support) {
    if (!support.meets(node.lost)) here.supports.push_back(support);
  };
  for (const auto& support : known_.supports) take(support);
  for (const auto& state : piece_.states) take(state.support);
  if (here.supports.empty()) {
    const auto found = find_state(here, node.lost, {});
    if (found != Found::state) return found == Found::undecided;
  }
  const auto is_kept = [&](const IndexSet& support) { return node.kept.includes(support); };
  if (node.left == 0 || std::ranges::any_of(here.supports, is_kept)) return true;
  if (node.left == 1) return finish_last(here);
  if (!pack(here)) return false;
  branch(here);
  return true;
}

LossPiece LossOpener::open(const LossNode& node, std::uint64_t most) {
  piece_ = {};
  stack_ = {node};
  program_.restart(known_.target / factor_unit_ + factor_room);
  while (!stack_.empty() && piece_.programs < programs_of_a_piece && piece_.nodes < most) {
    auto next = std::move(stack_.back());
    stack_.pop_back();
    const bool whole = open_one(next) && !support::is_requested(stop_);
    ++piece_.nodes;
    if (whole) continue;
    stack_.push_back(std::move(next));
    break;
  }
  piece_.open.assign(stack_.rbegin(), stack_.rend());
  return std::move(piece_);
}

}  // namespace kusabi::limit
