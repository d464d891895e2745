// AdjacentPairs: simultaneous descent in two bit pattern trees, and the test of adjacency.
#include "solvers/rays/adjacent_pairs.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace kusabi::rays {
namespace {

/// Number of leaf pairs between two calls of `stop`: about a millisecond.
constexpr std::uint64_t looks_between_stops = 256;

/// Number of cached third rays: on trusses sixteen answer nine tests of ten.
constexpr std::size_t max_third_rays = 16;

std::vector<int> numbers_below(std::size_t count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

}  // namespace

AdjacentPairs::AdjacentPairs(std::span<const ZeroSet> rays, const std::vector<int>& plus,
                             const std::vector<int>& minus, Candidates processed, int enough)
    : plus_(rays, plus),
      minus_(rays, minus),
      all_(rays, numbers_below(rays.size())),
      rays_(rays),
      processed_(processed),
      enough_(enough) {}

std::vector<AdjacentPairs::Part> AdjacentPairs::halves(const Part& part) const {
  const auto& [a, b] = part;
  if (!a->is_leaf() && (b->is_leaf() || a->size() >= b->size())) {
    return {{&plus_.child(*a, 0), b}, {&plus_.child(*a, 1), b}};
  }
  if (!b->is_leaf()) return {{a, &minus_.child(*b, 0)}, {a, &minus_.child(*b, 1)}};
  return {};
}

std::vector<AdjacentPairs::Part> AdjacentPairs::parts(std::uint64_t max_pairs) const {
  std::vector<Part> found;
  std::vector<Part> open{whole()};
  while (!open.empty()) {
    const Part part = open.back();
    open.pop_back();
    if (!may_be_adjacent(common(part.plus->all, part.minus->all))) continue;
    const auto pairs = static_cast<std::uint64_t>(part.plus->size()) *
                       static_cast<std::uint64_t>(part.minus->size());
    const auto halves_of_it = pairs > max_pairs ? halves(part) : std::vector<Part>{};
    if (halves_of_it.empty()) found.push_back(part);
    open.insert(open.end(), halves_of_it.rbegin(), halves_of_it.rend());
  }
  return found;
}

/// Search of one part.
class AdjacentPairs::Descent {
 public:
  Descent(const AdjacentPairs& pairs, const std::function<void(const AdjacentPair&)>& found,
          const std::function<bool()>& stop)
      : pairs_(pairs), found_(found), stop_(stop) {}

  std::uint64_t tested() const { return tested_; }
  bool stopped() const { return stopped_; }

  void descend(const BitPatternTree::Node& a, const BitPatternTree::Node& b) {
    if (stopped_ || !pairs_.may_be_adjacent(common(a.all, b.all))) return;
    if (!a.is_leaf() && (b.is_leaf() || a.size() >= b.size())) {
      descend(pairs_.plus_.child(a, 0), b);
      descend(pairs_.plus_.child(a, 1), b);
    } else if (!b.is_leaf()) {
      descend(a, pairs_.minus_.child(b, 0));
      descend(a, pairs_.minus_.child(b, 1));
    } else {
      look_at(a, b);
    }
  }

 private:
  void look_at(const BitPatternTree::Node& a, const BitPatternTree::Node& b) {
    if (stop_ && ++looks_ % looks_between_stops == 0 && stop_()) stopped_ = true;
    const auto& plus = pairs_.plus_;
    const auto& minus = pairs_.minus_;
    for (int i = a.first; i < a.last; ++i) {
      const BitPattern& above = plus.pattern(i);
      if (!pairs_.may_be_adjacent(common(above, b.all))) continue;
      const bool plain = is_plain(above);
      for (int j = b.first; j < b.last; ++j) {
        ++tested_;
        const BitPattern both = common(above, minus.pattern(j));
        if (!pairs_.may_be_adjacent(both)) continue;
        const AdjacentPair pair{plus.member(i), minus.member(j), both.zero};
        if (plain || is_plain(minus.pattern(j)) || !has_third(pair)) found_(pair);
      }
    }
  }

  /// True if a ray has the minimum number of equalities. These are independent, and so are those
  /// that it shares with another ray; if their number suffices, they define a face of two
  /// dimensions.
  bool is_plain(const BitPattern& ray) const { return size(ray.zero) == pairs_.enough_ + 1; }

  /// True if a third ray is on the smallest face of the two.
  bool has_third(const AdjacentPair& pair) {
    for (auto it = third_rays_.begin(); it != third_rays_.end(); ++it) {
      if (*it == pair.plus || *it == pair.minus) continue;
      if (!contains(pairs_.rays_[static_cast<std::size_t>(*it)], pair.common)) continue;
      std::rotate(third_rays_.begin(), it, it + 1);
      return true;
    }
    const auto third = pairs_.all_.superset(pair.common, {pair.plus, pair.minus});
    if (!third) return false;
    if (third_rays_.size() == max_third_rays) third_rays_.pop_back();
    third_rays_.insert(third_rays_.begin(), *third);
    return true;
  }

  const AdjacentPairs& pairs_;
  const std::function<void(const AdjacentPair&)>& found_;
  const std::function<bool()>& stop_;
  std::vector<int> third_rays_;  // most recent first
  std::uint64_t tested_ = 0;
  std::uint64_t looks_ = 0;
  bool stopped_ = false;
};

bool AdjacentPairs::search(const Part& part, const std::function<void(const AdjacentPair&)>& found,
                           const std::function<bool()>& stop, std::uint64_t& tested) const {
  Descent descent(*this, found, stop);
  descent.descend(*part.plus, *part.minus);
  tested += descent.tested();
  return !descent.stopped();
}

}  // namespace kusabi::rays
