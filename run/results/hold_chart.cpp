// Areas are drawn only where a piece is convex, so that its vertices prove it; over the friction
// coefficient there is a bar at each coefficient of the call.
#include "run/results/hold_chart.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/values.hpp"
#include "pictures/svg/convex_area.hpp"
#include "run/results/result_scenes.hpp"

namespace kusabi::run {
namespace {

using pictures::Chart;
using pictures::ChartArea;
using pictures::ChartSeries;
using pictures::Stroke;
using Points = std::vector<Eigen::Vector2d>;

/// Distance of a vertex that is not drawn, relative to that of the vertex at the first quartile of
/// those that are not the origin.
constexpr double far_away = 20;

class HoldCharts {
 public:
  HoldCharts(const ResultReader& reader, const std::string& sentence)
      : reader_(reader), result_(reader.at(reader.all(), "result")), sentence_(sentence) {}

  [[nodiscard]] std::optional<Chart> chart() const {
    auto chart = ResultReader::find(result_, "pieces") != nullptr      ? areas()
                 : ResultReader::find(result_, "points") != nullptr    ? over_friction()
                 : ResultReader::find(result_, "intervals") != nullptr ? bars()
                                                                       : Chart{};
    if (chart.title.empty()) return {};
    if (chart.series.empty()) chart.series.push_back({.name = "no load is known to be held"});
    return chart;
  }

 private:
  [[nodiscard]] Chart empty_chart(const char* title, std::string x, std::string y) const {
    return {.title = title,
            .description = sentence_,
            .lines = {sentence_},
            .x_name = std::move(x),
            .y_name = std::move(y),
            .series = {}};
  }

  [[nodiscard]] std::string contact_of(const ResultJson& entry) const {
    const auto* const pattern = ResultReader::find(entry, "pattern");
    if (pattern == nullptr) return "-";
    const auto names = reader_.names(*pattern, "contact");
    return names.empty() ? "none" : fmt::format("{}", fmt::join(names, " "));
  }

  [[nodiscard]] Chart bars() const {
    auto chart =
        empty_chart("Load factors that can be held", "factor of the reference load", "interval");
    chart.whole_numbers = true;
    double row = 0;
    for (const auto& each : reader_.list(result_, "intervals")) {
      const auto [low, high] = held_range(reader_, each);
      ++row;
      ChartSeries held{.name = "in contact: " + contact_of(each) + no_end(low, high),
                       .stroke = Stroke::bar};
      if (low < high)
        held.lines = {{{low, row}, {high, row}}};
      else  // a bar without length would not be seen
        held.marks = {{low, row, fmt::format("{} only", low)}};
      chart.series.push_back(std::move(held));
    }
    return chart;
  }

  // "; no end upwards", if there is none.
  [[nodiscard]] static std::string no_end(double low, double high) {
    if (std::isfinite(low) && std::isfinite(high)) return {};
    return std::isfinite(high)  ? "; no lower end"
           : std::isfinite(low) ? "; no upper end"
                                : "; no end on either side";
  }

  [[nodiscard]] Chart over_friction() const {
    auto chart = empty_chart("Load factors that can be held",
                             answer::friction_name(has_own_friction(reader_)),
                             "factor of the reference load");
    ChartSeries held{.name = "held at the friction coefficients of the call",
                     .stroke = Stroke::bar};
    ChartSeries none{.name = "no factor is known to be held"};
    bool endless = false;
    for (const auto& point : reader_.list(result_, "points")) {
      const double mu = reader_.number(point, "friction");
      const auto& intervals = reader_.list(point, "intervals");
      if (intervals.empty()) none.marks.push_back({mu, 0, fmt::format("none at {}", mu)});
      for (const auto& each : intervals) {
        const auto [low, high] = held_range(reader_, each);
        endless = endless || std::isinf(low) || std::isinf(high);
        if (low < high)
          held.lines.push_back({{mu, low}, {mu, high}});
        else  // a bar without length would not be seen
          held.marks.push_back({mu, low, fmt::format("at {} only {}", mu, low)});
      }
    }
    if (endless) held.name += "; arrow: no end";
    if (!held.lines.empty() || !held.marks.empty()) chart.series.push_back(std::move(held));
    if (!none.marks.empty()) chart.series.push_back(std::move(none));
    if (reader_.list(result_, "points").size() > 1)
      chart.series.push_back({.name = "between them nothing is computed"});
    return chart;
  }

