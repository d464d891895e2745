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
  double least = std::min(grid.most, bracket.upper_or_infinity());
  for (const auto& block : problems::blocks_of(problem)) {
    auto own = analysis.by_first_rank([&] {
      return quadratic_bound(problems::block_problem(problem, block),
                             {.enough = bracket.lower(),
                              .most = least,
                              .rounds = rounds,
                              .stop = analysis.budget().stop()});
    });
    result.evaluations += static_cast<std::uint64_t>(own.evaluations);
    least = std::min(least, own.factor);
    result.numbers.push_back(std::move(own.numbers));
    if (!(least > bracket.lower())) break;
  }
  if (least > bracket.lower()) result.factor = least;
  return result;
}

}  // namespace kusabi::wedged
