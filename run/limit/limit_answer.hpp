// What `kusabi limit` has found out: numbers alone, in the units of the problem.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "engine/outcome.hpp"
#include "nodes/limit/load_curve.hpp"
#include "nodes/limit/worst_case.hpp"

namespace kusabi::run {

/// A collapse.
struct LimitCollapse {
  double factor = 0;
  /// The least factor at which the same load is carried; nothing: the simplex method failed.
  std::optional<double> least;
  Eigen::VectorXd forces;  ///< q, n^m
  Eigen::VectorXd motion;  ///< u, n^d, f_R^T u = 1
};

/// What is known of the worst case.
struct LimitWorstCase {
  limit::RootStatus status = limit::RootStatus::failed;
  /// Minus infinity: none is known.
  double lower = -std::numeric_limits<double>::infinity();
  /// Minus infinity: a load is carried at no factor.
  double upper = -std::numeric_limits<double>::infinity();
  bool proved = false;  ///< whether both are shown in exact arithmetic, and near to each other
  bool lower_proved = false;
  bool upper_proved = false;
  /// What the 0-1 tree of (29) has come to by itself, if it was asked for: not proved.
  std::optional<double> zero_one_bound;
  Eigen::VectorXd zeta;
  std::optional<LimitCollapse> collapse;
  std::uint64_t cuts = 0;
  std::uint64_t nodes = 1;          ///< of the tree of signs, and
  std::uint64_t tree_programs = 0;  ///< its linear programs: they depend on the number of ranks
  limit::WorstCaseCounts counts;
  engine::Status search = engine::Status::solved;  ///< why it ended before it was done
};

struct LimitAnswer {
  limit::LoadStatus status = limit::LoadStatus::undetermined;
  std::optional<LimitCollapse> nominal;  ///< of `collapses`
  bool no_factor_proved = false;         ///< whether exact arithmetic shows `not_carried`
  std::optional<LimitWorstCase> worst;
  std::vector<double> samples;  ///< factors; minus infinity: not carried
  /// lambda*(f_D + beta T zeta) over beta, zeta the critical one; and lambda_min(beta alpha).
  std::vector<limit::CurvePiece> curve;
  std::vector<limit::CurvePiece> worst_curve;
  /// Why what else was asked for (the nominal factor, samples, curves) was not done to the end.
  engine::Status rest = engine::Status::solved;

  /// Whether the question is answered, and the answer proved.
  [[nodiscard]] bool whole() const;
};

}  // namespace kusabi::run
