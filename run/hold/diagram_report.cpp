// Tables of the pieces of a diagram, and of intervals.
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

// With several coefficients the first column is theirs, and one without intervals has a row.
void write_intervals(CsvWriter& csv, const wedged::LoadedProblem& loaded,
                     const std::vector<HeldPoint>& points, bool several) {
  if (several) csv.word("mu");
  csv.word("interval").word("low").word("high").word("standing").word("contact").end_row();
  for (const auto& point : points) {
    std::size_t number = 0;
    for (const auto& each : point.factors.intervals) {
      if (several) csv.number(point.mu);
      csv.count(++number).number(each.low).number(each.high);
      csv.word(standing_of(each));
      if (each.pattern)
        csv.text(contact_of(loaded, each.block, each.pattern)).end_row();
      else
        csv.nothing().end_row();
    }
    if (several && number == 0)
      csv.number(point.mu)
          .nothing()
          .nothing()
          .nothing()
          .text(standing_of_none(point))
          .nothing()
          .end_row();
  }
}

}  // namespace

const char* standing_of(const wedged::HeldInterval& interval) {
  const auto beyond = [](double held, const support::Bound& out) {
    if (std::isinf(held)) return support::Standing::proved;
    return std::isfinite(out.value) ? out.standing : support::Standing::computed;
  };
  return answer::interval_standing_word(
      interval.standing,
      both(beyond(interval.low, interval.low_out), beyond(interval.high, interval.high_out)));
}

std::string standing_of_none(const HeldPoint& point) {
  const auto& [unresolved, outside] = std::tie(point.factors.unresolved, point.factors.outside);
  return answer::none_standing_words(unresolved ? std::nullopt : std::optional(outside));
}

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

std::string diagram_table(const wedged::LoadedProblem& loaded, const wedged::Diagram& diagram) {
  auto text = fmt::format("\n{:>5}  {:>8}  {:>10}  {}\n", "piece", "vertices", "directions",
                          "in contact (U); others separated (R)");
  std::size_t number = 0;
  for (const auto& piece : diagram.pieces) {
    fmt::format_to(std::back_inserter(text), "{:>5}  {:>8}  {:>10}  {}{}\n", ++number,
                   piece.hull.vertices.size(),
                   piece.is_whole_plane ? "all" : fmt::format("{}", piece.hull.rays.size()),
                   contact_of(loaded, piece.pattern), piece.fine ? "" : "; may be larger");
  }
  return text;
}

void write_held_csv(std::ostream& out, const HoldOptions& options,
                    const wedged::LoadedProblem& loaded, const HoldFindings& findings) {
  CsvWriter csv(out);
  if (!findings.diagram)
    return write_intervals(csv, loaded, findings.points, options.points.size() > 1);
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
