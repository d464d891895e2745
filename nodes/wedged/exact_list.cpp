// One tree with exact test for each coefficient.
#include "nodes/wedged/exact_list.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>
#include <fmt/format.h>

#include "engine/collectives.hpp"
#include "nodes/wedged/friction/critical_friction.hpp"
#include "nodes/wedged/tree/candidate_friction.hpp"
#include "problems/wedged/scale_ratio.hpp"

namespace kusabi::wedged {
namespace {

/// Maximum number of steps of a sweep that are tested, since each takes a tree.
constexpr std::size_t max_tested = 400;

using Cones = std::set<std::pair<rays::Candidates, rays::Candidates>>;

ExactTest test_of(const ExactParameters& parameters) {
  return {.scale_ratio = problems::scale_ratio(parameters.structure, parameters.problem),
          .asked = parameters.proving == Proving::always};
}

bool is_wanted(const ExactTest& test) {
  return test.asked || test.scale_ratio > max_safe_scale_ratio;
}

PatternFindings exact_list(engine::Analysis& analysis, const ExactParameters& parameters,
                           std::span<const double> friction, EvidenceRecorder recorder = {}) {
  PatternParameters patterns;
  patterns.tree.thorough = static_cast<bool>(recorder);
  patterns.recorder = std::move(recorder);
  patterns.structure = &parameters.structure;
  patterns.proving = parameters.proving;
  return find_patterns(analysis, parameters.problem, friction, patterns);
}

/// Adds the test of a list, and the reasons why the list cannot be used for comparison.
void add(ExactTest& test, const PatternFindings& list) {
  test.done = list.exact.done;
  test.refused += list.exact.refused;
  test.unproved += list.exact.unproved;
  test.closed_unproved += list.exact.closed_unproved;
  test.unable = list.exact.unable;
  if (list.exact.displacement_ratio)
    test.displacement_ratio =
        std::min(*list.exact.displacement_ratio, test.displacement_ratio.value_or(HUGE_VAL));
  if (test.unable.empty() && !list.whole()) test.unable = "the exact test was stopped early";
  if (test.unable.empty() && list.unresolved() > 0)
    test.unable = "the exact test leaves patterns undecided";
  test.done = test.unable.empty();
}

/// Records that the lists differ.
void refute(ExactTest& test, const std::string& why) {
  test.unable = why;
  test.done = false;
}

rays::Candidates bits_of(const support::IndexSet& candidates) {
  rays::Candidates bits = 0;
  for (const int candidate : candidates) bits |= rays::bit(candidate);
  return bits;
}

/// Compares the found cones with those of the list, block by block; cones of different blocks
/// combine freely. Ignores cones without reaction on a block that can have reactions: its body
/// moves away, so they are not on the list.
bool is_same(const std::vector<rays::Cone>& found, const PatternFindings& list) {
  std::vector<rays::Candidates> blocks;
  std::vector<Cones> listed(list.blocks.size());
  std::vector<Cones> own(list.blocks.size());
  for (const auto& block : list.blocks) blocks.push_back(bits_of(block.candidates));
  for (const auto& leaf : list.leaves)
    listed[leaf.block].emplace(bits_of(leaf.pattern.contact), bits_of(leaf.pattern.separated));
  Cones whole;
  for (const auto& cone : found) {
    rays::Candidates separated = 0;
    bool moves_away = false;
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      const bool has_reaction = (cone.reaction & blocks[k]) != 0;
      if (has_reaction) separated |= cone.separated & blocks[k];
      moves_away = moves_away || (!has_reaction && !listed[k].empty());
    }
    if (moves_away) continue;
    whole.emplace(cone.reaction, separated);
    for (std::size_t k = 0; k < blocks.size(); ++k)
      if ((cone.reaction & blocks[k]) != 0)
        own[k].emplace(cone.reaction & blocks[k], separated & blocks[k]);
  }
  return own == listed && whole.size() == list.count();
}

}  // namespace

ExactTest tested_cones(engine::Analysis& analysis, const ExactParameters& parameters,
                       std::span<const double> friction, const std::vector<rays::Cone>& found) {
  auto test = test_of(parameters);
  if (!is_wanted(test)) return test;
  const auto list = exact_list(analysis, parameters, friction);
  add(test, list);
  if (analysis.is_first() && test.unable.empty() && !is_same(found, list)) {
    refute(test, fmt::format("by the exact test there are {} maximal cones, not these {}",
                             list.count().text(), found.size()));
  }
  // Cones in which a body moves away are not compared, and nothing is proved of them.
  if (test.proves() && list.flat == 0 && list.count() == found.size()) test.cones = found.size();
  return test;
}

ExactTest tested_counts(engine::Analysis& analysis, const ExactParameters& parameters,
                        std::span<const double> points, const SweepFindings& found,
                        ListRecords* records) {
  auto test = test_of(parameters);
  if (!is_wanted(test)) return test;
  const auto coefficients = engine::from_first_rank(analysis.transport(), [&] {
    std::set<double> all(points.begin(), points.end());
    all.insert(found.maximum);
    for (const auto& cone : found.cones) {
      all.insert({cone.begins.lower, cone.begins.upper});
      if (cone.absorbed) all.insert({cone.absorbed->lower, cone.absorbed->upper});
    }
    all.erase(all.begin(), all.upper_bound(0));
    return std::vector<double>(all.begin(), all.end());
  });
  const double minimum = CriticalFriction::range(parameters.problem).minimum;
  if (!coefficients.empty() && coefficients.front() < minimum) {
    test.unable = fmt::format("friction coefficients below {:g} are not tested", minimum);
    return test;
  }
  if (coefficients.size() > max_tested) {
    test.unable = fmt::format("{} coefficients are more than are tested", coefficients.size());
    return test;
  }
  if (records != nullptr) records->expect(coefficients.size());
  for (const double coefficient : coefficients) {
    const auto friction = candidate_friction(parameters.problem, coefficient);
    const auto list =
        exact_list(analysis, parameters, friction,
                   records == nullptr ? EvidenceRecorder() : records->begin(coefficient));
    if (records != nullptr) records->end(list, friction);
    const bool goes_on = engine::from_first_rank(analysis.transport(), [&] {
      add(test, list);
      const auto count = found.count_at(coefficient);
      if (test.unable.empty() && count.exact() && count.known != list.count()) {
        refute(test, fmt::format("by the exact test there are {} patterns at {}, not {}",
                                 list.count().text(), coefficient, count.known.text()));
      }
      return test.unable.empty();
    });
    if (!goes_on) break;
  }
  return test;
}

}  // namespace kusabi::wedged
