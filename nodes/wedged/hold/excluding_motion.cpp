// Multipliers of a program without compliance as a motion of the bodies.
#include "nodes/wedged/hold/excluding_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "nodes/wedged/hold/rigid_contradiction.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

/// Velocities below this share of the largest are zero, as are openings beyond sliding: a load 10^-7
/// beyond the end of its range leaves the motion as much freedom.
constexpr double negligible_velocity = 1e-3;

/// The motion of more candidates is not computed: it is only an explanation.
constexpr int most_candidates = 200;

// True if a load does work on some motion of the block.
bool does_work(const LoadedProblem& block, const LoadShare& share) {
  const auto acts_with = [&](double amount, bool present, Eigen::Index load) {
    return present && amount != 0 && !block.loads.motions.row(load).isZero(0);
  };
  return acts_with(share.dead, block.has_dead, 0) ||
         acts_with(share.reference, block.has_reference, block.has_dead ? 1 : 0);
}

bool is_in_range(const LoadedProblem& block, double mu) {
  const auto in_range = [&](double factor) {
    const double own = mu * factor;
    return own == 0 || (own >= min_friction && own <= max_friction);
  };
  return std::ranges::all_of(block.problem.friction, in_range);
}

/// Displacements of all candidates, zero outside of one subproblem.
struct MotionOfBlock {
  support::IndexSet candidates;
  Eigen::VectorXd displacements;
};

// Nothing if there is no such motion of any subproblem.
std::optional<MotionOfBlock> motion_of_a_block(const LoadedProblem& whole,
                                               const ExcludedLoad& load) {
  const Eigen::Index d = whole.problem.dimension;
  for (const auto& candidates : problems::blocks_of(whole.problem)) {
    const LoadedProblem block = loaded_block(whole, candidates);
    if (block.problem.modes.matrix.cols() == 0 || !does_work(block, load.share) ||
        candidates.size() > most_candidates || !is_in_range(block, load.friction))
      continue;
    const auto all = problems::all_candidates(block.problem);
    const auto beta = rigid_contradiction(block, std::array{load.share}, load.friction,
                                          Precision::doubles, {{}, all});
    if (!beta) continue;
    const Eigen::VectorXd own = block.problem.modes.matrix * *beta;
    Eigen::VectorXd motion = Eigen::VectorXd::Zero(whole.problem.modes.matrix.rows());
    Eigen::Index row = 0;
    for (const int i : candidates) {
      motion.segment(d * i, d) = -own.segment(row, d);
      row += d;
    }
    return MotionOfBlock{candidates, std::move(motion)};
  }
  return {};
}

}  // namespace

std::optional<ExcludingMotion> excluding_motion(const problems::CheckedStructure& structure,
                                                const LoadedProblem& whole, ExcludedLoad load) {
  if (!std::isnormal(load.share.reference)) load.share.reference = 0;  // beside an end at 0
  if (work_on_other_modes(whole, load.share) > negligible_work) return {};
  const auto motion = motion_of_a_block(whole, load);
  if (!motion) return {};
  ExcludingMotion found{.load = load,
                        .bodies = problems::body_motion(structure, motion->displacements)};
  const double largest = found.bodies.largest;
  if (!(largest > 0) || !std::isfinite(largest) || found.bodies.bodies.empty()) return {};
  const Eigen::Index d = structure->dimension;
  for (int i = 0; i < static_cast<int>(structure->contact.size()); ++i) {
    const Eigen::VectorXd own = motion->displacements.segment(d * i, d) / largest;
    const double slides = own.tail(d - 1).norm();
    const double mu = load.friction * whole.problem.friction[static_cast<std::size_t>(i)];
    if (own[0] > mu * slides + negligible_velocity)
      found.opening.insert(i);
    else if (mu > 0 && slides > negligible_velocity)
      found.sliding.insert(i);
  }
  found.opens_all = found.opening == motion->candidates;
  return found;
}

}  // namespace kusabi::wedged
