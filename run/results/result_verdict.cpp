// The key `verdict` of each kind of answer, as written by run/verdict/verdict_json.cpp.
#include "run/results/result_verdict.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <variant>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "answer/verdict_json.hpp"

namespace kusabi::run {
namespace {

class WrittenVerdict {
 public:
  explicit WrittenVerdict(const ResultReader& reader)
      : reader_(reader), verdict_(reader.at(reader.all(), "verdict")) {}

  [[nodiscard]] answer::Verdict verdict() const {
    answer::Verdict verdict{.ended = ended(),
                            .nodes_left = count(verdict_, "nodes_left"),
                            .details = reader_.names(verdict_, "details"),
                            .missing = reader_.names(verdict_, "missing")};
    if (ResultReader::find(reader_.all(), "warnings") != nullptr)
      verdict.warnings = reader_.names(reader_.all(), "warnings");
    const auto& answer = reader_.at(verdict_, "answer");
    const auto kind = reader_.text(answer, "kind");
    if (kind == "sticking") {
      verdict.answer = sticking(answer);
    } else if (kind == "critical") {
      verdict.answer = critical(answer);
    } else if (kind == "holding-friction") {
      verdict.answer = holding_friction(answer);
    } else if (kind == "holding-factors") {
      verdict.answer = holding_factors(answer);
    } else if (kind == "holding-sweep") {
      verdict.answer = holding_sweep(answer);
    } else if (kind == "holding-diagram") {
      verdict.answer = holding_diagram(answer);
    } else if (kind == "friction-steps") {
      verdict.answer = friction_steps(answer);
    } else if (kind == "load-interval") {
      verdict.answer = load_interval(answer);
    } else if (kind == "member-loss") {
      verdict.answer = member_loss(answer);
    } else if (kind == "load-steps") {
      verdict.answer = load_steps(answer);
    } else if (kind == "mixed-optimum") {
      verdict.answer = mixed_optimum(answer);
    } else {
      reader_.refuse(fmt::format("'kind' is not that of an answer: {}", kind));
    }
    return verdict;
  }

 private:
  [[nodiscard]] engine::Status ended() const {
    using enum engine::Status;
    const auto word = reader_.text(verdict_, "ended");
    for (const auto each :
         {solved, time_limit, node_limit, solution_limit, gap_limit, interrupted}) {
      if (word == answer::status_name(each)) return each;
    }
    reader_.refuse("'ended' is not the end of a search");
  }
  [[nodiscard]] std::uint64_t count(const ResultJson& object, const char* key) const {
    const auto& value = reader_.at(object, key);
    if (!value.is_number_unsigned()) reader_.refuse(fmt::format("'{}' is not a count", key));
    return value.get<std::uint64_t>();
  }
  [[nodiscard]] bool truth(const ResultJson& object, const char* key) const {
    const auto& value = reader_.at(object, key);
    if (!value.is_boolean()) reader_.refuse(fmt::format("'{}' is neither true nor false", key));
    return value.get<bool>();
  }
  /// A count of any size.
  [[nodiscard]] support::ExactCount digits(const ResultJson& object, const char* key) const {
    auto count = support::ExactCount::read(reader_.text(object, key));
    if (!count) reader_.refuse(fmt::format("'{}' is not a count", key));
    return *std::move(count);
  }
  [[nodiscard]] std::optional<double> some_number(const ResultJson& object, const char* key) const {
    if (ResultReader::find(object, key) == nullptr) return std::nullopt;
    return reader_.number(object, key);
  }
  [[nodiscard]] std::optional<std::string> some_text(const ResultJson& object,
                                                     const char* key) const {
    if (ResultReader::find(object, key) == nullptr) return std::nullopt;
    return reader_.text(object, key);
  }
  [[nodiscard]] support::Standing standing(const ResultJson& object, const char* key) const {
    const auto word = reader_.text(object, key);
    if (word != "proved" && word != "computed")
      reader_.refuse(fmt::format("'{}' is neither proved nor computed", key));
    return word == "proved" ? support::Standing::proved : support::Standing::computed;
  }
  [[nodiscard]] answer::Grounds grounds(const ResultJson& answer) const {
    const auto word = reader_.text(answer, "grounds");
    for (const auto each : {answer::Grounds::exact_arithmetic, answer::Grounds::solver_bounds})
      if (word == answer::grounds_name(each)) return each;
    reader_.refuse("'grounds' is neither exact-arithmetic nor solver-bounds");
  }
  [[nodiscard]] std::optional<support::Standing> some_standing(const ResultJson& object,
                                                               const char* key) const {
    if (ResultReader::find(object, key) == nullptr) return std::nullopt;
    return standing(object, key);
  }
  [[nodiscard]] std::optional<support::Bound> bound(const ResultJson& object,
                                                    const char* key) const {
    const auto* const found = ResultReader::find(object, key);
    if (found == nullptr) return std::nullopt;
    return support::Bound{reader_.number(*found, "value"), standing(*found, "standing")};
  }
  [[nodiscard]] support::Bracket bracket(const ResultJson& object, const char* key) const {
    const auto& found = reader_.at(object, key);
    return {bound(found, "lower"), bound(found, "upper")};
  }

