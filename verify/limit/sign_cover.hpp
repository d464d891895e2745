// Cover of all combinations of signs by the nodes of a limit-load certificate.
#pragma once

#include <optional>
#include <string>

#include "verify/limit/limit_certificate.hpp"

namespace kusabi::verify {

/// Checks that the nodes cover all combinations of signs.
/// @return the fault; nothing if every combination is below a node
std::optional<std::string> flaw_of_sign_cover(const LimitCertificate& certificate);

}  // namespace kusabi::verify
