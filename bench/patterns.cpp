// Nodes of the tree of sign patterns per pattern, under the branching rules of the program and
// under rules that were tried and rejected (docs/theory/wedged.md); candidates under polyhedral
// friction (Algorithm 5.8); accuracy of the estimated remaining time.
//
// Nodes and cone programs are the same on any machine; CPU seconds are not.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "engine/search.hpp"
#include "nodes/wedged/tree/sign_pattern_tree.hpp"
#include "problems/families/space_truss.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/session/progress_text.hpp"
#include "solvers/conic/node_solver.hpp"

namespace {

using namespace kusabi;
using conic::Sign;

// Values of a candidate at a node.
struct Candidate {
  double displacement;  // u_n >= 0
  double reaction;      // r_n >= 0
  double compliance;    // its own F_nn
  double reach;         // its own F_nn + mu |F_nt|
};

struct Strategy {
  std::string name;
  std::function<double(const Candidate&)> score;  // the candidate with the largest score is
                                                  // branched on
  int tried = 0;  // strong branching on this many candidates with the largest scores
};

const std::vector<Strategy>& strategies() {
  const auto product = [](const Candidate& c) { return c.displacement * c.reaction; };
  const auto compliance = [=](const Candidate& c) { return product(c) / c.compliance; };
  const auto relative = [=](const Candidate& c) { return product(c) / c.reach; };
  static const std::vector<Strategy> all{
      {"u r (paper)", product},
      {"u r / F_nn", compliance},
      {"u r / (F_nn + mu F_nt)", relative},
      {"largest r", [](const Candidate& c) { return c.reaction; }},
      {"largest u", [](const Candidate& c) { return c.displacement; }},
      {"the third, 2 tried", relative, 2},
      {"the third, 4 tried", relative, 4},
  };
  return all;
}

// The tree, searched depth first in this process.
class Search {
 public:
  Search(const problems::WedgedProblem& problem, double friction, const Strategy& strategy)
      : strategy_(strategy),
        friction_(friction),
        compliance_(problem.compliance.matrix / problems::mean_normal_compliance(problem)) {
    const std::vector<double> all(problem.contact_names.size(), friction);
    solver_.emplace(compliance_, all);
    candidates_ = (std::uint64_t{1} << all.size()) - 1;
  }

  void open(std::uint64_t contact, std::uint64_t separated) {
    ++nodes;
    const auto answer = solve(contact, separated);
    if (answer.sign == Sign::infeasible) return;
    const auto rest = candidates_ & ~(contact | separated);
    if (rest == 0) {
      found += answer.sign == Sign::feasible ? 1 : 0;
      return;
    }
    const auto ranked = rank(rest);
    auto best = ranked.front();
    double minimum = 1e300;
    for (std::size_t i = 0; i < static_cast<std::size_t>(strategy_.tried) && i < ranked.size();
         ++i) {
      const auto split = ranked[i];
      const auto touching = solve(contact | split, separated);
      if (touching.sign == Sign::infeasible) return close_and_open(contact, separated | split);
      const auto apart = solve(contact, separated | split);
      if (apart.sign == Sign::infeasible) return close_and_open(contact | split, separated);
      if (touching.upper + apart.upper < minimum) {
        minimum = touching.upper + apart.upper;
        best = split;
      }
    }
    open(contact | best, separated);
    open(contact, separated | best);
  }

  std::uint64_t nodes = 0;
  std::uint64_t programs = 0;
  std::uint64_t found = 0;

 private:
  conic::ConicResult solve(std::uint64_t contact, std::uint64_t separated) {
    ++programs;
    return solver_->solve(contact, separated);
  }

  // One child is infeasible and was just solved; the other replaces the node.
  void close_and_open(std::uint64_t contact, std::uint64_t separated) {
    ++nodes;
    open(contact, separated);
  }

  // Bits of the free candidates, best score first.
  [[nodiscard]] std::vector<std::uint64_t> rank(std::uint64_t rest) const {
    std::vector<std::pair<double, std::uint64_t>> scores;
    for (; rest != 0; rest &= rest - 1) {
      const Eigen::Index normal = 3 * std::countr_zero(rest);
      const auto own = compliance_.row(normal).segment(normal, 3);
      const Candidate candidate{std::max(0.0, solver_->displacement()[normal]),
                                std::max(0.0, solver_->reaction()[normal]), own[0],
                                own[0] + friction_ * own.tail(2).norm()};
      scores.emplace_back(-strategy_.score(candidate), rest & ~(rest - 1));
    }
    std::sort(scores.begin(), scores.end());
    std::vector<std::uint64_t> bits;
    bits.reserve(scores.size());
    for (const auto& [score, bit] : scores) bits.push_back(bit);
    return bits;
  }

