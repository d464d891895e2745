// Alternation of two iterations, each with bounds at any time.
#include "nodes/limit/root/split_root.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "nodes/limit/root/fixed_shares.hpp"
#include "nodes/limit/splitting/affine_iteration.hpp"
#include "nodes/limit/splitting/affine_program.hpp"
#include "nodes/limit/splitting/affine_projection.hpp"
#include "nodes/limit/splitting/face.hpp"
#include "nodes/limit/splitting/face_iteration.hpp"
#include "nodes/limit/splitting/row_projection.hpp"
#include "nodes/limit/splitting/safe_bound.hpp"

namespace kusabi::limit {
namespace {

using Clock = std::chrono::steady_clock;
using problems::LimitModel;

/// Steps between two evaluations of the motion and the bound.
constexpr int steps_per_evaluation = 50;
/// The same during the first `first_steps` steps, whose motions lead to different collapses.
constexpr int first_steps_per_evaluation = 10;
constexpr int first_steps = 50;
/// Steps between two polls for a stop.
constexpr int steps_per_poll = 10;

/// Number of random motions near the known collapse from which a worse one is searched, at the
/// beginning and after a face that is not the worst case's.
constexpr int first_tries = 10;
/// Ten sizes of such a motion, relative to the largest displacement: the smallest is
/// min_disturbance, each further one larger by disturbance_ratio.
constexpr double min_disturbance = 0.005;
constexpr double disturbance_ratio = 1.45;

/// Metric: weight of a change of the factor relative to one of a force.
constexpr double factor_metric = 0.1;

/// Distance of the sets below which a certificate is tried.
constexpr double near = 1e-3;

/// Steps after which the face of a collapse is examined: once for each collapse, and again when the
/// number of steps has grown by a factor, and to a minimum, since fewer steps on the face are
/// needed from there. A face may take as many steps, unless it is almost solved.
constexpr int first_face = 20;
constexpr int again_after = 8;
constexpr int min_again = 400;
constexpr double almost_solved = 1e-5;

/// Criteria for leaving a face: its residual has not fallen to a share in so many steps. Far from
/// the end it is most likely not the face of the worst case; near it a residual may stay the same
/// for long while members change between yielding and not.
constexpr double far_residual = 2e-3;
constexpr double far_fall = 0.75;
constexpr int far_steps = 100;
constexpr double near_fall = 0.95;
constexpr int near_steps = 200;

/// Residual below which a face is solved.
constexpr double no_residual = 1e-12;

/// Additional share of the time, and minimum time in milliseconds, for a bound at an early end, by
/// number of steps.
constexpr double time_share_of_last_bound = 0.1;
constexpr double milliseconds_for_last_bound = 300;
constexpr int steps_per_bound = 10;

/// Gap at which a face ends at once, and gap at which it ends at the next regular evaluation.
constexpr double small_gap = 5e-8;
constexpr double good_gap = 2e-7;

/// Maximum number of steps; then static cuts most likely do not suffice, or the collapse is
/// unknown.
constexpr int max_steps = 4000;

int steps_until_again(int steps) {
  return std::max(min_again, again_after * steps);
}

class SplitRoot {
 public:
  SplitRoot(const LimitModel& model, double alpha, LoadFactor& load_factor,
            const splitting::Sharing& sharing, const RootControl& control)
      : model_(model),
        alpha_(alpha),
        load_factor_(load_factor),
        sharing_(sharing),
        control_(control),
        program_(splitting::affine_program(model, alpha)),
        projection_(program_.equilibrium, metric(model)),
        bound_(model, control.stop) {}

  RootResult run(const Collapse& nominal);

 private:
  static Eigen::VectorXd metric(const LimitModel& model);
  RootStatus iterate(splitting::AffineIteration& iteration);
  void bound_at_the_end(splitting::AffineIteration& iteration);
  RootStatus look_at_face(splitting::AffineIteration& iteration);
  bool descend_by(Eigen::VectorXd motion);
  bool try_disturbed(int times);
  bool is_over(Clock::time_point end);
  void bound(const splitting::ColumnBlocks& y);
  [[nodiscard]] double share_of_best(const std::vector<double>& taken) const;
  [[nodiscard]] double gap() const { return result_.worst->collapse.factor - result_.lower; }
  [[nodiscard]] bool stopped() const { return support::is_requested(control_.stop); }
  [[nodiscard]] bool is_low_enough() const {
    return result_.worst->collapse.factor < control_.enough;
  }
  void show(int steps) const;

