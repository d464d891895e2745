// Curves of `kusabi limit`: table, JSON and CSV.
#pragma once

#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

#include "nodes/limit/root/limit_answer.hpp"
#include "problems/limit/limit_problem.hpp"
#include "run/limit/limit.hpp"

namespace kusabi::run {

/// Views of all curves of an answer. @pre the references outlive it
struct CurveReport {
  const LimitOptions& options;
  const problems::LimitProblem& problem;
  const limit::LimitAnswer& answer;

  /// The requested curves, breakpoint by breakpoint.
  [[nodiscard]] std::string table() const;
  /// Adds the keys of the curves to `result` (docs/result-files.md).
  void add_to(nlohmann::ordered_json& result) const;
  /// One line per breakpoint (docs/result-files.md).
  void write_csv(std::ostream& out) const;
};

}  // namespace kusabi::run
