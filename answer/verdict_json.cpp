// JSON keys of each kind of answer.
#include "answer/verdict_json.hpp"

#include "answer/ending.hpp"
#include "answer/values.hpp"
#include "answer/words.hpp"

namespace kusabi::answer {
namespace {

using nlohmann::ordered_json;

ordered_json bound_json(const std::optional<Bound>& bound) {
  if (!bound) return nullptr;
  return {{"value", number_or_null(bound->value)}, {"standing", standing_name(bound->standing)}};
}

ordered_json standing_json(const std::optional<Standing>& standing) {
  return standing ? ordered_json(standing_name(*standing)) : ordered_json();
}

ordered_json bracket_json(const Bracket& bracket) {
  return {{"lower", bound_json(bracket.lower)}, {"upper", bound_json(bracket.upper)}};
}

ordered_json text_or_null(const std::optional<std::string>& text) {
  return text ? ordered_json(*text) : ordered_json();
}

ordered_json remainder_json(const std::optional<ExactRemainder>& remainder) {
  if (!remainder) return nullptr;
  return {{"scale_ratio", remainder->scale_ratio},
          {"why", remainder->why},
          {"nodes", remainder->nodes}};
}

ordered_json answer_json(const std::monostate& /*none*/) {
  return nullptr;
}

ordered_json answer_json(const Sticking& found) {
  ordered_json json{{"kind", "sticking"},
                    {"thing", found.thing},
                    {"friction", found.friction},
                    {"factor", found.factor},
                    {"count", found.count.digits()},
                    {"undecided", found.undecided},
                    {"standing", standing_name(found.standing)},
                    {"grounds", grounds_name(found.grounds)},
                    {"degenerate", found.degenerate},
                    {"ambiguous", found.ambiguous},
                    {"doubt", remainder_json(found.remainder)},
                    {"displacement_ratio", number_or_null(found.displacement_ratio)}};
  if (found.example) json["example"] = true;
  return json;
}

ordered_json answer_json(const CriticalBracket& found) {
  return {{"kind", "critical"},
          {"bracket", bracket_json(found.bracket)},
          {"factor", found.factor},
          {"most", found.maximum},
          {"width", found.width},
          {"wide", found.wide},
          {"patterns_open", found.patterns_open},
          {"grounds", grounds_name(found.grounds)},
          {"displacement_ratio", number_or_null(found.displacement_ratio)}};
}

ordered_json answer_json(const HoldingBracket& found) {
  ordered_json json{{"kind", "holding-friction"},
                    {"bracket", bracket_json(found.bracket)},
                    {"factor", found.factor},
                    {"most", found.maximum},
                    {"reason", hold_reasons.at(static_cast<std::size_t>(found.reason))}};
  if (!found.load_case.empty()) json["case"] = found.load_case;
  return json;
}

ordered_json answer_json(const HoldingFactors& found) {
  auto intervals = ordered_json::array();
  for (const auto& each : found.intervals) {
    intervals.push_back({{"low", number_or_null(each.low)},
                         {"high", number_or_null(each.high)},
                         {"standing", standing_name(each.standing)},
                         {"below", bracket_json(each.below)},
                         {"above", bracket_json(each.above)}});
  }
  ordered_json json{{"kind", "holding-factors"},
                    {"friction", found.friction},
                    {"factor", found.factor},
                    {"of_reference", found.of_reference},
                    {"intervals", std::move(intervals)},
                    {"outside", standing_name(found.outside)},
                    {"open", found.open},
                    {"reason", hold_reasons.at(static_cast<std::size_t>(found.reason))}};
  if (!found.load_case.empty()) json["case"] = found.load_case;
  if (found.total) json["total"] = *found.total;
  if (found.grip) {
    json["grip"] = {{"held", found.grip->held},
                    {"held_standing", standing_name(found.grip->held_standing)},
                    {"least", bracket_json(found.grip->minimum)},
                    {"most", bracket_json(found.grip->maximum)},
                    {"unbounded", found.grip->unbounded},
                    {"unbounded_standing", standing_name(found.grip->unbounded_standing)}};
  }
  return json;
}

ordered_json answer_json(const HoldingSweep& found) {
  auto points = ordered_json::array();
  for (const auto& each : found.points) points.push_back(answer_json(each));
  return {{"kind", "holding-sweep"}, {"requested", found.requested}, {"points", std::move(points)}};
}

ordered_json answer_json(const HoldingDiagram& found) {
  return {{"kind", "holding-diagram"},
          {"friction", found.friction},
          {"factor", found.factor},
          {"cases", found.cases},
          {"pieces", found.pieces},
          {"everything", found.everything},
          {"outside", standing_name(found.outside)},
          {"open", found.open},
          {"coarse", found.coarse}};
}

ordered_json answer_json(const FrictionSteps& found) {
  return {{"kind", "friction-steps"},
          {"most", found.maximum},
          {"factor", found.factor},
          {"infeasible", bound_json(found.infeasible)},
          {"count", found.count.digits()},
          {"open_at_most", found.open_at_most},
          {"open_patterns", found.open_patterns},
          {"undecided_points", found.undecided_points},
          {"doubt", remainder_json(found.remainder)}};
}

ordered_json range_json(const LoadRange& loads) {
  return {{"half_width", number_or_null(loads.half_width)}, {"force", text_or_null(loads.force)}};
}

ordered_json answer_json(const LoadInterval& found) {
  ordered_json json{{"kind", "load-interval"},
                    {"uncertain", found.uncertain ? range_json(*found.uncertain) : ordered_json()},
                    {"least", bracket_json(found.minimum)},
                    {"most", bracket_json(found.maximum)},
                    {"carried_at_none", standing_json(found.carried_at_none)},
                    {"if_big_m", found.if_big_m},
                    {"incomplete", found.incomplete},
                    {"cases", found.cases}};
  if (!found.reference_action.empty()) json["reference_action"] = found.reference_action;
  if (found.struts) json["struts"] = true;
  return json;
}

ordered_json answer_json(const MemberLoss& found) {
  ordered_json json{{"kind", "member-loss"},
                    {"most", found.maximum},
                    {"factor", bracket_json(found.factor)},
                    {"fatal", standing_json(found.fatal)},
                    {"lost", found.lost},
                    {"target", number_or_null(found.target)},
                    {"reached", found.reached ? ordered_json(*found.reached) : ordered_json()},
                    {"cases", found.cases},
                    {"uncertain", found.uncertain}};
  if (!found.kept.empty()) json["kept"] = found.kept;
  if (found.struts) json["struts"] = true;
  if (found.sudden != 1) json["sudden"] = found.sudden;
  return json;
}

ordered_json answer_json(const LoadSteps& found) {
  return {{"kind", "load-steps"},
          {"nominal", bound_json(found.nominal)},
          {"nominal_at_none", standing_json(found.nominal_at_none)},
          {"half_width", number_or_null(found.half_width)},
          {"force", text_or_null(found.force)},
          {"worst", bracket_json(found.worst)},
          {"least", bracket_json(found.minimum)},
          {"worst_at_none", standing_json(found.worst_at_none)},
          {"points", found.points},
          {"points_asked", found.points_asked},
          {"open", found.open}};
}

ordered_json answer_json(const MixedOptimum& found) {
  return {{"kind", "mixed-optimum"},
          {"state", mixed_states.at(static_cast<std::size_t>(found.state))},
          {"standing", standing_name(found.standing)},
          {"maximise", found.maximise},
          {"objective", number_or_null(found.objective)},
          {"bound", bound_json(found.bound)},
          {"gap", number_or_null(found.gap)},
          {"unproved", found.unproved}};
}

// Neither is written to a result file.
ordered_json answer_json(const CertificateCheck& /*check*/) {
  return nullptr;
}
ordered_json answer_json(const Measurement& /*measurement*/) {
  return nullptr;
}

}  // namespace

const char* standing_name(Standing standing) {
  return standing == Standing::proved ? "proved" : "computed";
}

const char* grounds_name(Grounds grounds) {
  return grounds == Grounds::exact_arithmetic ? "exact-arithmetic" : "solver-bounds";
}

ordered_json verdict_json(const Verdict& verdict) {
  auto sentences = ordered_json::array();
  for (const auto& each : reservations(verdict)) sentences.push_back(each.sentence);
  return {
      {"sentence", headline(verdict)},
      {"details", verdict.details},
      {"reservations", std::move(sentences)},
      {"answered", is_answered(verdict)},
      {"exit_code", static_cast<int>(exit_code(verdict))},
      {"ended", status_name(verdict.ended)},
      {"nodes_left", verdict.nodes_left},
      {"missing", verdict.missing},
      {"answer", std::visit([](const auto& found) { return answer_json(found); }, verdict.answer)}};
}

}  // namespace kusabi::answer
