// Enclosure of K for the exact test within the limits of an analysis.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "engine/analysis/analysis.hpp"
#include "problems/structure/model/structure.hpp"
#include "support/stop.hpp"
#include "verify/structure/enclosed_problem.hpp"

namespace kusabi::wedged {

/// The enclosed K, or a sentence with the reason why there is none.
using StiffnessEnclosure = std::variant<verify::EnclosedProblem, std::string>;

/// enclosed_stiffness(), or enclosed_stiffness_without_limit().
using EncloseStiffness = StiffnessEnclosure (*)(const problems::Structure&,
                                                const support::LongWork&);

/// Every rank makes the same call and computes it. Nothing, on all of them, if the analysis ends
/// before one of them is done.
std::optional<StiffnessEnclosure> enclosed_within(engine::Analysis& analysis,
                                                  const problems::Structure& structure,
                                                  EncloseStiffness enclose);

}  // namespace kusabi::wedged
