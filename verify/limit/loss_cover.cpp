// Recursion over the members of one support: a loss that meets every support contains one of them.
#include "verify/limit/loss_cover.hpp"

#include <algorithm>

namespace kusabi::verify {

using support::IndexSet;

LossCover::LossCover(const std::vector<IndexSet>& supports, const IndexSet& kept, int maximum)
    : supports_(supports), needed_(supports.size()) {
  Numbers all;
  for (std::size_t k = 0; k < supports.size(); ++k) all.push_back(k);
  covers({}, kept, maximum, all);
}

std::vector<std::size_t> LossCover::needed() const {
  Numbers numbers;
  for (std::size_t k = 0; k < needed_.size(); ++k) {
    if (needed_[k]) numbers.push_back(k);
  }
  return numbers;
}

// For one further loss: true if no member is in all supports.
bool LossCover::covers_one(const IndexSet& lost, const IndexSet& kept, const Numbers& states) {
  auto common = supports_[states.front()] - kept;
  needed_[states.front()] = true;
  for (const auto k : states) {
    const auto fewer = common & supports_[k];
    if (fewer == common) continue;
    needed_[k] = true;
    common = fewer;
    if (common.empty()) return true;
  }
  flaw_ = lost | IndexSet::single(common.lowest());
  return false;
}

// True if more supports than further losses are disjoint: then one of them is not met.
bool LossCover::is_packed(const IndexSet& kept, int left, const Numbers& states) {
  Numbers packed;
  IndexSet all;
  for (const auto k : states) {
    const auto rest = supports_[k] - kept;
    if (rest.meets(all)) continue;
    all |= rest;
    packed.push_back(k);
    if (static_cast<int>(packed.size()) <= left) continue;
    for (const auto each : packed) needed_[each] = true;
    return true;
  }
  return false;
}

// @param states those without lost members
bool LossCover::covers(const IndexSet& lost, const IndexSet& kept, int left,
                       const Numbers& states) {
  if (states.empty()) {
    flaw_ = lost;
    return false;
  }
  const auto size = [&](std::size_t k) { return (supports_[k] - kept).size(); };
  std::vector<int> sizes;
  for (const auto k : states) sizes.push_back(size(k));
  const auto minimum = static_cast<std::size_t>(std::ranges::min_element(sizes) - sizes.begin());
  const auto smallest = states[minimum];
  if (left == 0 || sizes[minimum] == 0) {
    needed_[smallest] = true;
    return true;
  }
  if (left == 1) return covers_one(lost, kept, states);
  if (is_packed(kept, left, states)) return true;
  needed_[smallest] = true;
  auto kept_now = kept;
  for (const int member : supports_[smallest] - kept) {
    Numbers without;
    for (const auto k : states) {
      if (!supports_[k].contains(member)) without.push_back(k);
    }
    if (!covers(lost | IndexSet::single(member), kept_now, left - 1, without)) return false;
    kept_now.insert(member);
  }
  return true;
}

}  // namespace kusabi::verify
