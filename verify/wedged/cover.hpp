// Check that the nodes of a certificate are the closed nodes of one tree for each block: every sign
// pattern of the block is below exactly one of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verify/wedged/certificate.hpp"

namespace kusabi::verify {

/// @return the missing or repeated part; nothing if every sign pattern of every block is below
///         exactly one node
std::optional<std::string> flaw_of_cover(const Certificate& certificate);

/// The same for some nodes of a block.
std::optional<std::string> flaw_of_cover(const Certificate& certificate,
                                         const support::IndexSet& block,
                                         std::vector<const Record*> records);

}  // namespace kusabi::verify
