// Samples are shared among the ranks; curves are made by each alike.
#include "nodes/limit/compared_loads.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <utility>

#include "engine/shared_work.hpp"
#include "nodes/limit/worst_case_search.hpp"

namespace kusabi::limit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Samples in one piece of work: some milliseconds.
constexpr std::uint64_t samples_a_piece = 16;

/// Factors on a curve that differ by less are one, relative to the nominal one (at least 1 in
/// scaled units): a mode's line is known to 1e-12 or so.
constexpr double curve_tolerance = 1e-9;

std::vector<CurvePiece> in_units(const problems::LimitModel& model, std::vector<CurvePiece> curve) {
  for (auto& piece : curve) {
    piece.from.factor *= model.factor_unit;
    piece.from.slope *= model.factor_unit;
    piece.factor_at_end *= model.factor_unit;
    piece.from.motion = problems::motion_in_units(model, piece.from.motion);
  }
  return curve;
}

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

std::vector<CurvePiece> factor_curve(RootSearch& search, const Eigen::VectorXd& zeta) {
  const auto& model = search.model();
  const Eigen::VectorXd scaled = zeta / model.force_unit;
  const Eigen::VectorXd change = dead_load(model, scaled) - model.dead;
  auto& load_factor = search.load_factor();
  const auto solve = [&](double beta) -> std::optional<CurvePoint> {
    load_factor.restart();
    if (load_factor.solve(model.dead + beta * change) != LoadStatus::collapses) return {};
    auto collapse = load_factor.collapse();
    const double slope = -change.dot(collapse.motion);
    return CurvePoint{beta, collapse.factor, slope, std::move(collapse.motion)};
  };
  const double tolerance = curve_tolerance * std::max(1.0, std::abs(search.nominal().factor));
  return in_units(model, concave_curve(solve, 1, tolerance));
}

std::vector<CurvePiece> worst_factor_curve(RootSearch& search, double alpha) {
  const auto& model = search.model();
  const double scaled = search.scaled(alpha);
  const auto solve = [&](double beta) -> std::optional<CurvePoint> {
    auto found = search.solve(beta * scaled);
    if (found.status == RootStatus::open) {
      if (search_signs(search, found, beta * scaled).status != engine::Status::solved) return {};
    } else if (found.status != RootStatus::closed) {
      return {};
    }
    if (found.status == RootStatus::not_carried) return {};
    auto& [zeta, collapse] = *found.worst;
    double slope = 0;
    for (const auto& column : model.uncertain) {
      slope -= scaled * std::abs(column.work(collapse.motion));
    }
    return CurvePoint{beta, collapse.factor, slope, std::move(collapse.motion)};
  };
  return in_units(model, concave_curve(solve, 1, closed_gap));
}

}  // namespace kusabi::limit
