// Picture layout from the top: title, lines, scenes, legend.
#include "pictures/svg/picture.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "pictures/svg/canvas.hpp"
#include "pictures/svg/legend.hpp"
#include "pictures/svg/scales.hpp"
#include "pictures/svg/scene_drawing.hpp"
#include "pictures/svg/style.hpp"
#include "pictures/xml_text.hpp"

namespace kusabi::pictures {
namespace {

constexpr double width = 960;
constexpr double margin = 36;

void write(std::ostream& out, const std::string& title, double height, const Canvas& canvas) {
  fmt::print(out,
             "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" "
             "width=\"{0:g}\" height=\"{1:g}\" role=\"img\">\n<title>{2}</title>\n"
             "<style>{3}</style>\n<rect class=\"paper\" width=\"{0:g}\" height=\"{1:g}\"/>\n{4}"
             "</svg>\n",
             width, height, xml_text(title), style, canvas.text());
}

// Draws a rule and the legend below it. @return height of the paper
double draw_foot(Canvas& canvas, const std::vector<LegendEntry>& entries, double y, int columns) {
  canvas.line("rule", {margin, y}, {width - margin, y});
  const double height = draw_legend(canvas, entries, {margin, y + 12}, width - 2 * margin, columns);
  return std::round(y + 12 + height + 18);
}

struct SheetLayout {
  int columns;
  int rows;
  PixelPoint card;  // size, with its caption

  SheetLayout(std::size_t count, double shape) {
    constexpr int max_columns = 5;
    columns = std::clamp(static_cast<int>(std::ceil(std::sqrt(1.4 * static_cast<double>(count)))),
                         1, std::min(max_columns, std::max(2, static_cast<int>(count))));
    rows = (static_cast<int>(count) + columns - 1) / columns;
    const double across = (width - 2 * margin + gap) / columns - gap;
    card = PixelPoint(across, std::clamp(across * shape, 0.45 * across, 1.25 * across) + caption);
  }

  static constexpr double gap = 12;
  static constexpr double caption = 26;
};

void draw_card(Canvas& canvas, const Scene& scene, const PixelPoint& corner,
               const PixelPoint& size) {
  canvas.begin_group("small", scene.name + (scene.note.empty() ? "" : ": " + scene.note));
  canvas.rectangle("card", corner, size);
  canvas.words("caption", corner + PixelPoint(9, 18), "start", scene.name);
  canvas.words("note", corner + PixelPoint(size.x() - 9, 18), "end", scene.note);
  constexpr double inner = 16;
  draw_scene(canvas, scene,
             {corner + PixelPoint(inner, SheetLayout::caption + inner / 2),
              size - PixelPoint(2 * inner, SheetLayout::caption + 1.5 * inner)},
             small_detail);
  canvas.end_group();
}

}  // namespace

void write_svg(std::ostream& out, const Picture& picture, const Scene& scene) {
  constexpr double side = 96;
  constexpr double above = 56;
  Canvas canvas;
  const auto title = picture.title + " · " + scene.name;
  auto lines = picture.lines;
  lines.insert(lines.end(), scene.lines.begin(), scene.lines.end());
  const double top = canvas.head({margin, margin + 10}, title, lines) + above;
  const double across = width - 2 * side;
  const double shape = View::shape(scene.dimension, extent(scene, scales_of(scene)));
  const double height = std::clamp(across * shape, 160.0, 600.0);
  draw_scene(canvas, scene, {{side, top}, {across, height}}, large_detail);
  if (scene.dimension == 3) draw_axes(canvas, {margin, top + height - 16});
  const auto entries = legend(scene, picture.units);
  write(out, title, draw_foot(canvas, entries, top + height + above, 2), canvas);
}

void write_sheet(std::ostream& out, const Picture& picture, const std::vector<Scene>& scenes) {
  const auto count = std::min(scenes.size(), max_per_sheet);
  double shape = 0;
  for (std::size_t i = 0; i < count; ++i)
    shape =
        std::max(shape, View::shape(scenes[i].dimension, extent(scenes[i], scales_of(scenes[i]))));
  const SheetLayout layout(count, shape);
  Canvas canvas;
  const double top = canvas.head({margin, margin + 10}, picture.title, picture.lines) + 20;
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = static_cast<int>(i) / layout.columns;
    const auto column = static_cast<int>(i) % layout.columns;
    const PixelPoint step = layout.card + PixelPoint(SheetLayout::gap, SheetLayout::gap);
    draw_card(canvas, scenes[i],
              PixelPoint(margin, top) + PixelPoint(column * step.x(), row * step.y()), layout.card);
  }
  const double bottom = top + layout.rows * (layout.card.y() + SheetLayout::gap) + 6;
  write(out, picture.title, draw_foot(canvas, common_legend(scenes), bottom, 3), canvas);
}

}  // namespace kusabi::pictures
