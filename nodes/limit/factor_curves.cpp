// Points of curves, solved one by one, and the proofs of the pieces.
#include "nodes/limit/factor_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include <boost/serialization/vector.hpp>

#include "engine/collectives.hpp"
#include "nodes/limit/search/proved_ends.hpp"
#include "nodes/limit/search/worst_case_search.hpp"
#include "solvers/linear/linear_program.hpp"

namespace kusabi::limit {
namespace {

using problems::LimitProblem;

/// Tolerance for equal factors on a curve, relative to the nominal one (at least 1 in scaled
/// units): lines of modes are accurate to about 1e-12.
constexpr double curve_tolerance = 1e-9;

/// Relative widths of the bracket of a curve's end, tried in turn: the closer to the end, the
/// smaller the margin of the yield forces for a proof.
constexpr std::array<double, 3> end_widths = {default_end_width, 1e-5, 1e-3};

// The largest dissipation of the members on a motion, n^d.
double dissipation_on(const LimitProblem& problem, const Eigen::VectorXd& motion) {
  const Eigen::VectorXd rates = problem.equilibrium.transpose() * motion;
  return rates.cwiseMax(0).dot(problem.tension) - rates.cwiseMin(0).dot(problem.compression);
}

// The largest beta such that a motion without work of f_R admits f_D + beta g, where g does
// `growth` work on it: f_D'v + beta g'v may not exceed the largest dissipation on v. A proof of
// infeasibility may have either sign.
double carried_up_to(const LimitProblem& problem, Eigen::VectorXd motion,
                     const std::function<double(const Eigen::VectorXd&)>& growth) {
  double last = linear::infinity;
  if (motion.size() == 0) return last;
  for (int turn = 0; turn < 2; ++turn) {
    const double work = growth(motion);
    if (work > 0) {
      last = std::min(last, (dissipation_on(problem, motion) - problem.dead.dot(motion)) / work);
    }
    motion = -motion;
  }
  return last;
}

/// T zeta for the worst zeta of a motion, |zeta_j| <= 1.
Eigen::VectorXd worst_direction(const LimitProblem& problem, const problems::LimitModel& model,
                                const Eigen::VectorXd& motion) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(problem.uncertain_count());
  const Eigen::VectorXd scaled = motion.cwiseQuotient(model.displacement_unit);
  return dead_load(problem, worst_for(model, 1, scaled, none)) - problem.dead;
}

/// The worst case as a function of beta, and its proofs.
class WorstCurve {
 public:
  WorstCurve(RootSearch& search, const verify::Structure& truss, double alpha)
      : search_(search), truss_(truss), alpha_(alpha), model_(search.model()) {}

  /// Sample at a place; alpha is in the unit of force of the model at this place.
  CurveSample at(double beta);

  /// Stores the proofs of the pieces.
  void prove(LoadCurve& curve) const;

 private:
  /// A proved bound of the distance between a piece and the curve; infinity: no bound.
  [[nodiscard]] double error_of(const CurvePiece& piece) const;
  [[nodiscard]] double upper_at(double beta, const Eigen::VectorXd& scaled_motion) const;
  [[nodiscard]] double growth(const Eigen::VectorXd& motion) const {
    return alpha_ * worst_direction(search_.problem(), model_, motion).dot(motion);
  }

