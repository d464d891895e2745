// InlinePicture: a scene as a part of an HTML page, without title, lines and legend of its own; one
// style applies to all.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pictures/svg/canvas.hpp"
#include "pictures/svg/legend.hpp"
#include "pictures/svg/scene.hpp"

namespace kusabi::pictures {

struct InlinePicture {
  std::string id;           ///< of the element; no other id on the page begins with it and a dash
  std::string title;        ///< name for readers who cannot see the picture
  std::string description;  ///< text alternative, in a sentence
  bool large = false;       ///< true: with names and hatches
};

/// An svg element of the class "picture".
std::string inline_svg(const InlinePicture& picture, const Scene& scene);

/// A legend as such an element.
std::string inline_legend(const InlinePicture& picture, const std::vector<LegendEntry>& entries);

/// Content of a canvas, as such an element. @param size in pixels
std::string svg_element(const InlinePicture& picture, const PixelPoint& size, const Canvas& canvas);

/// The style of svg/style.hpp, charts included, restricted to `svg.picture`, so that a page may use
/// the same class names.
std::string inline_style();

}  // namespace kusabi::pictures
