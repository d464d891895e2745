// Table and JSON of `kusabi mip`.
#include "run/mip/mip_report.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "answer/ending.hpp"
#include "answer/values.hpp"
#include "run/output/csv.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/values.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;
using zero_one::MixedStatus;

const char* answer_name(MixedStatus answer) {
  switch (answer) {
    case MixedStatus::optimal:
      return "optimal";
    case MixedStatus::feasible:
      return "feasible";
    case MixedStatus::infeasible:
      return "infeasible";
    case MixedStatus::unbounded:
      return "unbounded";
    case MixedStatus::unknown:
      break;
  }
  return "unknown";
}

}  // namespace

const OptionWords<zero_one::ZeroOneCuts>& root_cuts_words() {
  using zero_one::ZeroOneCuts;
  static const OptionWords<ZeroOneCuts> words{{"none", ZeroOneCuts::none},
                                              {"disjunctive", ZeroOneCuts::disjunctive}};
  return words;
}

const OptionWords<zero_one::ZeroOneBranching>& zero_one_branching_words() {
  using zero_one::ZeroOneBranching;
  static const OptionWords<ZeroOneBranching> words{{"paper", ZeroOneBranching::paper},
                                                   {"look-ahead", ZeroOneBranching::look_ahead}};
  return words;
}

double MipReport::in_the_files_sense(double objective) const {
  return program.maximise ? 0 - objective : objective;
}

double MipReport::objective() const {
  return in_the_files_sense(found.point()->objective);
}

double MipReport::bound() const {
  return in_the_files_sense(found.bound());
}

double MipReport::gap() const {
  const double difference = std::abs(objective() - bound());
  return objective() == 0 ? difference : difference / std::abs(objective());
}

// Of a point that is not known to be optimal, its own; an optimum requires the bound as well, and a
// program without points the bounds that exclude them.
support::Standing MipReport::standing() const {
  const bool point = found.point() == nullptr || found.point()->proved;
  const bool proved = point && (found.status() == MixedStatus::feasible || found.proved());
  return proved ? support::Standing::proved : support::Standing::computed;
}

answer::Verdict MipReport::verdict() const {
  using State = answer::MixedOptimum::State;
  answer::MixedOptimum answer{.standing = standing(),
                              .maximise = program.maximise,
                              .unproved = found.outcome.tally().unproved};
  switch (found.status()) {
    case MixedStatus::optimal:
      answer.state = State::optimal;
      break;
    case MixedStatus::feasible:
      answer.state = State::feasible;
      break;
    case MixedStatus::infeasible:
      answer.state = State::infeasible;
      break;
    case MixedStatus::unbounded:
      answer.state = State::unbounded;
      break;
    case MixedStatus::unknown:
      break;
  }
  if (has_point()) {
    answer.objective = objective();
    answer.gap = gap();
  }
  if (std::isfinite(bound()))
    answer.bound = support::Bound{
        bound(), found.proved() ? support::Standing::proved : support::Standing::computed};
  return {.ended = found.outcome.status, .nodes_left = found.outcome.open, .answer = answer};
}

std::string MipReport::table(const Page& page) const {
  std::string text;
  auto out = std::back_inserter(text);
  if (found.point() != nullptr && found.status() != MixedStatus::unbounded) {
    std::size_t width = std::string_view("column").size();
    const auto& columns = program.mixed.program.columns;
    const auto& values = found.point()->values;
    for (std::size_t j = 0; j < columns.size(); ++j) {
      if (values[j] != 0) width = std::max(width, columns[j].name.size());
    }
    fmt::format_to(out, "\n{:<{}}  {:>14}\n", "column", width, "value");
    for (std::size_t j = 0; j < columns.size(); ++j) {
      if (values[j] == 0) continue;
      fmt::format_to(out, "{:<{}}  {:>14.8g}\n", columns[j].name, width, values[j]);
    }
  }
  text += '\n';
  const auto tally = found.outcome.tally();
  const auto& counts = found.tree.prepared().counts;
  fmt::format_to(out,
                 "{} nodes; {} linear programs, {} of them at the root; {} cuts in {} rounds; {} "
                 "coefficients reduced\n",
                 found.outcome.opened(), tally.programs + counts.programs, counts.programs,
                 counts.cuts, counts.cut_rounds, counts.tightened);
  RankTable ranks({"branched", "infeasible", "above", "leaves", "programs", "iterations"});
  const auto own = [](const zero_one::ZeroOneTally& its) {
    return std::vector<std::uint64_t>{its.branched, its.infeasible + its.unproved,
                                      its.above,    its.leaves,
                                      its.programs, its.iterations};
  };
  for (const auto& rank : found.outcome.ranks) ranks.add(rank.statistics, own(rank.tally));
  for (const auto& rank : found.outcome.earlier)
    ranks.add_earlier(rank.statistics, own(rank.tally));
  text += '\n' + ranks.text(page.width);
  return text;
}

