// Clauses of sentences about one pattern: the candidates in contact, the friction that its reactions
// need, and the candidates that slip with less.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "problems/wedged/wedged_problem.hpp"
#include "support/index_set.hpp"

namespace kusabi::run {

/// "contact at all 16 candidates", "contact at tip (root inactive)", "contact at 12 of 40
/// candidates".
/// @param block of the candidates; of several blocks the others are not mentioned
std::string contact_words(const problems::WedgedProblem& problem, std::uint32_t block,
                          const support::IndexSet& contact, const support::IndexSet& inactive = {});

/// Least coefficient at which reactions are within their friction cones.
struct FrictionNeed {
  double coefficient = 0;   ///< the largest |r_t| / (phi r_n)
  support::IndexSet slips;  ///< candidates on their cones there
};

/// @param contact candidates in contact  @param reaction of the block, force
FrictionNeed friction_need(const problems::WedgedProblem& problem, std::uint32_t block,
                           const support::IndexSet& contact, std::span<const double> reaction);

/// "tip slips", "all of them slip at once", "a…c slip first". @pre a candidate slips
std::string slip_words(const problems::WedgedProblem& problem, std::uint32_t block,
                       const support::IndexSet& contact, const FrictionNeed& need);

/// " The angle of friction there is about 15°."; empty for a factor of the coefficients of the
/// candidates.
std::string angle_sentence(const problems::WedgedProblem& problem, double coefficient);

}  // namespace kusabi::run
