// `kusabi example`: problem files of parametric families, used for measurements.
#pragma once

#include <memory>

#include "run/command/subcommand.hpp"

namespace kusabi::run {

std::unique_ptr<Subcommand> example_space_truss_subcommand();
std::unique_ptr<Subcommand> example_plane_truss_subcommand();
std::unique_ptr<Subcommand> example_grid_subcommand();

}  // namespace kusabi::run
