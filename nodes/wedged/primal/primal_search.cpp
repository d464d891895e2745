// Rounds of trials, in clusters and of all candidates.
#include "nodes/wedged/primal/primal_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <boost/serialization/vector.hpp>
#include <fmt/format.h>

#include "nodes/wedged/friction/critical_friction.hpp"
#include "nodes/wedged/primal/clusters.hpp"
#include "nodes/wedged/primal/linearisation.hpp"
#include "nodes/wedged/primal/mode_starts.hpp"
#include "nodes/wedged/primal/pattern_coefficient.hpp"

namespace kusabi::wedged {
namespace {

/// Factor of the coefficients of trials after a round without success, while no pattern is known.
constexpr double next_factor = 4;

/// Trials of a round from modes, and their coefficients as shares of the best one.
constexpr std::uint64_t starts_per_round = 6;
constexpr std::array<double, 3> start_shares{0.98, 0.8, 0.6};

/// Shares of its coefficient, and scalings, at which the best pattern is the start of new trials.
constexpr std::array<double, 3> descent_shares{0.9, 0.97, 0.99};
constexpr std::array<double, 2> descent_scales{0.5, 1};

/// Smallest relative decrease of the coefficient that counts as better.
constexpr double hardly_better = 2e-5;

/// Smallest relative decrease of the coefficient of a successful round.
constexpr double min_round_gain = 1e-4;

/// Consecutive rounds from modes without success before the search ends.
constexpr int max_idle_rounds = 3;

/// Number of clusters of a large block, and of their patterns that are tried with all candidates,
/// with slightly more friction since clusters are stiffer.
constexpr int cluster_count = 50;
constexpr std::size_t max_prolonged = 12;
constexpr double room_to_prolong = 1.15;

/// Largest coefficient of patterns of clusters that are kept, relative to the best one.
constexpr double pool_reach = 1.5;

/// Smallest relative distance of trials from an infeasible coefficient.
constexpr double min_above = 1e-4;

struct Trial {
  support::IndexSet contact;
  double factor = 1;
  double share = 0.5;
};

struct TrialResult {
  PrimalPattern pattern;
  std::uint64_t programs = 0;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& pattern& programs;
  }
};

// Search with clusters, or with all candidates.
class TrialRounds {
 public:
  TrialRounds(engine::Analysis& analysis, const problems::WedgedProblem& block,
              const PrimalParameters& parameters, double reach,
              const std::function<void(const PrimalPattern&)>& better)
      : analysis_(analysis),
        parameters_(parameters),
        reach_(reach),
        better_(better),
        modes_(block),
        linearisation_(block),
        critical_(block, 1e-8, Precision::doubles),
        best_(parameters.known) {
    linearisation_.end_when(analysis.budget().stop());
    critical_.end_when(analysis.budget().stop());
  }

  // Rounds from modes, each followed by rounds from the best pattern, until none is successful.
  void run() {
    double from = std::min(parameters_.from, parameters_.maximum);
    for (int idle = 0; idle < max_idle_rounds && !done(); ++idle) {
      if (round(mode_trials(from))) idle = -1;
      descend();
      if (!best_.is_known()) from = std::min(next_factor * from, parameters_.maximum);
    }
  }

  // Rounds from the best pattern at smaller coefficients, as long as they are successful.
  void descend() {
    while (best_.is_known() && !done()) {
      std::vector<Trial> trials;
      for (const double share : descent_shares)
        for (const double scale : descent_scales)
          trials.push_back({best_.contact, above_infeasible(share * best_.factor), scale});
      if (!round(trials)) return;
    }
  }

  // @return true if the round was successful
  bool round(const std::vector<Trial>& trials) {
    const auto results = analysis_.share<TrialResult>(
        trials.size(), [&](std::uint64_t piece) { return made(trials[piece]); });
    const double before = best_.factor;
    for (const auto& [pattern, programs] : results) {
      programs_ += programs;
      if (!pattern.is_known()) continue;
      pool_.push_back(pattern);
      if (!(pattern.factor < best_.factor * (1 - hardly_better))) continue;
      best_ = pattern;
    }
    if (best_.factor < before && better_) better_(best_);
    analysis_.say_now_and_then([&] {
      if (reach_ > 1)
        return fmt::format("looking for patterns of clusters of candidates: {} programs",
                           programs_);
      return best_.is_known()
                 ? fmt::format(
                       "looking for patterns without a tree: one sticks at {:.6g}, {} programs",
                       best_.factor, programs_)
                 : fmt::format("looking for patterns without a tree: none yet, {} programs",
                               programs_);
    });
    return best_.factor < before * (1 - min_round_gain);
  }

  [[nodiscard]] bool done() {
    return best_.factor <= parameters_.enough || best_.factor <= above_infeasible(0) ||
           analysis_.ended();
  }

  [[nodiscard]] const PrimalPattern& best() const { return best_; }
  [[nodiscard]] std::uint64_t programs() const { return programs_; }

