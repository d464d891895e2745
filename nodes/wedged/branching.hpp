// Which undecided candidate a node of the tree of sign patterns is split by.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// The rule. Any gives the same patterns.
enum class Branching {
  /// The largest u_n r_n: Remark 5.5 of the paper.
  product,
  /// The largest u_n r_n / c, where c = F_nn + mu |F_nt| is the largest normal displacement that
  /// the candidate's own reaction can bring for each unit of r_n. No unit is left in this product,
  /// and stiff candidates have as much say as soft ones: up to ten times fewer nodes.
  relative,
};

/// 1 / c of Branching::relative for each candidate (the unit of F, alike for all, makes no
/// difference), or ones.
std::vector<double> branching_weights(const problems::WedgedProblem& problem,
                                      std::span<const double> friction, Branching branching);

/// The candidate that violates complementarity most. Of equal ones the first, so that the tree is
/// the same everywhere.
/// @param open the undecided candidates, not empty  @param weight of each candidate's u_n r_n
/// @param violation gives u_n r_n of a candidate
template <class Violation>
int branching_candidate(std::uint64_t open, std::span<const double> weight, Violation violation) {
  int best = std::countr_zero(open);
  double largest = -1;
  for (auto rest = open; rest != 0; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    const double product = violation(i) * weight[static_cast<std::size_t>(i)];
    if (product > largest) {
      largest = product;
      best = i;
    }
  }
  return best;
}

}  // namespace kusabi::wedged
