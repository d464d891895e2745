// Options of `kusabi patterns`.
#include <cstdint>

#include <fmt/format.h>

#include "nodes/wedged/relaxation/facets.hpp"
#include "run/command/option_table.hpp"
#include "run/output/wrong_input.hpp"
#include "run/patterns/patterns.hpp"
#include "run/wedged/cuts_words.hpp"
#include "run/wedged/whole_state_json.hpp"

namespace kusabi::run {

const OptionWords<wedged::Branching>& branching_words() {
  using wedged::Branching;
  static const OptionWords<Branching> words{{"auto", Branching::automatic},
                                            {"paper", Branching::product},
                                            {"relative", Branching::relative},
                                            {"deepest", Branching::deepest},
                                            {"weighed", Branching::weighed}};
  return words;
}

void PatternsOptions::describe(OptionTable& table) {
  table.problem(input.file);
  table.friction(friction).swept();
  describe_tree(table);
  describe_table(table);
  table.output();
  table.lines(lines,
              "format of the result file: one object (json), or a line per pattern (jsonl), for "
              "more than about 100,000 patterns. All ranks write the lines during the search, and "
              "memory does not grow with their number; an object takes 5 kB of memory per pattern");
  table.csv_of("patterns");
  table.pictures(vtu, "pattern", "patterns.pvd");
  table.whole_states(
      whole, "patterns",
      fmt::format("the first {} and the one with the largest margin", whole_unless_requested));
  describe_limits(table);
  table.file("--trace", trace, Role::output, "timeline of all ranks, for ui.perfetto.dev");
  table.file("--record", record, Role::output,
             "depth and CPU time of each node of a search in one process, from which kusabi bench "
             "scaling --trace predicts the time on many ranks");
  table.file("--certificate", certificate, Role::evidence, "certificate file, for kusabi verify");
  table.flag("--exists", exists,
             "find one pattern, or prove that there is none. Large decoupled subproblems are first "
             "searched without a tree");
  table.prove(prove, "test every node in exact arithmetic, as kusabi verify does");
  table.quiet_and_serial();
}

void PatternsOptions::describe_tree(OptionTable& table) {
  using wedged::FacetBound;
  // Lower limit: the digits of a double in a margin. Upper limit: larger values would leave nothing
  // to find.
  table.number("--tolerance", &tolerance, between(1e-12, 1e-3),
               "tolerance of margins: a node with |t*| up to this value is degenerate");
  table.choice(
      "--branching", branching, branching_words(),
      "branching rule: largest u_n r_n (paper), largest u_n r_n relative to the "
      "compliance (relative), largest decrease of the margins of both children (deepest), "
      "a weighted mean of relative and deepest (weighed), or the rule whose sampled tree is "
      "smallest (auto). The patterns are the same; the number of nodes differs");
  table.choice(
      "--cuts", tightening, cuts_words(),
      "cuts from bounds of the reaction and the gap of each candidate, computed before the "
      "search and added to every node: for constrained bodies with a large tree (auto), "
      "never (none), or always (always)");
  table.number(
      "--probe", &probes, between(0, 1000),
      "number of candidates that strong branching compares at each node. Strong branching gives "
      "fewer nodes and a smaller certificate, but takes more time; 8 candidates are enough");
  table.choice("--method", polyhedral, {{"cones", false}, {"polyhedral", true}},
               "friction cones of the search: second-order cones (cones), or polyhedral cones that "
               "contain them (polyhedral, Algorithm 5.8); the resulting patterns are then tested "
               "with second-order cones");
  Range even_facets = between(FacetBound::minimum, FacetBound::maximum);
  even_facets.even = true;
  table.number("--facets", &facets, even_facets, "number of facets of each cone")
      .needs("--method", "polyhedral");
  table
      .flag("--candidates", list_candidates,
            "list all patterns found with polyhedral cones, each with the result of its test")
      .needs("--method", "polyhedral")
      .varies();
}

// Order, groups and length of the table, and the order of the search.
void PatternsOptions::describe_table(OptionTable& table) {
  table
      .choice("--sort", sort,
              {{"number", PatternSort::number},
               {"margin", PatternSort::margin},
               {"contact", PatternSort::contact},
               {"critical", PatternSort::critical}},
              "order of the table: as found (number), largest margin first (margin), fewest "
              "candidates in contact first (contact), or smallest critical friction coefficient "
              "first (critical), which requires about ten cone programs per pattern")
      .varies();
  table
      .number(
          "--group", &group, between(0, 1000),
          "table with one row per group of patterns. Two patterns are in one group if their "
          "contact sets differ in at most this number of candidates, or if a chain of such pairs "
          "connects them. Groups are also in the result file. Default: no groups, but on a "
          "terminal more than 40 patterns are grouped around those with the largest margins; 0 "
          "lists all")
      .varies();
  table.top(top);
  // Order by the number of decided signs, see SignPatternTree::bound.
  table
      .choice("--order", order,
              {{"depth-first", engine::Order::depth_first},
               {"breadth-first", engine::Order::best_first}},
              "order in which nodes are opened. The patterns are the same; breadth-first requires "
              "more memory")
      .varies();
}

void PatternsOptions::describe_limits(OptionTable& table) {
  table.search_limits(limits);
  table
      .number("--pattern-limit", &limits.solutions, above(0),
              "number of patterns after which the search ends; a few more may be found")
      .stops(engine::Status::solution_limit)
      .varies();
  table.resume(checkpoint);
  table.former_names_of_resume();
}

void PatternsOptions::check(const OptionTable& table) const {
  if (lines) {
    table.check_lines({"--csv", "--vtu", "--whole", "--group", "--exists"});
    if (sort != PatternSort::number) table.check_lines({"--sort"});
  }
  if (exists && !certificate.empty()) {
    throw WrongInput(
        "--certificate: --exists writes no certificate; expected --certificate without --exists, "
        "or kusabi critical --certificate");
  }
  if (exists && sort == PatternSort::critical) {
    throw WrongInput(
        "--sort critical: --exists ends with one pattern; expected --sort critical without "
        "--exists, or kusabi critical");
  }
  if (probes > 0 && polyhedral) throw WrongInput("--probe: requires --method cones");
  const bool one_search_depth_first =
      !exists && checkpoint.state.empty() && order == engine::Order::depth_first;
  if (!record.empty() && !one_search_depth_first)
    throw WrongInput(
        "--record: is not possible with --exists, --resume or breadth-first order; "
        "expected depth-first order and neither of the others");
}

}  // namespace kusabi::run
