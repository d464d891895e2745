// Disjoint sets, joined in pairs; only contact sets of similar size are compared.
#include "run/wedged/pattern_groups.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <utility>

namespace kusabi::run {
namespace {

int difference(const support::IndexSet& a, const support::IndexSet& b) {
  return (a - b).size() + (b - a).size();
}

/// Disjoint sets of indices, each represented by its least index.
class Joined {
 public:
  explicit Joined(std::size_t count) : above_(count) {
    std::iota(above_.begin(), above_.end(), 0U);
  }

  std::size_t set_of(std::size_t member) {
    while (above_[member] != member) member = above_[member] = above_[above_[member]];
    return member;
  }

  void join(std::size_t a, std::size_t b) {
    a = set_of(a);
    b = set_of(b);
    above_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> above_;
};

}  // namespace

std::vector<PatternGroup> pattern_groups(const std::vector<wedged::Configuration>& patterns,
                                         int max_differences) {
  // Contact sets that differ in n candidates differ in size by n at most.
  std::map<std::pair<std::uint32_t, int>, std::vector<std::size_t>> by_size;
  Joined joined(patterns.size());
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    const auto block = patterns[i].block;
    const auto& contact = patterns[i].pattern.contact;
    const int size = contact.size();
    for (int other = size - max_differences; other <= size + max_differences; ++other) {
      const auto found = by_size.find({block, other});
      if (found == by_size.end()) continue;
      for (const auto j : found->second) {
        if (difference(contact, patterns[j].pattern.contact) <= max_differences) joined.join(i, j);
      }
    }
    by_size[{block, size}].push_back(i);
  }
  std::map<std::size_t, PatternGroup> groups;
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    const auto& contact = patterns[i].pattern.contact;
    auto& group = groups[joined.set_of(i)];
    if (group.members.empty()) {
      group.largest_margin = i;
      group.contact = contact;
      group.varying = contact;  // the union, until all members are added
    }
    group.members.push_back(i);
    group.contact &= contact;
    group.varying |= contact;
    if (patterns[i].lower > patterns[group.largest_margin].lower) group.largest_margin = i;
  }
  std::vector<PatternGroup> list;
  for (auto& [first, group] : groups) {
    group.varying -= group.contact;
    list.push_back(std::move(group));
  }
  std::ranges::stable_sort(list, std::greater(),
                           [&](const auto& group) { return patterns[group.largest_margin].lower; });
  return list;
}

std::optional<std::vector<PatternGroup>> groups_around_largest_margin(
    const std::vector<wedged::Configuration>& patterns, int max_differences,
    std::size_t max_groups) {
  std::vector<std::size_t> order(patterns.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, std::greater(), [&](auto i) { return patterns[i].lower; });
  std::vector<PatternGroup> groups;
  for (const auto i : order) {
    const auto& contact = patterns[i].pattern.contact;
    const auto near = std::ranges::find_if(groups, [&](const PatternGroup& group) {
      const auto& first = patterns[group.largest_margin];
      return first.block == patterns[i].block &&
             difference(first.pattern.contact, contact) <= max_differences;
    });
    if (near != groups.end()) {
      near->members.push_back(i);
      near->contact &= contact;
      near->varying |= contact;  // the union, until all members are added
      continue;
    }
    if (groups.size() == max_groups) return {};
    groups.push_back({.members = {i}, .largest_margin = i, .contact = contact, .varying = contact});
  }
  for (auto& group : groups) {
    std::ranges::sort(group.members);
    group.varying -= group.contact;
  }
  return groups;
}

}  // namespace kusabi::run
