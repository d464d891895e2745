// Rows, columns and bits picked out.
#include "problems/wedged/problem_block.hpp"

#include <bit>

namespace kusabi::problems {
namespace {

std::vector<Eigen::Index> displacements_of(std::uint64_t candidates, int dimension) {
  std::vector<Eigen::Index> numbers;
  for (; candidates != 0; candidates &= candidates - 1) {
    for (int axis = 0; axis < dimension; ++axis)
      numbers.push_back(Eigen::Index{dimension} * std::countr_zero(candidates) + axis);
  }
  return numbers;
}

// The first candidates are numbered alike in a block and in the whole.
bool begins_the_whole(std::uint64_t block) {
  return (block & (block + 1)) == 0;
}

}  // namespace

std::uint64_t all_candidates(const WedgedProblem& problem) {
  const auto count = problem.contact_names.size();
  return count >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

std::vector<std::uint64_t> blocks_of(const WedgedProblem& problem) {
  return problem.blocks.empty() ? std::vector{all_candidates(problem)} : problem.blocks;
}

WedgedProblem block_problem(const WedgedProblem& problem, std::uint64_t candidates) {
  if (candidates == all_candidates(problem)) return problem;
  WedgedProblem part = problem;
  part.contact_names.clear();
  part.frames.clear();
  part.friction.clear();
  for (auto rest = candidates; rest != 0; rest &= rest - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(rest));
    part.contact_names.push_back(problem.contact_names[i]);
    if (!problem.frames.empty()) part.frames.push_back(problem.frames[i]);
    if (!problem.friction.empty()) part.friction.push_back(problem.friction[i]);
  }
  const auto own = displacements_of(candidates, problem.dimension);
  part.stiffness = problem.stiffness(own, own);
  part.compliance = problem.compliance(own, own);
  if (problem.precise_compliance.size() != 0)
    part.precise_compliance = problem.precise_compliance(own, own);
  part.blocks = {all_candidates(part)};
  return part;
}

std::uint64_t in_whole(std::uint64_t own, std::uint64_t block) {
  if (begins_the_whole(block)) return own;
  std::uint64_t set = 0;
  for (; own != 0 && block != 0; own >>= 1, block &= block - 1) {
    if ((own & 1) != 0) set |= block & ~(block - 1);
  }
  return set;
}

std::uint64_t in_block(std::uint64_t whole, std::uint64_t block) {
  if (begins_the_whole(block)) return whole & block;
  std::uint64_t set = 0;
  for (std::uint64_t bit = 1; block != 0; bit <<= 1, block &= block - 1) {
    if ((whole & block & ~(block - 1)) != 0) set |= bit;
  }
  return set;
}

}  // namespace kusabi::problems
