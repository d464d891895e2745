// Cover of all combinations of signs by the nodes of a theorem on limit loads.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "verify/limit/truss_certificate.hpp"

namespace kusabi::verify {

/// Checks that the nodes cover all combinations of signs of this number of columns.
/// @return the fault; nothing if every combination is below a node
std::optional<std::string> flaw_of_sign_cover(std::span<const LimitNode> nodes,
                                              std::size_t columns);

}  // namespace kusabi::verify
