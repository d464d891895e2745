// Tables of the pieces of a diagram, and of intervals.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "answer/words.hpp"
#include "run/hold/hold.hpp"
#include "run/output/csv.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;
using Points = std::vector<Eigen::Vector2d>;

ordered_json points_json(const Points& points) {
  auto list = ordered_json::array();
  for (const auto& point : points) list.push_back({point.x(), point.y()});
  return list;
}

// Bounds of the sum of the normal reactions, each with its standing.
void add_grip(CsvWriter& csv, const std::optional<answer::HoldingGrip>& grip) {
  if (!grip) {
    csv.nothing().nothing().nothing().nothing();
    return;
  }
  const auto [least, most] = answer::grip_standing_words(*grip);
  csv.number(grip->held ? std::optional(grip->at_least().value) : std::nullopt).text(least);
  const auto& upper = grip->maximum.upper;
  csv.number(upper ? std::optional(upper->value) : std::nullopt).text(most);
}

// @param load_case text of the first column; nothing: there is no such column
void write_interval_rows(CsvWriter& csv, const HoldOptions& options,
                         const wedged::LoadedProblem& loaded, const HoldFindings& findings,
                         const std::optional<std::string>& load_case) {
  const bool several = options.points.size() > 1;
  const auto begin_row = [&](double mu) {
    if (load_case) csv.text(*load_case);
    if (several) csv.number(mu);
  };
  for (std::size_t k = 0; k < findings.points.size(); ++k) {
    const auto& point = findings.points[k];
    const auto answer = factors_of(options, loaded, findings, k);
    const auto end_row = [&] {
      if (options.grip) add_grip(csv, answer.grip);
      csv.end_row();
    };
    for (std::size_t i = 0; i < answer.intervals.size(); ++i) {
      const auto& each = point.factors.intervals[i];
      begin_row(point.mu);
      csv.count(i + 1).number(each.low).number(each.high);
      csv.word(answer::name_of(answer.intervals[i].standing));
      if (each.pattern)
        csv.text(contact_of(loaded, each.block, each.pattern));
      else
        csv.nothing();
      end_row();
    }
    if (!answer.intervals.empty() || (!several && !options.grip && !load_case)) continue;
    begin_row(point.mu);
    csv.nothing().nothing().nothing().text(answer::none_standing_words(answer.outside)).nothing();
    end_row();
  }
}

// With several coefficients a column is theirs, and one without intervals has a row; so has a grip
// range, whose columns are last. Of several load cases each has its rows; those without a name of the
// case are what all of them hold.
void write_intervals(CsvWriter& csv, const HoldOptions& options,
                     const wedged::LoadedProblem& loaded, const HoldFindings& findings) {
  if (!findings.cases.empty()) csv.word("case");
  if (options.points.size() > 1) csv.word("mu");
  csv.word("interval").word("low").word("high").word("standing").word("contact");
  if (options.grip) {
    for (const char* const bound : {"at_least", "at_most"})
      csv.word(fmt::format("sum_{}", bound)).word(fmt::format("sum_{}_standing", bound));
  }
  csv.end_row();
  const bool cases = !findings.cases.empty();
  write_interval_rows(csv, options, loaded, findings, cases ? std::optional("") : std::nullopt);
  for (const auto& each : findings.cases)
    write_interval_rows(csv, options, loaded, each, each.load_case);
}

}  // namespace

ordered_json diagram_pieces(const wedged::LoadedProblem& loaded, const wedged::Diagram& diagram) {
  auto pieces = ordered_json::array();
  for (const auto& piece : diagram.pieces) {
    pieces.push_back({{"pattern", pattern_names(loaded, piece.pattern)},
                      {"vertices", points_json(piece.hull.vertices)},
                      {"rays", points_json(piece.hull.rays)},
                      {"everything", piece.is_whole_plane},
                      {"fine", piece.fine}});
  }
  return pieces;
}

namespace {

// One row for each vertex and each direction.
std::string vertices_table(const std::vector<std::string>& cases, const wedged::Diagram& diagram) {
  const auto column = [](const std::string& name) {
    return std::max<std::size_t>(name.size(), 14);
  };
  auto text = fmt::format("\n{:>5}  {:<9}  {:>{}}  {:>{}}\n", "piece", "", cases[0],
                          column(cases[0]), cases[1], column(cases[1]));
  std::size_t number = 0;
  for (const auto& piece : diagram.pieces) {
    ++number;
    const auto add = [&](const char* what, const Points& points) {
      for (const auto& point : points)
        fmt::format_to(std::back_inserter(text), "{:>5}  {:<9}  {:>{}.8g}  {:>{}.8g}\n", number,
                       what, point.x(), column(cases[0]), point.y(), column(cases[1]));
    };
    add("vertex", piece.hull.vertices);
    add("direction", piece.hull.rays);
  }
  return diagram.pieces.empty() ? std::string() : text + "(factors of the reference loads)\n";
}

}  // namespace

std::string diagram_table(const wedged::LoadedProblem& loaded,
                          const std::vector<std::string>& cases, const wedged::Diagram& diagram) {
  auto text = fmt::format("\n{:>5}  {:>8}  {:>10}  {}\n", "piece", "vertices", "directions",
                          "in contact (U); others separated (R)");
  std::size_t number = 0;
  for (const auto& piece : diagram.pieces) {
    fmt::format_to(std::back_inserter(text), "{:>5}  {:>8}  {:>10}  {}{}\n", ++number,
                   piece.hull.vertices.size(),
                   piece.is_whole_plane ? "all" : fmt::format("{}", piece.hull.rays.size()),
                   contact_of(loaded, piece.pattern), piece.fine ? "" : "; may be larger");
  }
  return text + vertices_table(cases, diagram);
}

void write_held_csv(std::ostream& out, const HoldOptions& options,
                    const wedged::LoadedProblem& loaded, const HoldFindings& findings) {
  CsvWriter csv(out);
  if (!findings.diagram) return write_intervals(csv, options, loaded, findings);
  csv.word("piece").word("what").word("first").word("second").word("contact").end_row();
  std::size_t number = 0;
  for (const auto& piece : findings.diagram->pieces) {
    ++number;
    const auto names = contact_of(loaded, piece.pattern);
    const auto add = [&](const char* what, const Points& points) {
      for (const auto& point : points)
        csv.count(number).word(what).number(point.x()).number(point.y()).text(names).end_row();
    };
    add("vertex", piece.hull.vertices);
    add("direction", piece.hull.rays);
    if (piece.is_whole_plane)
      csv.count(number).word("all").nothing().nothing().text(names).end_row();
  }
}

}  // namespace kusabi::run
