// Comparison of cones by the active candidates of their relative interiors.
#include "nodes/wedged/tree/maximal_cones.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace kusabi::wedged {
namespace {

/// True if the first comes before the second in lexicographic order of the increasing lists.
bool precedes(const support::IndexSet& a, const support::IndexSet& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

bool is_cone(const Configuration& leaf) {
  return leaf.state == LeafState::alive || leaf.state == LeafState::flat;
}

/// Feasible and flat cones are one kind.
int kind(const Configuration& leaf) {
  return is_cone(leaf) ? 0 : leaf.state == LeafState::marginal ? 1 : 2;
}

bool in_order(const Configuration& a, const Configuration& b) {
  if (kind(a) != kind(b)) return kind(a) < kind(b);
  if (a.block != b.block) return a.block < b.block;
  return wedged::comes_before(a.pattern, b.pattern);
}

}  // namespace

bool comes_before(const SignPattern& first, const SignPattern& second) {
  if (first.contact != second.contact) return precedes(first.contact, second.contact);
  return precedes(first.separated, second.separated);
}

bool within(const SignPattern& first, const SignPattern& second) {
  return second.contact.includes(first.contact) && second.separated.includes(first.separated);
}

std::vector<Configuration> maximal_cones(std::vector<Configuration> leaves) {
  std::sort(leaves.begin(), leaves.end(), in_order);
  std::vector<Configuration> kept;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const auto& leaf = leaves[i];
    // Solid cones are contained in no other. Of equal flat ones the first is kept.
    const auto contains_it = [&](const Configuration& other) {
      if (&other == &leaf || !is_cone(other) || other.block != leaf.block) return false;
      if (!within(leaf.pattern, other.pattern)) return false;
      return !within(other.pattern, leaf.pattern) || &other < &leaf;
    };
    if (leaf.state == LeafState::flat && std::any_of(leaves.begin(), leaves.end(), contains_it))
      continue;
    kept.push_back(leaf);
  }
  return kept;
}

support::ExactCount combinations(std::span<const std::uint64_t> cones_of_blocks) {
  std::vector<std::uint64_t> factors;
  std::ranges::copy_if(cones_of_blocks, std::back_inserter(factors),
                       [](std::uint64_t cones) { return cones != 0; });
  return factors.empty() ? support::ExactCount() : support::ExactCount::product(factors);
}

}  // namespace kusabi::wedged
