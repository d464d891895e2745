// Initial bracket from a few cone programs for each block, on the first rank.
#include "nodes/wedged/critical/critical_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "nodes/wedged/critical/smallest_search.hpp"
#include "nodes/wedged/friction/critical_friction.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

// Bounds from the root and single leaves of a block.
struct BlockStart {
  double infeasible = std::numeric_limits<double>::infinity();  // infeasible up to this coefficient
  double feasible =
      std::numeric_limits<double>::infinity();  // the leaf is feasible at this coefficient
  SignPattern leaf;
  std::uint64_t programs = 0;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& infeasible& feasible& leaf& programs;
  }
};

void take_leaf(CriticalFriction& critical, const SignPattern& leaf, std::int64_t maximum,
               BlockStart& start) {
  const auto cell = critical.locate(leaf, {.infeasible = 0, .feasible = CriticalCell::nowhere},
                                    CriticalMethod::newton, maximum);
  if (cell.feasible == CriticalCell::nowhere || critical.at(cell.feasible) >= start.feasible)
    return;
  start.feasible = critical.at(cell.feasible);
  start.leaf = leaf;
}

// Ends early with a partial result when the run is to stop.
void start_block(const problems::WedgedProblem& block, const CriticalGrid& grid,
                 const support::Stop& stop, BlockStart& start) {
  const int m = static_cast<int>(block.contact_names.size());
  const auto maximum = static_cast<std::int64_t>(std::llround(grid.maximum / grid.width));
  start.infeasible = 0;
  CriticalFriction root(block, grid.width, Precision::doubles);
  CriticalFriction leaves(block, grid.width, grid.precision);
  root.end_when(stop);
  leaves.end_when(stop);
  try {
    const auto cell = root.locate({}, {.infeasible = 0, .feasible = CriticalCell::nowhere},
                                  CriticalMethod::newton, maximum);
    start.infeasible = root.at(cell.infeasible);
    // In doubles each program takes long, and the leaf is near the answer if the root is.
    const bool near = cell.infeasible > 0 || grid.precision != Precision::doubles;
    if (near && cell.infeasible < maximum)
      take_leaf(leaves, leaf_with(support::IndexSet::below(m), m), maximum, start);
    const auto singles = single_contacts(block);
    if (!singles.empty() && singles.front().factor < start.feasible)
      take_leaf(leaves, leaf_with(support::IndexSet::single(singles.front().candidate), m), maximum,
                start);
  } catch (const support::Stopped&) {
  }
  start.programs = root.programs() + leaves.programs();
}

}  // namespace

SignPattern leaf_with(const support::IndexSet& contact, int candidates) {
  return {.contact = contact,
          .separated = support::IndexSet::below(candidates) - contact,
          .inactive = {}};
}

// With r_i = (1, r_t), u_ni = F_nn,ii + F_nt,ii'r_t is zero for the smallest r_t opposite to
// F_nt,ii.
std::vector<SingleContact> single_contacts(const problems::WedgedProblem& block) {
  std::vector<SingleContact> singles;
  if (block.modes.matrix.cols() > 0) return singles;
  const Eigen::Index d = block.dimension;
  const auto m = static_cast<Eigen::Index>(block.contact_names.size());
  for (Eigen::Index i = 0; i < m; ++i) {
    const Eigen::VectorXd coupling = block.compliance.matrix.row(d * i).segment(d * i + 1, d - 1);
    const double size = coupling.norm();
    const double own = block.friction.empty() ? 1 : block.friction[static_cast<std::size_t>(i)];
    if (!(size > 0) || !(own > 0)) continue;
    const double normal = block.compliance.matrix(d * i, d * i);
    Eigen::VectorXd reaction(d);
    reaction << 1, -normal / (size * size) * coupling;
    bool separates = true;
    for (Eigen::Index j = 0; j < m && separates; ++j)
      separates = j == i || block.compliance.matrix.row(d * j).segment(d * i, d).dot(reaction) > 0;
    if (separates) singles.push_back({normal / size / own, static_cast<int>(i)});
  }
  std::ranges::sort(singles, [](const auto& a, const auto& b) {
    return a.factor != b.factor ? a.factor < b.factor : a.candidate < b.candidate;
  });
  return singles;
}

std::uint64_t start_bracket(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                            const CriticalGrid& grid, NarrowingBracket& bracket) {
  const auto blocks = problems::blocks_of(problem);
  std::uint64_t programs = 0;
  double infeasible = grid.maximum;
  for (std::uint32_t number = 0; number < blocks.size(); ++number) {
    const auto start = analysis.by_first_rank([&] {
      BlockStart own;
      start_block(problems::block_problem(problem, blocks[number]), grid, analysis.budget().stop(),
                  own);
      return own;
    });
    infeasible = std::min(infeasible, start.infeasible);
    programs += start.programs;
    if (std::isfinite(start.feasible)) bracket.reduce_upper(start.feasible, {number, start.leaf});
    if (analysis.ended()) return programs;  // the other blocks have no bounds
  }
  SmallestCoefficient found;
  found.lower = infeasible;
  found.narrow(bracket, grid.width);
  return programs;
}

}  // namespace kusabi::wedged
