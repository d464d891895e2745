// The table and the JSON of `kusabi limit`.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "nodes/limit/limit_answer.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/structure.hpp"
#include "run/limit/limit.hpp"
#include "run/output/page.hpp"

namespace kusabi::run {

/// Both views of the answer. @pre the references outlive it
struct LimitReport {
  const LimitOptions& options;
  const problems::Structure& truss;
  const problems::LimitProblem& problem;
  const limit::LimitAnswer& answer;
  int ranks = 1;

  /// @param page that it is printed on
  [[nodiscard]] std::string table(const Page& page) const;
  [[nodiscard]] nlohmann::ordered_json json() const;
};

}  // namespace kusabi::run
