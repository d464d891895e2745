// All combinations of the values of the members.
#include "all_verdicts.hpp"

#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>

namespace kusabi::answer::testing {
namespace {

using Standings = std::initializer_list<std::optional<Standing>>;
constexpr auto all_grounds = {Grounds::exact_arithmetic, Grounds::solver_bounds};
constexpr Standings standings{std::nullopt, Standing::computed, Standing::proved};

const std::initializer_list<std::optional<ExactRemainder>> remainders{
    std::nullopt, ExactRemainder{.scale_ratio = 3e11, .why = "the exact test leaves patterns open"},
    ExactRemainder{.scale_ratio = 1, .nodes = 1}};

std::optional<double> ratio_of(Grounds grounds) {
  if (grounds == Grounds::solver_bounds) return std::nullopt;
  return 0x1p20;
}

std::optional<Bound> bound(double value, std::optional<Standing> standing) {
  if (!standing) return std::nullopt;
  return Bound{value, *standing};
}

std::vector<Bracket> brackets(double lower, double upper) {
  std::vector<Bracket> all;
  for (const auto& below : standings) {
    for (const auto& above : standings) all.push_back({bound(lower, below), bound(upper, above)});
  }
  return all;
}

void add_sticking(std::vector<AnyAnswer>& all) {
  for (const char* const count : {"0", "1", "27", "18446744073709551616"}) {
    for (const std::uint64_t undecided : {0U, 1U, 6U}) {
      for (const auto standing : {Standing::computed, Standing::proved}) {
        for (const bool ambiguous : {false, true}) {
          for (const auto& remainder : remainders) {
            for (const auto grounds : all_grounds) {
              all.push_back(Sticking{.thing = "way",
                                     .friction = 0.65,
                                     .factor = ambiguous,
                                     .count = *support::ExactCount::read(count),
                                     .undecided = undecided,
                                     .standing = standing,
                                     .grounds = grounds,
                                     .degenerate = standing == Standing::computed ? undecided : 0,
                                     .ambiguous = ambiguous,
                                     .remainder = remainder,
                                     .displacement_ratio = ratio_of(grounds)});
            }
          }
        }
      }
    }
  }
}

void add_critical(std::vector<AnyAnswer>& all) {
  for (const double lower : {0.47027123, 1000.0}) {
    for (const auto& bracket : brackets(lower, 0.47027124)) {
      if (lower > 1 && bracket.upper) continue;  // would lie below the lower bound
      for (const bool wide : {false, true}) {
        for (const bool open : {false, true}) {
          if ((wide || open) && !bracket.upper) continue;
          all.push_back(CriticalBracket{
              .bracket = bracket,
              .factor = open,
              .maximum = 1000,
              .width = 1e-8,
              .wide = wide || (bracket.upper && !bracket.lower),
              .patterns_open = open,
              .grounds = open ? Grounds::solver_bounds : Grounds::exact_arithmetic,
              .displacement_ratio =
                  ratio_of(wide ? Grounds::solver_bounds : Grounds::exact_arithmetic)});
        }
      }
    }
  }
}

void add_holding_brackets(std::vector<AnyAnswer>& all) {
  for (const double lower : {0.33333332, 1000.0}) {
    for (const auto& bracket : brackets(lower, 0.33333334)) {
      if (lower > 1 && bracket.upper) continue;  // would lie below the lower bound
      for (const bool factor : {false, true})
        all.push_back(HoldingBracket{.bracket = bracket,
                                     .factor = factor,
                                     .maximum = 1000,
                                     .load_case = factor ? "wind" : ""});
    }
  }
  for (const auto standing : {Standing::computed, Standing::proved})
    all.push_back(HoldingBracket{.bracket = {std::nullopt, Bound{0, standing}}, .maximum = 1000});
  for (const auto reason : {HoldReason::supports, HoldReason::unbalanced})
    all.push_back(HoldingBracket{.maximum = 1000, .reason = reason});
}

HoldingFactors::Interval interval(double low, double high, Standing standing) {
  return HoldingFactors::Interval::from(standing, {std::nullopt, Bound{low, standing}},
                                        {Bound{high, standing}, std::nullopt});
}

void add_grips(std::vector<AnyAnswer>& all) {
  HoldingFactors factors{.friction = 0.4, .intervals = {interval(-1, 2, Standing::proved)}};
  for (const auto standing : {Standing::computed, Standing::proved}) {
    factors.grip = HoldingGrip{.held = false, .standing = standing};
    all.push_back(factors);
    HoldingGrip grip{.minimum = {Bound{3, standing}, Bound{4, Standing::proved}}};
    for (const bool unbounded : {false, true}) {
      grip.unbounded = unbounded;
      grip.unbounded_standing = standing;
      if (!unbounded) grip.maximum = {Bound{5, Standing::proved}, Bound{6, standing}};
      factors.grip = grip;
      all.push_back(factors);
      grip.maximum = {};
    }
  }
}

void add_diagrams(std::vector<AnyAnswer>& all) {
  for (const std::uint64_t pieces : {0U, 1U, 3U}) {
    for (const auto standing : {Standing::computed, Standing::proved}) {
      for (const bool open : {false, true}) {
        HoldingDiagram diagram{
            .friction = 0.5, .cases = {"moment", "side"}, .pieces = pieces, .open = open};
        if (!open) diagram.outside = standing;
        all.push_back(diagram);
        if (pieces == 0) continue;
        diagram.coarse = pieces;
        all.push_back(diagram);
        diagram.everything = true;
        diagram.outside.reset();
        all.push_back(diagram);
      }
    }
  }
}

void add_holding(std::vector<AnyAnswer>& all) {
  for (const auto standing : {Standing::computed, Standing::proved}) {
    for (const bool open : {false, true}) {
      for (const bool reference : {false, true}) {
        HoldingFactors none{.friction = 0.4, .of_reference = reference, .open = open};
        if (!open) none.outside = standing;
        HoldingFactors held = none;
        held.friction = 0.5;
        held.intervals = {HoldingFactors::Interval::from(standing, {}, {})};
        held.outside.reset();
        HoldingFactors other = none;
        other.friction = 0.45;
        HoldingFactors some = none;
        some.friction = 0.45;
        some.load_case = "wind";
        some.total = 2;
        some.intervals = {interval(-1, 2, standing)};
        all.insert(all.end(), {none, held});
        if (reference) all.push_back(some);
        for (const std::uint64_t requested : {3U, 4U})
          all.push_back(HoldingSweep{.requested = requested,
                                     .points = {none, reference ? some : other, held}});
      }
    }
  }
  for (const auto reason : {HoldReason::supports, HoldReason::unbalanced})
    all.push_back(HoldingSweep{.requested = 2,
                               .points = {HoldingFactors{.friction = 0.1, .reason = reason},
                                          HoldingFactors{.friction = 0.2, .reason = reason}}});
  all.push_back(HoldingSweep{.requested = 2});
}

void add_steps(std::vector<AnyAnswer>& all) {
  for (const auto& standing : standings) {
    for (const char* const count : {"0", "1", "340282366920938463463374607431768211456"}) {
      for (const std::uint64_t open : {0U, 1U, 3U}) {
        for (const auto& remainder : remainders) {
          all.push_back(FrictionSteps{.maximum = 2,
                                      .factor = false,
                                      .infeasible = bound(count[0] == '0' ? 2 : 0.5, standing),
                                      .count = *support::ExactCount::read(count),
                                      .open_at_most = open,
                                      .open_patterns = open,
                                      .undecided_points = open,
                                      .remainder = remainder});
        }
      }
    }
  }
}

void add_loads(std::vector<AnyAnswer>& all) {
  const std::initializer_list<std::optional<LoadRange>> ranges{
      std::nullopt, LoadRange{0.45, "kN"}, LoadRange{0.5, std::nullopt}, LoadRange{}};
  for (const auto& loads : ranges) {
    for (const bool condition : {false, true}) {
      for (const auto& maximum : brackets(1.1162, 1.1163)) {
        for (const auto& minimum : brackets(-0.7, -0.6)) {
          all.push_back(LoadInterval{loads, minimum, maximum, std::nullopt, condition, condition});
        }
        for (const auto& minimum : brackets(2.1, 2.2))  // above the other end: empty
          all.push_back(LoadInterval{loads, minimum, maximum, std::nullopt, condition, false});
      }
      for (const auto standing : {Standing::computed, Standing::proved})
        all.push_back(LoadInterval{loads, {}, {}, standing, condition, false});
    }
  }
  for (const auto& nominal : standings) {
    for (const auto& worst : brackets(1.1, 1.2)) {
      for (const bool open : {false, true}) {
        LoadSteps steps{.nominal = bound(1.85, nominal),
                        .half_width = 2,
                        .worst = worst,
                        .points = 3,
                        .points_asked = open ? 5U : 3U,
                        .open = open || !worst.lower || !worst.upper};
        for (const double above : {0.4, 2.1}) {
          steps.minimum = {bound(above - 0.1, nominal), bound(above, nominal)};
          all.push_back(steps);
        }
        steps.minimum = {};
        all.push_back(steps);
        steps.worst = {};
        steps.worst_at_none = nominal;
        steps.open = !nominal;
        all.push_back(steps);
      }
    }
  }
}

void add_losses(std::vector<AnyAnswer>& all) {
  for (const auto& factor : brackets(0.7, 0.71)) {
    for (const std::uint64_t maximum : {1U, 2U}) {
      MemberLoss loss{.maximum = maximum, .factor = factor, .lost = {"a-b"}};
      all.push_back(loss);
      for (const std::optional<bool> reached : {std::optional<bool>(), {true}, {false}}) {
        loss.target = 0.8;
        // A target is missed only at a proved upper bound.
        loss.reached = reached;
        if (reached == false && (!factor.upper || factor.upper->standing == Standing::computed))
          continue;
        all.push_back(loss);
      }
    }
  }
  for (const auto standing : {Standing::computed, Standing::proved})
    all.push_back(MemberLoss{.maximum = 2, .fatal = standing, .lost = {"a-b", "c-d"}});
}

void add_programs(std::vector<AnyAnswer>& all) {
  using enum MixedOptimum::State;
  for (const auto state : {optimal, feasible, infeasible, unbounded, unknown}) {
    for (const auto& standing : standings) {
      for (const std::uint64_t unproved : {0U, 1U, 4U}) {
        const bool point = state == optimal || state == feasible;
        all.push_back(MixedOptimum{.state = state,
                                   .standing = standing.value_or(Standing::computed),
                                   .maximise = unproved == 1,
                                   .objective = point ? std::optional(-28.0) : std::nullopt,
                                   .bound = bound(-31, standing),
                                   .gap = point ? 0.1 : 0,
                                   .unproved = unproved});
      }
    }
  }
}

void add_certificates(std::vector<AnyAnswer>& all) {
  for (const std::uint64_t refusals : {0U, 2U}) {
    for (const std::uint64_t undecided : {0U, 1U, 6U}) {
      for (const std::uint64_t nodes : {0U, 9U})
        all.push_back(CertificateCheck{
            refusals,
            CertificateCheck::List{.patterns = 0, .nodes = nodes, .undecided = undecided}});
    }
    all.push_back(CertificateCheck{
        refusals, CertificateCheck::List{.patterns = 2, .nodes = 9, .displacement_ratio = 1e6}});
    all.push_back(CertificateCheck{refusals, CertificateCheck::Example{.patterns = 1}});
    all.push_back(
        CertificateCheck{refusals, CertificateCheck::Factor{.largest = Bracket::proved(1, 1.1)}});
  }
  for (const bool agrees : {false, true}) all.push_back(Measurement{agrees});
}

}  // namespace

std::vector<Verdict> all_verdicts() {
  std::vector<AnyAnswer> answers{std::monostate()};
  add_sticking(answers);
  add_critical(answers);
  add_holding_brackets(answers);
  add_holding(answers);
  add_grips(answers);
  add_diagrams(answers);
  add_steps(answers);
  add_loads(answers);
  add_losses(answers);
  add_programs(answers);
  add_certificates(answers);
  std::vector<Verdict> all;
  using enum engine::Status;
  for (const auto& answer : answers) {
    for (const auto ended :
         {solved, time_limit, node_limit, solution_limit, gap_limit, interrupted}) {
      for (const bool more : {false, true}) {
        Verdict verdict{.ended = ended, .answer = answer};
        if (ended != solved && !more) verdict.nodes_left = 3;
        if (more) {
          verdict.details = {"One way is pattern 1, with contact at tip."};
          verdict.missing = {"No certificate was written."};
          verdict.warnings = {"a.toml:3:1: a load is not part of the question"};
        }
        all.push_back(std::move(verdict));
      }
    }
  }
  return all;
}

}  // namespace kusabi::answer::testing
