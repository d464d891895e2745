// Unbounded intervals and pieces are drawn up to a box around all ends and vertices.
#include "run/results/hold_chart.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pictures/svg/convex_area.hpp"

namespace kusabi::run {
namespace {

using pictures::Chart;
using pictures::ChartSeries;
using Points = std::vector<Eigen::Vector2d>;

/// Distance of a vertex that is not drawn, relative to that of the vertex at the first quartile.
constexpr double far_away = 20;

constexpr double unbounded_end = std::numeric_limits<double>::infinity();

/// Intervals at one friction coefficient.
struct HeldAt {
  double mu = 0;
  std::vector<std::pair<double, double>> intervals{};
};

class HoldCharts {
 public:
  HoldCharts(const ResultReader& reader, const std::string& sentence)
      : reader_(reader), result_(reader.at(reader.all(), "result")), sentence_(sentence) {}

  [[nodiscard]] std::optional<Chart> chart() const {
    auto chart = ResultReader::find(result_, "diagram") != nullptr     ? areas()
                 : ResultReader::find(result_, "points") != nullptr    ? bands()
                 : ResultReader::find(result_, "intervals") != nullptr ? bars()
                                                                       : Chart{};
    if (chart.title.empty()) return {};
    if (chart.series.empty())
      chart.series.push_back(
          {.name = "no load is known to be held", .line = {{0, 0}}, .marks = {}});
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

  [[nodiscard]] std::pair<double, double> ends(const ResultJson& interval) const {
    const auto end = [&](const char* key, double otherwise) {
      return ResultReader::find(interval, key) == nullptr ? otherwise
                                                          : reader_.number(interval, key);
    };
    return {end("low", -unbounded_end), end("high", unbounded_end)};
  }

  // Twice the largest finite end.
  [[nodiscard]] static double drawn_size(const std::vector<HeldAt>& all) {
    double size = 1;
    for (const auto& point : all)
      for (const auto& [low, high] : point.intervals)
        for (const double end : {low, high})
          if (std::isfinite(end)) size = std::max(size, 2 * std::abs(end));
    return size;
  }

  [[nodiscard]] HeldAt held_at(const ResultJson& point, double mu) const {
    HeldAt held{.mu = mu};
    for (const auto& each : reader_.list(point, "intervals")) held.intervals.push_back(ends(each));
    return held;
  }

  [[nodiscard]] Chart bars() const {
    auto chart =
        empty_chart("Load factors that can be held", "factor of the reference load", "interval");
    chart.whole_numbers = true;
    const auto held = held_at(result_, 0);
    const double size = drawn_size({held});
    const auto& list = reader_.list(result_, "intervals");
    for (std::size_t i = 0; i < list.size(); ++i) {
      const auto row = static_cast<double>(i + 1);
      const auto& [low, high] = held.intervals[i];
      chart.series.push_back({.name = contact_of(list[i]),
                              .line = {{std::max(low, -size), row}, {std::min(high, size), row}},
                              .marks = {}});
    }
    return chart;
  }

  // A band connects the k-th intervals of adjacent coefficients with equally many intervals.
  [[nodiscard]] Chart bands() const {
    auto chart = empty_chart("Load factors that can be held", "friction coefficient",
                             "factor of the reference load");
    std::vector<HeldAt> all;
    for (const auto& point : reader_.list(result_, "points"))
      all.push_back(held_at(point, reader_.number(point, "mu")));
    const double size = drawn_size(all);
    for (auto first = all.begin(); first != all.end();) {
      const auto count = first->intervals.size();
      const auto last = std::find_if(
          first, all.end(), [&](const HeldAt& point) { return point.intervals.size() != count; });
      for (std::size_t k = 0; k < count; ++k) chart.series.push_back(band({first, last}, k, size));
      first = last;
    }
    return chart;
  }

  [[nodiscard]] static ChartSeries band(std::span<const HeldAt> points, std::size_t k,
                                        double size) {
    const double from = points.front().mu;
    const double to = points.back().mu;
    ChartSeries series{.name = from == to ? fmt::format("held at {}", from)
                                          : fmt::format("held from {} to {}", from, to),
                       .line = {},
                       .filled = points.size() > 1,
                       .marks = {}};
    for (const auto& point : points)
      series.line.emplace_back(point.mu, std::max(point.intervals[k].first, -size));
    for (auto point = points.rbegin(); point != points.rend(); ++point)
      series.line.emplace_back(point->mu, std::min(point->intervals[k].second, size));
    return series;
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
    for (const auto& vertex : vertices)
      if (vertex.norm() <= far_away * vertices[vertices.size() / 4].norm()) box.extend(vertex);
    if (box.isEmpty()) box.extend(Eigen::Vector2d(0, 0));
    Eigen::Vector2d size = box.sizes();
    for (int axis = 0; axis < 2; ++axis)
      if (size[axis] == 0) size[axis] = 2 * std::max(1.0, std::abs(box.center()[axis]));
    box.extend(Eigen::Vector2d(box.max() + size / 2));
    box.extend(Eigen::Vector2d(box.min() - size / 2));
    return box;
  }

  [[nodiscard]] Chart areas() const {
    const auto& diagram = reader_.at(result_, "diagram");
    const auto cases = reader_.names(diagram, "cases");
    if (cases.size() != 2) reader_.refuse("'cases' has another length");
    auto chart =
        empty_chart("Loads that can be held", "factor of " + cases[0], "factor of " + cases[1]);
    const auto& pieces = reader_.list(diagram, "pieces");
    Points all;
    for (const auto& piece : pieces)
      std::ranges::copy(points_of(piece, "vertices"), std::back_inserter(all));
    const auto box = drawn_box(std::move(all));
    for (const auto& piece : pieces) {
      const auto vertices = points_of(piece, "vertices");
      ChartSeries series{.name = contact_of(piece), .line = {}, .filled = true, .marks = {}};
      series.line = vertices.empty()
                        ? pictures::corners_of(box)
                        : pictures::convex_area(vertices, points_of(piece, "rays"), box);
      if (!series.line.empty()) chart.series.push_back(std::move(series));
    }
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
  return ResultReader::find(result, "diagram") != nullptr ||
         ResultReader::find(result, "points") != nullptr;
}

std::optional<pictures::Chart> hold_chart(const ResultReader& reader, const std::string& sentence) {
  return HoldCharts(reader, sentence).chart();
}

}  // namespace kusabi::run
