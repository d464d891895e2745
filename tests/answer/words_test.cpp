// Properties of the sentences of every verdict, and some sentences in full.
#include "answer/words.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "all_verdicts.hpp"
#include "answer/answer_words.hpp"
#include "answer/ending.hpp"
#include "answer/verdict_json.hpp"
#include "run/output/terminal_page.hpp"

namespace kusabi::answer {
namespace {

using testing::all_verdicts;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string all_words(const Verdict& verdict) {
  auto text = headline(verdict);
  for (const auto& each : reservations(verdict)) text += '\n' + each.sentence;
  return text;
}

bool is_computed(const std::optional<Bound>& bound) {
  return bound && bound->standing == Standing::computed;
}

bool is_refuted(const std::optional<ExactRemainder>& remainder) {
  return remainder && !remainder->why.empty();
}

/// True if a bound in the headline is not proved.
bool names_what_is_not_proved(const Verdict& verdict) {
  if (const auto* const found = std::get_if<CriticalBracket>(&verdict.answer))
    return is_computed(found->bracket.lower) || is_computed(found->bracket.upper);
  if (const auto* const found = std::get_if<FrictionSteps>(&verdict.answer))
    return is_computed(found->infeasible) && !is_refuted(found->remainder);
  if (const auto* const found = std::get_if<LoadInterval>(&verdict.answer)) {
    if (found->carried_at_none) return found->carried_at_none == Standing::computed;
    const bool empty = found->minimum.lower && found->maximum.upper &&
                       found->minimum.lower->value > found->maximum.upper->value;
    return empty ? is_computed(found->minimum.lower) || is_computed(found->maximum.upper)
                 : is_computed(found->maximum.lower);
  }
  if (const auto* const found = std::get_if<HoldingBracket>(&verdict.answer))
    return is_computed(found->bracket.lower) || is_computed(found->bracket.upper);
  if (const auto* const found = std::get_if<HoldingDiagram>(&verdict.answer)) {
    return found->outside == Standing::computed && !found->open && !found->everything &&
           verdict.ended == engine::Status::solved;
  }
  if (const auto* const found = std::get_if<MemberLoss>(&verdict.answer)) {
    if (found->fatal) return found->fatal == Standing::computed;
    return !found->target && (is_computed(found->factor.lower) || is_computed(found->factor.upper));
  }
  if (const auto* const found = std::get_if<LoadSteps>(&verdict.answer)) {
    return found->nominal_at_none == Standing::computed || is_computed(found->nominal);
  }
  if (const auto* const found = std::get_if<MixedOptimum>(&verdict.answer)) {
    using enum MixedOptimum::State;
    return found->state != infeasible && found->state != unbounded && is_computed(found->bound);
  }
  return false;
}

TEST(Verdicts, MarkEveryBoundThatIsNotProved) {
  for (const auto& verdict : all_verdicts()) {
    if (names_what_is_not_proved(verdict)) {
      const auto sentence = headline(verdict);
      EXPECT_TRUE(has(sentence, "computed, not proved") || has(sentence, "numerically undecided"))
          << all_words(verdict);
    }
  }
}

TEST(Verdicts, BeginWithACapital) {
  for (const auto& verdict : all_verdicts()) {
    const auto sentence = headline(verdict);
    EXPECT_TRUE(sentence.empty() || std::isupper(static_cast<unsigned char>(sentence.front())) != 0)
        << sentence;
  }
}

TEST(Verdicts, ClaimThatItCannotStickOnlyAfterACompleteSearchOrWithALowerBound) {
  for (const auto& verdict : all_verdicts()) {
    const auto sentence = headline(verdict);
    if (!has(sentence, "annot stick")) continue;
    if (const auto* const list = std::get_if<Sticking>(&verdict.answer)) {
      EXPECT_EQ(verdict.ended, engine::Status::solved) << sentence;
      EXPECT_EQ(list->undecided, 0U) << sentence;
      EXPECT_EQ(list->count, support::ExactCount(0)) << sentence;
      EXPECT_FALSE(list->remainder.has_value()) << sentence;
    } else if (const auto* const found = std::get_if<CriticalBracket>(&verdict.answer)) {
      EXPECT_TRUE(found->bracket.lower.has_value()) << sentence;
    } else if (const auto* const steps = std::get_if<FrictionSteps>(&verdict.answer)) {
      EXPECT_TRUE(steps->infeasible.has_value()) << sentence;
      EXPECT_FALSE(is_refuted(steps->remainder)) << sentence;
    }
  }
}

TEST(Verdicts, HaveAnExitCodeConsistentWithTheirReservations) {
  for (const auto& verdict : all_verdicts()) {
    const auto said = reservations(verdict);
    const bool open = std::ranges::any_of(said, &Reservation::open);
    const auto code = exit_code(verdict);
    if (code != failed) {
      EXPECT_EQ(code, open ? stopped_early : solved) << all_words(verdict);
    }
    if (verdict.ended != engine::Status::solved) {
      EXPECT_TRUE(open) << all_words(verdict);
    }
    EXPECT_EQ(is_answered(verdict), !open) << all_words(verdict);
    for (const auto& each : said) EXPECT_TRUE(each.sentence.ends_with('.')) << each.sentence;
  }
}

TEST(Verdicts, HaveAStatusThatAgreesWithTheExitCode) {
  for (const auto& verdict : all_verdicts()) {
    const auto status = status_text(verdict);
    if (exit_code(verdict) == solved) {
      EXPECT_TRUE(status == "solved" || status == "not-carried") << status;
    }
    if (verdict.ended != engine::Status::solved) {
      EXPECT_NE(status, "solved");
    }
  }
}

TEST(Verdicts, UseSingularAndPlural) {
  for (const auto& verdict : all_verdicts()) {
    const auto words = all_words(verdict);
    for (const char* const wrong : {" are 1 ", " 1 ways", " 1 sign patterns", " 1 patterns",
                                    " 1 nodes", " 1 open nodes", " 1 marginal nodes"})
      EXPECT_FALSE(has(words, wrong)) << words;
  }
}

TEST(Verdicts, AreWrittenWithTheirSentences) {
  for (const auto& verdict : all_verdicts()) {
    const auto written = verdict_json(verdict);
    EXPECT_EQ(written["sentence"], headline(verdict));
    EXPECT_EQ(written["details"], verdict.details);
    std::vector<std::string> sentences;
    for (const auto& each : reservations(verdict)) sentences.push_back(each.sentence);
    EXPECT_EQ(written["reservations"], sentences);
    EXPECT_EQ(written["exit_code"], static_cast<int>(exit_code(verdict)));
  }
}

TEST(Verdicts, ArePrintedCompletelyBelowTables) {
  for (const auto& verdict : all_verdicts()) {
    const auto text = run::conclusion_text(verdict, {});
    EXPECT_TRUE(has(text, headline(verdict)));
    for (const auto& each : reservations(verdict)) EXPECT_TRUE(has(text, each.sentence));
    for (const auto& each : verdict.warnings) EXPECT_TRUE(has(text, "Warning: " + each));
  }
}

Verdict critical(Bracket bracket, engine::Status ended = engine::Status::solved) {
  return {.ended = ended,
          .answer = CriticalBracket{.bracket = bracket, .maximum = 1000, .width = 1e-8}};
}

TEST(CriticalWords, QualifyEachBoundSeparately) {
  const Bound lower{0.5, Standing::proved}, upper{0.6, Standing::computed};
  EXPECT_EQ(headline(critical({lower, upper}, engine::Status::time_limit)),
            "It cannot stick below friction coefficient 0.5; at 0.6 it can (computed, not "
            "proved); in between, this is not known.");
  EXPECT_EQ(
      headline(critical({std::nullopt, upper})),
      "It can stick at friction coefficient 0.6 (computed, not proved); below it, this is not "
      "known.");
  EXPECT_EQ(headline(critical({lower, std::nullopt})),
            "It cannot stick up to friction coefficient 0.5; above it, this is not known.");
}

TEST(StickingWords, CountBeyondEveryInteger) {
  EXPECT_EQ(
      headline({.answer = Sticking{.friction = 2,
                                   .count = *support::ExactCount::read("18446744073709551616"),
                                   .standing = Standing::proved}}),
      "It can stick in 18446744073709551616 ways at friction coefficient 2.");
}

TEST(StickingWords, CountNoPatternThatTheExactTestHasNotProved) {
  const Verdict verdict{
      .answer = Sticking{.friction = 0.5,
                         .count = 1,
                         .standing = Standing::proved,
                         .remainder = ExactRemainder{3e11, "the exact test was stopped early", 0}}};
  EXPECT_EQ(headline(verdict), "It is not known whether it can stick at friction coefficient 0.5.");
  EXPECT_EQ(exit_code(verdict), stopped_early);
}

TEST(StickingWords, NameTheGroundsOfAProof) {
  Sticking list{.friction = 0.5, .count = 2, .standing = Standing::proved};
  EXPECT_THAT(all_words({.answer = list}), HasSubstr("Proved by the bounds of the solver"));
  list.grounds = Grounds::exact_arithmetic;
  EXPECT_THAT(all_words({.answer = list}), Not(HasSubstr("bounds of the solver")));
  const auto proved = Bracket::proved(0.5, 0.6);
  CriticalBracket bracket{.bracket = proved, .maximum = 1000, .width = 1e-8};
  EXPECT_THAT(all_words({.answer = bracket}), Not(HasSubstr("bounds of the solver")));
  bracket.grounds = Grounds::solver_bounds;
  const Verdict verdict{.answer = bracket};
  EXPECT_THAT(all_words(verdict), HasSubstr("Proved by the bounds of the solver"));
  EXPECT_EQ(answer_json(verdict)["grounds"], "solver-bounds");
  EXPECT_EQ(exit_code(verdict), solved);
}

TEST(StickingWords, DistinguishProvedConesFromComputedRays) {
  Sticking rays{.thing = "extremal ray",
                .friction = 0.5,
                .count = 7,
                .standing = Standing::computed,
                .proved_cones = 3};
  EXPECT_THAT(
      all_words({.answer = rays}),
      AllOf(HasSubstr("with 7 extremal rays in 3 maximal cones; exact arithmetic proves these "
                      "cones, and that there is no other."),
            HasSubstr("The rays themselves are computed in floating point, not proved.")));
  EXPECT_EQ(answer_json({.answer = rays})["proved_cones"], 3);
  rays.proved_cones.reset();
  EXPECT_THAT(all_words({.answer = rays}), HasSubstr("not proved in exact arithmetic"));
}

TEST(StickingWords, CountDegenerateNodes) {
  const Verdict verdict{
      .answer =
          Sticking{.friction = 0.5, .count = 2, .standing = Standing::computed, .degenerate = 5}};
  EXPECT_THAT(all_words(verdict), HasSubstr("of 5 degenerate nodes, with a margin of zero, nothing "
                                            "is proved"));
  EXPECT_EQ(exit_code(verdict), solved);
}

TEST(LoadWords, ReportTheGuaranteedIntervalOfASweep) {
  const auto proved = Bracket::proved(1.5, 1.5);
  LoadSteps steps{.nominal = Bound{3, Standing::computed},
                  .half_width = 1.5,
                  .worst = proved,
                  .minimum = Bracket::proved(0.5, 0.5),
                  .points = 1,
                  .points_asked = 1};
  EXPECT_THAT(headline({.answer = steps}),
              HasSubstr("the worst case is 1.5, proved; factors from "
                        "0.5 to 1.5 are carried under all admissible loads."));
  steps.minimum = Bracket::proved(2, 2);
  EXPECT_THAT(headline({.answer = steps}),
              HasSubstr("there is no load factor that is carried under all admissible loads."));
  steps.worst.upper = Bound{1.50000001, Standing::proved};
  EXPECT_THAT(
      headline({.answer = steps}),
      HasSubstr("the worst case is between 1.5 and 1.5000001, proved; there is no load factor"));
  steps.minimum = {};
  EXPECT_THAT(headline({.answer = steps}), HasSubstr("is open"));
}

// Carried up to 0.4 after buckling, and to 1.2 at most.
TEST(LoadWords, PassStrutsByTheirResidualStrength) {
  const auto bound = [](double value) { return Bound{value, Standing::proved}; };
  LoadInterval interval{.uncertain = LoadRange{40, "kN"},
                        .minimum = {bound(-3), bound(-1)},
                        .maximum = {bound(0.4), bound(1.2)},
                        .struts = true};
  const auto sentence = [&] { return headline({.answer = interval}); };
  EXPECT_EQ(
      sentence(),
      "It carries every factor from -1 to 0.4 of the reference load, for every dead load "
      "within ± 40 kN, while no strut falls below its residual strength; even with all struts at "
      "full strength some admissible load is carried at no factor above 1.2. Open: whether every "
      "factor from 0 to 1 is carried.");
  interval.maximum.upper = bound(0.9);
  EXPECT_THAT(sentence(), HasSubstr("Not passed"));
  interval.maximum = {bound(1.1), bound(1.2)};
  EXPECT_THAT(sentence(), HasSubstr(" Passed"));
  interval.maximum.lower = std::nullopt;
  EXPECT_THAT(sentence(), ::testing::StartsWith(
                              "With all struts at their residual strength no load factor was "
                              "found that it carries for every dead load within ± 40 kN; even "
                              "with all struts at full strength some admissible load is "
                              "carried at no factor above 1.2."));
}

TEST(LoadWords, SayThatADeadLoadAloneIsNotCarried) {
  LoadInterval nominal;
  nominal.maximum.lower = nominal.maximum.upper = Bound{-0.5, Standing::computed};
  EXPECT_EQ(headline({.answer = nominal}),
            "The largest factor of the reference load that it carries is at least -0.5 (computed, "
            "not proved); no factor above -0.5 is carried (computed, not proved).");
  nominal.minimum = Bracket::proved(-3.000001, -3);
  EXPECT_EQ(
      headline({.answer = nominal}),
      "It carries its dead load at load factors from -3 to -0.5, and at none below -3.0001 or "
      "above -0.5 (computed, not proved).");
  const MemberLoss loss{.factor = {{}, Bound{-0.5, Standing::proved}}, .lost = {"a-b"}};
  EXPECT_EQ(headline({.answer = loss}),
            "After the loss of a-b it carries its dead load only at load factors up to -0.5.");
}

TEST(LoadWords, OfSeveralCasesHoldForFactorsThatAllCasesCarry) {
  const auto both = [](double value) {
    const Bound bound{value, Standing::computed};
    return Bracket{bound, bound};
  };
  const auto sentence = [&](const Bracket& minimum, const Bracket& maximum) {
    return headline({.answer = LoadInterval{.minimum = minimum, .maximum = maximum, .cases = 2}});
  };
  EXPECT_EQ(sentence(both(-1), both(3)),
            "It carries 3 times the reference load in each of 2 load cases, and no more "
            "(computed, not proved).");
  EXPECT_EQ(
      sentence(both(4), both(3)),
      "There is no load factor that it carries in all of 2 load cases (computed, not proved).");
  const auto between = [](double lower, double upper) { return Bracket::proved(lower, upper); };
  EXPECT_EQ(sentence(between(2.9, 3.1), between(3, 3.05)),
            "It is numerically undecided whether any load factor is carried in all of 2 load "
            "cases.");
  EXPECT_EQ(sentence(between(-1.1, -1), between(2.99999999, 3.00000001)),
            "It carries 2.9999 times the reference load in each of 2 load cases, but no "
            "more than 3.0001 times.");
  EXPECT_EQ(sentence({}, both(3)),
            "No load factor was found at which it carries its dead load in each of 2 load cases; "
            "the load of some case is carried at no factor above 3 (computed, not proved).");
}

TEST(LoadWords, CallADeadLoadWithoutUncertaintyByItsName) {
  const auto one = Bracket::proved(1, 1);
  EXPECT_EQ(headline({.answer = LoadInterval{.uncertain = LoadRange{0, "kN"},
                                             .minimum = {},
                                             .maximum = one,
                                             .cases = 2}}),
            "The largest factor of the reference load that it carries is at least 1, under its "
            "dead load, in each of 2 load cases; the load of some case is carried at no factor "
            "above 1.");
}

// Of a factor above the upper bound it is known that one admissible load is not carried, and no
// more.
TEST(LoadWords, SayOfWhichLoadsAFactorIsABound) {
  LoadInterval interval{.uncertain = LoadRange{2, "kN"},
                        .minimum = {},
                        .maximum = {Bound{1}, Bound{1.00001}},
                        .if_big_m = true};
  const auto sentence = [&] { return headline({.answer = interval}); };
  EXPECT_EQ(sentence(),
            "The largest factor of the reference load that it carries is at least 1 if M is large "
            "enough (computed, not proved), for every dead load within ± 2 kN; some admissible "
            "load is carried at no factor above 1.0001 if M is large enough (computed, not "
            "proved).");
  interval = {.uncertain = LoadRange{}, .maximum = Bracket::proved(2, 3)};
  interval.minimum = Bracket::proved(-1, -1);
  interval.cases = 2;
  interval.reference_action = "snow";
  interval.reference_factor = 1.5;
  EXPECT_EQ(sentence(),
            "It carries every factor from -1 to 2 of 1.5 snow, in every combination of actions, in "
            "each of 2 load cases; some combination of actions is carried at no factor above 3. "
            "Passed: these include 0 to 1.");
  interval.reference_factor = {};
  EXPECT_THAT(sentence(), HasSubstr("of the action snow with its factor in each combination,"));
}

// Nothing is known of the side on which no outer bound is.
TEST(LoadWords, NameTheBoundsOfAnUndecidedIntervalThatAreKnown) {
  const LoadInterval undecided{.uncertain = LoadRange{2, "kN"},
                               .minimum = {{}, Bound{1.1, Standing::proved}},
                               .maximum = {Bound{1, Standing::proved}, Bound{1.2}}};
  std::vector<std::string> said;
  for (const auto& each : reservations({.answer = undecided})) said.push_back(each.sentence);
  EXPECT_THAT(said, ::testing::Contains("Some admissible load is carried at no factor above 1.2 "
                                        "(computed, not proved)."));
  EXPECT_THAT(said, Not(::testing::Contains(HasSubstr("below"))));
}

TEST(LossWords, NameTheMembersThatAreKept) {
  MemberLoss loss{.factor = {Bound{2, Standing::proved}, {}}, .kept = {"a-b", "b-c"}};
  EXPECT_THAT(headline({.answer = loss}), HasSubstr("any one member except a-b b-c (kept)"));
  loss.struts = true;
  EXPECT_THAT(headline({.answer = loss}),
              HasSubstr("while no strut falls below its residual strength"));
  loss.factor = {{}, Bound{3, Standing::proved}};
  loss.lost = {"a-c"};
  EXPECT_EQ(
      headline({.answer = loss}),
      "After the loss of a-c, even with all struts at full strength, the limit load factor is "
      "at most 3.");
}

TEST(HoldingWords, ExcludeNoFactorOfABracket) {
  const auto bound = [](double value) { return Bound{value, Standing::proved}; };
  HoldingFactors found{.friction = 3,
                       .intervals = {{.standing = IntervalStanding::proved}},
                       .outside = Standing::proved,
                       .load_case = "wind"};
  found.intervals[0].below = {bound(-1.1000000001), bound(-1.0999999992)};
  found.intervals[0].above = {bound(0.9), bound(0.9000000004)};
  EXPECT_EQ(headline({.answer = found}),
            "It can hold these factors of the reference load at friction coefficient 3 in load "
            "case \"wind\": from -1.0999 to 0.9, and none below -1.1001 or above 0.90001.");
  found.intervals.push_back({.standing = IntervalStanding::proved});
  found.intervals[1].below = {bound(1.9999999), bound(2)};
  EXPECT_THAT(
      headline({.answer = found}),
      HasSubstr("and all from 2 on, and none below -1.1001 or between 0.90001 and 1.9999."));
}

TEST(HoldingWords, ProveAnIntervalIfNoFactorBeyondItsEndsIsHeld) {
  using Interval = HoldingFactors::Interval;
  const auto known = Bracket::proved(1, 2);
  const Bracket below{std::nullopt, Bound{1, Standing::proved}};
  EXPECT_EQ(Interval::from(Standing::proved, known, {}).standing, IntervalStanding::proved);
  EXPECT_EQ(Interval::from(Standing::proved, below, {}).standing, IntervalStanding::states_proved);
  EXPECT_EQ(Interval::from(Standing::computed, known, {}).standing, IntervalStanding::computed);
}

TEST(HoldingWords, ShowABoundBesideZeroAsZero) {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  HoldingFactors found{.friction = 0.5, .outside = Standing::proved};
  found.intervals = {HoldingFactors::Interval::from(
      Standing::computed, {Bound{-2 * least, Standing::proved}, Bound{0, Standing::computed}},
      {Bound{0, Standing::computed}, Bound{2 * least, Standing::proved}})};
  EXPECT_THAT(headline({.answer = found}),
              HasSubstr(": 0 (computed, not proved), and none below 0 or above 0."));
}

TEST(HoldingWords, NameWhatIsNotKnownOfASum) {
  HoldingGrip grip{.standing = Standing::proved,
                   .minimum = {Bound{0, Standing::proved}, Bound{0.943, Standing::proved}}};
  EXPECT_THAT(grip_sentence(grip),
              HasSubstr("add up to 0 or more, in some to 0.943 or less; an upper bound is not "
                        "known."));
  grip.minimum.upper.reset();
  EXPECT_THAT(grip_sentence(grip),
              HasSubstr("0 or more; a larger lower bound and an upper bound are not known."));
  EXPECT_EQ(grip_line(grip),
            "sum of the normal reactions under the dead load alone: at least 0 (proved), upper "
            "bound not known\n");
  const HoldingFactors found{.friction = 0.5, .grip = grip};
  const auto said = reservations({.answer = found});
  EXPECT_EQ(std::ranges::count_if(said, &Reservation::open), 2);
  grip.minimum.upper = Bound{0, Standing::proved};  // no reaction at all
  EXPECT_TRUE(grip.has_least());
}

TEST(HoldingWords, NameACoefficientOfZeroAsNoFriction) {
  const Bound zero{0, Standing::proved};
  HoldingBracket found{.bracket = {zero, std::nullopt}, .maximum = 1000};
  EXPECT_EQ(headline({.answer = found}),
            "It cannot hold the dead load without friction; with friction, this is not known.");
  found.bracket.upper = Bound{0.5, Standing::computed};
  EXPECT_EQ(headline({.answer = found}),
            "It cannot hold the dead load without friction; at friction coefficient 0.5 it can "
            "(computed, not proved).");
}

TEST(HoldingWords, NameTheLoadsThatAWedgedPatternHolds) {
  HoldingFactors found{.friction = 0.4, .reason = HoldReason::wedging};
  EXPECT_THAT(headline({.answer = found}), HasSubstr("hold the reference load at any factor"));
  found.of_reference = false;
  EXPECT_THAT(headline({.answer = found}), HasSubstr("hold the dead load at"));
}

TEST(LossWords, OfVerifyNameTheLoadCase) {
  const CertificateCheck check{.claim = CertificateCheck::Loss{.load_case = "wind",
                                                               .lost = {"a-b"},
                                                               .factor = Bracket::proved(1, 2)}};
  EXPECT_THAT(headline({.answer = check}),
              HasSubstr("PROVED: in load case \"wind\", after the loss of any member"));
}

TEST(HoldingWords, OfVerifyNameASignOfFactors) {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  const auto end = [](double value) { return Bound{value, Standing::proved}; };
  const CertificateCheck check{.claim = CertificateCheck::Held{
                                   .friction = 0.5, .none = {{{}, end(-least)}, {end(least), {}}}}};
  EXPECT_EQ(headline({.answer = check}),
            "PROVED: at friction coefficient 0.5, it cannot hold: below 0, above 0");
}

TEST(LoadWords, ReportAnEmptyInterval) {
  const LoadInterval empty{.uncertain = LoadRange{2.5, "kN"},
                           .minimum = Bracket::proved(1.5, 1.5),
                           .maximum = Bracket::proved(0.5, 0.5)};
  EXPECT_EQ(headline({.answer = empty}),
            "There is no load factor that it carries for every dead load within ± 2.5 kN.");
  EXPECT_EQ(exit_code({.answer = empty}), solved);
}

}  // namespace
}  // namespace kusabi::answer
