// Unbounded pieces are drawn up to a box around all vertices.
#include "run/hold/diagram_report.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "pictures/svg/chart.hpp"
#include "pictures/svg/convex_area.hpp"
#include "run/hold/hold_report.hpp"
#include "run/output/csv.hpp"
#include "run/output/values.hpp"
#include "run/verdict/words.hpp"
#include "run/wedged/problem_summary.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;
using Points = std::vector<Eigen::Vector2d>;

/// Distance of a vertex that is not drawn, in terms of that of the nearest quarter.
constexpr double far_away = 20;

ordered_json points_json(const Points& points) {
  auto list = ordered_json::array();
  for (const auto& point : points) list.push_back({point.x(), point.y()});
  return list;
}

// The box of the vertices that are not far away, and half of its size around it. Far ones are due
// to gaps that large loads close.
Eigen::AlignedBox2d drawn_box(const wedged::Diagram& diagram) {
  Points all;
  for (const auto& piece : diagram.pieces)
    all.insert(all.end(), piece.vertices.begin(), piece.vertices.end());
  std::ranges::sort(all, {}, [](const auto& vertex) { return vertex.norm(); });
  Eigen::AlignedBox2d box;
  for (const auto& vertex : all)
    if (vertex.norm() <= far_away * all[all.size() / 4].norm()) box.extend(vertex);
  if (box.isEmpty()) box.extend(Eigen::Vector2d(0, 0));
  Eigen::Vector2d size = box.sizes();
  for (int axis = 0; axis < 2; ++axis)
    if (size[axis] == 0) size[axis] = 2 * std::max(1.0, std::abs(box.center()[axis]));
  box.extend(Eigen::Vector2d(box.max() + size / 2));
  box.extend(Eigen::Vector2d(box.min() - size / 2));
  return box;
}

pictures::Chart area_chart(const HoldOptions& options, const wedged::LoadedProblem& loaded,
                           const wedged::Diagram& diagram) {
  pictures::Chart chart{.title = "Loads that can be held",
                        .description = {},
                        .lines = {},
                        .x_name = "factor of " + options.cases.front(),
                        .y_name = "factor of " + options.cases.back(),
                        .series = {}};
  const auto box = drawn_box(diagram);
  for (const auto& piece : diagram.pieces) {
    pictures::ChartSeries series{.name = contact_of(loaded, diagram.block, piece.pattern),
                                 .line = {},
                                 .filled = true,
                                 .marks = {}};
    series.line = piece.endless_all ? pictures::corners_of(box)
                                    : pictures::convex_area(piece.vertices, piece.rays, box);
    if (!series.line.empty()) chart.series.push_back(std::move(series));
  }
  return chart;
}

pictures::Chart bar_chart(const wedged::HeldFactors& factors, const wedged::LoadedProblem& loaded) {
  pictures::Chart chart{.title = "Load factors that can be held",
                        .description = {},
                        .lines = {},
                        .x_name = "factor of the reference load",
                        .y_name = "interval",
                        .whole_numbers = true,
                        .series = {}};
  double size = 1;
  for (const auto& each : factors.intervals)
    for (const double end : {each.low, each.high})
      if (std::isfinite(end)) size = std::max(size, 2 * std::abs(end));
  double row = 0;
  for (const auto& each : factors.intervals) {
    ++row;
    chart.series.push_back(
        {.name = contact_of(loaded, each.block, each.pattern),
         .line = {{std::max(each.low, -size), row}, {std::min(each.high, size), row}},
         .marks = {}});
  }
  return chart;
}

}  // namespace

ordered_json diagram_json(const HoldOptions& options, const wedged::LoadedProblem& loaded,
                          const wedged::Diagram& diagram) {
  auto pieces = ordered_json::array();
  for (const auto& piece : diagram.pieces) {
    pieces.push_back({{"pattern", pattern_names(loaded, diagram.block, piece.pattern)},
                      {"vertices", points_json(piece.vertices)},
                      {"rays", points_json(piece.rays)},
                      {"everything", piece.endless_all},
                      {"fine", piece.fine}});
  }
  return {{"cases", options.cases},
          {"proved", diagram.proved},
          {"open", diagram.open},
          {"pieces", std::move(pieces)}};
}

std::string diagram_table(const wedged::LoadedProblem& loaded, const wedged::Diagram& diagram) {
  auto text = fmt::format("\n{:>5}  {:>8}  {:>10}  {}\n", "piece", "vertices", "directions",
                          "in contact (U); others separated (R)");
  std::size_t number = 0;
  for (const auto& piece : diagram.pieces) {
    fmt::format_to(std::back_inserter(text), "{:>5}  {:>8}  {:>10}  {}\n", ++number,
                   piece.vertices.size(),
                   piece.endless_all ? "all" : fmt::format("{}", piece.rays.size()),
                   contact_of(loaded, diagram.block, piece.pattern));
  }
  return text;
}

void write_held_csv(std::ostream& out, const wedged::LoadedProblem& loaded,
                    const HoldFindings& findings) {
  CsvWriter csv(out);
  if (!findings.diagram) {
    csv.word("interval").word("low").word("high").word("contact").end_row();
    std::size_t number = 0;
    for (const auto& each : findings.factors->intervals) {
      csv.count(++number).number(each.low).number(each.high);
      csv.text(contact_of(loaded, each.block, each.pattern)).end_row();
    }
    return;
  }
  csv.word("piece").word("what").word("first").word("second").word("contact").end_row();
  std::size_t number = 0;
  for (const auto& piece : findings.diagram->pieces) {
    ++number;
    const auto names = contact_of(loaded, findings.diagram->block, piece.pattern);
    const auto add = [&](const char* what, const Points& points) {
      for (const auto& point : points)
        csv.count(number).word(what).number(point.x()).number(point.y()).text(names).end_row();
    };
    add("vertex", piece.vertices);
    add("direction", piece.rays);
    if (piece.endless_all) csv.count(number).word("all").nothing().nothing().text(names).end_row();
  }
}

void write_held_chart(std::ostream& out, const HoldOptions& options,
                      const wedged::LoadedProblem& loaded, const HoldFindings& findings) {
  auto chart = findings.diagram ? area_chart(options, loaded, *findings.diagram)
                                : bar_chart(*findings.factors, loaded);
  chart.description = headline(hold_verdict(options, loaded, findings));
  chart.lines = {chart.description};
  if (chart.series.empty())
    chart.series.push_back({.name = "nothing is held", .line = {{0, 0}}, .marks = {}});
  pictures::write_chart(out, chart);
}

}  // namespace kusabi::run