  const Strategy& strategy_;
  double friction_;
  Eigen::MatrixXd compliance_;
  std::optional<conic::NodeSolver<3>> solver_;
  std::uint64_t candidates_ = 0;
};

struct Instance {
  problems::SpaceTrussSize size;
  double friction;
};

problems::WedgedProblem announced(const Instance& instance, const char* what) {
  const auto& [rows, depth, bays] = instance.size;
  fmt::print("\n{}: {} x {} candidates, {} bays, mu = {}\n", what, rows, depth, bays,
             instance.friction);
  return problems::wedged_problem(checked(problems::space_truss(instance.size)));
}

void measure_branching(const Instance& instance) {
  const auto problem = announced(instance, "branching");
  fmt::print("{:<24} {:>9} {:>13} {:>9} {:>18} {:>12}\n", "rule", "nodes", "cone programs",
             "patterns", "nodes a pattern", "CPU seconds");
  for (const auto& strategy : strategies()) {
    Search search(problem, instance.friction, strategy);
    const auto start = std::clock();
    search.open(0, 0);
    const auto seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const auto share = search.found == 0
                           ? std::string("-")
                           : fmt::format("{:.1f}", static_cast<double>(search.nodes) /
                                                       static_cast<double>(search.found));
    fmt::print("{:<24} {:>9} {:>13} {:>9} {:>18} {:>12.2f}\n", strategy.name, search.nodes,
               search.programs, search.found, share, seconds);
    std::fflush(stdout);
  }
}

void measure_facets(const Instance& instance) {
  const auto problem = announced(instance, "polyhedral friction");
  const std::vector<double> friction(problem.contact_names.size(), instance.friction);
  fmt::print("{:<10} {:>9} {:>13} {:>9} {:>12}\n", "facets", "nodes", "leaves tested", "patterns",
             "CPU seconds");
  for (const int facets : {4, 8, 16, 32, 0}) {
    wedged::SignPatternTree tree(problem, friction, {.tolerances = {}, .facets = facets});
    const auto start = std::clock();
    const auto outcome = engine::search(tree);
    const auto seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const auto tally = tree.tally();
    fmt::print("{:<10} {:>9} {:>13} {:>9} {:>12.2f}\n",
               facets == 0 ? "(cones)" : std::to_string(facets), outcome.opened(),
               facets == 0 ? "-" : std::to_string(tally.polyhedral_leaves), tally.found, seconds);
    std::fflush(stdout);
  }
}

// Estimates of the remaining time at each tenth of the run, compared with the true values.
void measure_estimates(const Instance& instance) {
  const auto problem = announced(instance, "time left");
  const std::vector<double> friction(problem.contact_names.size(), instance.friction);
  wedged::SignPatternTree tree(problem, friction);
  struct Estimate {
    double at, closed;
    std::optional<double> left;
  };
  std::vector<Estimate> estimates;
  run::RemainingTime remaining;
  engine::Options options;
  options.progress = [&](const auto& state) {
    remaining.observe(state.seconds, state.closed);
    estimates.push_back({state.seconds, state.closed, remaining.seconds()});
  };
  const auto outcome = engine::search(tree, options);
  const double whole = estimates.empty() ? 0 : estimates.back().at;
  fmt::print("{:>9} {:>9} {:>14} {:>14}   ({} nodes, {:.1f} s)\n", "of time", "of tree", "estimate",
             "true: s left", outcome.opened(), whole);
  int tenth = 1;
  for (const auto& [at, closed, left] : estimates) {
    if (at < 0.1 * tenth * whole || tenth == 10) continue;
    fmt::print("{:>7} % {:>7.1f} % {:>14} {:>14.1f}\n", 10 * tenth, 100 * closed,
               left ? fmt::format("{:.1f}", *left) : "-", whole - at);
    ++tenth;
  }
}

}  // namespace

// bench_patterns [branching | facets | time-left]: all three by default
int main(int count, char** words) {
  const std::string part = count > 1 ? words[1] : "";
  const auto wanted = [&](const char* name) { return part.empty() || part == name; };
  if (wanted("branching")) {
    for (const auto& instance :
         {Instance{{5, 2, 3}, 0.65}, Instance{{10, 2, 3}, 0.6}, Instance{{5, 4, 3}, 0.6},
          Instance{{6, 5, 3}, 0.5}, Instance{{15, 2, 3}, 0.5}})
      measure_branching(instance);
  }
  if (wanted("facets")) {
    for (const auto& instance : {Instance{{5, 2, 3}, 0.65}, Instance{{5, 2, 3}, 1.0},
                                 Instance{{5, 4, 3}, 0.6}, Instance{{15, 2, 3}, 0.5}})
      measure_facets(instance);
  }
  if (wanted("time-left")) {
    for (const auto& instance : {Instance{{15, 2, 3}, 0.55}, Instance{{6, 5, 3}, 0.5},
                                 Instance{{10, 4, 3}, 0.55}, Instance{{8, 5, 3}, 0.5}})
      measure_estimates(instance);
  }
}