  // Distinct patterns, the best first.
  [[nodiscard]] std::vector<PrimalPattern> pool() const {
    auto patterns = pool_;
    std::ranges::sort(patterns, [](const auto& a, const auto& b) {
      return a.factor != b.factor ? a.factor < b.factor : a.contact < b.contact;
    });
    // Not std::ranges::unique: Clang 14 rejects its result in the library of GCC 12.
    const auto same = [](const auto& a, const auto& b) { return a.contact == b.contact; };
    patterns.erase(std::unique(patterns.begin(), patterns.end(), same), patterns.end());
    return patterns;
  }

 private:
  std::vector<Trial> mode_trials(double from) {
    std::vector<Trial> trials;
    for (std::uint64_t i = 0; i < starts_per_round; ++i, ++next_start_) {
      auto start = modes_.at(next_start_);
      const double factor = best_.is_known() ? start_shares[i % start_shares.size()] * best_.factor
                                             : from / static_cast<double>(1 << (i % 3));
      trials.push_back({std::move(start.contact), above_infeasible(factor), start.share});
    }
    return trials;
  }

  [[nodiscard]] double above_infeasible(double factor) const {
    return std::max(factor, parameters_.infeasible * (1 + min_above));
  }

  // Largest coefficient of a pattern worth keeping.
  [[nodiscard]] double limit() const {
    return best_.factor * (reach_ > 1 ? reach_ : 1 - hardly_better);
  }

  TrialResult made(const Trial& trial) {
    const auto before = critical_.programs() + linearisation_.programs();
    TrialResult result;
    try {
      const auto estimate = linearisation_.from(trial.contact, trial.factor, trial.share);
      if (estimate) {
        const auto factor = pattern_coefficient(
            critical_, estimate->contact,
            {.infeasible = parameters_.infeasible, .first = trial.factor, .limit = limit()});
        if (factor && *factor <= parameters_.maximum) result.pattern = {*factor, estimate->contact};
      }
    } catch (const support::Stopped&) {
    }
    result.programs = critical_.programs() + linearisation_.programs() - before;
    return result;
  }

  engine::Analysis& analysis_;
  PrimalParameters parameters_;
  double reach_;
  const std::function<void(const PrimalPattern&)>& better_;
  ModeStarts modes_;
  Linearisation linearisation_;
  CriticalFriction critical_;
  PrimalPattern best_;
  std::vector<PrimalPattern> pool_;
  std::uint64_t programs_ = 0, next_start_ = 0;
};

// Trials for the whole block from the patterns of its clusters.
std::vector<Trial> prolonged(engine::Analysis& analysis, const problems::WedgedProblem& block,
                             const PrimalParameters& parameters, std::uint64_t& programs) {
  const auto clusters = clusters_of(block, cluster_count);
  const std::function<void(const PrimalPattern&)> nobody;
  TrialRounds coarse(analysis, clusters.problem,
                     {.infeasible = 0,
                      .maximum = parameters.maximum,
                      .enough = 0,
                      .from = parameters.from,
                      .known = {}},
                     pool_reach, nobody);
  coarse.run();
  programs += coarse.programs();
  std::vector<Trial> trials;
  for (const auto& pattern : coarse.pool()) {
    if (trials.size() == max_prolonged) break;
    trials.push_back(
        {clusters.members(pattern.contact),
         std::max(room_to_prolong * pattern.factor, parameters.infeasible * (1 + min_above)), 0.5});
  }
  return trials;
}

}  // namespace

PrimalFindings search_primal(engine::Analysis& analysis, const problems::WedgedProblem& block,
                             const PrimalParameters& parameters,
                             const std::function<void(const PrimalPattern&)>& better) {
  PrimalFindings findings;
  const bool with_clusters =
      static_cast<int>(block.contact_names.size()) >= min_candidates_for_clusters;
  if (parameters.part == PrimalPart::later && !with_clusters) return findings;
  TrialRounds rounds(analysis, block, parameters, 1, better);
  if (with_clusters && parameters.part != PrimalPart::later && !rounds.done()) {
    auto trials = prolonged(analysis, block, parameters, findings.programs);
    if (rounds.best().is_known())
      for (auto& trial : trials)
        trial.factor = std::min(trial.factor, start_shares[0] * rounds.best().factor);
    for (std::size_t first = 0; first < trials.size() && !rounds.done();
         first += starts_per_round) {
      const auto last = std::min<std::size_t>(first + starts_per_round, trials.size());
      rounds.round({trials.begin() + static_cast<std::ptrdiff_t>(first),
                    trials.begin() + static_cast<std::ptrdiff_t>(last)});
    }
    rounds.descend();
  }
  if (!with_clusters || parameters.part != PrimalPart::first) rounds.run();
  findings.best = rounds.best();
  findings.programs += rounds.programs();
  return findings;
}

}  // namespace kusabi::wedged
