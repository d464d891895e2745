// Leaves of a search of a tree of sign patterns, on all ranks.
#pragma once

#include <utility>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/analysis/analysis.hpp"
#include "engine/collectives.hpp"
#include "nodes/wedged/tree/sign_pattern_tree.hpp"

namespace kusabi::wedged {

struct TreeLeaves {
  engine::Status status = engine::Status::solved;
  std::vector<Configuration> leaves;  ///< feasible, flat or undecided

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& status& leaves;
  }
};

/// Broadcasts the leaves. @param outcome complete on rank 0; its solutions are moved from
inline TreeLeaves tree_leaves(engine::Analysis& analysis,
                              engine::OutcomeOf<SignPatternTree>& outcome) {
  return engine::from_first_rank(analysis.transport(), [&] {
    TreeLeaves result{outcome.status, {}};
    for (auto& found : outcome.solutions) result.leaves.push_back(std::move(found.solution));
    return result;
  });
}

}  // namespace kusabi::wedged
