// Construction of a bit pattern tree, and the query for supersets.
#include "solvers/rays/bit_pattern_tree.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <utility>

namespace kusabi::rays {
namespace {

/// Maximum number of members of a leaf: a few comparisons cost no more than one level of the tree.
constexpr int leaf_size = 8;

/// Sample size for the choice of the splitting bit.
constexpr int max_sampled = 128;

constexpr int bits_in_word = 64;

using Word = Candidates ZeroSet::*;
constexpr std::array<Word, 3> words{&ZeroSet::p, &ZeroSet::q, &ZeroSet::u};

BitPattern either(const BitPattern& a, const BitPattern& b) {
  return {{a.zero.p | b.zero.p, a.zero.q | b.zero.q, a.zero.u | b.zero.u}, a.r | b.r};
}

struct Split {
  Word word = words[0];
  Candidates mask = 0;  // no bit: all members are equal
};

Split best_split(std::span<const ZeroSet> sets, std::span<const int> members) {
  const std::size_t step = (members.size() + max_sampled - 1) / max_sampled;
  std::array<std::array<int, bits_in_word>, words.size()> counts{};
  int sampled = 0;
  for (std::size_t at = 0; at < members.size(); at += step, ++sampled) {
    const ZeroSet& set = sets[static_cast<std::size_t>(members[at])];
    for (std::size_t word = 0; word < words.size(); ++word) {
      for (Candidates rest = set.*words[word]; rest != 0; rest &= rest - 1) {
        ++counts[word][static_cast<std::size_t>(std::countr_zero(rest))];
      }
    }
  }
  Split best;
  int minimum = sampled;  // above the count of any splitting bit
  for (std::size_t word = 0; word < words.size(); ++word) {
    for (int place = 0; place < bits_in_word; ++place) {
      const int unevenness = std::abs(2 * counts[word][static_cast<std::size_t>(place)] - sampled);
      if (unevenness < minimum) {
        minimum = unevenness;
        best = {words[word], bit(place)};
      }
    }
  }
  return best;
}

}  // namespace

BitPatternTree::BitPatternTree(std::span<const ZeroSet> sets, std::vector<int> members)
    : members_(std::move(members)), patterns_(members_.size()) {
  nodes_.push_back({.all = {}, .first = 0, .last = static_cast<int>(members_.size()), .left = -1});
  grow(sets, 0);
}

void BitPatternTree::grow(std::span<const ZeroSet> sets, std::size_t node) {
  const int first = nodes_[node].first;
  const int last = nodes_[node].last;
  if (last - first > leaf_size) {
    const auto begin = members_.begin() + first;
    const auto end = members_.begin() + last;
    const Split split = best_split(sets, {begin, end});
    const auto middle = std::partition(begin, end, [&](int member) {
      return (sets[static_cast<std::size_t>(member)].*split.word & split.mask) != 0;
    });
    if (middle != begin && middle != end) {
      const int border = static_cast<int>(middle - members_.begin());
      const std::size_t left = nodes_.size();
      nodes_[node].left = static_cast<int>(left);
      nodes_.push_back({.all = {}, .first = first, .last = border, .left = -1});
      nodes_.push_back({.all = {}, .first = border, .last = last, .left = -1});
      grow(sets, left);
      grow(sets, left + 1);
      nodes_[node].all = either(nodes_[left].all, nodes_[left + 1].all);
      return;
    }
  }
  BitPattern all;
  for (int at = first; at < last; ++at) {
    const auto place = static_cast<std::size_t>(at);
    patterns_[place] = pattern_of(sets[static_cast<std::size_t>(members_[place])]);
    all = either(all, patterns_[place]);
  }
  nodes_[node].all = all;
}

std::optional<int> BitPatternTree::superset(const ZeroSet& smaller,
                                            std::array<int, 2> except) const {
  return superset(root(), smaller, except);
}

std::optional<int> BitPatternTree::superset(const Node& node, const ZeroSet& smaller,
                                            const std::array<int, 2>& except) const {
  if (!contains(node.all.zero, smaller)) return std::nullopt;
  if (node.is_leaf()) {
    for (int place = node.first; place < node.last; ++place) {
      if (!contains(pattern(place).zero, smaller)) continue;
      if (member(place) != except[0] && member(place) != except[1]) return member(place);
    }
    return std::nullopt;
  }
  const auto found = superset(child(node, 0), smaller, except);
  return found ? found : superset(child(node, 1), smaller, except);
}

}  // namespace kusabi::rays