  [[nodiscard]] Points points_of(const ResultJson& piece, const char* key) const {
    Points points;
    for (const auto& each : reader_.list(piece, key))
      points.emplace_back(reader_.vector(each, 2).head<2>());
    return points;
  }

  // The box of the vertices that are not far away, and half of its size around it. Far ones are due
  // to gaps that large loads close.
  [[nodiscard]] static Eigen::AlignedBox2d drawn_box(Points vertices) {
    std::ranges::sort(vertices, {}, [](const auto& vertex) { return vertex.norm(); });
    Eigen::AlignedBox2d box;
    const auto others =
        std::ranges::find_if(vertices, [](const auto& vertex) { return vertex.norm() > 0; });
    const double near = others == vertices.end() ? 0 : others[(vertices.end() - others) / 4].norm();
    for (const auto& vertex : vertices)
      if (vertex.norm() <= far_away * near) box.extend(vertex);
    if (box.isEmpty()) box.extend(Eigen::Vector2d(0, 0));
    Eigen::Vector2d size = box.sizes();
    for (int axis = 0; axis < 2; ++axis)
      if (size[axis] == 0) size[axis] = 2 * std::max(1.0, std::abs(box.center()[axis]));
    box.extend(Eigen::Vector2d(box.max() + size / 2));
    box.extend(Eigen::Vector2d(box.min() - size / 2));
    return box;
  }

  [[nodiscard]] Chart areas() const {
    const auto cases = reader_.names(result_, "cases");
    if (cases.size() != 2) reader_.refuse("'cases' has another length");
    auto chart =
        empty_chart("Loads that can be held", "factor of " + cases[0], "factor of " + cases[1]);
    const auto& pieces = reader_.list(result_, "pieces");
    Points all;
    for (const auto& piece : pieces)
      std::ranges::copy(points_of(piece, "vertices"), std::back_inserter(all));
    chart.shown = drawn_box(std::move(all));
    std::size_t outside = 0;
    for (const auto& piece : pieces) {
      ChartArea area{points_of(piece, "vertices"), points_of(piece, "rays")};
      const bool everything = area.vertices.empty();
      if (everything) area = {{{0, 0}}, {{1, 0}, {0, 1}, {-1, -1}}};
      if (pictures::convex_area(area.vertices, area.rays, *chart.shown).empty()) {
        ++outside;
        continue;
      }
      const auto* const end = everything           ? "; no end on any side"
                              : !area.rays.empty() ? "; no end"
                                                   : "";
      const auto* const fine = ResultReader::find(piece, "fine");
      const bool coarse = fine != nullptr && *fine == false;
      chart.series.push_back({.name = "in contact: " + contact_of(piece) + end +
                                      (coarse ? "; may be larger than drawn" : ""),
                              .areas = {std::move(area)}});
    }
    if (outside > 0)
      chart.series.push_back(
          {.name = answer::counted(outside, "piece") + " outside of the frame, far away"});
    return chart;
  }

  const ResultReader& reader_;
  const ResultJson& result_;
  const std::string& sentence_;
};

}  // namespace

bool is_charted_hold(const ResultReader& reader) {
  const auto* const command = ResultReader::find(reader.all(), "command");
  if (command == nullptr || *command != "hold") return false;
  const auto& result = reader.at(reader.all(), "result");
  return ResultReader::find(result, "pieces") != nullptr ||
         ResultReader::find(result, "points") != nullptr;
}

std::optional<pictures::Chart> hold_chart(const ResultReader& reader, const std::string& sentence) {
  return HoldCharts(reader, sentence).chart();
}

}  // namespace kusabi::run
