// Chart layout from the top: title, lines, axes and curves, legend.
#include "pictures/svg/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ostream>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "pictures/svg/inline_picture.hpp"
#include "pictures/svg/style.hpp"
#include "pictures/xml_text.hpp"

namespace kusabi::pictures {
namespace {

constexpr double chart_width = 960;
constexpr double inline_width = 640;
constexpr double chart_margin = 36;
constexpr double left_of_plot = 84;
constexpr double plot_shape = 380 / chart_width;  ///< height, relative to the whole width
constexpr double row = 20;

/// Minimum span of an axis; closer numbers are drawn as one.
constexpr double min_span = 1e-9;

/// Ticks of an axis: multiples of 1, 2 or 5 times a power of ten.
struct Axis {
  double minimum = std::numeric_limits<double>::infinity();
  double maximum = -std::numeric_limits<double>::infinity();
  double step = 1;

  void take(double value) {
    minimum = std::min(minimum, value);
    maximum = std::max(maximum, value);
  }

  /// @param about approximate number of steps @param smallest minimum step
  void settle(int about, double smallest) {
    const double size = std::max(std::abs(minimum), std::abs(maximum));
    if (!(maximum - minimum > min_span * size))
      maximum = minimum + std::max(smallest, std::max(1.0, std::abs(minimum)));
    const double wanted = std::max((maximum - minimum) / about, smallest);
    step = std::pow(10, std::floor(std::log10(wanted)));
    for (const double factor : {2.0, 5.0, 10.0}) {
      if (step < wanted) step = std::pow(10, std::floor(std::log10(wanted))) * factor;
    }
    minimum = step * std::floor(minimum / step);
    maximum = step * std::ceil(maximum / step);
  }

  [[nodiscard]] int count() const {
    return static_cast<int>(std::lround((maximum - minimum) / step));
  }
  /// Number with the digits of the step, so that rounding is not visible.
  [[nodiscard]] std::string text(int number) const {
    const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(step))));
    const double value = minimum + number * step;
    return fmt::format("{:.{}f}", std::abs(value) < step / 2 ? 0 : value, digits);
  }
  [[nodiscard]] double share(double value) const { return (value - minimum) / (maximum - minimum); }
};

class Plot {
 public:
  Plot(const Chart& chart, const PixelPoint& corner, const PixelPoint& size)
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

  [[nodiscard]] PixelPoint place(double x, double y) const {
    return corner_ + PixelPoint(size_.x() * x_.share(x), size_.y() * (1 - y_.share(y)));
  }

  void draw_axes(Canvas& canvas) const {
    const PixelPoint bottom = corner_ + PixelPoint(0, size_.y());
    for (int i = 0; i <= x_.count(); ++i) {
      const PixelPoint at = bottom + PixelPoint(size_.x() * i / x_.count(), 0);
      canvas.line("grid", at, at - PixelPoint(0, size_.y()));
      canvas.words("line", at + PixelPoint(0, row), "middle", x_.text(i));
    }
    for (int i = 0; i <= y_.count(); ++i) {
      const PixelPoint at = bottom - PixelPoint(0, size_.y() * i / y_.count());
      canvas.line("grid", at, at + PixelPoint(size_.x(), 0));
      canvas.words("line", at + PixelPoint(-9, 4.5), "end", y_.text(i));
    }
    canvas.line("frame", bottom, bottom + PixelPoint(size_.x(), 0));
    canvas.line("frame", bottom, corner_);
    canvas.words("word", bottom + PixelPoint(size_.x() / 2, 2.3 * row), "middle", chart_.x_name);
    canvas.words("word", corner_ + PixelPoint(-chart_margin, -14), "start", chart_.y_name);
  }

  void draw_series(Canvas& canvas, std::size_t number) const {
    const auto& series = chart_.series[number];
    std::vector<PixelPoint> line;
    for (const auto& point : series.line) line.push_back(place(point.x(), point.y()));
    if (series.filled)
      canvas.polygon(fmt::format("area s{}", number % 4), line);
    else if (!line.empty())
      canvas.polyline(fmt::format("curve s{}{}", number % 4, series.dashed ? " dashed" : ""), line);
    for (const auto& mark : series.marks) {
      canvas.begin_group("marked", mark.words);
      canvas.circle(fmt::format("mark s{}", number % 4), place(mark.x, mark.y), 4);
      canvas.end_group();
    }
  }

  const Chart& chart_;
  PixelPoint corner_, size_;
  Axis x_, y_;
};

/// One row per series. @return y of the lower edge
double draw_chart_legend(Canvas& canvas, const Chart& chart, double y) {
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const auto& series = chart.series[i];
    const PixelPoint left(chart_margin, y);
    if (series.filled)
      canvas.rectangle(fmt::format("area s{}", i % 4), left - PixelPoint(0, 6), {30, 12});
    else if (!series.line.empty())
      canvas.polyline(fmt::format("curve s{}{}", i % 4, series.dashed ? " dashed" : ""),
                      {left, left + PixelPoint(30, 0)});
    if (!series.marks.empty())
      canvas.circle(fmt::format("mark s{}", i % 4), left + PixelPoint(15, 0), 4);
    canvas.words("word", left + PixelPoint(40, 4.5), "start", series.name);
    y += row + 4;
  }
  return y;
}

/// Axes, curves and legend. @return y of the lower edge
double draw_chart(Canvas& canvas, const Chart& chart, double top, double across) {
  const PixelPoint size(across - left_of_plot - chart_margin, plot_shape * across);
  Plot(chart, {left_of_plot, top}, size).draw(canvas);
  return draw_chart_legend(canvas, chart, top + size.y() + 3.8 * row);
}

}  // namespace

void write_chart(std::ostream& out, const Chart& chart) {
  Canvas canvas;
  double y = chart_margin + 10;
  canvas.words("title", {chart_margin, y}, "start", chart.title);
  for (const auto& line : chart.lines) {
    y += row;
    canvas.words("line", {chart_margin, y}, "start", line);
  }
  y = draw_chart(canvas, chart, y + 2.4 * row, chart_width);
  const bool areas = std::ranges::any_of(chart.series, &ChartSeries::filled);
  fmt::print(
      out,
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" "
      "width=\"{0:g}\" height=\"{1:g}\" role=\"img\" aria-labelledby=\"title desc\">\n"
      "<title id=\"title\">{2}</title>\n<desc id=\"desc\">{3}</desc>\n"
      "<style>{4}{5}{6}</style>\n<rect class=\"paper\" width=\"{0:g}\" height=\"{1:g}\"/>\n{7}"
      "</svg>\n",
      chart_width, std::round(y + 6), xml_text(chart.title), xml_text(chart.description), style,
      chart_style, areas ? area_style : std::string_view(), canvas.text());
}

std::string inline_chart(const std::string& id, const Chart& chart) {
  Canvas canvas;
  canvas.begin_group("chart");
  const double y = draw_chart(canvas, chart, 1.6 * row, inline_width);
  canvas.end_group();
  return svg_element({id, chart.title, chart.description, true}, {inline_width, std::round(y)},
                     canvas);
}

}  // namespace kusabi::pictures
