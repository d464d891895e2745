// One search for the smallest coefficient at which anything wedges, and what it says of the
// bracket.
#pragma once

#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/critical/critical_bracket.hpp"
#include "nodes/wedged/critical/critical_dive.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "nodes/wedged/critical/critical_tree.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Which of the searches for the smallest it is.
struct SmallestQuestion {
  CriticalDirection direction;
  CriticalPhase phase;
  CriticalGrid grid;        ///< nothing above its end is of interest
  double known;             ///< nothing wedges below
  BlockBounds bounds = {};  ///< at the end of the grid; of a search downwards
};

/// On all ranks.
struct Smallest {
  engine::Status status = engine::Status::solved;
  double lower = 0;
  double upper = std::numeric_limits<double>::infinity();  ///< the leaf is feasible here
  PatternNode leaf;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& status& lower& upper& leaf;
  }

  /// @param width of the grid that the bracket's ends are to lie on
  void narrow(CriticalBracket& bracket, double width) const;
};

std::int64_t multiples(double most, double width);

/// @param known nothing wedges below  @param most no coefficient above was of interest
Smallest smallest_of(const engine::OutcomeOf<CriticalTree>& outcome, const CriticalGrid& grid,
                     double known);

/// @param ranks on rank 0, what each of them has done
Smallest find_smallest(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                       const SmallestQuestion& question, std::vector<CriticalCost>& costs,
                       std::vector<engine::RankReport<CriticalTree>>& ranks);

}  // namespace kusabi::wedged
