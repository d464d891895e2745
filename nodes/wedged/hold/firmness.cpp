// Patterns shared among the ranks, each followed to both of its ends.
#include "nodes/wedged/hold/firmness.hpp"

#include <cstddef>
#include <cstdint>

#include "engine/collectives.hpp"
#include "nodes/wedged/hold/block_hold.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

/// Relative width of the brackets of ends.
constexpr double firmness_width = 1e-6;

/// The reference load alone.
LoadedProblem without_dead(LoadedProblem loaded) {
  loaded.clearance.setZero();
  if (!loaded.has_dead) return loaded;
  auto& loads = loaded.loads;
  loaded.has_dead = false;
  loads.displacements = numbers::PreciseMatrix(loads.displacements.rightCols(1));
  loads.work = numbers::PreciseMatrix(loads.work.bottomRightCorner(1, 1));
  loads.motions = numbers::PreciseMatrix(loads.motions.bottomRows(1));
  loads.other_modes = numbers::PreciseMatrix(loads.other_modes.bottomRows(1));
  loads.sizes = Eigen::VectorXd(loads.sizes.tail(1));
  return loaded;
}

}  // namespace

PatternFirmness::PatternFirmness(engine::Analysis& analysis, const LoadedProblem& loaded, double mu)
    : analysis_(analysis),
      mu_(mu),
      out_of_equilibrium_(work_on_other_modes(loaded, {0, 1}) > negligible_work),
      candidates_(problems::blocks_of(loaded.problem)) {
  parameters_.width = firmness_width;
  parameters_.total = 1;
  const LoadedProblem alone = without_dead(loaded);
  for (const auto& candidates : candidates_) blocks_.push_back(loaded_block(alone, candidates));
}

std::optional<Firmness> PatternFirmness::of(const Configuration& leaf) const {
  const auto& block = blocks_[leaf.block];
  if (leaf.state != LeafState::feasible) return {};
  if (out_of_equilibrium_) return Firmness{};
  if (!acts(block, 0)) return {};
  const SignPattern own = own_leaf(leaf, candidates_[leaf.block]);
  std::vector<HoldCost> costs;
  BlockHold hold(analysis_, block, parameters_, costs);
  const auto found = hold.ends_of({own.contact, own.separated}, mu_);
  return Firmness{found.low_out.value, found.low, found.high, found.high_out.value};
}

std::vector<std::optional<Firmness>> firmness_of_patterns(engine::Analysis& analysis,
                                                          const LoadedProblem& loaded, double mu,
                                                          std::span<const Configuration> leaves) {
  const auto known = engine::from_first_rank(analysis.transport(), [&] {
    return std::vector<Configuration>(leaves.begin(), leaves.end());
  });
  if (known.empty()) return {};
  const PatternFirmness firmness(analysis, loaded, mu);
  const auto ends = analysis.share_within_limits<std::vector<double>>(
      known.size(), [&](std::uint64_t number) -> std::vector<double> {
        const auto found = firmness.of(known[number]);
        if (!found) return {};
        return {found->low_out, found->low, found->high, found->high_out};
      });
  std::vector<std::optional<Firmness>> result(ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (!ends[i].empty()) result[i] = Firmness{ends[i][0], ends[i][1], ends[i][2], ends[i][3]};
  }
  return result;
}

}  // namespace kusabi::wedged
