// Inline pictures: a card of a sheet, or a picture in detail.
#include "pictures/svg/inline_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "pictures/svg/canvas.hpp"
#include "pictures/svg/scales.hpp"
#include "pictures/svg/scene_drawing.hpp"
#include "pictures/svg/style.hpp"
#include "pictures/xml_text.hpp"

namespace kusabi::pictures {

std::string svg_element(const InlinePicture& picture, const PixelPoint& size,
                        const Canvas& canvas) {
  return fmt::format(
      "<svg id=\"{0}\" class=\"picture\" viewBox=\"0 0 {1:g} {2:g}\" width=\"{1:g}\" "
      "height=\"{2:g}\" role=\"img\" aria-labelledby=\"{0}-title {0}-desc\">\n"
      "<title id=\"{0}-title\">{3}</title>\n<desc id=\"{0}-desc\">{4}</desc>\n{5}</svg>\n",
      xml_text(picture.id), size.x(), size.y(), xml_text(picture.title),
      xml_text(picture.description), canvas.text());
}

std::string inline_svg(const InlinePicture& picture, const Scene& scene) {
  const double across = picture.large ? 720 : 320;
  const double side = picture.large ? 72 : 16;
  const double shape = View::shape(scene.dimension, extent(scene, scales_of(scene)));
  const double inner = across - 2 * side;
  const double high = std::clamp(inner * shape, 0.3 * inner, inner);
  Canvas canvas;
  canvas.begin_group(picture.large ? "large" : "small");
  draw_scene(canvas, scene, {{side, side}, {inner, high}},
             picture.large ? large_detail : small_detail);
  if (picture.large && scene.dimension == 3) draw_axes(canvas, {4, high + 2 * side - 60});
  canvas.end_group();
  return svg_element(picture, {across, std::round(high + 2 * side)}, canvas);
}

std::string inline_legend(const InlinePicture& picture, const std::vector<LegendEntry>& entries) {
  constexpr double across = 328;  // of a phone 360 pixels wide, without margins
  Canvas canvas;
  const double height = draw_legend(canvas, entries, {4, 4}, across, 1);
  return svg_element(picture, {across, height + 8}, canvas);
}

std::string inline_style() {
  std::string scoped;
  const auto whole = std::string(style).append(chart_style);
  std::string_view rest = whole;
  const auto take = [&rest](std::size_t length) {
    const auto taken = rest.substr(0, length);
    rest.remove_prefix(taken.size());
    return taken;
  };
  while (!rest.empty()) {
    if (rest.front() == '@') {
      scoped.append(take(rest.find('{') + 1));
    } else if (rest.front() == '}' || rest.front() == '\n' || rest.front() == ' ') {
      scoped.append(take(1));
    } else {
      auto selectors = take(rest.find('{'));
      while (!selectors.empty()) {
        const auto one = selectors.substr(0, selectors.find(','));
        selectors.remove_prefix(std::min(selectors.size(), one.size() + 1));
        const auto first = one.find_first_not_of(' ');
        scoped.append("svg.picture ").append(one.substr(first)) += selectors.empty() ? "" : ", ";
      }
      scoped.append(take(rest.find('}') + 1));
    }
  }
  return scoped;
}

}  // namespace kusabi::pictures
