// One form for each block, optimised by the first rank.
#include "nodes/wedged/quadratic/quadratic_bracket.hpp"

#include <algorithm>
#include <utility>

#include <boost/serialization/vector.hpp>

#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {

QuadraticForms quadratic_forms(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                               const CriticalGrid& grid, const NarrowingBracket& bracket,
                               int rounds) {
  QuadraticForms result;
  double minimum = std::min(grid.maximum, bracket.upper_or_infinity());
  for (const auto& block : problems::blocks_of(problem)) {
    auto own = analysis.by_first_rank([&] {
      return quadratic_bound(problems::block_problem(problem, block),
                             {.enough = bracket.lower(),
                              .maximum = minimum,
                              .rounds = rounds,
                              .stop = analysis.budget().stop()});
    });
    result.evaluations += static_cast<std::uint64_t>(own.evaluations);
    minimum = std::min(minimum, own.factor);
    result.numbers.push_back(std::move(own.numbers));
    if (!(minimum > bracket.lower())) break;
  }
  if (minimum > bracket.lower()) result.factor = minimum;
  return result;
}

}  // namespace kusabi::wedged
