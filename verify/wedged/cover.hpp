// Whether the nodes of a certificate are the closed nodes of a tree for each block: every sign
// pattern of the block below exactly one of them.
#pragma once

#include <optional>
#include <string>

#include "verify/wedged/certificate.hpp"

namespace kusabi::verify {

/// @return what is missing, or there twice; nothing if every sign pattern of every block is below
///         exactly one of its nodes
std::optional<std::string> flaw_of_cover(const Certificate& certificate);

}  // namespace kusabi::verify
