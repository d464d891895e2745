// A single search for the smallest critical coefficient, and its contribution to the bracket.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/critical/critical_dive.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "nodes/wedged/critical/critical_tree.hpp"
#include "nodes/wedged/critical/narrowing_bracket.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Parameters of the search.
struct SmallestParameters {
  CriticalDirection direction;
  CriticalPhase phase;
  CriticalGrid grid;        ///< with the upper limit of the search
  double known;             ///< no configuration is wedged below
  BlockBounds bounds = {};  ///< at the upper limit of the grid, for a search downwards
};

/// The result, on all ranks.
struct SmallestCoefficient {
  engine::Status status = engine::Status::solved;
  double lower = 0;
  double upper = std::numeric_limits<double>::infinity();  ///< the leaf is feasible here
  PatternNode leaf;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& status& lower& upper& leaf;
  }

  /// @param width of the grid of the bracket
  void narrow(NarrowingBracket& bracket, double width) const;
};

/// The multiple of the width nearest to `maximum`.
std::int64_t multiples(double maximum, double width);

/// The bracket that the outcome of a search implies.
/// @param known no configuration is wedged below
SmallestCoefficient smallest_coefficient(const engine::OutcomeOf<CriticalTree>& outcome,
                                         const CriticalGrid& grid, double known);

/// @param ranks receives on rank 0 the costs of each rank
SmallestCoefficient find_smallest(engine::Analysis& analysis,
                                  const problems::WedgedProblem& problem,
                                  const SmallestParameters& parameters,
                                  std::vector<CriticalCost>& costs,
                                  std::vector<engine::RankReport<CriticalTree>>& ranks);

}  // namespace kusabi::wedged
