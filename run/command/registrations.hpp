// Registrations of all subcommands, each defined below its class; run/subcommands.cpp lists them.
#pragma once

#include "run/command/subcommand.hpp"

namespace kusabi::run {

extern const Registration patterns_subcommand, rays_subcommand, critical_subcommand,
    hold_subcommand, limit_subcommand, sweep_subcommand, mip_subcommand, verify_subcommand,
    show_subcommand, draw_subcommand, report_subcommand, example_space_truss_subcommand,
    example_plane_truss_subcommand, example_grid_subcommand, example_dome_subcommand,
    example_tower_subcommand, import_subcommand, export_mps_subcommand, export_cbf_subcommand,
    export_matrix_subcommand, bench_scaling_subcommand, bench_schedules_subcommand,
    bench_uts_subcommand;

}  // namespace kusabi::run