  const LimitModel& model_;
  double alpha_;
  LoadFactor& load_factor_;
  const splitting::Sharing& sharing_;
  const RootControl& control_;
  splitting::AffineProgram program_;
  splitting::AffineProjection projection_;
  splitting::SafeStates bound_;
  std::optional<splitting::ColumnBlocks> best_;  // of the bound
  std::vector<double> best_taken_;               // its use of each member
  bool improved_ = false;                        // since the last face
  std::mt19937 bits_;                            // the same on every rank
  int tries_ = 0;
  Clock::time_point began_ = Clock::now();
  RootResult result_;
};

Eigen::VectorXd SplitRoot::metric(const LimitModel& model) {
  Eigen::VectorXd metric = Eigen::VectorXd::Ones(model.member_count() + 1);
  metric(model.member_count()) = factor_metric;
  return metric;
}

// @return false if a load has no factor
bool SplitRoot::descend_by(Eigen::VectorXd motion) {
  const double work = model_.reference.dot(motion);
  if (!(std::abs(work) > 1e-14)) return true;
  motion /= work;
  const double before = result_.worst->collapse.factor;
  if (!descend_from(model_, alpha_, load_factor_, motion, result_)) return false;
  improved_ = improved_ || result_.worst->collapse.factor < before - closed_gap;
  return true;
}

// Searches near the known collapse. @return as descend_by()
bool SplitRoot::try_disturbed(int times) {
  constexpr int sizes = 10;
  for (int k = 0; k < times && !stopped() && !is_low_enough(); ++k) {
    Eigen::VectorXd motion = result_.worst->collapse.motion;
    const double size = min_disturbance * std::pow(disturbance_ratio, tries_++ % sizes) *
                        motion.cwiseAbs().maxCoeff();
    for (double& u : motion) u += size * (static_cast<double>(bits_()) * 0x1p-31 - 1);
    if (!descend_by(std::move(motion))) return false;
  }
  return true;
}

// Share of the best certificate so far in a combination with the new one, such that no member
// exceeds its yield force; 1: no other is possible.
double SplitRoot::share_of_best(const std::vector<double>& taken) const {
  constexpr double margin = 2e-9;  // remaining margin for a proof, if possible
  double share = 0;
  for (int i = 0; i < program_.members(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    double maximum = program_.capacity(i);
    if (best_ && best_taken_[at] < maximum - margin) maximum -= margin;
    if (taken[at] <= maximum) continue;
    if (!best_) return 1;
    share = std::max(share, std::min(1.0, (taken[at] - maximum) / (taken[at] - best_taken_[at])));
  }
  return share;
}

void SplitRoot::bound(const splitting::ColumnBlocks& y) {
  auto point = y;
  auto taken = splitting::row_sizes(point, sharing_);
  const double share = share_of_best(taken);
  if (share >= 1) return;
  if (share > 0) {
    splitting::blend(point, *best_, share);
    taken = splitting::row_sizes(point, sharing_);
  }
  const auto state = bound_.state(taken, Eigen::VectorXd::Zero(model_.member_count()));
  ++result_.counts.relaxations;
  if (!state || state->bound <= result_.lower) return;
  result_.lower = state->bound;
  best_ = std::move(point);
  best_taken_ = std::move(taken);
}

void SplitRoot::show(int steps) const {
  if (!control_.watcher) return;
  control_.watcher(static_cast<std::uint64_t>(steps), result_.lower,
                   result_.worst->collapse.factor);
}

// @return `open` if the face gives no answer
RootStatus SplitRoot::look_at_face(splitting::AffineIteration& iteration) {
  std::vector<int> signs;
  for (const double zeta : result_.worst->zeta) signs.push_back(zeta < 0 ? -1 : 1);
  const auto& collapse = result_.worst->collapse;
  splitting::FaceIteration face(
      program_, projection_, sharing_,
      splitting::face_of(program_, collapse.factor, collapse.motion, std::move(signs)), iteration);
  double last = std::numeric_limits<double>::infinity();
  double expected = 0;  // residual at the small gap, in proportion; zero: not known
  int last_steps = 0;
  bool good = false;
  for (;;) {
    if (face.steps() % steps_per_poll == 0 && stopped()) return RootStatus::stopped;
    face.step();
    const bool done = face.residual() <= no_residual;
    const bool regular = face.steps() % steps_per_evaluation == 0 || done;
    const bool almost =
        face.steps() % first_steps_per_evaluation == 0 && face.residual() <= expected;
    if (!regular && !almost) continue;
    bound(face.affine_point());
    show(iteration.steps() + face.steps());
    if (gap() <= small_gap) return RootStatus::closed;
    expected = small_gap / gap() * face.residual();
    if (!regular) continue;
    const bool ends = good || done;
    good = gap() <= good_gap;
    if (ends && good) return RootStatus::closed;
    const bool too_long = face.steps() >= steps_until_again(iteration.steps()) &&
                          face.residual() > almost_solved && !good;
    if (done || too_long) return RootStatus::open;
    const bool far = face.residual() > far_residual;
    if (face.steps() - last_steps < (far ? far_steps : near_steps)) continue;
    if (!good && face.residual() > (far ? far_fall : near_fall) * last) return RootStatus::open;
    last = face.residual();
    last_steps = face.steps();
  }
}

// True if the time is over by the clock of the rank with the first columns.
bool SplitRoot::is_over(Clock::time_point end) {
  const int groups = splitting::groups_of(static_cast<int>(program_.columns.size()));
  std::vector<double> over(static_cast<std::size_t>(groups), Clock::now() > end ? 1 : 0);
  sharing_.fill(over);
  return over.front() != 0;
}

// Any certificate gives a bound: without a target the sets soon intersect.
void SplitRoot::bound_at_the_end(splitting::AffineIteration& iteration) {
  const auto now = Clock::now();
  const std::chrono::duration<double, std::milli> so_far = now - began_;
  const std::chrono::duration<double, std::milli> grace(
      std::max(milliseconds_for_last_bound, time_share_of_last_bound * so_far.count()));
  const auto end = now + std::chrono::duration_cast<Clock::duration>(grace);
  bound_.set_stop({});
  while (!best_ && !is_over(end)) {
    for (int k = 0; k < steps_per_bound; ++k) {
      iteration.step(-std::numeric_limits<double>::infinity());
    }
    bound(iteration.affine_point());
  }
}

RootStatus SplitRoot::iterate(splitting::AffineIteration& iteration) {
  int next_face = first_face;
  int tries = first_tries;
  while (iteration.steps() < max_steps) {
    if (!try_disturbed(tries)) return RootStatus::not_carried;
    tries = 1;
    const int look =
        iteration.steps() < first_steps ? first_steps_per_evaluation : steps_per_evaluation;
    for (int k = 0; k < look && !is_low_enough(); ++k) {
      if (iteration.steps() % steps_per_poll == 0 && stopped()) return RootStatus::stopped;
      iteration.step(result_.worst->collapse.factor);
    }
    if (is_low_enough()) return RootStatus::enough;
    if (!descend_by(iteration.motion())) return RootStatus::not_carried;
    if (iteration.residual() < near) bound(iteration.affine_point());
    const int steps = iteration.steps();
    show(steps);
    if (gap() <= closed_gap) return RootStatus::closed;
    if (improved_) next_face = first_face;
    if (steps < next_face) continue;
    improved_ = false;
    const auto status = look_at_face(iteration);
    if (status != RootStatus::open) return status;
    next_face = steps_until_again(steps);
    tries = first_tries;
  }
  return RootStatus::open;
}

RootResult SplitRoot::run(const Collapse& nominal) {
  const auto solves = load_factor_.solves();
  const bool carried = descend_from(model_, alpha_, load_factor_, nominal.motion, result_);
  result_.status = RootStatus::not_carried;
  if (carried && !result_.worst) {
    result_.status = stopped() ? RootStatus::stopped : RootStatus::failed;
  } else if (carried) {
    if (projection_.definite()) {
      splitting::AffineIteration iteration(program_, projection_, sharing_);
      result_.status = iterate(iteration);
      if (result_.status == RootStatus::stopped && !best_) bound_at_the_end(iteration);
    } else {
      result_.status = RootStatus::failed;
    }
  }
  if (best_ && result_.status != RootStatus::enough) {
    result_.cuts = cuts_of_point(*best_, sharing_, model_, alpha_);
    bound_.set_stop({});
    if (auto proof = proof_of_fixed_shares(bound_, model_, alpha_, result_.cuts, 1e-9, false)) {
      result_.proof = std::move(*proof);
    }
  }
  result_.counts.load_factors = load_factor_.solves() - solves;
  return std::move(result_);
}

}  // namespace

RootResult split_root(const LimitModel& model, double alpha, const Collapse& nominal,
                      LoadFactor& load_factor, const splitting::Sharing& sharing,
                      const RootControl& control) {
  return SplitRoot(model, alpha, load_factor, sharing, control).run(nominal);
}

}  // namespace kusabi::limit
