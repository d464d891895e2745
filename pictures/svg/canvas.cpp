// SVG elements with coordinates rounded to hundredths of a pixel.
#include "pictures/svg/canvas.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "pictures/xml_text.hpp"

namespace kusabi::pictures {
namespace {

std::string coordinates(const std::vector<PixelPoint>& points) {
  std::string text;
  for (const PixelPoint& point : points)
    fmt::format_to(std::back_inserter(text), "{:.2f},{:.2f} ", point.x(), point.y());
  if (!text.empty()) text.pop_back();
  return text;
}

// Letters of a text in UTF-8.
std::size_t letters(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

std::vector<std::string> lines_of(std::string_view text, std::size_t longest) {
  std::vector<std::string> lines(1);
  while (!text.empty()) {
    const auto word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    if (!lines.back().empty() && letters(lines.back()) + 1 + letters(word) > longest)
      lines.emplace_back();
    if (!lines.back().empty()) lines.back() += ' ';
    lines.back() += word;
  }
  return lines;
}

void Canvas::line(std::string_view kind, const PixelPoint& from, const PixelPoint& to) {
  fmt::format_to(std::back_inserter(text_),
                 "<line class=\"{}\" x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\"/>\n",
                 kind, from.x(), from.y(), to.x(), to.y());
}

void Canvas::polyline(std::string_view kind, const std::vector<PixelPoint>& points) {
  fmt::format_to(std::back_inserter(text_), "<polyline class=\"{}\" points=\"{}\"/>\n", kind,
                 coordinates(points));
}

void Canvas::polygon(std::string_view kind, const std::vector<PixelPoint>& points) {
  fmt::format_to(std::back_inserter(text_), "<polygon class=\"{}\" points=\"{}\"/>\n", kind,
                 coordinates(points));
}

void Canvas::circle(std::string_view kind, const PixelPoint& centre, double radius) {
  fmt::format_to(std::back_inserter(text_),
                 "<circle class=\"{}\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>\n", kind,
                 centre.x(), centre.y(), radius);
}

void Canvas::rectangle(std::string_view kind, const PixelPoint& corner, const PixelPoint& size) {
  fmt::format_to(
      std::back_inserter(text_),
      "<rect class=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"/>\n", kind,
      corner.x(), corner.y(), size.x(), size.y());
}

void Canvas::arrow(std::string_view kind, const PixelPoint& from, const PixelPoint& to,
                   double head) {
  const PixelPoint way = to - from;
  const double length = way.norm();
  if (!(length > 0)) return;
  const double size = std::min(head, length / 3);
  const PixelPoint along = way / length;
  const PixelPoint across(-along.y(), along.x());
  const PixelPoint neck = to - size * along;
  line(kind, from, neck);
  polygon(kind, {to, neck + 0.42 * size * across, neck - 0.42 * size * across});
}

void Canvas::words(std::string_view kind, const PixelPoint& at, std::string_view anchor,
                   std::string_view text) {
  fmt::format_to(std::back_inserter(text_),
                 "<text class=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\">{}</text>\n",
                 kind, at.x(), at.y(), anchor, xml_text(text));
}

double Canvas::head(const PixelPoint& at, const std::string& title,
                    const std::vector<std::string>& lines) {
  constexpr std::size_t longest_title = 66;
  double y = at.y() - 26;
  for (const auto& line : lines_of(title, longest_title))
    words("title", {at.x(), y += 26}, "start", line);
  for (const auto& text : lines)
    for (const auto& line : lines_of(text, longest_line))
      words("line", {at.x(), y += 20}, "start", line);
  return y;
}

void Canvas::begin_group(std::string_view kind, std::string_view title) {
  fmt::format_to(std::back_inserter(text_), "<g class=\"{}\">\n", kind);
  if (!title.empty())
    fmt::format_to(std::back_inserter(text_), "<title>{}</title>\n", xml_text(title));
}

void Canvas::end_group() {
  text_ += "</g>\n";
}

}  // namespace kusabi::pictures