  RootSearch& search_;
  const verify::Structure& truss_;
  double alpha_;
  problems::LimitModel model_;
  std::map<double, double> lower_;  // proved, by beta
};

CurveSample WorstCurve::at(double beta) {
  if (search_.set_up(model_) != LoadStatus::collapses) return {};
  const LimitParameters parameters{.alpha = beta * alpha_};
  auto worst = WorstCaseSearch(search_, parameters, truss_).solve();
  if (worst.search != engine::Status::solved) return {};
  if (worst.status == RootStatus::not_carried) {
    const auto last =
        carried_up_to(search_.problem(), std::move(worst.overpowering_motion),
                      [this](const Eigen::VectorXd& motion) { return growth(motion); });
    return NotCarried{last, worst.standing};
  }
  if (worst.status != RootStatus::closed || !worst.collapse) return {};
  if (is_proved(worst.ends.lower)) lower_[beta] = worst.ends.at_least();
  auto& [factor, minimum, forces, motion] = *worst.collapse;
  const double slope = -growth(motion);
  return CurvePoint{beta, factor, slope, std::move(motion)};
}

double WorstCurve::upper_at(double beta, const Eigen::VectorXd& scaled_motion) const {
  const Eigen::VectorXd zeta =
      worst_for(model_, 1, scaled_motion, Eigen::VectorXd::Zero(model_.uncertain_count()));
  return proved_upper(truss_, search_.problem(), model_, beta * alpha_, zeta, scaled_motion)
      .value_or(linear::infinity);
}

double WorstCurve::error_of(const CurvePiece& piece) const {
  const Eigen::VectorXd motion = piece.from.motion.cwiseQuotient(model_.displacement_unit);
  double error = 0;
  for (const auto& [beta, factor] :
       {std::pair(piece.from.at, piece.from.factor), std::pair(piece.to, piece.factor_at_end)}) {
    const auto lower = lower_.find(beta);
    if (lower == lower_.end()) return linear::infinity;
    error = std::max({error, factor - lower->second, upper_at(beta, motion) - factor});
  }
  return error;
}

void WorstCurve::prove(LoadCurve& curve) const {
  const auto errors = engine::from_first_rank(search_.analysis().transport(), [&] {
    std::vector<double> list;
    for (const auto& piece : curve.pieces) list.push_back(error_of(piece));
    return list;
  });
  for (std::size_t k = 0; k < errors.size(); ++k) {
    if (std::isfinite(errors[k])) curve.pieces[k].error = errors[k];
  }
}

}  // namespace

LoadCurve factor_curve(RootSearch& search, const Eigen::VectorXd& load, double to) {
  const auto& model = search.model();
  const auto& problem = search.problem();
  auto& load_factor = search.load_factor();
  Eigen::VectorXd unit(model.free_count());
  for (int k = 0; k < model.free_count(); ++k) unit(k) = model.load_unit(k);
  const Eigen::VectorXd change = load.cwiseQuotient(unit);
  const auto sample = [&](double beta) -> CurveSample {
    load_factor.restart();
    const auto status = load_factor.solve(model.dead + beta * change);
    if (status == LoadStatus::not_carried) {
      auto reason = load_factor.overpowering_motion();
      if (reason.size() > 0) reason = problems::motion_in_units(model, reason);
      return NotCarried{carried_up_to(problem, std::move(reason),
                                      [&](const Eigen::VectorXd& v) { return load.dot(v); })};
    }
    if (status != LoadStatus::collapses) return {};
    const auto collapse = load_factor.collapse();
    Eigen::VectorXd motion = problems::motion_in_units(model, collapse.motion);
    const double slope = -load.dot(motion);
    return CurvePoint{beta, collapse.factor * model.factor_unit, slope, std::move(motion)};
  };
  const double tolerance = curve_tolerance * std::max(1.0, std::abs(search.nominal().factor));
  return concave_curve(sample, to, tolerance * model.factor_unit);
}

LoadCurve worst_factor_curve(RootSearch& search, const verify::Structure& truss, double alpha,
                             double to) {
  const double tolerance = 2 * closed_gap * search.model().factor_unit;
  WorstCurve worst(search, truss, alpha);
  LoadCurve curve;
  for (const double end_width : end_widths) {
    curve = concave_curve([&](double beta) { return worst.at(beta); }, to, tolerance, end_width);
    worst.prove(curve);
    if (curve.proved() || search.ended()) break;
  }
  return curve;
}

}  // namespace kusabi::limit
