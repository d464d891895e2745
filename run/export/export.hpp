// `kusabi export`: the programs and matrices that are solved here, as files that other programs
// read (docs/export.md).
#pragma once

#include <memory>

#include "run/command/subcommand.hpp"

namespace kusabi::run {

/// Linear and 0-1 programs of limit analysis.
std::unique_ptr<Subcommand> export_mps_subcommand();
/// The cone program of a node of the tree of sign patterns.
std::unique_ptr<Subcommand> export_cbf_subcommand();
/// Stiffness or compliance of the contact candidates.
std::unique_ptr<Subcommand> export_matrix_subcommand();

}  // namespace kusabi::run
