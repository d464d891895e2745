// Samples are distributed over the ranks.
#include "nodes/limit/compared_loads.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include "engine/analysis/analysis.hpp"
#include "engine/collectives.hpp"
#include "solvers/linear/linear_program.hpp"

namespace kusabi::limit {
namespace {

/// Samples in one unit of work: some milliseconds.
constexpr std::uint64_t samples_per_piece = 16;

// A sample with a generator of its own, |zeta|_inf = alpha. @param alpha scaled
Eigen::VectorXd sampled_zeta(std::uint64_t seed, std::uint64_t sample, int count, double alpha) {
  std::seed_seq sequence{seed, sample};
  std::mt19937_64 bits(sequence);
  Eigen::VectorXd zeta(count);
  // The standard specifies the numbers of mt19937_64 but not its distributions.
  for (double& each : zeta) each = 2 * (static_cast<double>(bits() >> 11U) * 0x1p-53) - 1;
  if (zeta.size() > 0) zeta *= alpha / zeta.cwiseAbs().maxCoeff();
  return zeta;
}

}  // namespace

SampledLoads sampled_loads(RootSearch& search, const LimitParameters& parameters) {
  const auto& model = search.model();
  const auto& budget = search.analysis().budget();
  const double alpha = search.scaled(*parameters.alpha);
  LoadFactor load_factor(model, budget.stop());
  load_factor.solve(model.dead);
  const auto solve = [&](std::uint64_t sample) {
    load_factor.restart();
    return load_factor.solve(
        dead_load(model, sampled_zeta(parameters.seed, sample, model.uncertain_count(), alpha)));
  };
  // Factor of each solved sample, with its number.
  using Factors = std::vector<std::pair<std::uint64_t, double>>;
  const auto piece = [&](std::uint64_t number) {
    Factors factors;
    const auto first = number * samples_per_piece;
    const auto last = std::min(first + samples_per_piece, parameters.samples);
    for (auto sample = first; sample < last && !budget.spent(); ++sample) {
      const auto status = solve(sample);
      if (status == LoadStatus::undetermined) continue;
      factors.emplace_back(sample, status == LoadStatus::collapses
                                       ? load_factor.collapse().factor * model.factor_unit
                                       : -linear::infinity);
    }
    return factors;
  };
  SampledLoads result;
  std::optional<std::pair<double, std::uint64_t>> minimum;
  const auto pieces = (parameters.samples + samples_per_piece - 1) / samples_per_piece;
  for (const auto& some : search.analysis().share<Factors>(pieces, piece)) {
    for (const auto& [sample, factor] : some) {
      result.factors.push_back(factor);
      if (std::isfinite(factor) && (!minimum || factor < minimum->first))
        minimum = {factor, sample};
    }
  }
  if (!minimum) return result;
  // All ranks use the decision of the first one.
  const auto motion = engine::from_first_rank(search.analysis().transport(), [&] {
    std::vector<double> found;
    if (solve(minimum->second) != LoadStatus::collapses) return found;
    const auto scaled = load_factor.collapse().motion;
    found.assign(scaled.begin(), scaled.end());
    return found;
  });
  if (motion.empty()) return result;
  const Eigen::Map<const Eigen::VectorXd> scaled(motion.data(), model.free_count());
  result.best = ZeroOneStart{minimum->first, problems::motion_in_units(model, scaled)};
  return result;
}

}  // namespace kusabi::limit
