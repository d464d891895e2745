// Selection of rows, columns and candidates.
#include "problems/wedged/problem_block.hpp"

#include "problems/structure/bodies/null_space.hpp"
#include "problems/structure/bodies/rigid_motions.hpp"

namespace kusabi::problems {
using support::IndexSet;

namespace {

std::vector<Eigen::Index> displacements_of(const IndexSet& candidates, int dimension) {
  std::vector<Eigen::Index> numbers;
  for (const int candidate : candidates) {
    for (int axis = 0; axis < dimension; ++axis)
      numbers.push_back(Eigen::Index{dimension} * candidate + axis);
  }
  return numbers;
}

// The columns with nonzero entries in the given rows.
std::vector<Eigen::Index> columns_of(const Eigen::MatrixXd& matrix,
                                     const std::vector<Eigen::Index>& rows) {
  std::vector<Eigen::Index> columns;
  for (Eigen::Index k = 0; k < matrix.cols(); ++k) {
    if (!matrix(rows, k).isZero(0.0)) columns.push_back(k);
  }
  return columns;
}

// Makes columns independent, with pivoting by their largest entries; the remaining part of the
// others is rounding in 104 bits and is dropped.
numbers::PreciseMatrix independent_columns(numbers::PreciseMatrix matrix) {
  Eigen::Index kept = 0;
  for (; kept < matrix.cols(); ++kept) {
    Eigen::Index row = 0;
    Eigen::Index column = 0;
    const double largest =
        matrix.rightCols(matrix.cols() - kept).cast<double>().cwiseAbs().maxCoeff(&row, &column);
    if (!(largest > largest_zero_pivot)) break;
    matrix.col(kept).swap(matrix.col(kept + column));
    for (Eigen::Index other = kept + 1; other < matrix.cols(); ++other) {
      const numbers::Precise share = matrix(row, other) / matrix(row, kept);
      if (!share.is_zero()) matrix.col(other) -= share * matrix.col(kept);
    }
  }
  return matrix.leftCols(kept);
}

// Blocks of the first candidates have the same numbers as the whole.
bool begins_the_whole(const IndexSet& block) {
  return block == IndexSet::below(block.size());
}

}  // namespace

IndexSet all_candidates(const WedgedProblem& problem) {
  return IndexSet::below(static_cast<int>(problem.contact_names.size()));
}

std::vector<IndexSet> blocks_of(const WedgedProblem& problem) {
  return problem.blocks.empty() ? std::vector{all_candidates(problem)} : problem.blocks;
}

WedgedProblem block_problem(const WedgedProblem& problem, const IndexSet& candidates) {
  if (candidates == all_candidates(problem)) return problem;
  WedgedProblem part = problem;
  part.contact_names.clear();
  part.frames.clear();
  part.friction.clear();
  for (const int candidate : candidates) {
    const auto i = static_cast<std::size_t>(candidate);
    part.contact_names.push_back(problem.contact_names[i]);
    if (!problem.frames.empty()) part.frames.push_back(problem.frames[i]);
    if (!problem.friction.empty()) part.friction.push_back(problem.friction[i]);
  }
  const auto own = displacements_of(candidates, problem.dimension);
  if (problem.compliance.stiffness.size() != 0)
    part.compliance.stiffness = problem.compliance.stiffness(own, own);
  part.compliance.matrix = problem.compliance.matrix(own, own);
  if (problem.compliance.precise.size() != 0)
    part.compliance.precise = problem.compliance.precise(own, own);
  if (problem.modes.matrix.cols() > 0) {
    const auto moving = columns_of(problem.modes.matrix, own);
    part.modes.matrix = problem.modes.matrix(own, moving);
    if (problem.modes.precise.size() != 0) part.modes.precise = problem.modes.precise(own, moving);
  }
  part.blocks = {all_candidates(part)};
  return part;
}

WedgedProblem problem_without_others(const WedgedProblem& problem, const IndexSet& candidates) {
  WedgedProblem part = block_problem(problem, candidates);
  if (part.modes.matrix.cols() == 0) return part;
  const bool precise = part.modes.precise.size() != 0;
  part.modes.precise = independent_columns(
      precise ? part.modes.precise
              : numbers::PreciseMatrix(part.modes.matrix.cast<numbers::Precise>()));
  part.modes.matrix = part.modes.precise.cast<double>();
  if (!precise) part.modes.precise.resize(0, 0);
  return part;
}

IndexSet in_whole(const IndexSet& own, const IndexSet& block) {
  if (begins_the_whole(block)) return own;
  IndexSet set;
  int number = 0;
  for (const int candidate : block) {
    if (own.contains(number++)) set.insert(candidate);
  }
  return set;
}

IndexSet in_block(const IndexSet& whole, const IndexSet& block) {
  if (begins_the_whole(block)) return whole & block;
  IndexSet set;
  int number = 0;
  for (const int candidate : block) {
    if (whole.contains(candidate)) set.insert(number);
    ++number;
  }
  return set;
}

}  // namespace kusabi::problems
