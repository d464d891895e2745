// Chart layout from the top: title, lines, axes and curves, legend.
#include "pictures/svg/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ostream>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "pictures/svg/convex_area.hpp"
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
/// Space beyond the last points on a side without an end, relative to their distance.
constexpr double beyond = 0.25;

/// Letters of a legend on a page, whose letters are larger on a phone.
constexpr std::size_t longest_inline_line = 50;

/// Minimum span of an axis; closer numbers are drawn as one.
constexpr double min_span = 1e-9;

/// Ticks of an axis: multiples of 1, 2 or 5 times a power of ten.
struct Axis {
  double minimum = std::numeric_limits<double>::infinity();
  double maximum = -std::numeric_limits<double>::infinity();
  double step = 1;
  bool goes_down = false, goes_up = false;  // without an end

  void take(double value) {
    if (!std::isfinite(value)) {
      (value < 0 ? goes_down : goes_up) = true;
      return;
    }
    minimum = std::min(minimum, value);
    maximum = std::max(maximum, value);
  }

  /// @param about approximate number of steps @param smallest minimum step
  void settle(int about, double smallest) {
    if (minimum > maximum) minimum = maximum = 0;
    const double size = std::max(std::abs(minimum), std::abs(maximum));
    const bool wide = maximum - minimum > min_span * size;
    const double more = wide ? beyond * (maximum - minimum) : std::max(1.0, size);
    if (goes_down) minimum -= more;
    if (goes_up) maximum += more;
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

const char* kind_of(Stroke stroke) {
  return stroke == Stroke::dashed ? " dashed" : stroke == Stroke::bar ? " thick" : "";
}

class Plot {
 public:
  Plot(const Chart& chart, const PixelPoint& corner, const PixelPoint& size)
      : chart_(chart), corner_(corner), size_(size) {
    if (chart.shown) {
      take(chart.shown->min());
      take(chart.shown->max());
    } else {
      for (const auto& series : chart.series) take_points(series);
    }
    if (chart.whole_numbers) y_.take(0);
    x_.settle(10, std::numeric_limits<double>::min());
    y_.settle(8, chart.whole_numbers ? 1 : std::numeric_limits<double>::min());
    frame_ = {Eigen::Vector2d(x_.minimum, y_.minimum), Eigen::Vector2d(x_.maximum, y_.maximum)};
  }

  void draw(Canvas& canvas) const {
    draw_axes(canvas);
    for (std::size_t i = 0; i < chart_.series.size(); ++i) draw_series(canvas, i);
  }

 private:
  void take(const Eigen::Vector2d& point) {
    x_.take(point.x());
    y_.take(point.y());
  }

  void take_points(const ChartSeries& series) {
    for (const auto& line : series.lines)
      for (const auto& point : line) take(point);
    for (const auto& mark : series.marks) take({mark.x, mark.y});
    for (const auto& area : series.areas) {
      for (const auto& point : area.vertices) take(point);
      for (const auto& ray : area.rays) {
        if (ray.x() != 0) x_.take(std::copysign(HUGE_VAL, ray.x()));
        if (ray.y() != 0) y_.take(std::copysign(HUGE_VAL, ray.y()));
      }
    }
  }

  [[nodiscard]] PixelPoint place(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d inside = point.cwiseMax(frame_.min()).cwiseMin(frame_.max());
    return corner_ +
           PixelPoint(size_.x() * x_.share(inside.x()), size_.y() * (1 - y_.share(inside.y())));
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
    for (const auto& area : series.areas) draw_area(canvas, number, area);
    for (const auto& line : series.lines) draw_line(canvas, number, line);
    for (const auto& mark : series.marks) {
      canvas.begin_group("marked", mark.words);
      canvas.circle(fmt::format("mark s{}", number % 4), place({mark.x, mark.y}), 4);
      canvas.end_group();
    }
  }

  void draw_area(Canvas& canvas, std::size_t number, const ChartArea& area) const {
    const auto corners = convex_area(area.vertices, area.rays, frame_);
    std::vector<PixelPoint> points;
    for (const auto& corner : corners) points.push_back(place(corner));
    if (points.empty()) return;
    canvas.polygon(fmt::format("area s{}", number % 4), points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto next = (i + 1) % points.size();
      if (!is_cut(area, corners[i], corners[next]))
        canvas.line(fmt::format("edge s{}", number % 4), points[i], points[next]);
    }
  }

  // True for an edge on the frame if the area goes on behind it.
  [[nodiscard]] bool is_cut(const ChartArea& area, const Eigen::Vector2d& from,
                            const Eigen::Vector2d& to) const {
    for (int axis = 0; axis < 2; ++axis) {
      const double tolerance = min_span * frame_.sizes()[axis];
      for (const double side : {-1.0, 1.0}) {
        const double limit = side < 0 ? frame_.min()[axis] : frame_.max()[axis];
        const auto beyond_by = [&](const auto& point) { return side * (point[axis] - limit); };
        if (std::min(beyond_by(from), beyond_by(to)) < -tolerance) continue;
        if (std::ranges::any_of(area.rays, [&](const auto& ray) { return side * ray[axis] > 0; }) ||
            std::ranges::any_of(area.vertices,
                                [&](const auto& vertex) { return beyond_by(vertex) > tolerance; }))
          return true;
      }
    }
    return false;
  }

  void draw_line(Canvas& canvas, std::size_t number,
                 const std::vector<Eigen::Vector2d>& line) const {
    if (line.empty()) return;
    std::vector<PixelPoint> points;
    for (const auto& point : line) points.push_back(place(point));
    canvas.polyline(fmt::format("curve s{}{}", number % 4, kind_of(chart_.series[number].stroke)),
                    points);
    const auto end = [&](const Eigen::Vector2d& last, const PixelPoint& from,
                         const PixelPoint& to) {
      if (!last.allFinite()) canvas.arrow(fmt::format("arrow s{}", number % 4), from, to, head);
    };
    if (points.size() < 2) return;
    end(line.front(), points[1], points[0]);
    end(line.back(), points[points.size() - 2], points.back());
  }

  static constexpr double head = 12;

  const Chart& chart_;
  PixelPoint corner_, size_;
  Axis x_, y_;
  Eigen::AlignedBox2d frame_;
};

/// Rows of a legend: a sample, and its text in lines of at most `longest` letters.
class ChartLegend {
 public:
  ChartLegend(Canvas& canvas, double y, std::size_t longest)
      : canvas_(canvas), y_(y), longest_(longest) {}

  /// @return y of the lower edge
  double draw(const Chart& chart) {
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
      const auto& series = chart.series[i];
      if (!series.areas.empty())
        canvas_.rectangle(fmt::format("area s{}", i % 4), left() - PixelPoint(0, 6), {30, 12});
      if (!series.lines.empty())
        canvas_.polyline(fmt::format("curve s{}{}", i % 4, kind_of(series.stroke)),
                         {left(), left() + PixelPoint(30, 0)});
      if (!series.marks.empty())
        canvas_.circle(fmt::format("mark s{}", i % 4), left() + PixelPoint(15, 0), 4);
      words(series.name);
    }
    return y_;
  }

 private:
  [[nodiscard]] PixelPoint left() const { return {chart_margin, y_}; }

  void words(const std::string& text) {
    for (const auto& line : lines_of(text, longest_)) {
      canvas_.words("word", left() + PixelPoint(40, 4.5), "start", line);
      y_ += row + 4;
    }
  }

  Canvas& canvas_;
  double y_;
  std::size_t longest_;
};

/// Axes, curves and legend. @param longest line of the legend @return y of the lower edge
double draw_chart(Canvas& canvas, const Chart& chart, double top, double across,
                  std::size_t longest) {
  const PixelPoint size(across - left_of_plot - chart_margin, plot_shape * across);
  Plot(chart, {left_of_plot, top}, size).draw(canvas);
  return ChartLegend(canvas, top + size.y() + 3.8 * row, longest).draw(chart);
}

}  // namespace

void write_chart(std::ostream& out, const Chart& chart) {
  Canvas canvas;
  double y = canvas.head({chart_margin, chart_margin + 10}, chart.title, chart.lines);
  y = draw_chart(canvas, chart, y + 2.4 * row, chart_width, longest_line);
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

std::string inline_chart(const std::string& id, const Chart& chart) {
  Canvas canvas;
  canvas.begin_group("chart");
  const double y = draw_chart(canvas, chart, 1.6 * row, inline_width, longest_inline_line);
  canvas.end_group();
  return svg_element({id, chart.title, chart.description, true}, {inline_width, std::round(y)},
                     canvas);
}

}  // namespace kusabi::pictures
