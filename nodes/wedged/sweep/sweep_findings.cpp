// Ranges of cones from histories of leaves, and counts from these.
#include "nodes/wedged/sweep/sweep_findings.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "nodes/wedged/tree/maximal_cones.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

/// The range of a cone that begins with a change of its leaf, in terms of the whole problem.
ConeRange range_of(const SweptLeaf& leaf, const LeafChange& change,
                   const support::IndexSet& candidates, const FrictionGrid& grid) {
  ConeRange range{.block = leaf.block,
                  .pattern = {.contact = leaf.pattern.contact,
                              .separated = candidates - leaf.pattern.contact,
                              .inactive = {}},
                  .begins = {grid.at(change.before), grid.at(change.after)},
                  .absorbed = {}};
  if (change.to.kind == LeafStage::Kind::flat) {
    const auto& [kind, loaded, moved] = change.to;
    range.pattern.contact = problems::in_whole(loaded, candidates);
    range.pattern.separated = problems::in_whole(moved, candidates);
    range.pattern.inactive = candidates - (range.pattern.contact | range.pattern.separated);
  }
  return range;
}

/// The earlier of two brackets of the same event.
void take_earlier(FrictionBracket& bracket, const FrictionBracket& other) {
  bracket.lower = std::min(bracket.lower, other.lower);
  bracket.upper = std::min(bracket.upper, other.upper);
}

bool by_cone(const ConeRange& a, const ConeRange& b) {
  if (a.block != b.block) return a.block < b.block;
  return comes_before(a.pattern, b.pattern);
}

bool same_cone(const ConeRange& a, const ConeRange& b) {
  return a.block == b.block && a.pattern == b.pattern;
}

/// Unites the ranges of equal cones, which several leaves may have, from the smallest coefficient
/// on.
void unite(std::vector<ConeRange>& ranges) {
  std::sort(ranges.begin(), ranges.end(), by_cone);
  std::vector<ConeRange> united;
  for (auto& range : ranges) {
    if (!united.empty() && same_cone(united.back(), range))
      take_earlier(united.back().begins, range.begins);
    else
      united.push_back(std::move(range));
  }
  ranges = std::move(united);
}

/// Ends a range where the first larger cone begins. @return false if the range is then empty
bool remains(ConeRange& range, const std::vector<ConeRange>& all) {
  if (range.solid()) return true;
  for (const auto& other : all) {
    if (other.block != range.block || same_cone(range, other)) continue;
    if (!within(range.pattern, other.pattern)) continue;
    if (!range.absorbed) range.absorbed = other.begins;
    take_earlier(*range.absorbed, other.begins);
  }
  return !range.absorbed || range.absorbed->upper > range.begins.upper;
}

bool begins_before(const ConeRange& a, const ConeRange& b) {
  if (a.begins.upper != b.begins.upper) return a.begins.upper < b.begins.upper;
  return by_cone(a, b);
}

/// The brackets in order; those that overlap or touch are merged.
std::vector<FrictionBracket> merged(std::vector<FrictionBracket> brackets) {
  std::sort(brackets.begin(), brackets.end(),
            [](const auto& a, const auto& b) { return a.lower < b.lower; });
  std::vector<FrictionBracket> list;
  for (const auto& bracket : brackets) {
    if (list.empty() || bracket.lower > list.back().upper)
      list.push_back(bracket);
    else
      list.back().upper = std::max(list.back().upper, bracket.upper);
  }
  return list;
}

/// Counts at increasing coefficients outside all brackets, each event taken once.
class IncreasingCounts {
 public:
  explicit IncreasingCounts(const SweepFindings& findings) : of_block_(findings.blocks, 0) {
    for (const auto& cone : findings.cones) {
      begins_.push_back({cone.begins.upper, cone.block});
      if (cone.absorbed) ends_.push_back({cone.absorbed->lower, cone.block});
    }
    for (const auto& leaf : findings.unresolved) opens_.push_back({leaf.lower, leaf.block});
    for (auto* const events : {&begins_, &ends_, &opens_})
      std::ranges::sort(*events, {}, &Event::at);
  }

  /// @param from no smaller than `to` of the last call
  CountRange between(double from, double to) {
    const double friction = std::midpoint(from, to);
    for (; begun_ < begins_.size() && begins_[begun_].at <= friction; ++begun_)
      ++of_block_[begins_[begun_].block];
    for (; ended_ < ends_.size() && ends_[ended_].at < friction; ++ended_)
      --of_block_[ends_[ended_].block];
    while (open_ < opens_.size() && opens_[open_].at < friction) ++open_;
    return {from, to, combinations(of_block_), open_};
  }

 private:
  struct Event {
    double at = 0;
    std::uint32_t block = 0;
  };

  std::vector<Event> begins_, ends_, opens_;
  std::size_t begun_ = 0, ended_ = 0, open_ = 0;
  std::vector<std::uint64_t> of_block_;
};

}  // namespace

void add_histories(SweepFindings& findings, const std::vector<SweptLeaf>& leaves,
                   const std::vector<support::IndexSet>& candidates, const FrictionGrid& grid) {
  std::vector<ConeRange> ranges;
  for (const auto& leaf : leaves) {
    const auto& own = candidates[leaf.block];
    if (!leaf.history || leaf.history->open_above != LeafHistory::never) {
      const auto from = leaf.history ? leaf.history->open_above : 0;
      findings.unresolved.push_back({leaf.block, leaf.pattern, grid.at(from)});
    }
    if (!leaf.history) continue;
    for (const auto& change : leaf.history->changes)
      ranges.push_back(range_of(leaf, change, own, grid));
  }
  unite(ranges);
  for (auto range : ranges) {
    if (range.begins.lower < findings.maximum && remains(range, ranges))
      findings.cones.push_back(std::move(range));
  }
  std::sort(findings.cones.begin(), findings.cones.end(), begins_before);
}

ConeCount SweepFindings::count_at(double friction) const {
  ConeCount count{.friction = friction, .known = {}};
  std::vector<std::uint64_t> of_block(blocks, 0);
  for (const auto& cone : cones) {
    const bool changes =
        cone.begins.contains(friction) || (cone.absorbed && cone.absorbed->contains(friction));
    if (changes) ++count.unresolved;
    const bool begun = cone.begins.upper <= friction;
    if (begun && (!cone.absorbed || friction <= cone.absorbed->lower)) ++of_block[cone.block];
  }
  for (const auto& leaf : unresolved) {
    if (friction > leaf.lower) ++count.unresolved;
  }
  count.known = combinations(of_block);
  return count;
}

std::vector<CountRange> SweepFindings::staircase() const {
  std::vector<FrictionBracket> brackets;
  for (const auto& cone : cones) {
    brackets.push_back(cone.begins);
    if (cone.absorbed) brackets.push_back(*cone.absorbed);
  }
  for (const auto& leaf : unresolved) brackets.push_back({leaf.lower, leaf.lower});
  std::vector<CountRange> ranges;
  IncreasingCounts counts(*this);
  const auto add = [&](double from, double to) {
    to = std::min(to, maximum);
    if (!(from < to)) return;
    ranges.push_back(counts.between(from, to));
  };
  double from = 0;
  for (const auto& [lower, upper] : merged(std::move(brackets))) {
    add(from, lower);
    from = upper;
  }
  add(from, maximum);
  return ranges;
}

}  // namespace kusabi::wedged
