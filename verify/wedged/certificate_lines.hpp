// Parts of the certificate reader: the header is in certificate.cpp, bounds are in bound_lines.cpp,
// nodes in node_lines.cpp.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "verify/wedged/certificate.hpp"
#include "verify/wedged/lines.hpp"

namespace kusabi::verify {

/// Features of a version of the file format.
struct Version {
  bool names_blocks = false;  ///< blocks are listed, and a node begins with the number of its block
  bool has_motions = false;   ///< rigid-body modes of unconstrained bodies
  bool has_bounds = false;    ///< bounds of candidates, and nodes proved with the resulting cuts
};

/// The block number in the next word, counted from 0.
/// @throws CertificateError, as do all functions below
std::size_t read_block_number(Lines& lines, const Certificate& certificate);

/// Name of the numbers of a node `infeasible` or of a bound in messages.
/// @param motions of its block
std::string multipliers_of(std::size_t motions);

/// Refuses the line if a multiplier of a cut is negative.
void refuse_negative(const Lines& lines, std::span<const double> multipliers);

/// Reads from the line 'dimension D' to the friction coefficients.
void read_header(Lines& lines, Certificate& certificate);

/// Reads from the line 'blocks N' to the last block.
void read_blocks(Lines& lines, Certificate& certificate);

/// Reads from the line 'motions P' to the last row of G.
void read_motions(Lines& lines, Certificate& certificate);

/// Reads from the line 'bounds N' to the last bound.
void read_bounds(Lines& lines, Certificate& certificate);

/// Reads from the line 'nodes' to the line 'end N', without repeated nodes.
void read_records(Lines& lines, Version version, Certificate& certificate);

}  // namespace kusabi::verify
