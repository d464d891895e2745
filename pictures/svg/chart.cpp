// From the top: title, lines, axes with what is drawn between them, legend.
#include "pictures/svg/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ostream>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "pictures/svg/style.hpp"
#include "pictures/xml_text.hpp"

namespace kusabi::pictures {
namespace {

constexpr double chart_width = 960;
constexpr double chart_margin = 36;
constexpr double plot_height = 380;
constexpr double row = 20;

/// Beside the classes of all pictures.
constexpr std::string_view chart_style = R"(
.grid { stroke: #d8dee4; stroke-width: 1; }
.frame { stroke: #6e7781; stroke-width: 1.3; }
.curve { fill: none; stroke-width: 2.4; }
.dashed { stroke-dasharray: 7 5; }
.curve.s0 { stroke: #0969da; } .mark.s0 { fill: #0969da; }
.curve.s1 { stroke: #bc4c00; } .mark.s1 { fill: #bc4c00; }
.curve.s2 { stroke: #1a7f64; } .mark.s2 { fill: #1a7f64; }
.curve.s3 { stroke: #8250df; } .mark.s3 { fill: #8250df; }
.mark { stroke: #ffffff; stroke-width: 1.2; }
@media (prefers-color-scheme: dark) {
.grid { stroke: #30363d; }
.frame { stroke: #9ea7b3; }
.curve.s0 { stroke: #58a6ff; } .mark.s0 { fill: #58a6ff; }
.curve.s1 { stroke: #ffa657; } .mark.s1 { fill: #ffa657; }
.curve.s2 { stroke: #4ac2a0; } .mark.s2 { fill: #4ac2a0; }
.curve.s3 { stroke: #bc8cff; } .mark.s3 { fill: #bc8cff; }
.mark { stroke: #0d1117; }
}
)";

/// The numbers along an axis: multiples of 1, 2 or 5 times a power of ten.
struct Axis {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  double step = 1;

  void take(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }

  /// @param about how many steps @param smallest no step is smaller
  void settle(int about, double smallest) {
    if (!(least < most)) most = least + std::max(smallest, std::max(1.0, std::abs(least)));
    const double wanted = std::max((most - least) / about, smallest);
    step = std::pow(10, std::floor(std::log10(wanted)));
    for (const double factor : {2.0, 5.0, 10.0}) {
      if (step < wanted) step = std::pow(10, std::floor(std::log10(wanted))) * factor;
    }
    least = step * std::floor(least / step);
    most = step * std::ceil(most / step);
  }

  [[nodiscard]] int count() const { return static_cast<int>(std::lround((most - least) / step)); }
  /// With the digits of the step, so that no rounding shows.
  [[nodiscard]] std::string text(int number) const {
    const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(step))));
    const double value = least + number * step;
    return fmt::format("{:.{}f}", std::abs(value) < step / 2 ? 0 : value, digits);
  }
  [[nodiscard]] double share(double value) const { return (value - least) / (most - least); }
};

class Plot {
 public:
  Plot(const Chart& chart, const Point& corner, const Point& size)
      : chart_(chart), corner_(corner), size_(size) {
    for (const auto& series : chart.series) {
      for (const auto& point : series.line) take(point.x(), point.y());
      for (const auto& mark : series.marks) take(mark.x, mark.y);
    }
    if (chart.whole_numbers) y_.take(0);
    x_.settle(10, std::numeric_limits<double>::min());
    y_.settle(8, chart.whole_numbers ? 1 : std::numeric_limits<double>::min());
  }

  void draw(Canvas& canvas) const {
    draw_axes(canvas);
    for (std::size_t i = 0; i < chart_.series.size(); ++i) draw_series(canvas, i);
  }

 private:
  void take(double x, double y) {
    x_.take(x);
    y_.take(y);
  }

  [[nodiscard]] Point place(double x, double y) const {
    return corner_ + Point(size_.x() * x_.share(x), size_.y() * (1 - y_.share(y)));
  }

  void draw_axes(Canvas& canvas) const {
    const Point bottom = corner_ + Point(0, size_.y());
    for (int i = 0; i <= x_.count(); ++i) {
      const Point at = bottom + Point(size_.x() * i / x_.count(), 0);
      canvas.line("grid", at, at - Point(0, size_.y()));
      canvas.words("line", at + Point(0, row), "middle", x_.text(i));
    }
    for (int i = 0; i <= y_.count(); ++i) {
      const Point at = bottom - Point(0, size_.y() * i / y_.count());
      canvas.line("grid", at, at + Point(size_.x(), 0));
      canvas.words("line", at + Point(-9, 4.5), "end", y_.text(i));
    }
    canvas.line("frame", bottom, bottom + Point(size_.x(), 0));
    canvas.line("frame", bottom, corner_);
    canvas.words("word", bottom + Point(size_.x() / 2, 2.3 * row), "middle", chart_.x_name);
    canvas.words("word", corner_ + Point(-chart_margin, -14), "start", chart_.y_name);
  }

  void draw_series(Canvas& canvas, std::size_t number) const {
    const auto& series = chart_.series[number];
    std::vector<Point> line;
    for (const auto& point : series.line) line.push_back(place(point.x(), point.y()));
    if (!line.empty())
      canvas.polyline(fmt::format("curve s{}{}", number % 4, series.dashed ? " dashed" : ""), line);
    for (const auto& mark : series.marks) {
      canvas.begin_group("marked", mark.words);
      canvas.circle(fmt::format("mark s{}", number % 4), place(mark.x, mark.y), 4);
      canvas.end_group();
    }
  }

  const Chart& chart_;
  Point corner_, size_;
  Axis x_, y_;
};

/// A row a series. @return how far down it reaches
double draw_chart_legend(Canvas& canvas, const Chart& chart, double y) {
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const auto& series = chart.series[i];
    const Point left(chart_margin, y);
    if (!series.line.empty())
      canvas.polyline(fmt::format("curve s{}{}", i % 4, series.dashed ? " dashed" : ""),
                      {left, left + Point(30, 0)});
    if (!series.marks.empty())
      canvas.circle(fmt::format("mark s{}", i % 4), left + Point(15, 0), 4);
    canvas.words("word", left + Point(40, 4.5), "start", series.name);
    y += row + 4;
  }
  return y;
}

}  // namespace

void write_chart(std::ostream& out, const Chart& chart) {
  constexpr double left = 84;
  Canvas canvas;
  double y = chart_margin + 10;
  canvas.words("title", {chart_margin, y}, "start", chart.title);
  for (const auto& line : chart.lines) {
    y += row;
    canvas.words("line", {chart_margin, y}, "start", line);
  }
  y += 2.4 * row;
  const Point size(chart_width - left - chart_margin, plot_height);
  Plot(chart, {left, y}, size).draw(canvas);
  y = draw_chart_legend(canvas, chart, y + plot_height + 3.8 * row);
  fmt::print(out,
             "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" "
             "width=\"{0:g}\" height=\"{1:g}\" role=\"img\" aria-labelledby=\"title desc\">\n"
             "<title id=\"title\">{2}</title>\n<desc id=\"desc\">{3}</desc>\n"
             "<style>{4}{5}</style>\n<rect class=\"paper\" width=\"{0:g}\" height=\"{1:g}\"/>\n{6}"
             "</svg>\n",
             chart_width, std::round(y + 6), xml_text(chart.title), xml_text(chart.description),
             style, chart_style, canvas.text());
}

}  // namespace kusabi::pictures
