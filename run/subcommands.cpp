// List of all subcommands, with chapters of help.
#include "run/subcommands.hpp"

#include <utility>

#include "run/bench/bench.hpp"
#include "run/critical/critical.hpp"
#include "run/draw/draw.hpp"
#include "run/example/example.hpp"
#include "run/export/export.hpp"
#include "run/hold/hold.hpp"
#include "run/import/import.hpp"
#include "run/limit/limit.hpp"
#include "run/mip/mip.hpp"
#include "run/patterns/patterns.hpp"
#include "run/rays/rays.hpp"
#include "run/report/report.hpp"
#include "run/show/show.hpp"
#include "run/sweep/sweep.hpp"
#include "run/verify/verify.hpp"

namespace kusabi::run {

CommandList command_list() {
  std::vector<std::unique_ptr<Subcommand>> all;
  all.push_back(patterns_subcommand());
  all.push_back(rays_subcommand());
  all.push_back(critical_subcommand());
  all.push_back(hold_subcommand());
  all.push_back(limit_subcommand());
  all.push_back(sweep_subcommand());
  all.push_back(mip_subcommand());
  all.push_back(verify_subcommand());
  all.push_back(show_subcommand());
  all.push_back(draw_subcommand());
  all.push_back(report_subcommand());
  all.push_back(example_space_truss_subcommand());
  all.push_back(example_plane_truss_subcommand());
  all.push_back(example_grid_subcommand());
  all.push_back(import_subcommand());
  all.push_back(export_mps_subcommand());
  all.push_back(export_cbf_subcommand());
  all.push_back(export_matrix_subcommand());
  all.push_back(bench_scaling_subcommand());
  all.push_back(bench_schedules_subcommand());
  all.push_back(bench_uts_subcommand());
  return {
      std::move(all),
      {{"example", "problem files of parametric families"},
       {"export", "programs and matrices as files for other solvers"},
       {"bench", "measurements and tests of the search engine"}},
      {{"Wedged configurations", {"patterns", "rays", "critical", "sweep"}},
       {"Loads held by friction", {"hold"}},
       {"Limit loads of trusses", {"limit"}},
       {"Mixed zero-one programs", {"mip"}},
       {"Verification", {"verify"}},
       {"Summaries, pictures and reports", {"show", "draw", "report"}},
       {"Generated problem files", {"example space-truss", "example plane-truss", "example grid"}},
       {"Files of other programs", {"import"}},
       {"Files for other solvers", {"export mps", "export cbf", "export matrix"}},
       {"Measurements of the search engine", {"bench scaling", "bench schedules", "bench uts"}}}};
}

}  // namespace kusabi::run
