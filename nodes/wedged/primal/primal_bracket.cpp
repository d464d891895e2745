// One search for each block, and the cell of the best pattern.
#include "nodes/wedged/primal/primal_bracket.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "nodes/wedged/critical/critical_start.hpp"
#include "nodes/wedged/critical/smallest_search.hpp"
#include "nodes/wedged/friction/critical_friction.hpp"
#include "nodes/wedged/primal/primal_search.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

// A point of the grid.
struct LeafPoint {
  double factor = std::numeric_limits<double>::infinity();
  std::uint64_t programs = 0;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& factor& programs;
  }
};

// Coefficient from which on the leaf is feasible; infinity if undecided, or not known in time.
LeafPoint begin_of(engine::Analysis& analysis, const problems::WedgedProblem& block,
                   const SignPattern& leaf, std::int64_t feasible, const CriticalGrid& grid) {
  return analysis.by_first_rank([&] {
    LeafPoint point;
    CriticalFriction critical(block, grid.width, grid.precision);
    critical.end_when(analysis.budget().stop());
    try {
      const auto cell = critical.locate(leaf, {.infeasible = 0, .feasible = feasible},
                                        CriticalMethod::newton, feasible);
      if (cell.feasible != CriticalCell::nowhere) point.factor = critical.at(cell.feasible);
    } catch (const support::Stopped&) {
    }
    point.programs = critical.programs();
    return point;
  });
}

std::uint64_t search_block(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                           std::uint32_t number, const CriticalGrid& grid, PrimalPart part,
                           NarrowingBracket& bracket) {
  const auto block = problems::block_problem(problem, problems::blocks_of(problem)[number]);
  const int m = static_cast<int>(block.contact_names.size());
  const FrictionGrid points(grid.width);
  PrimalParameters parameters{.infeasible = bracket.lower(),
                              .maximum = bracket.upper().value_or(grid.maximum),
                              .enough = 0,
                              .known = {},
                              .part = part};
  if (bracket.leaf() && bracket.leaf()->block == number)
    parameters.known = {*bracket.upper(), bracket.leaf()->pattern.contact};
  bool better = false;
  const auto found = search_primal(analysis, block, parameters, [&](const PrimalPattern& pattern) {
    const auto multiple = static_cast<std::int64_t>(std::ceil(pattern.factor / grid.width));
    bracket.reduce_upper(points.at(multiple), {number, leaf_with(pattern.contact, m)});
    bracket.show();
    better = true;
  });
  if (!better || analysis.ended()) return found.programs;
  const auto leaf = *bracket.leaf();
  const auto begin =
      begin_of(analysis, block, leaf.pattern, multiples(*bracket.upper(), grid.width), grid);
  bracket.reduce_upper(begin.factor, leaf);
  bracket.show();
  return found.programs + begin.programs;
}

}  // namespace

std::uint64_t reduce_by_patterns(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                                 const CriticalGrid& grid, PrimalPart part,
                                 NarrowingBracket& bracket) {
  std::uint64_t programs = 0;
  const auto blocks = static_cast<std::uint32_t>(problems::blocks_of(problem).size());
  for (std::uint32_t number = 0; number < blocks; ++number)
    programs += search_block(analysis, problem, number, grid, part, bracket);
  return programs;
}

}  // namespace kusabi::wedged
