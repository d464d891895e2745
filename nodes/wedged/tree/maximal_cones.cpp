// Comparison of cones by the active candidates of their relative interiors, many cones at a time.
#include "nodes/wedged/tree/maximal_cones.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

namespace kusabi::wedged {
namespace {

/// True if the first comes before the second in lexicographic order of the increasing lists.
bool precedes(const support::IndexSet& a, const support::IndexSet& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

/// Feasible and flat cones are one kind.
int kind(const Configuration& leaf) {
  return leaf.is_cone() ? 0 : leaf.state == LeafState::marginal ? 1 : 2;
}

bool in_order(const Configuration& a, const Configuration& b) {
  if (kind(a) != kind(b)) return kind(a) < kind(b);
  if (a.block != b.block) return a.block < b.block;
  return wedged::comes_before(a.pattern, b.pattern);
}

/// Number of cones compared at a time: their bits fit in the cache.
constexpr std::size_t cones_per_batch = 4096;

/// Consecutive cones of one block: for each candidate those with it in contact, and those with it
/// separated, one bit per cone.
class ConeBits {
 public:
  /// @param first, last a range of the leaves, last excluded
  ConeBits(const std::vector<Configuration>& leaves, std::size_t first, std::size_t last)
      : leaves_(leaves), first_(first), all_(last - first) {
    for (std::size_t i = first; i < last; ++i) {
      all_.add(i - first);
      add(contact_, leaves[i].pattern.contact, i - first);
      add(separated_, leaves[i].pattern.separated, i - first);
    }
  }

  /// True if another of these cones contains this one. Of equal ones the first contains the others.
  [[nodiscard]] bool contain(std::size_t leaf) const {
    const auto& pattern = leaves_[leaf].pattern;
    auto others = all_;
    if (!others.restrict_to(contact_, pattern.contact) ||
        !others.restrict_to(separated_, pattern.separated))
      return false;
    for (std::size_t word = 0; word < others.words.size(); ++word) {
      for (auto left = others.words[word]; left != 0; left &= left - 1) {
        const auto other = first_ + bits * word + static_cast<std::size_t>(std::countr_zero(left));
        if (other == leaf) continue;
        if (other < leaf || !within(leaves_[other].pattern, pattern)) return true;
      }
    }
    return false;
  }

 private:
  static constexpr std::size_t bits = 64;

  struct Cones {
    explicit Cones(std::size_t count) : words((count + bits - 1) / bits) {}

    void add(std::size_t cone) { words[cone / bits] |= std::uint64_t{1} << (cone % bits); }

    // Keeps the cones in the rows of all these candidates. @return false if there are none
    bool restrict_to(const std::vector<Cones>& rows, const support::IndexSet& candidates) {
      for (const int candidate : candidates) {
        const auto row = static_cast<std::size_t>(candidate);
        if (row >= rows.size()) return false;
        std::uint64_t any = 0;
        for (std::size_t k = 0; k < words.size(); ++k) any |= words[k] &= rows[row].words[k];
        if (any == 0) return false;
      }
      return true;
    }

    std::vector<std::uint64_t> words;
  };

  void add(std::vector<Cones>& rows, const support::IndexSet& candidates, std::size_t cone) const {
    for (const int candidate : candidates) {
      const auto row = static_cast<std::size_t>(candidate);
      if (row >= rows.size()) rows.resize(row + 1, Cones(bits * all_.words.size()));
      rows[row].add(cone);
    }
  }

  const std::vector<Configuration>& leaves_;
  std::size_t first_;
  Cones all_;
  std::vector<Cones> contact_, separated_;  // by candidate
};

/// Marks flat cones contained in others of a block. Solid cones are contained in no other.
/// @param first, last the range of its cones
void mark_contained(const std::vector<Configuration>& leaves, std::size_t first, std::size_t last,
                    std::vector<bool>& contained) {
  std::vector<std::size_t> flat;
  for (std::size_t i = first; i < last; ++i) {
    if (leaves[i].state == LeafState::flat) flat.push_back(i);
  }
  for (std::size_t from = first; from < last && !flat.empty(); from += cones_per_batch) {
    const ConeBits cones(leaves, from, std::min(last, from + cones_per_batch));
    for (const auto leaf : flat) contained[leaf] = contained[leaf] || cones.contain(leaf);
  }
}

}  // namespace

bool comes_before(const SignPattern& first, const SignPattern& second) {
  if (first.contact != second.contact) return precedes(first.contact, second.contact);
  return precedes(first.separated, second.separated);
}

bool has_larger_margin(const Configuration& first, const Configuration& second) {
  if (first.lower != second.lower) return first.lower > second.lower;
  return in_order(first, second);
}

bool within(const SignPattern& first, const SignPattern& second) {
  return second.contact.includes(first.contact) && second.separated.includes(first.separated);
}

std::vector<Configuration> maximal_cones(std::vector<Configuration> leaves) {
  std::sort(leaves.begin(), leaves.end(), in_order);
  std::vector<bool> contained(leaves.size());
  std::size_t last = 0;
  for (std::size_t first = 0; first < leaves.size() && leaves[first].is_cone(); first = last) {
    while (last < leaves.size() && leaves[last].is_cone() &&
           leaves[last].block == leaves[first].block)
      ++last;
    mark_contained(leaves, first, last, contained);
  }
  std::vector<Configuration> kept;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    if (!contained[i]) kept.push_back(std::move(leaves[i]));
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
