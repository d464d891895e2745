// Multipliers of a program without compliance as a motion of the bodies.
#include "nodes/wedged/hold/excluding_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "nodes/wedged/hold/rigid_contradiction.hpp"
#include "nodes/wedged/hold/statics.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

/// Velocities below this share of the largest are zero, as are openings beyond sliding: a load 10^-7
/// beyond the end of its range leaves the motion as much freedom.
constexpr double negligible_velocity = 1e-3;

/// In space the motion of more candidates is not computed: it is only an explanation.
constexpr int most_candidates = 200;

/// Relative distance from the end of a range at which the motion in the plane is computed: at the end
/// itself the load does no work on it.
constexpr double beyond_end = 1e-5;

/// Negative work of the load at the end, beside the work of the load beyond it, that is rounding.
constexpr double lost_work = 1e-3;

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

Eigen::VectorXd works_of(const LoadedProblem& block, const LoadShare& share) {
  const Eigen::MatrixXd works = block.loads.motions.cast<double>();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(block.problem.modes.matrix.cols());
  if (block.has_dead) sum += share.dead * works.row(0).transpose();
  if (block.has_reference) sum += share.reference * works.row(block.has_dead ? 1 : 0).transpose();
  return sum;
}

// The load a little beyond the end of a range.
LoadShare beyond(const LoadedProblem& block, const ExcludedLoad& load) {
  using Side = ExcludedLoad::Side;
  auto share = load.share;
  if (share.dead == 0 || (load.side != Side::less && load.side != Side::more)) return share;
  const double reference = works_of(block, {0, 1}).norm();
  const double ratio = reference > 0 ? works_of(block, {1, 0}).norm() / reference : 0;
  share.reference +=
      (load.side == Side::less ? -1 : 1) * beyond_end * std::max(std::abs(share.reference), ratio);
  return share;
}

// Nothing if there is none. In space that is also so where reactions balance each other.
// @param load changed to the load beyond its end if it is zero
std::optional<Eigen::VectorXd> amounts_of_modes(const LoadedProblem& block, ExcludedLoad& load,
                                                const support::Stop& stop) {
  if (block.problem.dimension == 2) {
    const auto share = beyond(block, load);
    const auto works = works_of(block, share);
    auto amounts = static_motion(block, works, load.friction, stop);
    if (load.share.reference == 0) load.share = share;
    // If statics ends elsewhere, the load itself does negative work.
    if (amounts && works_of(block, load.share).dot(*amounts) < -lost_work * works.dot(*amounts))
      amounts.reset();
    return amounts;
  }
  if (block.problem.contact_names.size() > most_candidates) return {};
  const auto all = problems::all_candidates(block.problem);
  const auto beta = rigid_contradiction(block, std::array{load.share}, load.friction,
                                        Precision::doubles, {{}, all});
  if (!beta) return {};
  return Eigen::VectorXd(-*beta);
}

// Nothing if there is no such motion of any subproblem.
std::optional<MotionOfBlock> motion_of_a_block(const LoadedProblem& whole, ExcludedLoad& load,
                                               const support::Stop& stop) {
  const Eigen::Index d = whole.problem.dimension;
  for (const auto& candidates : problems::blocks_of(whole.problem)) {
    const LoadedProblem block = loaded_block(whole, candidates);
    if (block.problem.modes.matrix.cols() == 0 || works_of(block, beyond(block, load)).isZero(0) ||
        !is_in_range(block, load.friction))
      continue;
    const auto amounts = amounts_of_modes(block, load, stop);
    if (!amounts) continue;
    const Eigen::VectorXd own = block.problem.modes.matrix * *amounts;
    Eigen::VectorXd motion = Eigen::VectorXd::Zero(whole.problem.modes.matrix.rows());
    Eigen::Index row = 0;
    for (const int i : candidates) {
      motion.segment(d * i, d) = own.segment(row, d);
      row += d;
    }
    return MotionOfBlock{candidates, std::move(motion)};
  }
  return {};
}

}  // namespace

std::optional<ExcludingMotion> excluding_motion(const problems::CheckedStructure& structure,
                                                const LoadedProblem& whole, ExcludedLoad load,
                                                const support::Stop& stop) {
  if (!std::isnormal(load.share.reference)) load.share.reference = 0;  // beside an end at 0
  if (work_on_other_modes(whole, load.share) > negligible_work) return {};
  if (whole.problem.dimension == 2 && load.side == ExcludedLoad::Side::less_friction)
    load.friction *= 1 - beyond_end;
  const auto motion = motion_of_a_block(whole, load, stop);
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