  [[nodiscard]] std::optional<answer::ExactRemainder> remainder(const ResultJson& answer) const {
    const auto* const found = ResultReader::find(answer, "doubt");
    if (found == nullptr) return std::nullopt;
    return answer::ExactRemainder{reader_.number(*found, "scale_ratio"),
                                  reader_.text(*found, "why"), count(*found, "nodes")};
  }

  [[nodiscard]] answer::Sticking sticking(const ResultJson& answer) const {
    return {.thing = reader_.text(answer, "thing"),
            .friction = reader_.number(answer, "friction"),
            .factor = truth(answer, "factor"),
            .count = digits(answer, "count"),
            .undecided = count(answer, "undecided"),
            .standing = standing(answer, "standing"),
            .grounds = grounds(answer),
            .degenerate = count(answer, "degenerate"),
            .ambiguous = truth(answer, "ambiguous"),
            .remainder = remainder(answer),
            .displacement_ratio = some_number(answer, "displacement_ratio"),
            .example = ResultReader::find(answer, "example") != nullptr};
  }
  [[nodiscard]] answer::HoldReason hold_reason(const ResultJson& answer) const {
    const auto word = reader_.text(answer, "reason");
    const auto found = std::ranges::find(answer::hold_reasons, word);
    if (found == answer::hold_reasons.end())
      reader_.refuse("'reason' is not that of an answer about loads");
    return static_cast<answer::HoldReason>(found - answer::hold_reasons.begin());
  }
  [[nodiscard]] answer::HoldingBracket holding_friction(const ResultJson& answer) const {
    return {.bracket = bracket(answer, "bracket"),
            .factor = truth(answer, "factor"),
            .maximum = reader_.number(answer, "most"),
            .reason = hold_reason(answer),
            .load_case = some_text(answer, "case").value_or("")};
  }
  [[nodiscard]] answer::HoldingFactors holding_factors(const ResultJson& answer) const {
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    answer::HoldingFactors found{.friction = reader_.number(answer, "friction"),
                                 .factor = truth(answer, "factor"),
                                 .of_reference = truth(answer, "of_reference"),
                                 .intervals = {},
                                 .outside = standing(answer, "outside"),
                                 .open = truth(answer, "open"),
                                 .reason = hold_reason(answer),
                                 .load_case = some_text(answer, "case").value_or(""),
                                 .total = some_number(answer, "total")};
    for (const auto& each : reader_.list(answer, "intervals")) {
      found.intervals.push_back({some_number(each, "low").value_or(-unbounded),
                                 some_number(each, "high").value_or(unbounded),
                                 standing(each, "standing"), bracket(each, "below"),
                                 bracket(each, "above")});
    }
    if (const auto* const grip = ResultReader::find(answer, "grip"))
      found.grip = holding_grip(*grip);
    return found;
  }
  [[nodiscard]] answer::HoldingGrip holding_grip(const ResultJson& grip) const {
    return {.held = truth(grip, "held"),
            .held_standing = standing(grip, "held_standing"),
            .minimum = bracket(grip, "least"),
            .maximum = bracket(grip, "most"),
            .unbounded = truth(grip, "unbounded"),
            .unbounded_standing = standing(grip, "unbounded_standing")};
  }
  [[nodiscard]] answer::HoldingSweep holding_sweep(const ResultJson& answer) const {
    answer::HoldingSweep found{.requested = count(answer, "requested")};
    for (const auto& each : reader_.list(answer, "points"))
      found.points.push_back(holding_factors(each));
    return found;
  }
  [[nodiscard]] answer::HoldingDiagram holding_diagram(const ResultJson& answer) const {
    return {.friction = reader_.number(answer, "friction"),
            .factor = truth(answer, "factor"),
            .cases = reader_.names(answer, "cases"),
            .pieces = count(answer, "pieces"),
            .everything = truth(answer, "everything"),
            .outside = standing(answer, "outside"),
            .open = truth(answer, "open"),
            .coarse = count(answer, "coarse")};
  }
  [[nodiscard]] answer::CriticalBracket critical(const ResultJson& answer) const {
    return {.bracket = bracket(answer, "bracket"),
            .factor = truth(answer, "factor"),
            .maximum = reader_.number(answer, "most"),
            .width = reader_.number(answer, "width"),
            .wide = truth(answer, "wide"),
            .patterns_open = truth(answer, "patterns_open"),
            .grounds = grounds(answer),
            .displacement_ratio = some_number(answer, "displacement_ratio")};
  }
  [[nodiscard]] answer::FrictionSteps friction_steps(const ResultJson& answer) const {
    return {.maximum = reader_.number(answer, "most"),
            .factor = truth(answer, "factor"),
            .infeasible = bound(answer, "infeasible"),
            .count = digits(answer, "count"),
            .open_at_most = count(answer, "open_at_most"),
            .open_patterns = count(answer, "open_patterns"),
            .undecided_points = count(answer, "undecided_points"),
            .remainder = remainder(answer)};
  }
  [[nodiscard]] answer::LoadInterval load_interval(const ResultJson& answer) const {
    answer::LoadInterval found{
        .uncertain = {},
        .minimum = bracket(answer, "least"),
        .maximum = bracket(answer, "most"),
        .carried_at_none = some_standing(answer, "carried_at_none"),
        .if_big_m = truth(answer, "if_big_m"),
        .incomplete = truth(answer, "incomplete"),
        .cases = count(answer, "cases"),
        .reference_action = some_text(answer, "reference_action").value_or(""),
        .struts = ResultReader::find(answer, "struts") != nullptr};
    if (const auto* const loads = ResultReader::find(answer, "uncertain"))
      found.uncertain =
          answer::LoadRange{some_number(*loads, "half_width"), some_text(*loads, "force")};
    return found;
  }
  [[nodiscard]] answer::MemberLoss member_loss(const ResultJson& answer) const {
    answer::MemberLoss found{.maximum = count(answer, "most"),
                             .factor = bracket(answer, "factor"),
                             .fatal = some_standing(answer, "fatal"),
                             .lost = reader_.names(answer, "lost"),
                             .target = some_number(answer, "target"),
                             .reached = {},
                             .cases = count(answer, "cases"),
                             .struts = ResultReader::find(answer, "struts") != nullptr,
                             .sudden = some_number(answer, "sudden").value_or(1)};
    if (ResultReader::find(answer, "kept") != nullptr) found.kept = reader_.names(answer, "kept");
    if (ResultReader::find(answer, "reached") != nullptr) found.reached = truth(answer, "reached");
    if (ResultReader::find(answer, "uncertain") != nullptr)
      found.uncertain = truth(answer, "uncertain");
    return found;
  }
  [[nodiscard]] answer::LoadSteps load_steps(const ResultJson& answer) const {
    return {.nominal = bound(answer, "nominal"),
            .nominal_at_none = some_standing(answer, "nominal_at_none"),
            .half_width = some_number(answer, "half_width"),
            .force = some_text(answer, "force"),
            .worst = bracket(answer, "worst"),
            .minimum = bracket(answer, "least"),
            .worst_at_none = some_standing(answer, "worst_at_none"),
            .points = count(answer, "points"),
            .points_asked = count(answer, "points_asked"),
            .open = truth(answer, "open")};
  }
  [[nodiscard]] answer::MixedOptimum mixed_optimum(const ResultJson& answer) const {
    const auto word = reader_.text(answer, "state");
    const auto state = std::ranges::find(answer::mixed_states, word);
    if (state == answer::mixed_states.end()) reader_.refuse("'state' is not that of a program");
    return {.state = static_cast<answer::MixedOptimum::State>(state - answer::mixed_states.begin()),
            .standing = standing(answer, "standing"),
            .maximise = truth(answer, "maximise"),
            .objective = some_number(answer, "objective"),
            .bound = bound(answer, "bound"),
            .gap = some_number(answer, "gap").value_or(0),
            .unproved = count(answer, "unproved")};
  }

  const ResultReader& reader_;
  const ResultJson& verdict_;
};

}  // namespace

answer::Verdict result_verdict(const ResultReader& reader) {
  return WrittenVerdict(reader).verdict();
}

}  // namespace kusabi::run
