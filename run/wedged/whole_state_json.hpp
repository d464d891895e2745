// What a configuration does to the whole structure, in the result file: (4) and (5) of the wedged
// paper.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "problems/structure/structure.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "problems/wedged/whole_structure.hpp"

namespace kusabi::run {

class WholeStateJson {
 public:
  WholeStateJson(const problems::Structure& structure, const problems::WedgedProblem& problem)
      : names_(structure.node_names), structure_(structure, problem) {}

  /// Adds `all_displacements` and `support_reactions`, by node in global axes, and `imbalance`.
  /// @param reactions of all candidates, dm
  /// @param displacements likewise
  void add_to(nlohmann::ordered_json& configuration, std::span<const double> reactions,
              std::span<const double> displacements) const;

 private:
  std::vector<std::string> names_;
  problems::WholeStructure structure_;
};

}  // namespace kusabi::run
