// The page docs/sentences.md: the answer and the reservations of representative runs of each command.
// `KUSABI_RENEW_PAGES=1 answer_tests --gtest_filter=Sentences*` writes the page.
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "all_verdicts.hpp"
#include "answer/ending.hpp"
#include "answer/values.hpp"
#include "answer/words.hpp"

namespace kusabi::answer {
namespace {

struct Run {
  std::string what;
  Verdict verdict;
};

struct Command {
  std::string name;
  std::vector<Run> runs;
};

Bound proved(double value) {
  return {value, Standing::proved};
}
Bound computed(double value) {
  return {value, Standing::computed};
}
Bracket proved(double lower, double upper) {
  return Bracket::proved(lower, upper);
}
Verdict stopped(AnyAnswer answer, engine::Status why = engine::Status::time_limit) {
  Verdict verdict{.ended = why, .answer = std::move(answer)};
  const bool counts_nodes = std::holds_alternative<Sticking>(verdict.answer) ||
                            std::holds_alternative<MixedOptimum>(verdict.answer);
  if (counts_nodes) verdict.nodes_left = 5;
  return verdict;
}

Command patterns() {
  const Sticking list{.friction = 0.65, .count = 27, .standing = Standing::proved};
  const auto with = [&](auto change) {
    auto other = list;
    change(other);
    return other;
  };
  const auto nine = with([](auto& found) { found.count = 9; });
  return {"patterns",
          {{"all patterns", {.answer = list}},
           {"one pattern, of an unconstrained body", {.answer = with([](auto& found) {
                                                        found.count = 1;
                                                        found.standing = Standing::computed;
                                                      })}},
           {"`--prove`", {.answer = with([](auto& found) {
                            found.grounds = Grounds::exact_arithmetic;
                            found.displacement_ratio = 1e6;
                          })}},
           {"degenerate nodes", {.answer = with([](auto& found) {
                                   found.standing = Standing::computed;
                                   found.degenerate = 4;
                                 })}},
           {"`--exists`, one is found", {.answer = with([](auto& found) {
                                           std::tie(found.count, found.example) =
                                               std::pair(1, true);
                                         })}},
           {"none", {.answer = with([](auto& found) { found.count = 0; })}},
           {"none, of an unconstrained body", {.answer = with([](auto& found) {
                                                 found.count = 0;
                                                 found.standing = Standing::computed;
                                               })}},
           {"stopped with nine", stopped(nine, engine::Status::node_limit)},
           {"stopped before the first", stopped(with([](auto& found) { found.count = 0; }))},
           {"undecided patterns", {.answer = with([](auto& found) {
                                     std::tie(found.count, found.undecided) = std::pair(9, 2);
                                   })}},
           {"stiffnesses that are far apart",
            {.answer = with([](auto& found) {
               found.count = 2;
               found.remainder = ExactRemainder{3e11, "the exact test was stopped early"};
             })}}}};
}

Command rays() {
  const Sticking list{.thing = "extremal ray",
                      .friction = 1,
                      .factor = true,
                      .count = 44,
                      .standing = Standing::computed};
  auto none = list;
  none.count = 0;
  auto ambiguous = list;
  ambiguous.ambiguous = true;
  auto proved = list;
  proved.proved_cones = 5;
  return {"rays",
          {{"all rays", {.answer = list}},
           {"proved", {.answer = proved}},
           {"none", {.answer = none}},
           {"stopped", stopped(list, engine::Status::node_limit)},
           {"undecided", {.answer = ambiguous}}}};
}

Command critical() {
  const CriticalBracket bracket{
      .bracket = proved(0.47027964, 0.47027965), .maximum = 1000, .width = 1e-8};
  const auto with = [&](Bracket own, bool wide = false) {
    auto other = bracket;
    other.bracket = own;
    other.wide = wide;
    return other;
  };
  auto by_solver = bracket;
  by_solver.grounds = Grounds::solver_bounds;
  auto list = bracket;
  list.patterns_open = true;
  return {
      "critical",
      {{"a bracket", {.answer = bracket}},
       {"bounds of the solver", {.answer = by_solver}},
       {"an upper bound that is computed", {.answer = with({proved(0.5), computed(0.50000001)})}},
       {"a lower bound that is computed", {.answer = with({computed(0.5), proved(0.50000001)})}},
       {"it cannot stick", {.answer = with({proved(1000), std::nullopt})}},
       {"stopped with a bracket", stopped(with({computed(0.0201), computed(0.6384)}, true))},
       {"stopped below the first pattern", stopped(with({proved(0.0201), std::nullopt}))},
       {"stopped without a lower bound", stopped(with({std::nullopt, proved(0.6384)}, true))},
       {"stopped without bounds", stopped(with({}))},
       {"undecided within the bracket", {.answer = with({proved(0.4702), proved(0.4703)}, true)}},
       {"`--list` is not complete", {.answer = list}}}};
}

Command hold() {
  const HoldingBracket bracket{.bracket = proved(0.33333333, 0.33333334), .maximum = 1000};
  const auto with = [&](Bracket own, HoldReason reason = HoldReason::searched) {
    return HoldingBracket{.bracket = own, .maximum = 1000, .reason = reason, .load_case = ""};
  };
  auto of_cases = bracket;
  of_cases.load_case = "wind";
  of_cases.cases = {{.name = "wind", .bracket = bracket.bracket},
                    {.name = "snow", .bracket = proved(0.1, 0.10000001)}};
  auto of_file = bracket;
  of_file.factor = true;
  return {
      "hold",
      {{"a bracket", {.answer = bracket}},
       {"an upper bound that is computed", {.answer = with({proved(0.4), computed(0.40000001)})}},
       {"without friction", {.answer = with({std::nullopt, proved(0)})}},
       {"it cannot hold the load", {.answer = with({proved(1000), std::nullopt})}},
       {"a load that nothing resists", {.answer = with({}, HoldReason::unbalanced)}},
       {"constrained bodies", {.answer = with({}, HoldReason::supports)}},
       {"all load cases", {.answer = of_cases}},
       {"coefficients in the file", {.answer = of_file}},
       {"stopped", stopped(with({proved(0.1), proved(0.9)}))},
       {"stopped without bounds", stopped(with({}))},
       {"undecided",
        {.answer = with({proved(0.33), std::nullopt}),
         .missing = {no_certificate(nothing_is_proved)}}},
       {"too large for a proof",
        {.answer = with({std::nullopt, computed(0.33)}),
         .missing = {no_certificate(stiffness_is_not_enclosed)}}}}};
}

HoldingFactors factors(double low, double high) {
  HoldingFactors found{.friction = 0.4, .outside = Standing::proved};
  found.intervals = {HoldingFactors::Interval::from(Standing::proved, proved(low - 1e-8, low),
                                                    proved(high, high + 1e-8))};
  return found;
}

Command hold_factors() {
  const auto held = factors(-0.62499999, 0.48295454);
  auto half = held;
  half.intervals.front().above = {};
  auto grip = held;
  grip.grip = HoldingGrip{.standing = Standing::proved,
                          .minimum = {computed(1.17), proved(1.18)},
                          .maximum = proved(1.5, 1.51)};
  auto computed_ends = held;
  computed_ends.intervals.front().standing = IntervalStanding::computed;
  computed_ends.outside = Standing::computed;
  HoldingFactors none{.friction = 0.4, .outside = Standing::proved};
  auto dead = none;
  dead.of_reference = false;
  const auto with_others = [](HoldingFactors found) {
    found.open = true;
    found.outside.reset();
    return found;
  };
  const auto open = with_others(none);
  const auto part = with_others(held);
  HoldingFactors wedged{.friction = 0.4, .reason = HoldReason::wedging};
  auto of_cases = held;
  of_cases.load_case = "wind";
  of_cases.cases = {{.name = "wind", .intervals = held.intervals, .outside = Standing::proved},
                    {.name = "snow", .intervals = half.intervals, .outside = Standing::proved}};
  auto of_none = none;
  of_none.load_case = "wind";
  of_none.cases = {{.name = "snow", .intervals = half.intervals, .outside = Standing::proved},
                   {.name = "wind", .outside = Standing::proved}};
  auto of_file = held;
  of_file.friction = 1;
  of_file.factor = true;
  const auto at = [](double friction, HoldingFactors found) {
    found.friction = friction;
    return found;
  };
  const auto total = [&](HoldingFactors found) {
    found.total = 4000;
    return found;
  };
  return {
      "hold --mu",
      {{"factors between two ends", {.answer = held}},
       {"factors without an end", {.answer = half}},
       {"`--total`", {.answer = total(held)}},
       {"ends that are computed", {.answer = computed_ends}},
       {"`--grip`, of which a bound is computed", {.answer = grip}},
       {"no factor", {.answer = none}},
       {"all load cases", {.answer = of_cases}},
       {"all load cases, of which one holds nothing", {.answer = of_none}},
       {"coefficients in the file", {.answer = of_file}},
       {"a dead load alone", {.answer = dead}},
       {"all factors, as it is wedged", {.answer = wedged}},
       {"stopped", stopped(part)},
       {"stopped without a state", stopped(open)},
       {"stopped during `--grip`",
        {.ended = engine::Status::time_limit, .answer = held, .missing = {no_grip_range}}},
       {"undecided patterns", {.answer = open}},
       {"undecided patterns besides a state", {.answer = part}},
       {"several coefficients",
        {.answer = HoldingSweep{.requested = 3, .points = {at(0.2, none), held, at(0.6, half)}}}},
       {"several coefficients, a dead load alone",
        {.answer = HoldingSweep{.requested = 2, .points = {at(0.2, dead), dead}}}},
       {"several coefficients, stopped",
        stopped(HoldingSweep{.requested = 3, .points = {at(0.2, none), held}})},
       {"several coefficients, stopped before the first", stopped(HoldingSweep{.requested = 3})}}};
}

Command hold_diagram() {
  const HoldingDiagram diagram{
      .friction = 0.5, .cases = {"moment", "side"}, .pieces = 8, .outside = Standing::proved};
  const auto with = [&](auto change) {
    auto other = diagram;
    change(other);
    return other;
  };
  const auto open = with([](auto& found) {
    found.open = true;
    found.outside.reset();
  });
  return {
      "hold --diagram",
      {{"pieces", {.answer = diagram}},
       {"none", {.answer = with([](auto& found) { found.pieces = 0; })}},
       {"all pairs", {.answer = with([](auto& found) {
                        found.everything = true;
                        found.outside.reset();
                      })}},
       {"pieces larger than drawn, and others that are computed", {.answer = with([](auto& found) {
                                                                     found.coarse = 2;
                                                                     found.outside =
                                                                         Standing::computed;
                                                                   })}},
       {"stopped", stopped(open)},
       {"undecided patterns", {.answer = open}}}};
}

Command sweep_friction() {
  const FrictionSteps steps{.maximum = 1, .infeasible = computed(0.47027964), .count = 31};
  const auto with = [&](auto change) {
    auto other = steps;
    change(other);
    return other;
  };
  return {"sweep --mu",
          {{"steps", {.answer = steps}},
           {"steps, with --prove",
            {.answer = with([](auto& found) { found.infeasible->standing = Standing::proved; })}},
           {"none", {.answer = with([](auto& found) {
                       std::tie(found.infeasible, found.count) = std::pair(computed(1), 0);
                     })}},
           {"stopped", stopped(with([](auto& found) {
              std::tie(found.infeasible, found.count) = std::pair(std::nullopt, 0);
            }))},
           {"undecided patterns", {.answer = with([](auto& found) {
                                     found.open_at_most = found.open_patterns = 2;
                                     found.undecided_points = 1;
                                   })}},
           {"stopped, with `--certificate`",
            {.ended = engine::Status::time_limit,
             .answer = with([](auto& found) {
               std::tie(found.infeasible, found.count) = std::pair(std::nullopt, 0);
             }),
             .missing = {no_certificate("the lists were not tested")}}}}};
}

Command sweep_loads() {
  const LoadSteps steps{.nominal = computed(2.7071067),
                        .half_width = 2,
                        .force = "kN",
                        .worst = proved(1.8827769, 1.8827770),
                        .minimum = proved(-2.6345771, -2.6345770),
                        .points = 3,
                        .points_asked = 3};
  const auto with = [&](Bracket worst, Bracket minimum = {}, bool open = false) {
    auto other = steps;
    std::tie(other.worst, other.minimum, other.open) = std::tuple(worst, minimum, open);
    return other;
  };
  auto none = with({});
  none.worst_at_none = Standing::proved;
  auto two = with({proved(1.8), proved(2.7)}, steps.minimum, true);
  two.points = 2;
  return {
      "sweep --alpha",
      {{"all points", {.answer = steps}},
       {"some load is not carried", {.answer = none}},
       {"no factor for all loads", {.answer = with(proved(0.5, 0.5), proved(1.2, 1.3))}},
       {"the nominal load is not carried",
        {.answer = LoadSteps{.nominal_at_none = Standing::proved, .points = 1, .points_asked = 1}}},
       {"stopped at a point with an open bracket", stopped(two)},
       {"stopped with an upper bound only", stopped(with({std::nullopt, computed(2.7)}, {}, true))},
       {"stopped before the first point", stopped(LoadSteps{.points_asked = 3, .open = true})},
       {"stopped, with `--certificate`",
        {.ended = engine::Status::time_limit,
         .answer = two,
         .missing = {no_certificate_of(1, "2 computed half-widths", not_all_is_proved)}}}}};
}

Command limit() {
  const LoadInterval nominal{.minimum = proved(-3.0000001, -3), .maximum = proved(2.7, 2.7000001)};
  const auto uncertain = [&](Bracket minimum, Bracket maximum) {
    return LoadInterval{.uncertain = LoadRange{2, "kN"}, .minimum = minimum, .maximum = maximum};
  };
  auto as_printed = uncertain({}, {computed(1.1), computed(1.2)});
  as_printed.if_big_m = true;
  auto struts = uncertain(proved(-1.1, -1), proved(0.4, 1.2));
  struts.struts = true;
  auto buckled = struts;
  buckled.minimum.upper = buckled.maximum.lower = std::nullopt;
  auto actions = uncertain(proved(-1.1, -1), proved(1.4, 1.4000001));
  actions.reference_action = "snow";
  actions.reference_factor = 1.5;
  actions.cases = 2;
  auto none = uncertain({}, {});
  none.carried_at_none = Standing::proved;
  auto dead = nominal;
  std::tie(dead.minimum, dead.maximum, dead.carried_at_none) =
      std::tuple(Bracket(), Bracket(), Standing::computed);
  auto part = nominal;
  part.incomplete = true;
  return {"limit",
          {{"without uncertainty", {.answer = nominal}},
           {"a dead load that needs a factor",
            {.answer = LoadInterval{.minimum = proved(0.5, 0.5), .maximum = proved(2.7, 2.7)}}},
           {"the dead load is not carried", {.answer = dead}},
           {"the worst case", {.answer = uncertain(proved(-2.7, -2.6), proved(1.88, 1.8800001))}},
           {"the worst case, below 1", {.answer = uncertain(proved(-2.7, -2.6), proved(0.8, 0.8))}},
           {"some load is not carried", {.answer = none}},
           {"no factor for all loads", {.answer = uncertain(proved(1.5, 1.5), proved(0.5, 0.5))}},
           {"combinations of actions in two load cases", {.answer = actions}},
           {"struts", {.answer = struts}},
           {"struts, of which no carried factor is known", stopped(buckled)},
           {"the program (29) as printed", {.answer = as_printed}},
           {"stopped without a nominal factor", stopped(LoadInterval())},
           {"stopped with bounds of the worst case",
            stopped(uncertain(proved(-2.7, -2.6), proved(1.8, 2.7)))},
           {"stopped with an upper bound of the worst case",
            stopped(uncertain({}, {std::nullopt, computed(2.7)}))},
           {"a worst case of which no upper bound is proved",
            {.answer = uncertain(proved(-2.7, -2.6), {proved(1.8), computed(1.8000001)})}},
           {"`--curve` is not complete", {.answer = part}}}};
}

Command limit_lose() {
  MemberLoss loss{.factor = proved(0.7071067, 0.7071068), .lost = {"a-b"}};
  const auto with = [&](auto change) {
    auto other = loss;
    change(other);
    return other;
  };
  return {
      "limit --lose",
      {{"the worst loss", {.answer = loss}},
       {"sudden, of two members, under uncertain loads", {.answer = with([](auto& found) {
                                                            found.maximum = 2;
                                                            found.lost = {"a-b", "c-d"};
                                                            found.uncertain = true;
                                                            found.sudden = 1.5;
                                                            found.kept = {"d0"};
                                                          })}},
       {"a loss after which nothing is carried",
        {.answer = with([](auto& found) { found.fatal = Standing::proved; })}},
       {"a target that remains", {.answer = with([](auto& found) {
                                    std::tie(found.target, found.reached) = std::pair(0.5, true);
                                  })}},
       {"a target that does not", {.answer = with([](auto& found) {
                                     std::tie(found.target, found.reached) = std::pair(0.8, false);
                                   })}},
       {"a target that is open", {.answer = with([](auto& found) { found.target = 0.7071067; })}},
       {"struts", {.answer = with([](auto& found) {
                     found.factor = proved(0.5, 0.7071068);
                     found.struts = true;
                   })}},
       {"struts, with a target that does not remain", {.answer = with([](auto& found) {
                                                         std::tie(found.target, found.reached,
                                                                  found.struts) =
                                                             std::tuple(0.8, false, true);
                                                       })}},
       {"stopped", stopped(with([](auto& found) { found.factor.lower = {}; }))},
       {"struts, stopped", stopped(with([](auto& found) {
          found.factor.lower = {};
          found.struts = true;
        }))},
       {"stopped before the first", stopped(MemberLoss())}}};
}

Command mip() {
  using enum MixedOptimum::State;
  const MixedOptimum optimum{
      .state = optimal, .standing = Standing::proved, .objective = -28, .bound = proved(-28)};
  const auto with = [&](auto change) {
    auto other = optimum;
    change(other);
    return other;
  };
  return {"mip",
          {{"the optimum", {.answer = optimum}},
           {"of a large program", {.answer = with([](auto& found) {
                                     found.standing = Standing::computed;
                                     found.bound = computed(-28);
                                     found.unproved = 1;
                                   })}},
           {"no point", {.answer = with([](auto& found) { found.state = infeasible; })}},
           {"no bound", {.answer = with([](auto& found) { found.state = unbounded; })}},
           {"stopped", stopped(with([](auto& found) {
              found.state = feasible;
              found.bound = proved(-31);
              found.gap = 0.107;
            }))},
           {"stopped without a point", stopped(MixedOptimum{.bound = computed(-31)})},
           {"undecided", {.answer = with([](auto& found) {
                            found.state = feasible;
                            found.unproved = 4;
                          })}}}};
}

Command verify() {
  using Check = CertificateCheck;
  const auto check = [](auto claim) { return Verdict{.answer = Check{.claim = std::move(claim)}}; };
  const Check::List list{.patterns = 27, .nodes = 237};
  return {"verify",
          {{"a list", check(list)},
           {"a list without patterns", check(Check::List{.nodes = 53})},
           {"a list with marginal nodes",
            check(Check::List{.patterns = 27, .nodes = 235, .undecided = 2})},
           {"an unconstrained body",
            check(Check::List{.patterns = 2, .nodes = 19, .displacement_ratio = 1e6})},
           {"an example", check(Check::Example{.patterns = 1})},
           {"states under load",
            check(Check::Held{.friction = 0.4,
                              .held = {proved(-0.625, 0.482)},
                              .none = {{{}, proved(-0.626)}, {proved(0.483), {}}}})},
           {"the worst case", check(Check::Factor{.loads = {2, "kN"},
                                                  .largest = proved(1.8827, 1.8828),
                                                  .minimum = proved(-2.63458, -2.63457)})},
           {"the loss of members",
            check(Check::Loss{.lost = {"a-b"}, .factor = proved(0.7071, 0.7072)})},
           {"a refused statement", {.answer = Check{.refusals = 1, .claim = list}}},
           {"stopped", stopped(Check{.claim = list}, engine::Status::interrupted)}}};
}

std::string page() {
  std::string text =
      "# Sentences\n\n"
      "Each answer is a sentence, followed by its reservations: what is open, then what is "
      "computed\n"
      "only. Table, result file and report have the same sentences. Here they are of "
      "representative\n"
      "runs of each command, with the exit code. Commands add details, such as the first pattern\n"
      "([result files](result-files.md#printed-output)); a certificate that is verified has no "
      "result\n"
      "file. A run that fails (exit code 1 or 2) has one line with its reason instead of an "
      "answer.\n\n"
      "The page is written, and compared with the code, by a test "
      "(`Sentences.AreThoseOfThePage`).\n";
  for (const auto& [command, runs] :
       {patterns(), rays(), critical(), hold(), hold_factors(), hold_diagram(), sweep_friction(),
        sweep_loads(), limit(), limit_lose(), mip(), verify()}) {
    text += fmt::format("\n## {}\n", command);
    for (const auto& [what, verdict] : runs) {
      text += fmt::format("\n{} (exit code {}):\n\n```text\n{}\n", what,
                          static_cast<int>(exit_code(verdict)), headline(verdict));
      for (const auto& each : reservations(verdict)) text += each.sentence + '\n';
      text += "```\n";
    }
  }
  return text;
}

TEST(Sentences, AreThoseOfThePage) {
  const auto file = std::string(KUSABI_SOURCE_DIR) + "/docs/sentences.md";
  if (std::getenv("KUSABI_RENEW_PAGES") != nullptr) std::ofstream(file) << page();
  std::ifstream in(file);
  const std::string written{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(written, page())
      << "KUSABI_RENEW_PAGES=1 answer_tests --gtest_filter=Sentences* writes it";
}

TEST(Sentences, AreNotSaidTwice) {
  for (const auto& verdict : testing::all_verdicts()) {
    std::set<std::string> said{headline(verdict)};
    for (const auto& each : reservations(verdict))
      EXPECT_TRUE(said.insert(each.sentence).second) << each.sentence;
  }
}

}  // namespace
}  // namespace kusabi::answer
