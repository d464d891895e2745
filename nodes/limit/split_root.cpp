// Two iterations in turn, each with bounds at any time.
#include "nodes/limit/split_root.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include <cstdio>
#include <ctime>
#include "nodes/limit/fixed_shares.hpp"
#include "nodes/limit/splitting/affine_iteration.hpp"
#include "nodes/limit/splitting/affine_program.hpp"
#include "nodes/limit/splitting/affine_projection.hpp"
#include "nodes/limit/splitting/face.hpp"
#include "nodes/limit/splitting/face_iteration.hpp"
#include "nodes/limit/splitting/row_projection.hpp"
#include "nodes/limit/splitting/safe_bound.hpp"

namespace kusabi::limit {
namespace {

using problems::LimitModel;

/// Steps between two looks at the motion and the bound, and between two questions for an end.
constexpr int steps_a_look = 50;
constexpr int steps_a_question = 10;

/// The metric: a change of the factor costs ten times as much as one of a force.
constexpr double factor_metric = 0.1;

/// A certificate is tried where sets are as near to each other as this.
constexpr double near = 1e-3;

/// The face of a collapse is looked at when the sets are as near as this, and no worse load was
/// found in this share of all steps.
constexpr double near_enough = 2e-3;
constexpr double quiet_share = 0.25;
constexpr int least_steps = 100;

/// It is left when the residual has not fallen to this share in so many steps.
constexpr double face_fall = 0.7;
constexpr int face_steps = 200;

/// Ends that differ by less are told after all, where they do not meet soon.
constexpr double good_gap = 2e-7;

/// Faces that were looked at in vain.
constexpr int most_faces = 6;

double cpu() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

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
  RootStatus iterate();
  RootStatus look_at_face(splitting::AffineIteration& iteration);
  bool improve(Eigen::VectorXd motion);
  void bound(const splitting::ColumnBlocks& y);
  [[nodiscard]] double gap() const { return result_.worst->collapse.factor - result_.lower; }
  [[nodiscard]] bool stopped() const { return support::asked(control_.stop); }
  void tell(int steps) const;

  const LimitModel& model_;
  double alpha_;
  LoadFactor& load_factor_;
  const splitting::Sharing& sharing_;
  const RootControl& control_;
  splitting::AffineProgram program_;
  splitting::AffineProjection projection_;
  splitting::SafeBound bound_;
  std::optional<splitting::ColumnBlocks> best_;  // of the bound
  bool improved_ = false;
  RootResult result_;
};

Eigen::VectorXd SplitRoot::metric(const LimitModel& model) {
  Eigen::VectorXd metric = Eigen::VectorXd::Ones(model.member_count() + 1);
  metric(model.member_count()) = factor_metric;
  return metric;
}

// @return false if a load is carried at no factor
bool SplitRoot::improve(Eigen::VectorXd motion) {
  const double work = model_.reference.dot(motion);
  if (!(std::abs(work) > 1e-14)) return true;
  motion /= work;
  const double before = result_.worst->collapse.factor;
  if (!descend_from(model_, alpha_, load_factor_, motion, result_)) return false;
  improved_ = result_.worst->collapse.factor < before - closed_gap;
  return true;
}

void SplitRoot::bound(const splitting::ColumnBlocks& y) {
  const auto state = bound_.state(splitting::row_sizes(y, sharing_),
                                  Eigen::VectorXd::Zero(model_.member_count()));
  ++result_.counts.relaxations;
  if (!state || state->bound <= result_.lower) return;
  result_.lower = state->bound;
  best_ = y;
}

void SplitRoot::tell(int steps) const {
  if (!control_.watcher) return;
  control_.watcher(static_cast<std::uint64_t>(steps), result_.lower,
                   result_.worst->collapse.factor);
}

RootStatus SplitRoot::look_at_face(splitting::AffineIteration& iteration) {
  std::vector<int> signs;
  for (const double zeta : result_.worst->zeta) signs.push_back(zeta < 0 ? -1 : 1);
  const auto& collapse = result_.worst->collapse;
  splitting::FaceIteration face(
      program_, projection_, sharing_,
      splitting::face_of(program_, collapse.factor, collapse.motion, std::move(signs)), iteration);
  double last = std::numeric_limits<double>::infinity();
  int last_steps = 0;
  int good_steps = 0;
  for (;;) {
    if (face.steps() % steps_a_question == 0 && stopped()) return RootStatus::stopped;
    face.step();
    if (face.steps() % steps_a_look != 0 && face.residual() > 1e-12) continue;
    bound(face.affine_point());
    tell(iteration.steps() + face.steps());
    fprintf(stderr, "  face %d res %.3e lower %.9g upper %.9g gap %.2e cpu %.2f\n", face.steps(), face.residual(), result_.lower * model_.factor_unit, collapse.factor * model_.factor_unit, gap(), cpu());
    if (gap() <= closed_gap) return RootStatus::closed;
    if (gap() <= good_gap && good_steps == 0) good_steps = face.steps();
    if (good_steps > 0 && face.steps() > 1.25 * good_steps + 100) return RootStatus::closed;
    if (face.residual() <= 1e-12) return RootStatus::open;
    if (face.steps() - last_steps < face_steps) continue;
    if (face.residual() > face_fall * last) return gap() <= good_gap ? RootStatus::closed : RootStatus::open;
    last = face.residual();
    last_steps = face.steps();
  }
}

RootStatus SplitRoot::iterate() {
  splitting::AffineIteration iteration(program_, projection_, sharing_);
  int last_found = 0;
  int faces = 0;
  for (;;) {
    for (int k = 0; k < steps_a_look; ++k) {
      if (iteration.steps() % steps_a_question == 0 && stopped()) return RootStatus::stopped;
      iteration.step(result_.worst->collapse.factor);
    }
    const auto u = iteration.motion();
    if (!improve(u)) return RootStatus::not_carried;
    if (improved_) last_found = iteration.steps();
    if (iteration.residual() < near) bound(iteration.affine_point());
    tell(iteration.steps());
    {
      const auto& w = result_.worst->collapse.motion;
      const Eigen::VectorXd e1 = model_.equilibrium.transpose() * u / model_.reference.dot(u), e2 = model_.equilibrium.transpose() * w;
      fprintf(stderr, "it %d res %.3e lower %.9g upper %.9g gap %.2e cpu %.2f cos %.8f d1 %.2e\n", iteration.steps(), iteration.residual(), result_.lower * model_.factor_unit, result_.worst->collapse.factor * model_.factor_unit, gap(), cpu(), e1.dot(e2) / e1.norm() / e2.norm(), (e1 - e2).lpNorm<1>() / e2.lpNorm<1>());
    }
    if (gap() <= closed_gap) return RootStatus::closed;
    const int steps = iteration.steps();
    const bool quiet = steps - last_found >= quiet_share * steps;
    if (!quiet || steps < least_steps || iteration.residual() > near_enough) continue;
    const auto status = look_at_face(iteration);
    if (status != RootStatus::open) return status;
    if (++faces == most_faces) return RootStatus::open;
    last_found = steps;  // so that phase one goes on for a while
  }
}

RootResult SplitRoot::run(const Collapse& nominal) {
  const auto solves = load_factor_.solves();
  const bool carried = descend_from(model_, alpha_, load_factor_, nominal.motion, result_);
  result_.status = RootStatus::not_carried;
  if (carried && !result_.worst) {
    result_.status = stopped() ? RootStatus::stopped : RootStatus::failed;
  } else if (carried) {
    result_.status = projection_.definite() ? iterate() : RootStatus::failed;
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
