// Check that the nodes of a theorem are the closed nodes of one tree: every sign pattern of its block
// is below exactly one of them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "verify/wedged/certificate.hpp"

namespace kusabi::verify {

/// The missing or repeated part; nothing if every sign pattern of the block is below exactly one
/// node, or is that of a wedged configuration if the theorem is about these.
std::optional<std::string> flaw_of_cover(const Certificate& certificate, std::size_t theorem);

}  // namespace kusabi::verify
