// The table and the JSON of `kusabi mip`.
#include "run/mip/mip_report.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "run/output/rank_table.hpp"
#include "run/output/values.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

// A value that is worth less, or is itself less, is a zero that was rounded.
bool is_zero(double value, double cost) {
  constexpr double nothing = 1e-9;
  return std::abs(value) * std::max(1.0, std::abs(cost)) <= nothing;
}

const char* answer_name(MipAnswer answer) {
  switch (answer) {
    case MipAnswer::optimal:
      return "optimal";
    case MipAnswer::feasible:
      return "feasible";
    case MipAnswer::infeasible:
      return "infeasible";
    case MipAnswer::unbounded:
      return "unbounded";
    case MipAnswer::unknown:
      break;
  }
  return "unknown";
}

}  // namespace

const zero_one::ZeroOnePoint* MipReport::point() const {
  return outcome.solutions.empty() ? nullptr : &outcome.solutions.front().solution;
}

MipAnswer MipReport::answer() const {
  if (unbounded) return point() != nullptr ? MipAnswer::unbounded : MipAnswer::infeasible;
  const bool whole = outcome.status == engine::Status::solved;
  if (point() == nullptr) {
    return whole && total().unproved == 0 ? MipAnswer::infeasible : MipAnswer::unknown;
  }
  const double missing = std::abs(objective() - bound());
  const double most = optimality_tolerance * tree.prepared().relaxation.steps().size(objective());
  return whole && missing <= most ? MipAnswer::optimal : MipAnswer::feasible;
}

zero_one::ZeroOneTally MipReport::total() const {
  return outcome.tally();
}

double MipReport::in_the_files_sense(double objective) const {
  return program.maximise ? -objective : objective;
}

double MipReport::objective() const {
  return in_the_files_sense(point()->objective);
}

double MipReport::bound() const {
  return in_the_files_sense(tree.lower_bound(outcome.bound, total()));
}

double MipReport::gap() const {
  const double difference = std::abs(objective() - bound());
  return objective() == 0 ? difference : difference / std::abs(objective());
}

bool MipReport::answered() const {
  const auto found = answer();
  return outcome.status == engine::Status::solved && found != MipAnswer::feasible &&
         found != MipAnswer::unknown;
}

bool MipReport::proved() const {
  return tree.proves();
}

std::string MipReport::verdict() const {
  switch (answer()) {
    case MipAnswer::infeasible:
      return "infeasible: no point satisfies all rows, bounds and binaries\n";
    case MipAnswer::unbounded:
      return fmt::format("unbounded: there are points, and the objective has no {} bound\n",
                         program.maximise ? "upper" : "lower");
    case MipAnswer::unknown:
      return fmt::format(
          "no point was found, and it is not known that there is none; {} bound {}\n",
          program.maximise ? "upper" : "lower", bound());
    case MipAnswer::optimal:
    case MipAnswer::feasible:
      break;
  }
  return fmt::format("{} objective {}; {} bound {} ({}), gap {:.2g} %\n",
                     answer() == MipAnswer::optimal ? "optimal:" : "best point so far:",
                     objective(), program.maximise ? "upper" : "lower", bound(),
                     proved() ? "safe against rounding" : "without a proof", 100 * gap());
}

// What stands between the answer and a proof.
std::string MipReport::doubts() const {
  std::string text;
  auto out = std::back_inserter(text);
  const auto found = answer();
  const bool whole = outcome.status == engine::Status::solved;
  const auto unproved = total().unproved;
  if (whole && !answered()) {
    fmt::format_to(
        out,
        "not answered: the search is done, but {} nodes were closed without a proof that "
        "nothing is left in them{}\n",
        unproved,
        found == MipAnswer::feasible && unproved == 0 ? ", and the bounds of others are too weak"
                                                      : "");
  } else if (unproved != 0) {
    fmt::format_to(
        out,
        "{} nodes were closed without a proof that nothing is left in them; their bounds "
        "say that nothing better is\n",
        unproved);
  }
  // That nothing satisfies the rows is shown by a contradiction of theirs, whatever the bounds.
  if (found != MipAnswer::unbounded && found != MipAnswer::infeasible && !proved()) {
    text +=
        "the bound is not proved: columns without bounds leave no room for rounding; it was "
        "computed "
        "in 30 digits\n";
  }
  return text;
}

std::string MipReport::table() const {
  std::string text;
  auto out = std::back_inserter(text);
  if (point() != nullptr && answer() != MipAnswer::unbounded) {
    std::size_t width = std::string_view("column").size();
    const auto& columns = program.mixed.program.columns;
    const auto& values = point()->values;
    for (std::size_t j = 0; j < columns.size(); ++j) {
      if (!is_zero(values[j], columns[j].cost)) width = std::max(width, columns[j].name.size());
    }
    fmt::format_to(out, "\n{:<{}}  {:>14}\n", "column", width, "value");
    for (std::size_t j = 0; j < columns.size(); ++j) {
      if (is_zero(values[j], columns[j].cost)) continue;
      fmt::format_to(out, "{:<{}}  {:>14.8g}\n", columns[j].name, width, values[j]);
    }
  }
  text += '\n' + verdict() + doubts();
  const auto tally = total();
  const auto& counts = tree.prepared().counts;
  fmt::format_to(out,
                 "{} nodes; {} linear programs, {} of them at the root; {} cuts in {} rounds; {} "
                 "coefficients made smaller\n",
                 outcome.opened(), tally.programs + counts.programs, counts.programs, counts.cuts,
                 counts.cut_rounds, counts.tightened);
  RankTable ranks({"branched", "infeasible", "above", "leaves", "programs", "iterations"});
  const auto own = [](const zero_one::ZeroOneTally& its) {
    return std::vector<std::uint64_t>{its.branched, its.infeasible + its.unproved,
                                      its.above,    its.leaves,
                                      its.programs, its.iterations};
  };
  for (const auto& rank : outcome.ranks) ranks.add(rank.statistics, own(rank.tally));
  for (const auto& rank : outcome.earlier) ranks.add_earlier(rank.statistics, own(rank.tally));
  text += '\n' + ranks.text();
  return text;
}

ordered_json MipReport::json() const {
  const auto& given = program.mixed.program;
  const auto& counts = tree.prepared().counts;
  ordered_json result{{"answer", answer_name(answer())}};
  if (answer() == MipAnswer::optimal || answer() == MipAnswer::feasible) {
    result["objective"] = objective();
    result["bound"] = number_or_null(bound());
    result["gap"] = number_or_null(gap());
    result["proved"] = proved();
    ordered_json columns = ordered_json::object();
    for (std::size_t j = 0; j < given.columns.size(); ++j) {
      const double value = point()->values[j];
      if (!is_zero(value, given.columns[j].cost)) columns[given.columns[j].name] = value;
    }
    result["columns"] = std::move(columns);
  } else if (answer() == MipAnswer::unknown) {
    result["bound"] = number_or_null(bound());
  }
  result["unproved"] = total().unproved;
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
          {"status", status_name(outcome.status)},
          {"result", std::move(result)},
          {"statistics",
           {{"opened", outcome.opened()},
            {"open", outcome.open},
            {"ranks", rank_reports(outcome.ranks, counts_json<zero_one::ZeroOneTally>)},
            {"earlier_runs", rank_reports(outcome.earlier, counts_json<zero_one::ZeroOneTally>)}}}};
}

}  // namespace kusabi::run
