// Opening of a node: states until it is closed, or a support to branch on.
#include "nodes/limit/loss/loss_tree.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "nodes/limit/loss/bracing.hpp"
#include "nodes/limit/root/worst_case.hpp"

namespace kusabi::limit {

using support::IndexSet;

namespace {

/// A program without a state is consistent with a remaining factor up to this above the target,
/// scaled: the margin of the yield forces costs about as much.
constexpr double consistent = 10 * closed_gap;

// Supports that are pairwise disjoint outside of `kept`, the smallest first.
std::vector<IndexSet> packing(const std::vector<IndexSet>& supports, const IndexSet& kept) {
  std::vector<IndexSet> rest;
  rest.reserve(supports.size());
  for (const auto& support : supports) rest.push_back(support - kept);
  std::ranges::stable_sort(rest, {}, &IndexSet::size);
  std::vector<IndexSet> packed;
  IndexSet all;
  for (auto& each : rest) {
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
struct LossTree::Opening {
  const Node& node;
  std::vector<IndexSet> supports{};  // without lost members: of the pool, then of the node
  std::size_t of_pool = 0;
  std::optional<IndexSet> solution{};
  IndexSet branches{};  // members to branch on; empty: closed
  bool undecided = false;
};

LossTree::Tally& LossTree::Tally::operator+=(const Tally& other) {
  programs += other.programs;
  states += other.states;
  undecided += other.undecided;
  return *this;
}

LossTree::LossTree(const problems::LimitModel& model, LossProof& proof, const LossTarget& target,
                   const std::vector<IndexSet>& pool, support::Stop stop)
    : model_(model),
      proof_(proof),
      target_(target),
      pool_(pool),
      stop_(std::move(stop)),
      program_(model, target.factor / model.factor_unit, stop_),
      remaining_(model, stop_) {}

LossTree::Node LossTree::root() const {
  return {{}, IndexSet::below(model_.member_count()) - target_.eligible, target_.most, {}};
}

// A set of members that is proved to carry the state: those with stress, these with braces, or all
// that are left.
std::optional<IndexSet> LossTree::proved_support(const Node& node, const IndexSet& lost,
                                                 const CarryingState& state) {
  const double factor = state.factor * model_.factor_unit;
  IndexSet stressed;
  for (int i = 0; i < model_.member_count(); ++i) {
    if (state.forces(i) != 0) stressed.insert(i);
  }
  ++tally_.states;
  const auto carry = [&](const IndexSet& members) {
    return proof_.carries(members, target_.factor, factor, state.forces);
  };
  if (carry(stressed)) return stressed;
  const auto left = IndexSet::below(model_.member_count()) - lost;
  auto support = braced(model_, stressed, left, node.kept);
  if (carry(support)) return support;
  if (carry(left)) return left;
  return {};
}

// Looks for a state without the lost members, and adds its support. If it is not proved, one with a
// larger margin is looked for.
bool LossTree::find_state(Opening& here, const IndexSet& lost, const IndexSet& avoided) {
  for (const double margin : yield_margins) {
    ++tally_.programs;
    const auto result = program_.solve(lost, avoided, here.node.kept, margin);
    if (result == StateProgram::Result::none) {
      report(here, lost);
      return false;
    }
    if (result == StateProgram::Result::undetermined) break;
    if (auto support = proved_support(here.node, lost, program_.state())) {
      here.supports.push_back(*std::move(support));
      return true;
    }
  }
  here.undecided = true;
  return false;
}

// The program (5) is asked too: a loss is reported only if both programs agree on it.
void LossTree::report(Opening& here, const IndexSet& lost) {
  ++tally_.programs;
  const auto status = remaining_.solve(lost);
  const double limit = target_.factor / model_.factor_unit + consistent;
  if (status == LoadStatus::undetermined ||
      (status == LoadStatus::collapses && remaining_.collapse().factor > limit)) {
    here.undecided = true;
  } else {
    here.solution = lost;
  }
}

// One further loss: the members that all supports have are tried one by one.
void LossTree::finish_last(Opening& here) {
  IndexSet common = here.supports.front() - here.node.kept;
  for (const auto& support : here.supports) common &= support;
  while (!common.empty()) {
    const int member = common.lowest();
    if (!find_state(here, with(here.node.lost, member), common)) return;
    common &= here.supports.back();
  }
}

// Several further losses: disjoint supports, until they are too many to be broken, or no more are
// found.
void LossTree::pack(Opening& here) {
  const auto& kept = here.node.kept;
  for (;;) {
    const auto packed = packing(here.supports, kept);
    if (packed.front().empty() || static_cast<int>(packed.size()) > here.node.left) return;
    IndexSet all;
    for (const auto& each : packed) all |= each;
    if (!find_state(here, here.node.lost, all)) return;
    const auto rest = here.supports.back() - kept;
    if (rest.empty()) return;
    if (rest.meets(all)) break;
  }
  const auto smallest = std::ranges::min_element(
      here.supports, {}, [&](const IndexSet& support) { return (support - kept).size(); });
  here.branches = *smallest - kept;
}

void LossTree::open(Opening& here) {
  program_.restart();
  for (const auto& support : pool_) {
    if (!support.meets(here.node.lost)) here.supports.push_back(support);
  }
  here.of_pool = here.supports.size();
  here.supports.insert(here.supports.end(), here.node.supports.begin(), here.node.supports.end());
  if (here.supports.empty() && !find_state(here, here.node.lost, {})) return;
  const auto is_kept = [&](const IndexSet& support) { return here.node.kept.includes(support); };
  if (here.node.left == 0 || std::ranges::any_of(here.supports, is_kept)) return;
  if (here.node.left == 1) {
    finish_last(here);
  } else {
    pack(here);
  }
}

std::vector<IndexSet> LossTree::supports_at(const Node& node) {
  Opening here{node};
  open(here);
  return {here.supports.begin() + static_cast<std::ptrdiff_t>(here.of_pool), here.supports.end()};
}

void LossTree::expand(Node&& node, engine::Expansion<LossTree>& out) {
  Opening here{node};
  open(here);
  // A stopped search keeps the node, which is not opened completely.
  if (support::asked(stop_)) {
    out.branch(std::move(node));
    return;
  }
  if (here.undecided) ++tally_.undecided;
  if (here.solution) out.solution({*here.solution, std::move(here.supports)});
  if (here.branches.empty()) return;
  std::vector<int> members(here.branches.begin(), here.branches.end());
  const auto uses = [&](int member) {
    return -std::ranges::count_if(
        here.supports, [member](const IndexSet& support) { return support.contains(member); });
  };
  std::ranges::stable_sort(members, {}, uses);
  auto kept = node.kept;
  for (const int member : members) {
    Node child{with(node.lost, member), kept, node.left - 1, {}};
    for (std::size_t k = here.of_pool; k < here.supports.size(); ++k) {
      if (!here.supports[k].contains(member)) child.supports.push_back(here.supports[k]);
    }
    out.branch(std::move(child));
    kept.insert(member);
  }
}

}  // namespace kusabi::limit
