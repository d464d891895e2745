// List of all subcommands, with chapters of help.
#include "run/subcommands.hpp"

#include <utility>

#include "run/bench/bench.hpp"
#include "run/critical/critical.hpp"
#include "run/draw/draw.hpp"
#include "run/example/example.hpp"
#include "run/export/export.hpp"
#include "run/hold/hold.hpp"
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
  all.push_back(export_mps_subcommand());
  all.push_back(export_cbf_subcommand());
  all.push_back(export_matrix_subcommand());
  all.push_back(bench_scaling_subcommand());
  all.push_back(bench_schedules_subcommand());
  all.push_back(bench_uts_subcommand());
  return {
      std::move(all),
      {{"example", "writes a problem file of a family of structures"},
       {"export", "writes what is solved here for the solvers of others"},
       {"bench", "measures and tries the search engine"}},
      {{"Can it stick?", {"patterns", "rays", "critical", "sweep"}},
       {"What can friction hold under load?", {"hold"}},
       {"What does a truss carry when its loads are not known exactly?", {"limit"}},
       {"What is the optimum of a zero-one program?", {"mip"}},
       {"Is it true?", {"verify"}},
       {"What does it look like?", {"show", "draw", "report"}},
       {"Is there a problem file to try?",
        {"example space-truss", "example plane-truss", "example grid"}},
       {"How do the solvers of others get it?", {"export mps", "export cbf", "export matrix"}},
       {"How well does the search engine do?", {"bench scaling", "bench schedules", "bench uts"}}}};
}

}  // namespace kusabi::run