bool MipReport::has_point() const {
  return found.status() == MixedStatus::optimal || found.status() == MixedStatus::feasible;
}

void MipReport::write_csv(std::ostream& out) const {
  CsvWriter csv(out);
  csv.word("column").word("value").end_row();
  if (!has_point()) return;
  const auto& columns = program.mixed.program.columns;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const double value = found.point()->values[j];
    if (value != 0) csv.text(columns[j].name).number(value).end_row();
  }
}

ordered_json MipReport::json() const {
  const auto& given = program.mixed.program;
  const auto& counts = found.tree.prepared().counts;
  ordered_json result{{"answer", answer_name(found.status())}};
  if (has_point()) {
    result["objective"] = objective();
    result["bound"] = answer::number_or_null(bound());
    result["gap"] = answer::number_or_null(gap());
    result["proved"] = found.proved();
    result["point_proved"] = found.point()->proved;
    ordered_json columns = ordered_json::object();
    for (std::size_t j = 0; j < given.columns.size(); ++j) {
      const double value = found.point()->values[j];
      if (value != 0) columns[given.columns[j].name] = value;
    }
    result["columns"] = std::move(columns);
  } else if (found.status() == MixedStatus::unknown) {
    result["bound"] = answer::number_or_null(bound());
  } else {
    result["proved"] = standing() == support::Standing::proved;
  }
  result["unproved"] = found.outcome.tally().unproved;
  // Those of an unbounded program are of the program without costs.
  const auto root_bound = [&](double bound) {
    return found.unbounded ? ordered_json() : answer::number_or_null(in_the_files_sense(bound));
  };
  result["root"] = {{"first_bound", root_bound(counts.first_bound)},
                    {"last_bound", root_bound(counts.last_bound)},
                    {"programs", counts.programs},
                    {"cut_rounds", counts.cut_rounds},
                    {"cut_programs", counts.cut_programs},
                    {"cuts", counts.cuts},
                    {"tighten_programs", counts.tighten_programs},
                    {"tightened", counts.tightened},
                    {"fixed", counts.fixed}};
  return {{"command", "mip"},
          {"version", KUSABI_VERSION},
          {"problem",
           {{"file", options.file},
            {"name", given.name},
            {"sense", program.maximise ? "maximise" : "minimise"},
            {"rows", given.rows.size()},
            {"columns", given.columns.size()},
            {"binaries", program.mixed.binaries.size()},
            {"entries", given.entries.size()},
            {"fingerprint", hexadecimal(fingerprint)}}},
          {"options",
           {{"cuts", word_of(root_cuts_words(), options.cuts)},
            {"branching", word_of(zero_one_branching_words(), options.branching)},
            {"tighten", options.tighten},
            {"dive", options.dive}}},
          {"status", answer::status_text(verdict())},
          {"result", std::move(result)},
          {"statistics",
           {{"opened", found.outcome.opened()},
            {"open", found.outcome.open},
            {"ranks", rank_reports(found.outcome.ranks, counts_json<zero_one::ZeroOneTally>)},
            {"earlier_runs",
             rank_reports(found.outcome.earlier, counts_json<zero_one::ZeroOneTally>)}}}};
}

}  // namespace kusabi::run
