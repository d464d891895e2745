// The zero-one tree on random programs of several kinds: nodes, linear programs and seconds for
// each branching rule and each option at the root, compared with branch and cut of GLPK (glpsol
// --cuts) on the same programs. Optima must agree.
//
// Nodes and linear programs are the same on any machine; seconds are not.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glpk.h>

#include "engine/search.hpp"
#include "nodes/zero_one/tree.hpp"
#include "tests/nodes/zero_one/programs.hpp"

namespace {

using namespace kusabi;

constexpr double time_limit = 20;  // seconds per program and variant

struct Sums {
  std::uint64_t nodes = 0;
  std::uint64_t programs = 0;
  double seconds = 0;
  int unsolved = 0;
};

struct Way {
  std::string name;
  zero_one::ZeroOneRootOptions root;
  zero_one::ZeroOneBranching branching;
};

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// NaN if there is no point, or none was found in time.
double by_kusabi(const linear::MixedProgram& mixed, const Way& way, Sums& sums) {
  const double start = now();
  zero_one::ZeroOneTree tree(zero_one::prepare_root(mixed, way.root), way.branching);
  engine::Options options;
  options.goal = engine::Goal::best;
  options.limits.seconds = time_limit;
  const auto outcome = engine::search(tree, options);
  sums.seconds += now() - start;
  sums.nodes += outcome.opened();
  sums.programs += outcome.ranks[0].tally.programs + tree.prepared().counts.programs;
  if (outcome.status != engine::Status::solved) {
    ++sums.unsolved;
    return std::nan("");
  }
  return outcome.solutions.empty() ? std::nan("") : outcome.solutions[0].solution.objective;
}

void count_nodes(glp_tree* tree, void* info) {
  int total = 0;
  glp_ios_tree_size(tree, nullptr, nullptr, &total);
  *static_cast<int*>(info) = total;
}

double by_glpk(const linear::MixedProgram& mixed, Sums& sums) {
  const auto& program = mixed.program;
  glp_prob* const lp = glp_create_prob();
  if (!program.rows.empty()) glp_add_rows(lp, static_cast<int>(program.rows.size()));
  glp_add_cols(lp, static_cast<int>(program.columns.size()));
  const auto type = [](double lower, double upper) {
    if (lower == upper) return GLP_FX;
    if (std::isfinite(lower)) return std::isfinite(upper) ? GLP_DB : GLP_LO;
    return std::isfinite(upper) ? GLP_UP : GLP_FR;
  };
  for (std::size_t i = 0; i < program.rows.size(); ++i) {
    const auto& row = program.rows[i];
    glp_set_row_bnds(lp, static_cast<int>(i) + 1, type(row.lower, row.upper), row.lower, row.upper);
  }
  for (std::size_t j = 0; j < program.columns.size(); ++j) {
    const auto& column = program.columns[j];
    const int number = static_cast<int>(j) + 1;
    glp_set_col_bnds(lp, number, type(column.lower, column.upper), column.lower, column.upper);
    glp_set_obj_coef(lp, number, column.cost);
  }
  std::vector<int> rows{0};
  std::vector<int> columns{0};
  std::vector<double> values{0};
  for (const auto& [row, column, value] : program.entries) {
    rows.push_back(row + 1);
    columns.push_back(column + 1);
    values.push_back(value);
  }
  glp_load_matrix(lp, static_cast<int>(values.size()) - 1, rows.data(), columns.data(),
                  values.data());
  for (const int column : mixed.binaries) glp_set_col_kind(lp, column + 1, GLP_BV);
  glp_iocp control;
  glp_init_iocp(&control);
  control.msg_lev = GLP_MSG_OFF;
  control.presolve = GLP_ON;
  control.gmi_cuts = control.mir_cuts = control.cov_cuts = control.clq_cuts = GLP_ON;
  constexpr int milliseconds = 1000;
  control.tm_lim = static_cast<int>(time_limit) * milliseconds;
  int nodes = 0;
  control.cb_func = count_nodes;
  control.cb_info = &nodes;
  const double start = now();
  const int code = glp_intopt(lp, &control);
  sums.seconds += now() - start;
  sums.nodes += static_cast<std::uint64_t>(nodes);
  if (code == GLP_ETMLIM) ++sums.unsolved;
  const bool optimal = code == 0 && glp_mip_status(lp) == GLP_OPT;
  const double objective = optimal ? glp_mip_obj_val(lp) : std::nan("");
  glp_delete_prob(lp);
  return objective;
}

bool agree(double a, double b) {
  constexpr double tolerance = 1e-6;
  return std::isnan(a) || std::isnan(b) ||
         std::abs(a - b) <= tolerance * std::max(1.0, std::abs(b));
}

}  // namespace

int main() {
  glp_term_out(GLP_OFF);
  using zero_one::ZeroOneBranching;
  using zero_one::ZeroOneCuts;
  const std::vector<Way> ways{
      {"the paper's branching, nothing at the root",
       {.tighten = false, .dive = false},
       ZeroOneBranching::paper},
      {"the paper's branching (as the program does)", {}, ZeroOneBranching::paper},
      {"the same, disjunctive cuts", {.cuts = ZeroOneCuts::disjunctive}, ZeroOneBranching::paper},
      {"look ahead", {}, ZeroOneBranching::look_ahead},
      {"the same, disjunctive cuts",
       {.cuts = ZeroOneCuts::disjunctive},
       ZeroOneBranching::look_ahead}};
  struct Family {
    const char* name;
    int kind;
    int binaries;
  };
  constexpr Family families[]{{"knapsacks, 3 rows", 0, 90},
                              {"set covers", 1, 100},
                              {"flows with charges", 2, 100},
                              {"anything", 3, 40}};
  constexpr unsigned seeds = 5;
  int disagreements = 0;
  for (const auto& family : families) {
    fmt::print("\n{} random programs: {}, {} binaries\n", seeds, family.name, family.binaries);
    fmt::print("{:<46}{:>9}{:>11}{:>9}{:>10}\n", "", "nodes", "programs", "seconds", "unsolved");
    Sums glpk;
    std::vector<double> optima;
    for (unsigned seed = 0; seed < seeds; ++seed) {
      optima.push_back(by_glpk(tests::random_mixed(seed, family.kind, family.binaries), glpk));
    }
    const auto print = [](const std::string& name, const Sums& sums) {
      fmt::print("{:<46}{:>9}{:>11}{:>9.2f}{:>10}\n", name, sums.nodes, sums.programs, sums.seconds,
                 sums.unsolved);
      std::fflush(stdout);
    };
    for (const auto& way : ways) {
      Sums sums;
      for (unsigned seed = 0; seed < seeds; ++seed) {
        const auto mixed = tests::random_mixed(seed, family.kind, family.binaries);
        if (!agree(by_kusabi(mixed, way, sums), optima[seed])) ++disagreements;
      }
      print(way.name, sums);
    }
    print("GLPK's branch and cut, all cuts, presolved", glpk);
  }
  fmt::print("\n{} optima differ\n", disagreements);
  return disagreements == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
