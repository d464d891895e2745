// Result of the tree of sign patterns: the minimal set of cones D(Y) whose union contains all
// configurations, (16) of the wedged paper.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "support/exact_count.hpp"

namespace kusabi::wedged {

/// True if all configurations of the first cone are configurations of the second: if, and only if,
/// the candidates with reactions and with gaps in its relative interior are subsets of those of the
/// second.
/// @pre both feasible or flat, of one block
bool within(const SignPattern& first, const SignPattern& second);

/// The leaves without repetitions and without faces of others: first feasible and flat ones, the
/// maximal cones, then undecided ones, which are all kept. Each kind is sorted by blocks, then
/// lexicographically by the candidates in contact and by the separated ones. The order does not
/// depend on the tree.
std::vector<Configuration> maximal_cones(std::vector<Configuration> leaves);

/// Lexicographic order by the candidates in contact, then by the separated ones.
bool comes_before(const SignPattern& first, const SignPattern& second);

/// The number of maximal cones of a structure from those of its blocks, which combine freely.
/// Blocks without any are inactive.
support::ExactCount combinations(std::span<const std::uint64_t> cones_of_blocks);

}  // namespace kusabi::wedged
