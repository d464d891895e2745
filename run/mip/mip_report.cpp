// The table and the JSON of `kusabi mip`.
#include "run/mip/mip_report.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "run/output/csv.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/values.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;
using zero_one::MixedStatus;

// A value that is worth less, or is itself less, is a zero that was rounded.
bool is_zero(double value, double cost) {
  constexpr double nothing = 1e-9;
  return std::abs(value) * std::max(1.0, std::abs(cost)) <= nothing;
}

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

double MipReport::in_the_files_sense(double objective) const {
  return program.maximise ? -objective : objective;
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

std::string MipReport::verdict() const {
  switch (found.status()) {
    case MixedStatus::infeasible:
      return "infeasible: no point satisfies all rows, bounds and binaries\n";
    case MixedStatus::unbounded:
      return fmt::format("unbounded: there are points, and the objective has no {} bound\n",
                         program.maximise ? "upper" : "lower");
    case MixedStatus::unknown:
      return fmt::format(
          "no point was found, and it is not known that there is none; {} bound {}\n",
          program.maximise ? "upper" : "lower", bound());
    case MixedStatus::optimal:
    case MixedStatus::feasible:
      break;
  }
  return fmt::format("{} objective {}; {} bound {} ({}), gap {:.2g} %\n",
                     found.status() == MixedStatus::optimal ? "optimal:" : "best point so far:",
                     objective(), program.maximise ? "upper" : "lower", bound(),
                     found.proved() ? "safe against rounding" : "without a proof", 100 * gap());
}

// What stands between the answer and a proof.
std::string MipReport::doubts() const {
  std::string text;
  auto out = std::back_inserter(text);
  const auto status = found.status();
  const bool whole = found.outcome.status == engine::Status::solved;
  const auto unproved = found.outcome.tally().unproved;
  if (whole && !found.answered()) {
    fmt::format_to(
        out,
        "not answered: the search is done, but {} nodes were closed without a proof that "
        "nothing is left in them{}\n",
        unproved,
        status == MixedStatus::feasible && unproved == 0 ? ", and the bounds of others are too weak"
                                                         : "");
  } else if (unproved != 0) {
    fmt::format_to(
        out,
        "{} nodes were closed without a proof that nothing is left in them; their bounds "
        "say that nothing better is\n",
        unproved);
  }
  // That nothing satisfies the rows is shown by a contradiction of theirs, whatever the bounds.
  if (status != MixedStatus::unbounded && status != MixedStatus::infeasible && !found.proved()) {
    text +=
        "the bound is not proved: columns without bounds leave no room for rounding; it was "
        "computed "
        "in 30 digits\n";
  }
  return text;
}

std::string MipReport::table(const Page& page) const {
  std::string text;
  auto out = std::back_inserter(text);
  if (found.point() != nullptr && found.status() != MixedStatus::unbounded) {
    std::size_t width = std::string_view("column").size();
    const auto& columns = program.mixed.program.columns;
    const auto& values = found.point()->values;
    for (std::size_t j = 0; j < columns.size(); ++j) {
      if (!is_zero(values[j], columns[j].cost)) width = std::max(width, columns[j].name.size());
    }
    fmt::format_to(out, "\n{:<{}}  {:>14}\n", "column", width, "value");
    for (std::size_t j = 0; j < columns.size(); ++j) {
      if (is_zero(values[j], columns[j].cost)) continue;
      fmt::format_to(out, "{:<{}}  {:>14.8g}\n", columns[j].name, width, values[j]);
    }
  }
  text += '\n';
  const auto tally = found.outcome.tally();
  const auto& counts = found.tree.prepared().counts;
  fmt::format_to(out,
                 "{} nodes; {} linear programs, {} of them at the root; {} cuts in {} rounds; {} "
                 "coefficients made smaller\n",
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
  text += '\n' + ranks.text(page.width) + '\n' + page.strong(verdict()) + page.doubtful(doubts());
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
    if (!is_zero(value, columns[j].cost)) csv.text(columns[j].name).number(value).end_row();
  }
}

ordered_json MipReport::json() const {
  const auto& given = program.mixed.program;
  const auto& counts = found.tree.prepared().counts;
  ordered_json result{{"answer", answer_name(found.status())}};
  if (has_point()) {
    result["objective"] = objective();
    result["bound"] = number_or_null(bound());
    result["gap"] = number_or_null(gap());
    result["proved"] = found.proved();
    ordered_json columns = ordered_json::object();
    for (std::size_t j = 0; j < given.columns.size(); ++j) {
      const double value = found.point()->values[j];
      if (!is_zero(value, given.columns[j].cost)) columns[given.columns[j].name] = value;
    }
    result["columns"] = std::move(columns);
  } else if (found.status() == MixedStatus::unknown) {
    result["bound"] = number_or_null(bound());
  }
  result["unproved"] = found.outcome.tally().unproved;
  result["root"] = {{"first_bound", number_or_null(in_the_files_sense(counts.first_bound))},
                    {"last_bound", number_or_null(in_the_files_sense(counts.last_bound))},
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
           {{"cuts", options.cuts == zero_one::ZeroOneCuts::none ? "none" : "disjunctive"},
            {"branching",
             options.branching == zero_one::ZeroOneBranching::paper ? "paper" : "look-ahead"},
            {"tighten", options.tighten},
            {"dive", options.dive}}},
          {"status", status_name(found.outcome.status)},
          {"result", std::move(result)},
          {"statistics",
           {{"opened", found.outcome.opened()},
            {"open", found.outcome.open},
            {"ranks", rank_reports(found.outcome.ranks, counts_json<zero_one::ZeroOneTally>)},
            {"earlier_runs",
             rank_reports(found.outcome.earlier, counts_json<zero_one::ZeroOneTally>)}}}};
}

}  // namespace kusabi::run
