// The answer of the tree of sign patterns: the fewest cones D(Y) whose union is all configurations,
// (16) of the wedged paper.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nodes/wedged/tree/sign_pattern.hpp"
#include "support/exact_count.hpp"

namespace kusabi::wedged {

/// Whether all configurations of the first cone are configurations of the second. That is so if,
/// and only if, what the first loads and moves in its relative interior the second does, too.
/// @pre both alive or flat, of one block
bool within(const SignPattern& first, const SignPattern& second);

/// The leaves without those that are faces of another and without repetitions. First the living and
/// flat ones, the maximal cones, then the marginal and the undecided ones, which are all kept;
/// each kind block by block in the order of a dictionary: by the candidates in contact, then by the
/// separated ones. So the order does not depend on the tree.
std::vector<Configuration> maximal_cones(std::vector<Configuration> leaves);

/// The order of a dictionary: by the candidates in contact, then by the separated ones.
bool comes_before(const SignPattern& first, const SignPattern& second);

/// How many maximal cones a structure has whose blocks have so many each: any cone of one goes with
/// any of another. Blocks without any stay at rest.
support::ExactCount combinations(std::span<const std::uint64_t> cones_of_blocks);

}  // namespace kusabi::wedged
