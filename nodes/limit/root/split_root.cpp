// Alternation of two iterations, each with bounds at any time.
#include "nodes/limit/root/split_root.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
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

/// Steps between two evaluations of the motion and the bound, and between two polls for a stop.
constexpr int steps_a_look = 50;
constexpr int steps_a_question = 10;

/// Metric: weight of a change of the factor relative to one of a force.
constexpr double factor_metric = 0.1;

/// Distance of the sets below which a certificate is tried.
constexpr double near = 1e-3;

/// Distance of the sets below which the face of a collapse is examined: once for each collapse, and
/// again when the number of steps has grown by a factor.
constexpr double near_enough = 2e-3;
constexpr double again_share = 0.1;
constexpr int least_steps = 100;

/// Criteria for leaving a face: its residual has not fallen to this share in so many steps, or its
/// first residual is not below this share of the other iteration's, in which case it is most likely
/// not the face of the worst case.
constexpr double face_start = 0.5;
constexpr double face_fall = 0.7;
constexpr int face_steps = 200;

/// Residual below which a face is solved.
constexpr double no_residual = 1e-12;

/// A bound, which costs a linear program, is computed when the residual has fallen to this share.
constexpr double bound_fall = 0.5;

/// Additional share of the time, and minimum time in milliseconds, for a bound at an early end, by
/// number of steps.
constexpr double share_at_the_end = 0.1;
constexpr double milliseconds_at_the_end = 300;
constexpr int steps_a_bound = 10;

/// Gap at which the iteration ends after a quarter more steps, even if the bounds do not meet.
constexpr double good_gap = 2e-7;
constexpr double patience = 1.25;
constexpr int more_steps = 100;

/// Maximum number of steps; then static cuts most likely do not suffice, or the collapse is
/// unknown.
constexpr int most_steps = 4000;

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
  RootStatus look_at_face(splitting::AffineIteration& iteration, bool patient);
  bool improve(Eigen::VectorXd motion);
  void bound(const splitting::ColumnBlocks& y);
  [[nodiscard]] double share_of_best(const std::vector<double>& taken) const;
  [[nodiscard]] double gap() const { return result_.worst->collapse.factor - result_.lower; }
  [[nodiscard]] bool stopped() const { return support::asked(control_.stop); }
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
  bool improved_ = false;
  Clock::time_point began_ = Clock::now();
  RootResult result_;
};

Eigen::VectorXd SplitRoot::metric(const LimitModel& model) {
  Eigen::VectorXd metric = Eigen::VectorXd::Ones(model.member_count() + 1);
  metric(model.member_count()) = factor_metric;
  return metric;
}

// @return false if a load has no factor
bool SplitRoot::improve(Eigen::VectorXd motion) {
  const double work = model_.reference.dot(motion);
  if (!(std::abs(work) > 1e-14)) return true;
  motion /= work;
  const double before = result_.worst->collapse.factor;
  if (!descend_from(model_, alpha_, load_factor_, motion, result_)) return false;
  improved_ = result_.worst->collapse.factor < before - closed_gap;
  return true;
}

// Share of the best certificate so far in a combination with the new one, such that no member
// exceeds its yield force; 1: no other is possible.
double SplitRoot::share_of_best(const std::vector<double>& taken) const {
  constexpr double room = 2e-9;  // remaining margin for a proof, if possible
  double share = 0;
  for (int i = 0; i < program_.members(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    double most = program_.capacity(i);
    if (best_ && best_taken_[at] < most - room) most -= room;
    if (taken[at] <= most) continue;
    if (!best_) return 1;
    share = std::max(share, std::min(1.0, (taken[at] - most) / (taken[at] - best_taken_[at])));
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

// @return open: without result
RootStatus SplitRoot::look_at_face(splitting::AffineIteration& iteration, bool patient) {
  std::vector<int> signs;
  for (const double zeta : result_.worst->zeta) signs.push_back(zeta < 0 ? -1 : 1);
  const auto& collapse = result_.worst->collapse;
  splitting::FaceIteration face(
      program_, projection_, sharing_,
      splitting::face_of(program_, collapse.factor, collapse.motion, std::move(signs)), iteration);
  double bounded = std::numeric_limits<double>::infinity();  // residual at the last bound
  double last = 0;
  int last_steps = 0;
  int good_steps = 0;
  for (;;) {
    if (face.steps() % steps_a_question == 0 && stopped()) return RootStatus::stopped;
    face.step();
    const bool done = face.residual() <= no_residual;
    if (face.steps() % steps_a_look != 0 && !done) continue;
    if (face.residual() <= bound_fall * bounded || done) {
      bound(face.affine_point());
      bounded = face.residual();
    }
    show(iteration.steps() + face.steps());
    if (gap() <= closed_gap) return RootStatus::closed;
    const bool good = gap() <= good_gap;
    if (good && good_steps == 0) good_steps = face.steps();
    if (good && (done || face.steps() > patience * good_steps + more_steps)) {
      return RootStatus::closed;
    }
    if (done) return RootStatus::open;
    if (last_steps == 0) {
      const bool far = face.residual() > face_start * iteration.residual();
      if (far && !patient) return RootStatus::open;
    } else if (face.steps() - last_steps < face_steps) {
      continue;
    } else if (face.residual() > face_fall * last) {
      return good ? RootStatus::closed : RootStatus::open;
    }
    last = face.residual();
    last_steps = face.steps();
  }
}

// Any certificate gives a bound: without a target the sets soon intersect.
void SplitRoot::bound_at_the_end(splitting::AffineIteration& iteration) {
  const auto now = Clock::now();
  const std::chrono::duration<double, std::milli> so_far = now - began_;
  const std::chrono::duration<double, std::milli> grace(
      std::max(milliseconds_at_the_end, share_at_the_end * so_far.count()));
  const auto over = [end = now + grace] { return Clock::now() > end; };
  bound_.set_stop(over);
  while (!best_ && !over()) {
    for (int k = 0; k < steps_a_bound; ++k) {
      iteration.step(-std::numeric_limits<double>::infinity());
    }
    bound(iteration.affine_point());
  }
}

RootStatus SplitRoot::iterate(splitting::AffineIteration& iteration) {
  double next_face = 0;
  unsigned faces = 0;  // of this collapse
  while (iteration.steps() < most_steps) {
    for (int k = 0; k < steps_a_look; ++k) {
      if (iteration.steps() % steps_a_question == 0 && stopped()) return RootStatus::stopped;
      iteration.step(result_.worst->collapse.factor);
    }
    if (!improve(iteration.motion())) return RootStatus::not_carried;
    if (improved_) {
      next_face = 0;
      faces = 0;
    }
    if (iteration.residual() < near) bound(iteration.affine_point());
    const int steps = iteration.steps();
    show(steps);
    if (gap() <= closed_gap) return RootStatus::closed;
    if (steps < least_steps || steps < next_face || iteration.residual() > near_enough) continue;
    ++faces;
    const bool patient =
        faces > 2 && std::has_single_bit(faces - 1);  // the third, fifth, ninth, ...
    const auto status = look_at_face(iteration, patient);
    if (status != RootStatus::open) return status;
    next_face = (1 + again_share) * steps;
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
  if (best_) {
    result_.cuts = cuts_of_point(*best_, sharing_, model_, alpha_);
    if (auto proof = proof_of_fixed_shares(model_, alpha_, result_.cuts, 1e-9, false)) {
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
