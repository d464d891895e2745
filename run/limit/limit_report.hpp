// The table and the JSON of `kusabi limit`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/outcome.hpp"
#include "nodes/limit/load_curve.hpp"
#include "nodes/limit/sign_tree.hpp"
#include "problems/limit/limit_problem.hpp"
#include "run/limit/limit.hpp"

namespace kusabi::run {

/// A collapse in the units of the problem.
struct LimitCollapse {
  double factor = 0;
  Eigen::VectorXd forces;  ///< q, n^m
  Eigen::VectorXd motion;  ///< u, n^d, f_R^T u = 1
};

/// What is known of the worst case, in the units of the problem.
struct LimitWorstCase {
  nodes::limit::RootStatus status = nodes::limit::RootStatus::failed;
  double lower = 0;    ///< proved in exact arithmetic; minus infinity: nothing is proved
  double upper = 0;    ///< likewise; minus infinity: a load is carried at no factor
  bool proved = true;  ///< whether `lower` is: not by all methods
  Eigen::VectorXd zeta;
  std::optional<LimitCollapse> collapse;
  std::uint64_t cuts = 0;
  std::uint64_t nodes = 1;          ///< of the tree of signs, and
  std::uint64_t tree_programs = 0;  ///< its linear programs: they hang on the number of ranks
  nodes::limit::WorstCaseCounts counts;
  engine::Status search = engine::Status::solved;  ///< why the search of a tree ended
};

struct LimitAnswer {
  nodes::limit::LoadStatus status = nodes::limit::LoadStatus::undetermined;
  std::optional<LimitCollapse> nominal;
  std::optional<LimitWorstCase> worst;
  std::vector<double> samples;  ///< factors; minus infinity: not carried
  /// lambda*(f_D + beta T zeta) over beta, zeta the critical one; and lambda_min(beta alpha).
  std::vector<nodes::limit::CurvePiece> curve;
  std::vector<nodes::limit::CurvePiece> worst_curve;
};

/// Both views of the answer. @pre the references outlive it
struct LimitReport {
  const LimitOptions& options;
  const problems::LimitProblem& problem;
  const LimitAnswer& answer;
  int ranks = 1;

  [[nodiscard]] std::string table() const;
  [[nodiscard]] nlohmann::ordered_json json() const;
};

}  // namespace kusabi::run
