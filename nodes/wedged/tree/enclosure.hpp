// K enclosed for the verifier's test within the limits of a campaign.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "engine/campaign.hpp"
#include "problems/structure/model/structure.hpp"
#include "support/stop.hpp"
#include "verify/structure/loose_stiffness.hpp"

namespace kusabi::wedged {

/// Or why there is none, a sentence.
using Enclosure = std::variant<verify::EnclosedProblem, std::string>;

/// enclosed_stiffness(), or enclosed_stiffness_of_any().
using Enclose = Enclosure (*)(const problems::Structure&, const support::LongWork&);

/// Every rank makes the same call and computes it. Nothing, on all of them, if the campaign ends
/// before one of them has it.
std::optional<Enclosure> enclosed_within(engine::Campaign& campaign,
                                         const problems::Structure& structure, Enclose enclose);

}  // namespace kusabi::wedged
