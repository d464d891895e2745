// Whether the nodes of a certificate are the closed nodes of a tree: every sign pattern below
// exactly one of them.
#pragma once

#include <optional>
#include <string>

#include "verify/certificate.hpp"

namespace kusabi::verify {

/// @return what is missing, or there twice; nothing if every sign pattern is below exactly one node
std::optional<std::string> flaw_of_cover(const Certificate& certificate);

}  // namespace kusabi::verify
