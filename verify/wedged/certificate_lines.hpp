// Parts of the certificate reader: the problem is in certificate.cpp, bounds are in bound_lines.cpp,
// theorems, nodes and states in node_lines.cpp.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "verify/wedged/certificate.hpp"
#include "verify/wedged/lines.hpp"

namespace kusabi::verify {

/// The block number in the next word, counted from 0.
/// @throws CertificateError, as do all functions below
std::size_t read_block_number(Lines& lines, const Certificate& certificate);

/// The theorem number in the next word, counted from 0.
std::size_t read_theorem_number(Lines& lines, const Certificate& certificate);

/// Refuses a bound or a cut of a theorem with loads whose weights are not there.
void refuse_without_weights(const Lines& lines, const Theorem& theorem);

/// Name of the numbers of a node `infeasible` or of a bound in messages.
/// @param motions of its block
std::string multipliers_of(std::size_t motions);

/// Refuses the line if a multiplier of a cut is negative.
void refuse_negative(const Lines& lines, std::span<const double> multipliers);

/// Reads from the line 'theorems N' to the last theorem.
void read_theorems(Lines& lines, Certificate& certificate);

/// Reads from the line 'bounds N' to the last bound.
void read_bounds(Lines& lines, Certificate& certificate);

/// Reads from the line 'evidence' to the line 'end N', without repeated nodes and states.
void read_evidence(Lines& lines, Certificate& certificate);

}  // namespace kusabi::verify
