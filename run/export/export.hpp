// `kusabi export`: programs and matrices as files for other solvers (docs/export.md).
#pragma once

#include <memory>

#include "run/command/subcommand.hpp"

namespace kusabi::run {

/// Linear and zero-one programs of limit analysis.
std::unique_ptr<Subcommand> export_mps_subcommand();
/// Cone program of a node of the tree of sign patterns.
std::unique_ptr<Subcommand> export_cbf_subcommand();
/// Stiffness or compliance matrix of the contact candidates.
std::unique_ptr<Subcommand> export_matrix_subcommand();

}  // namespace kusabi::run
