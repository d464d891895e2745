// What the reader of certificates consists of: the header is in certificate.cpp, bounds are in
// bound_lines.cpp, nodes in node_lines.cpp.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "verify/wedged/certificate.hpp"
#include "verify/wedged/lines.hpp"

namespace kusabi::verify {

/// How a file of one version says what another says in other words.
struct Version {
  bool names_blocks = false;  ///< lists them, and begins a node with the number of its block
  bool has_motions = false;   ///< of loose bodies
  bool has_bounds = false;    ///< of candidates, and nodes proved with the cuts that follow
};

/// The number of a block as the next word has it, but counted from 0.
/// @throws CertificateError, as all of these
std::size_t read_block_number(Lines& lines, const Certificate& certificate);

/// What the numbers of a dead node, or of a bound, are called. @param motions of its block
std::string multipliers_of(std::size_t motions);

/// Refuses the line if one of the multipliers of cuts is negative.
void refuse_negative(const Lines& lines, std::span<const double> multipliers);

/// From the line 'bounds N' to the last of them.
void read_bounds(Lines& lines, Certificate& certificate);

/// From the line 'nodes' to the line 'end N', repeated nodes left out.
void read_records(Lines& lines, Version version, Certificate& certificate);

}  // namespace kusabi::verify
