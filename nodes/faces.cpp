// Which numbers of a marginal leaf's configuration are zero, and which living pattern has those
// zeros.
#include "nodes/faces.hpp"

#include <algorithm>
#include <bit>
#include <vector>

namespace kusabi::nodes {
namespace {

// The leaf is solved again as far as double precision goes, since what vanishes in the limit
// vanishes with the bracket of t*: at 1e-7, the tolerance of the sign, it may still be 1e-5.
constexpr conic::Tolerances sharp{.sign = 1e-11, .value = 1e-12, .iterations = 100};

// Of numbers that sum to about one, those that vanish end below 1e-5, those that do not are seldom
// below 1e-4; whatever the numbers are, the largest zero and the least nonzero must lie this far
// apart. On trusses of one bay with their 800 ties the gap is at least 1e5.
constexpr double widest_zero = 1e-5;
constexpr double least_gap = 1e3;

// Below this all numbers are alike: the rounding of F r.
constexpr double rounding = 1e-14;

struct Entry {
  double size;
  std::uint64_t candidate;
};

// The candidates whose number is zero; nothing if zero cannot be told from nonzero, or none is
// zero.
std::optional<std::uint64_t> zeros(std::vector<Entry>& entries) {
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.size < b.size; });
  const auto clamped = [&](std::size_t i) { return std::max(entries[i].size, rounding); };
  std::size_t last = 0;
  double widest = 0;
  for (std::size_t i = 0; i + 1 < entries.size(); ++i) {
    const double gap = clamped(i + 1) / clamped(i);
    if (gap <= widest) continue;
    widest = gap;
    last = i;
  }
  if (widest < least_gap || entries[last].size > widest_zero) return std::nullopt;
  std::uint64_t set = 0;
  for (std::size_t i = 0; i <= last; ++i) set |= entries[i].candidate;
  return set;
}

}  // namespace

FaceFinder::FaceFinder(const problems::WedgedProblem& problem, std::span<const double> friction)
    : solver_(problem, friction, sharp) {}

std::optional<Face> FaceFinder::find(const SignPattern& leaf,
                                     std::span<const std::uint64_t> living) {
  solver_.solve(leaf.contact, leaf.separated, {.when_dead = false, .when_alive = false});
  std::vector<Entry> entries;
  for (auto rest = leaf.contact | leaf.separated; rest != 0; rest &= rest - 1) {
    const auto candidate = rest & ~(rest - 1);
    const int i = std::countr_zero(rest);
    const bool touches = (leaf.contact & candidate) != 0;
    entries.push_back(
        {touches ? solver_.normal_reaction(i) : solver_.normal_displacement(i), candidate});
  }
  const auto zero = zeros(entries);
  if (!zero) return std::nullopt;
  const auto loaded = leaf.contact & ~*zero;                     // must be in contact
  const auto resting = leaf.contact | (leaf.separated & *zero);  // may be
  for (const auto contact : living) {
    if ((loaded & ~contact) == 0 && (contact & ~resting) == 0) {
      return Face{
          .within = contact, .unloaded = leaf.contact & *zero, .unmoved = leaf.separated & *zero};
    }
  }
  return std::nullopt;
}

}  // namespace kusabi::nodes
