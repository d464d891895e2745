// Samples are shared among the ranks.
#include "nodes/limit/compared_loads.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>

#include "engine/shared_work.hpp"

namespace kusabi::limit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Samples in one piece of work: some milliseconds.
constexpr std::uint64_t samples_a_piece = 16;

}  // namespace

std::vector<double> sampled_factors(RootSearch& search, const LimitQuestion& question) {
  const auto& model = search.model();
  const auto& budget = search.campaign().budget();
  const double alpha = search.scaled(*question.alpha);
  LoadFactor load_factor(model, budget.stop());
  load_factor.solve(model.dead);
  const auto piece = [&](std::uint64_t number) {
    std::vector<double> factors;
    const auto first = number * samples_a_piece;
    const auto last = std::min(first + samples_a_piece, question.samples);
    for (auto sample = first; sample < last && !budget.spent(); ++sample) {
      std::seed_seq seed{question.seed, sample};
      std::mt19937_64 bits(seed);
      Eigen::VectorXd zeta(model.uncertain_count());
      // The standard fixes what mt19937_64 yields, not what its distributions make of it.
      for (double& each : zeta) each = 2 * (static_cast<double>(bits() >> 11U) * 0x1p-53) - 1;
      if (zeta.size() > 0) zeta *= alpha / zeta.cwiseAbs().maxCoeff();
      load_factor.restart();
      const auto status = load_factor.solve(dead_load(model, zeta));
      if (status == LoadStatus::undetermined) continue;
      factors.push_back(status == LoadStatus::collapses
                            ? load_factor.collapse().factor * model.factor_unit
                            : -infinity);
    }
    return factors;
  };
  std::vector<double> all;
  const auto pieces = (question.samples + samples_a_piece - 1) / samples_a_piece;
  for (const auto& some :
       engine::share_work<std::vector<double>>(search.campaign().transport(), pieces, piece)) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

}  // namespace kusabi::limit
